#!/usr/bin/env bash
# The networks that read plain pictures, those that look like GarmentCodeData's: one for the whole picture, which also says
# whether a picture is plain, one for necks from near, and one for waists, armholes, ends of sleeves and skirts.
#
#   runs/plain_reader.sh
#
# After picture_reader.sh, whose garments and weights it takes (START for other weights, picture_reader.onnx among them; MORE is a
# list of splits of further garments; DESIGNS a file of scripts/place_designs.py, with which all three say design parameters, too).
# steps.sh lists the environment. Of MINUTES (170) the whole picture has eight in eighteen, details five, and necks, which go on
# from these, five. Ends with $WORK/plain-reader/plain_reader.onnx, plain_neck.onnx and plain_details.onnx, cards beside them.
#
# The package's files: docs/picture-reader.md has the commands.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

minutes=${MINUTES:-170}
begin=${START:-$work/picture-reader/run/weights.safetensors}
sewn=$work/worn out=$work/plain-reader
read -ra more <<< "${MORE:-}"
both=(batch_size=64 block=256 echo=2 validation_garments=100 variation=0.7 studio=0 several=0)
whole=(network.image_size=160 ema=0.995 validate_every=250 learning_rate=0.0006 plain=0.92 nothing=0.02 unlike=0.06 close=0
    near=0.9 unguessed=0.1)
details=(network.image_size=160 plain=1.0 nothing=0 close=1.0 unguessed=0 ema=0.99 validate_every=400 learning_rate=0.0006
    warmup_steps=30 frozen_stages=2 losses.designs=1)
if [ -n "$rehearse" ]; then
    both+=(steps=2 batch_size=4 block=4 echo=1 log_every=1 validate_every=1 validation_garments=2 network.embedding=8
        "network.stages=[8,8,16,16]" "network.depths=[1,1,1,1]" network.width=24 network.heads=2 network.mask_width=8)
    whole+=(network.image_size=64) details+=(network.image_size=64)
fi
plain() { # name, eighteenths of the time, settings
    local run=$out/$1 again=()
    [ -f "$run/checkpoint.pt" ] && again+=(--resume)
    OMP_NUM_THREADS=1 swifttailor train picture-reader --data "$sewn/train" "${more[@]}" --validation "$sewn/validation" \
        --apart "$sewn/test" ${DESIGNS:+--designs "$DESIGNS"} --out "$run" --workers "$beside" --threads 1 \
        --max-minutes $(((minutes * $2 + 17) / 18)) "${again[@]}" --set "${both[@]}" "${@:3}"
}
exported() { # run, file, options
    step "plain-$1-exported" swifttailor train export "$out/$1" --out "$out/plain_$2.onnx" --overwrite --int8 "${@:3}"
}
step plain-whole plain whole 8 "${whole[@]}" "${settings[@]}" start="$begin"
step plain-details plain details 5 "${details[@]}" 'parts=["waist","sleeve","skirt","armhole"]' "${settings[@]}" \
    start="$out/whole/weights.safetensors"
step plain-neck plain neck 5 "${details[@]}" 'parts=["neck"]' "${settings[@]}" start="$out/details/weights.safetensors"
exported whole reader --data "$sewn/validation"
for name in neck details; do
    exported "$name" "$name" --data "$sewn/validation"
done
