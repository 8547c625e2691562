#!/usr/bin/env bash
# The network that reads garments that nobody wears, laid flat or hung, and says whether a picture shows one.
#
#   PHOTOGRAPHS="FOLDER..." runs/laid_reader.sh
#
# After picture_reader.sh, whose garments and weights it takes (START for other weights, picture_reader.onnx among them; MORE is a
# list of splits of further garments; DESIGNS a file of scripts/place_designs.py, with which it says design parameters, too).
# PHOTOGRAPHS are folders of photographs of which only the kind is known (docs/picture-reader.md says where some come from); without
# any all pictures are drawn. steps.sh lists the environment. Of MINUTES (100) one third has all but the first three stages of the
# trunk learn, the rest what looks at its map. Ends with $WORK/laid-reader/laid_reader.onnx, its card beside it.
#
# The package's file: docs/picture-reader.md has the commands.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

minutes=${MINUTES:-100}
begin=${START:-$work/picture-reader/run/weights.safetensors}
sewn=$work/worn out=$work/laid-reader
read -ra more <<< "${MORE:-}"
read -ra photographs <<< "${PHOTOGRAPHS:-}"
values=(batch_size=64 block=64 pool=4096 echo=2 ema=0.98 validate_every=100 validation_garments=75 learning_rate=0.001
    warmup_steps=30 network.image_size=192 plain=0 studio=0 close=0 several=0.03 nothing=0.03 worn=0.15 unguessed=0.4
    variation=0.8)
if [ ${#photographs[@]} -gt 0 ]; then
    values+=(laid=0.46 photograph=0.33)
else
    values+=(laid=0.79)
fi
if [ -n "$rehearse" ]; then
    values+=(steps=2 batch_size=4 block=4 pool=0 echo=1 log_every=1 validate_every=1 validation_garments=2 network.embedding=8
        "network.stages=[8,8,16,16]" "network.depths=[1,1,1,1]" network.width=24 network.heads=2 network.mask_width=8
        network.image_size=64)
fi
laid() { # name, thirds of the time, settings
    local run=$out/$1 again=()
    [ -f "$run/checkpoint.pt" ] && again+=(--resume)
    OMP_NUM_THREADS=1 swifttailor train picture-reader --data "$sewn/train" "${more[@]}" --validation "$sewn/validation" \
        --apart "$sewn/test" ${DESIGNS:+--designs "$DESIGNS"} ${PHOTOGRAPHS:+--photographs "${photographs[@]}"} --out "$run" \
        --workers "$beside" --threads 1 --max-minutes $(((minutes * $2 + 2) / 3)) "${again[@]}" --set "${values[@]}" "${settings[@]}" "${@:3}"
}
step laid-deep laid deep 1 start="$begin" frozen_stages=3
step laid-run laid run 2 start="$out/deep/weights.safetensors" frozen_stages=4
step laid-exported swifttailor train export "$out/run" --out "$out/laid_reader.onnx" --overwrite --int8 \
    --data "$sewn/validation"
