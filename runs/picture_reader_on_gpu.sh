#!/usr/bin/env bash
# The picture reader on a machine that is lent for minutes, with a GPU and without a network. A checkout is all that it
# takes: the patterns are those of the package's library, sewn by GarmentSewer on all cores.
#
#   MINUTES=20 runs/picture_reader_on_gpu.sh
#
# steps.sh lists the environment; START is the weights.safetensors of a run to go on from. All cores but one draw. Goes on
# where it was interrupted. Ends with $WORK/gpu/picture_reader.onnx, its card, and the run, whose measurements
# scripts/draw_learning_curve.py draws. What validates it are 150 of the known patterns: judge it by others.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

out=$work/gpu
sizes=(batch_size=256 block=256 ema=0.999 echo=3 validate_every=1000 validation_garments=60 plain=0.22 nothing=0.02
    network.image_size=160 learning_rate=0.0015)
patterns=() length=2.5
if [ -n "$rehearse" ]; then
    sizes=(steps=2 batch_size=4 block=4 echo=1 validate_every=1 log_every=1 validation_garments=2 network.image_size=64
        network.embedding=8 "network.stages=[8,8,16,16]" "network.depths=[1,1,1,1]" network.width=24 network.heads=2
        network.mask_width=8)
    patterns=(--limit 8 --validation 2) length=6
fi

sew() {
    swifttailor data build --engine network --edge-length "$length" --workers "$cores" --out "$out/worn" --split "$1" \
        --patterns "$out/patterns/$1.jsonl.gz" || [ $? -eq 1 ]
}
learn() {
    local more=()
    [ -f "$out/run/checkpoint.pt" ] && more+=(--resume)
    OMP_NUM_THREADS=1 "${launch[@]}" train picture-reader --data "$out/worn/train" --validation "$out/worn/validation" \
        --out "$out/run" --workers $((cores > 1 ? cores - 1 : 1)) --threads 1 --max-minutes "${MINUTES:-20}" "${more[@]}" \
        --set "${sizes[@]}" "${settings[@]}"
}
step gpu-patterns "$python" scripts/write_known_patterns.py "$out/patterns" "${patterns[@]}"
step gpu-worn-validation sew validation
step gpu-worn-train sew train
step gpu-eyes learn
step gpu-exported swifttailor train export "$out/run" --out "$out/picture_reader.onnx" --overwrite --half --data "$out/worn/validation"
