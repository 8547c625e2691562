#!/usr/bin/env bash
# A network that looks from near at everything: the start of those for details of plain pictures (plain_reader.sh). From the
# picture reader's weights, in three stages on close-ups alone.
#
#   runs/close_up_reader.sh
#
# After picture_reader.sh, whose garments and weights it takes (START=FILE for other weights, picture_reader.onnx among
# them). steps.sh lists the environment. Small things are learnt where they are alone: plain close-ups first, then those of
# all looks, then the same at a falling rate. MINUTES (160) are shared 3 to 4 to 2. The start of the package's files has run 40
# minutes, 55 and 22 on one core that much else was done on. Ends with $WORK/close-up-reader/run/weights.safetensors.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

minutes=${MINUTES:-160}
begin=${START:-$work/picture-reader/run/weights.safetensors}
sewn=$work/worn out=$work/close-up-reader
both=(network.image_size=96 batch_size=64 block=256 echo=3 validation_garments=60 close=1.0 nothing=0 several=0)
plain=(plain=1.0 studio=0 learning_rate=0.0015 final_rate=0.2 ema=0.995 validate_every=500)
all=(plain=0.35 studio=0.25 learning_rate=0.001 final_rate=0.03 validate_every=500)
falling=(plain=0.35 studio=0.25 learning_rate=0.0008 final_rate=0.02 ema=0.99 warmup_steps=50 validate_every=250 seed=1)
if [ -n "$rehearse" ]; then
    both+=(network.image_size=64 steps=2 batch_size=4 block=4 echo=1 log_every=1 validation_garments=2 network.embedding=8
        "network.stages=[8,8,16,16]" "network.depths=[1,1,1,1]" network.width=24 network.heads=2 network.mask_width=8)
fi
near() { # name, ninths of the time, settings
    local run=$out/$1 more=()
    [ -f "$run/checkpoint.pt" ] && more+=(--resume)
    OMP_NUM_THREADS=1 swifttailor train picture-reader --data "$sewn/train" --validation "$sewn/validation" \
        --apart "$sewn/test" --out "$run" --workers "$beside" --threads 1 --max-minutes $(((minutes * $2 + 8) / 9)) "${more[@]}" \
        --set "${both[@]}" "${@:3}"
}
step close-plain near plain 3 "${plain[@]}" "${settings[@]}" start="$begin"
step close-all near all 4 "${all[@]}" "${settings[@]}" start="$out/plain/weights.safetensors"
step close-run near run 2 "${falling[@]}" "${settings[@]}" start="$out/all/weights.safetensors"
