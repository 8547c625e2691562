#!/usr/bin/env bash
# PatternMaker from nothing: patterns, pictures, a training from random weights, the model file.
#
#   GARMENTCODE=FOLDER runs/pattern_maker.sh
#
# steps.sh lists the environment, data.sh says how long the data take. Then the patterns are measured, 0.15 s of a core
# each. The training takes MINUTES (380: what that of the package has had, in several trainings, on one core of a server),
# on a GPU where there is one, else in a process for each of the CORES, their layers compiled where there is a C++
# compiler; it goes on where it was interrupted. Ends with $WORK/pattern-maker/pattern_maker.zip and its card beside it.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

set_values losses.numbers=4 losses.foresight=8 tasks.text=0.3 tasks.image=0.2 tasks.text_image=0.25 tasks.edit=0.25 \
    own_numbers=0.6
more=()
measure=(--data "$work/garments")  # how sure it is of pictures
if [ -n "$rehearse" ]; then
    set_values steps=4 batch_size=2 reads=2 validate_every=2 log_every=1 validation_samples=2 network.image_size=32 \
        network.hidden_size=16 network.layers=1 network.heads=2 network.key_value_heads=1 \
        network.intermediate_size=16 network.vision_hidden_size=16 network.vision_layers=1 network.vision_heads=2
    measure=()  # one that has learnt nothing writes hundreds of patterns of full length
elif ! nvidia-smi > /dev/null 2>&1; then
    if [ "$cores" -gt 1 ]; then
        launch=("$python" -m torch.distributed.run --nproc_per_node "$cores" -m swifttailor)
        more+=(--threads 1)
    fi
    command -v g++ > /dev/null && set_values compiled=true
fi

runs/data.sh
mapfile -t files < <(training_files)
step maker-trained train pattern-maker --patterns "${files[@]}" --validation "$work/patterns/validation.jsonl.gz" \
    --apart "$work/patterns/test.jsonl.gz" --edits "$work/patterns/all-edits.jsonl.gz" --cache "$work/measured" \
    --data "$work/garments" "$work/sewn" --config small --max-minutes "${MINUTES:-380}" "${more[@]}" \
    --set "${settings[@]}"
step maker-exported swifttailor train export "$work/pattern-maker/run" --out "$work/pattern-maker/pattern_maker.zip" --overwrite \
    --half "${measure[@]}"
