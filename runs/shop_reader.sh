#!/usr/bin/env bash
# The network that tells photographs of people from drawings, and reads people before white and who is cut out of a photograph.
#
#   PHOTOGRAPHS="FOLDER..." runs/shop_reader.sh
#
# After picture_reader.sh, whose garments and weights it takes (START for other weights, picture_reader.onnx among them; MORE is a
# list of splits of further garments; DESIGNS a file of scripts/place_designs.py, without which it cannot tell photographs).
# PHOTOGRAPHS are folders of photographs with what people wear in them (docs/picture-reader.md says where some come from).
# steps.sh lists the environment. Takes MINUTES (180). Ends with $WORK/shop-reader/shop_reader.onnx, its card beside it.
#
# The package's file: docs/picture-reader.md has the commands.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

[ -n "${PHOTOGRAPHS:-}" ] || { echo 'Give PHOTOGRAPHS="FOLDER..." with a garments.jsonl in each.' >&2; exit 2; }
begin=${START:-$work/picture-reader/run/weights.safetensors}
sewn=$work/worn out=$work/shop-reader
read -ra more <<< "${MORE:-}"
read -ra photographs <<< "$PHOTOGRAPHS"
values=(start="$begin" frozen_stages=2 batch_size=64 block=64 pool=4096 echo=2 ema=0.98 validate_every=100
    validation_garments=60 learning_rate=0.0005 warmup_steps=30 network.image_size=192 plain=0 studio=0.06 several=0.04
    nothing=0.03 close=0.06 photograph=0.45 cut_out=0.65 unguessed=0.4 losses.designs=0.5)
if [ -n "$rehearse" ]; then
    values+=(steps=2 batch_size=4 block=4 pool=0 echo=1 log_every=1 validate_every=1 validation_garments=2 network.embedding=8
        "network.stages=[8,8,16,16]" "network.depths=[1,1,1,1]" network.width=24 network.heads=2 network.mask_width=8
        network.image_size=64)
fi
shop() {
    local again=()
    [ -f "$out/run/checkpoint.pt" ] && again+=(--resume)
    OMP_NUM_THREADS=1 swifttailor train picture-reader --data "$sewn/train" "${more[@]}" --validation "$sewn/validation" \
        --apart "$sewn/test" ${DESIGNS:+--designs "$DESIGNS"} --photographs "${photographs[@]}" --out "$out/run" \
        --workers "$beside" --threads 1 --max-minutes "${MINUTES:-180}" "${again[@]}" --set "${values[@]}" "${settings[@]}"
}
step shop-run shop
step shop-exported swifttailor train export "$out/run" --out "$out/shop_reader.onnx" --overwrite --int8
