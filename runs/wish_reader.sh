#!/usr/bin/env bash
# The wish reader from nothing: patterns, a training from random weights, the model file.
#
#   GARMENTCODE=FOLDER runs/wish_reader.sh
#
# steps.sh lists the environment, data.sh says how long the patterns take. Then they are measured, 0.15 s of a core
# each, once for this network and PatternMaker. The training is 5,000 steps, half an hour of one core of a server (MINUTES
# ends it earlier); it goes on where it was interrupted. Ends with $WORK/wish-reader/wish_reader.onnx and its card beside
# it.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

set_values steps=5000
more=()
[ -n "${MINUTES:-}" ] && more+=(--max-minutes "$MINUTES")
if [ -n "$rehearse" ]; then
    set_values steps=8 batch_size=8 validate_every=4 log_every=2 validation_texts=20 network.width=16 network.layers=1
fi

runs/data.sh patterns
mapfile -t files < <(training_files)
step reader-trained train wish-reader --patterns "${files[@]}" --validation "$work/patterns/validation.jsonl.gz" \
    --apart "$work/patterns/test.jsonl.gz" --edits "$work/patterns/all-edits.jsonl.gz" --cache "$work/measured" \
    --spoken "$(dirname "${BASH_SOURCE[0]}")"/spoken/*.jsonl \
    --config small --threads 1 "${more[@]}" --set "${settings[@]}"
step reader-exported swifttailor train export "$work/wish-reader/run" --out "$work/wish-reader/wish_reader.onnx" --overwrite --half
