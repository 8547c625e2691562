#!/usr/bin/env bash
# From patterns to the small PatternMaker: training, model file.
#
#   runs/pattern_maker_small.sh [WORK [MINUTES]]
#
# WORK (out/pattern-maker) holds the run and the model file; MINUTES (240) is for the training alone. Goes on where it
# was interrupted when it is started again. Before the training the patterns are measured once, 0.15 s of a core each;
# on a GPU the same script uses it. GARMENTCODE names the folder of the patterns (train.jsonl.gz, validation.jsonl.gz,
# edits.jsonl.gz); DATA, where it is given, a data set with renders of them (swifttailor data build, data render), for
# patterns from pictures.
set -euo pipefail

work=${1:-out/pattern-maker}
minutes=${2:-240}
patterns=${GARMENTCODE:-../shared/garmentcode}
# Waiting threads that spin make training many times slower where something else runs as well.
export OMP_WAIT_POLICY=PASSIVE GOMP_SPINCOUNT=0

files=("$patterns/train.jsonl.gz")
[ -f "$patterns/train-2.jsonl.gz" ] && files+=("$patterns/train-2.jsonl.gz")
more=()
[ -f "$patterns/edits.jsonl.gz" ] && more+=(--edits "$patterns/edits.jsonl.gz")
pictures=()
[ -n "${DATA:-}" ] && pictures=(--data "$DATA")
[ -f "$work/run/checkpoint.pt" ] && more+=(--resume)
swifttailor train pattern-maker --patterns "${files[@]}" --validation "$patterns/validation.jsonl.gz" \
    --out "$work/run" --config small --max-minutes "$minutes" --workers 2 "${more[@]}" "${pictures[@]}"
swifttailor train export "$work/run" --out "$work/pattern_maker.zip" "${pictures[@]}"
