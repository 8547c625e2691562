#!/usr/bin/env bash
# The wish reader and the reader of people's own words from nothing: patterns, two trainings, the model files.
#
#   GARMENTCODE=FOLDER runs/wish_reader.sh
#
# steps.sh lists the environment, data.sh says how long the patterns take. Then they are measured, 0.15 s of a core
# each, once for these networks and PatternMaker. The first training is 5,000 steps from random weights, half an hour of
# one core of a server (MINUTES ends it earlier). The second goes on from there, with texts in people's own words
# (runs/spoken) among those that are composed: 5,600 steps, an hour. Both go on where they were interrupted. Ends with
# $WORK/wish-reader/wish_reader.onnx, $WORK/spoken-reader/spoken_reader.onnx and their cards.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

set_values steps=5000
more=()
[ -n "${MINUTES:-}" ] && more+=(--max-minutes "$MINUTES")
spoken=(steps=5600 "start=$work/wish-reader/run/weights.safetensors")
if [ -n "$rehearse" ]; then
    little=(steps=8 batch_size=8 validate_every=4 log_every=2 validation_texts=20 network.width=16 network.layers=1)
    set_values "${little[@]}"
    spoken+=("${little[@]}")
fi

runs/data.sh patterns
mapfile -t files < <(training_files)
given=(--patterns "${files[@]}" --validation "$work/patterns/validation.jsonl.gz" --apart "$work/patterns/test.jsonl.gz"
    --edits "$work/patterns/all-edits.jsonl.gz" --cache "$work/measured" --threads 1 "${more[@]}")
step reader-trained train wish-reader "${given[@]}" --config small --set "${settings[@]}"
step reader-exported swifttailor train export "$work/wish-reader/run" --out "$work/wish-reader/wish_reader.onnx" --overwrite --half
step spoken-trained train_into spoken-reader wish-reader "${given[@]}" --spoken runs/spoken/*.jsonl --config spoken --set "${spoken[@]}"
step spoken-exported swifttailor train export "$work/spoken-reader/run" --out "$work/spoken-reader/spoken_reader.onnx" --overwrite --half
