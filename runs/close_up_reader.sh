#!/usr/bin/env bash
# The networks that look from near, beside the picture reader: one at necks, waists and ends of sleeves, from its weights, in
# three stages on close-ups alone; and from that one another at the necks of people, where hair is to be told from hoods.
#
#   runs/close_up_reader.sh
#
# After picture_reader.sh, whose garments and weights it takes (START=FILE for other weights, picture_reader.onnx among
# them). steps.sh lists the environment. Small things are learnt where they are alone: plain close-ups first, then those of
# all looks, then the same at a falling rate, at last necks of people. MINUTES (210) are shared 3 to 4 to 2 to 3. The package's
# files have run 40 minutes, 55, 22 and 47 on one core that much else was done on. Ends with
# $WORK/close-up-reader/close_up_reader.onnx and people_neck.onnx, cards beside them.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

minutes=${MINUTES:-210}
begin=${START:-$work/picture-reader/run/weights.safetensors}
sewn=$work/worn out=$work/close-up-reader
both=(network.image_size=96 batch_size=64 block=256 echo=3 validation_garments=60 close=1.0 nothing=0 several=0)
plain=(plain=1.0 studio=0 learning_rate=0.0015 final_rate=0.2 ema=0.995 validate_every=500)
all=(plain=0.35 studio=0.25 learning_rate=0.001 final_rate=0.03 validate_every=500)
neck=(plain=0 studio=0.25 unguessed=0 'parts=["neck"]' variation=0.8 learning_rate=0.0007 ema=0.995 warmup_steps=50
    validate_every=200 losses.masks=1 losses.places=1 losses.view=0.1 echo=2)
falling=(plain=0.35 studio=0.25 learning_rate=0.0008 final_rate=0.02 ema=0.99 warmup_steps=50 validate_every=250 seed=1)
if [ -n "$rehearse" ]; then
    both+=(network.image_size=64 steps=2 batch_size=4 block=4 echo=1 log_every=1 validation_garments=2 network.embedding=8
        "network.stages=[8,8,16,16]" "network.depths=[1,1,1,1]" network.width=24 network.heads=2 network.mask_width=8)
fi
near() { # name, twelfths of the time, settings
    local run=$out/$1 more=()
    [ -f "$run/checkpoint.pt" ] && more+=(--resume)
    OMP_NUM_THREADS=1 swifttailor train picture-reader --data "$sewn/train" --validation "$sewn/validation" \
        --apart "$sewn/test" --out "$run" --workers 1 --threads 1 --max-minutes $(((minutes * $2 + 11) / 12)) "${more[@]}" \
        --set "${both[@]}" "${@:3}"
}
step close-plain near plain 3 "${plain[@]}" "${settings[@]}" start="$begin"
step close-all near all 4 "${all[@]}" "${settings[@]}" start="$out/plain/weights.safetensors"
step close-run near run 2 "${falling[@]}" "${settings[@]}" start="$out/all/weights.safetensors"
step close-neck near neck 3 "${neck[@]}" "${settings[@]}" start="$out/run/weights.safetensors"
step close-exported swifttailor train export "$out/run" --out "$out/close_up_reader.onnx" --overwrite --int8 \
    --data "$sewn/validation" --close-ups neck waist sleeve
step close-neck-exported swifttailor train export "$out/neck" --out "$out/people_neck.onnx" --overwrite --int8 \
    --data "$sewn/validation" --close-ups neck
