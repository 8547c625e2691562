#!/usr/bin/env bash
# The picture reader from nothing: patterns, garments sewn by GarmentSewer, a training from random weights, the model
# file.
#
#   GARMENTCODE=FOLDER runs/picture_reader.sh
#
# steps.sh lists the environment, data.sh says how long the patterns take. Then they are sewn, 0.3 s of a core each, and
# measured, 0.1 s each. Trained in two stages, so that most pictures are small: STAGE minutes (600) of 128 pixels, then
# MINUTES (600) of 192, on a GPU where there is one, else on one core while others draw; each goes on where it was
# interrupted. Ends with $WORK/picture-reader/picture_reader.onnx and its card beside it.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

small=(network.image_size=128) large=(network.image_size=192 learning_rate=0.001)
length=2.5
if [ -n "$rehearse" ]; then
    tiny=(steps=2 batch_size=4 block=4 echo=1 validate_every=1 log_every=1 validation_garments=2 network.embedding=8
        "network.stages=[8,8,16,16]" "network.depths=[1,1,1,1]" network.width=24 network.heads=2 network.mask_width=8)
    small=(network.image_size=32 "${tiny[@]}") large=(network.image_size=64 "${tiny[@]}")
    length=6
fi

runs/data.sh patterns
mapfile -t files < <(training_files)
sewn=$work/worn
sew() {
    swifttailor data build --engine network --edge-length "$length" --workers "$cores" --out "$sewn" "$@" || [ $? -eq 1 ]
}
for split in validation test; do
    step "worn-$split" sew --split "$split" --patterns "$work/patterns/$split.jsonl.gz"
done
step worn-train sew --split train --patterns "${files[@]}"
drawing=$((cores > 1 ? cores - 1 : 1))
given=(--data "$sewn/train" --validation "$sewn/validation" --apart "$sewn/test" --threads 1)
eyes() {
    local out=$1 minutes=$2 more=()
    [ -f "$out/checkpoint.pt" ] && more+=(--resume)
    swifttailor train picture-reader "${given[@]}" --out "$out" --workers "$drawing" --max-minutes "$minutes" \
        "${more[@]}" --set "${@:3}"
}
out=$work/picture-reader
step eyes-small eyes "$out/small" "${STAGE:-600}" "${small[@]}" "${settings[@]}"
step eyes-large eyes "$out/run" "${MINUTES:-600}" "${large[@]}" "${settings[@]}" start="$out/small/weights.safetensors"
step eyes-exported swifttailor train export "$out/run" --out "$out/picture_reader.onnx" --half \
    --data "$sewn/validation"
