#!/usr/bin/env bash
# The picture reader and the network for plain pictures, at 192 pixels, on a machine that is lent for minutes, with a GPU and
# without a network.
#
#   PACKED=packed DESIGNS=designs.safetensors START=start.onnx MINUTES=8 runs/picture_reader_on_gpu.sh [PART...]
#
# PART is garments, eyes, plain or files, all without any: where a command may only take so long, each in its own.
#
# A checkout and three files are all that it takes. PACKED is a folder of scripts/pack_worn_garments.py with, in this order,
# sewn training and validation garments, draped training and validation garments, and more sewn ones for training; 6,000 are
# 52 MB. Without it patterns of the package's library are sewn by GarmentSewer, which takes minutes. DESIGNS is a file of
# scripts/place_designs.py with the designs of the same garments: the networks learn to say design parameters, too. START is a
# picture reader of the same trunk, or a file of scripts/take_picture_trunk_torch.py (--name efficientnet-lite2 --half).
# steps.sh lists the rest of the environment. All cores but one draw; two thirds of the MINUTES are for pictures of all looks,
# a third for plain ones. Ends with $WORK/gpu/picture_reader.onnx and plain_reader.onnx, their cards, and the runs.
#
# The package's picture_reader.onnx has learnt by this twice: 5.4 minutes from photographs' weights, 776,000 pictures shown of
# 6,095 garments; then 7.3 from there, 1,677,000 of 9,595 with designs, 458 of them draped by physics, which counted twice;
# on an NVIDIA H200 and 16 cores. Starting and validating take two minutes more. plain_reader.onnx went on from there on one
# core: docs/picture-reader.md#on-one-core.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

out=$work/gpu
minutes=${MINUTES:-8}
both=(network.trunk=efficientnet-lite2 network.image_size=192 batch_size=512 block=256 steps=100000 validate_every=100000)
eyes=(pool=65536 echo=10 learning_rate=0.001 warmup_steps=60 final_rate=0.02 ema=0.998 validation_garments=30 plain=0.25
    studio=0.15 nothing=0.02 several=0.02 close=0.1)
plain=(pool=16384 echo=4 learning_rate=0.0007 warmup_steps=20 final_rate=0.03 ema=0.99 validation_garments=40 plain=0.92
    studio=0 several=0 nothing=0.02 unlike=0.06 close=0 near=0.9 unguessed=0.1 variation=0.7)
patterns=() length=2.5
if [ -n "$rehearse" ]; then
    both=(steps=2 batch_size=4 block=4 validate_every=1 log_every=1 network.image_size=64 network.embedding=8
        "network.stages=[8,8,16,16]" "network.depths=[1,1,1,1]" network.width=24 network.heads=2 network.mask_width=8)
    eyes+=(pool=8 echo=1 validation_garments=2) plain+=(pool=8 echo=1 validation_garments=2)
    patterns=(--limit 8 --validation 2) length=6
fi

sew() {
    swifttailor data build --engine network --edge-length "$length" --workers "$cores" --out "$out/worn" --split "$1" \
        --patterns "$out/patterns/$1.jsonl.gz" || [ $? -eq 1 ]
}
learn() { # name, hundredths of the time, validation, settings
    local run=$out/$1 data=("${garments[@]}") again=()
    [ "$1" = plain ] && data+=("${drapes[@]}" "${drapes[@]}")
    [ -f "$run/checkpoint.pt" ] && again+=(--resume)
    OMP_NUM_THREADS=1 "${launch[@]}" train picture-reader --data "${data[@]}" --validation "$3" \
        --apart "${validation[@]}" ${DESIGNS:+--designs "$DESIGNS"} --out "$run" --workers $((cores > 1 ? cores - 1 : 1)) --threads 1 \
        --max-minutes "$(awk "BEGIN {print $minutes * $2 / 100}")" "${again[@]}" --set "${both[@]}" "${@:4}"
}
exported() {
    step "gpu-$1-exported" swifttailor train export "$out/$1" --out "$out/$2_reader.onnx" --overwrite "$3" --data "$4"
}
garments() {
    if [ -n "${PACKED:-}" ]; then
        "$python" scripts/pack_worn_garments.py --unpack "$PACKED" --out "$out/worn" --workers "$cores"
    else
        step gpu-patterns "$python" scripts/write_known_patterns.py "$out/patterns" "${patterns[@]}"
        step gpu-worn-validation sew validation
        step gpu-worn-train sew train
    fi
}
find_garments() {
    if [ -n "${PACKED:-}" ]; then
        validation=("$out/worn/2" "$out/worn/4") drapes=("$out/worn/3")
        local more
        mapfile -t more < <(ls -d "$out"/worn/[5-9] 2> /dev/null)
        garments=("$out/worn/1" "${more[@]}" "${drapes[@]}" "${drapes[@]}")
    else
        validation=("$out/worn/validation") drapes=() garments=("$out/worn/train")
    fi
}
for part in "${@:-garments eyes plain files}"; do
    for one in $part; do
        find_garments
        case $one in
            garments) garments ;;
            eyes) step gpu-eyes learn eyes 67 "${validation[0]}" "${eyes[@]}" "${settings[@]}" ;;
            plain)
                step gpu-plain learn plain 33 "${validation[-1]}" "${plain[@]}" "start=$out/eyes/weights.safetensors"
                ;;
            files)
                exported eyes picture --int8 "${validation[0]}"
                exported plain plain --int8 "${validation[-1]}"
                ;;
            *) echo "'$one' is no part; garments, eyes, plain and files are." >&2; exit 2 ;;
        esac
    done
done
