#!/usr/bin/env bash
# The picture reader from nothing: patterns, garments sewn by GarmentSewer, a training from random weights, the model
# file.
#
#   GARMENTCODE=FOLDER runs/picture_reader.sh
#
# steps.sh lists the environment, data.sh says how long the patterns take. USUAL is a list of files of patterns that
# people wear, to be learnt from beside the training patterns. All are sewn, 0.3 s of a core each, and measured, 0.1 s
# each. Trained for MINUTES (1200) in stages of growing pictures, so that most pictures are small and easy: 64
# pixels for a tenth of the time, 96 for two, 128 for three, 160 for two and 160 on mostly plain pictures for two; each
# begins with the weights of the one before, and goes on where it was interrupted. Where there is no GPU each core trains
# a process, which draws its own pictures. Ends with $WORK/picture-reader/picture_reader.onnx and its card beside it.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

minutes=${MINUTES:-1200}
both=(batch_size=64 ema=0.999 echo=3 validate_every=1000 nothing=0.02)
easy=(network.image_size=64 learning_rate=0.002 final_rate=0.3 plain=0.3 studio=0.35 several=0.02)
middle=(network.image_size=96 learning_rate=0.0015 final_rate=0.1 plain=0.25 studio=0.3 several=0.03)
large=(network.image_size=128 learning_rate=0.001 final_rate=0.3 plain=0.22)
full=(network.image_size=160 learning_rate=0.0006 plain=0.22)
last=(network.image_size=160 learning_rate=0.0004 final_rate=0.02 plain=0.5 studio=0.2 close=0.1)
length=2.5
if [ -n "$rehearse" ]; then
    both=(steps=2 batch_size=4 block=4 echo=1 validate_every=1 log_every=1 validation_garments=2 network.embedding=8
        "network.stages=[8,8,16,16]" "network.depths=[1,1,1,1]" network.width=24 network.heads=2 network.mask_width=8)
    easy=(network.image_size=32) middle=("${easy[@]}") large=(network.image_size=64) full=("${large[@]}")
    last=("${large[@]}")
    length=6
fi

runs/data.sh patterns
mapfile -t files < <(training_files)
read -ra usual <<< "${USUAL:-}"
sewn=$work/worn
sew() {
    swifttailor data build --engine network --edge-length "$length" --workers "$cores" --out "$sewn" "$@" || [ $? -eq 1 ]
}
for split in validation test; do
    step "worn-$split" sew --split "$split" --patterns "$work/patterns/$split.jsonl.gz"
done
step worn-train sew --split train --patterns "${files[@]}" "${usual[@]}"
drawing=$((cores > 1 ? cores - 1 : beside))
if [ "$cores" -gt 1 ] && [ "$("$python" -c "import torch; print(int(torch.cuda.is_available()))")" = 0 ]; then
    launch=("$python" -m torch.distributed.run --standalone --nproc_per_node "$cores" -m swifttailor)
    drawing=$beside
fi
given=(--data "$sewn/train" --validation "$sewn/validation" --apart "$sewn/test" --threads 1)
out=$work/picture-reader
eyes() { # name, tenths of the time, settings
    local run=$out/$1 share=$2 more=()
    [ -f "$run/checkpoint.pt" ] && more+=(--resume)
    OMP_NUM_THREADS=1 "${launch[@]}" train picture-reader "${given[@]}" --out "$run" --workers "$drawing" \
        --max-minutes $(((minutes * share + 9) / 10)) "${more[@]}" --set "${both[@]}" "${@:3}"
}
step eyes-easy eyes easy 1 "${easy[@]}" "${settings[@]}"
step eyes-middle eyes middle 2 "${middle[@]}" "${settings[@]}" start="$out/easy/weights.safetensors"
step eyes-large eyes large 3 "${large[@]}" "${settings[@]}" start="$out/middle/weights.safetensors"
step eyes-full eyes full 2 "${full[@]}" "${settings[@]}" start="$out/large/weights.safetensors"
step eyes-last eyes run 2 "${last[@]}" "${settings[@]}" start="$out/full/weights.safetensors"
step eyes-exported swifttailor train export "$out/run" --out "$out/picture_reader.onnx" --overwrite --half \
    --data "$sewn/validation"
