#!/usr/bin/env bash
# From patterns to the small PatternMaker: pictures, training, model file.
#
#   runs/pattern_maker_small.sh [WORK [MINUTES]]
#
# WORK (out/pattern-maker) holds the pictures, the run and the model file; MINUTES (240) is for the training alone. Goes
# on where it was interrupted when it is started again. GARMENTCODE names the folder of the patterns (train.jsonl.gz,
# validation.jsonl.gz, edits.jsonl.gz). DATA may name a data set with renders of them (swifttailor data build, data
# render); without it PICTURED (3000) of the garments are sewn by GarmentSewer and drawn, 0.5 s of a core each. Before
# the training the patterns are measured once, 0.15 s of a core each. MORE names further files of patterns to learn from,
# such as scripts/sample_garmentcode.py and scripts/sample_drafts.py write, and EDITS another file of edits than that of
# GARMENTCODE. On a GPU the same script uses it; without one, PROCESSES (2) processes train
# together, a core each, their layers compiled where there is a C++ compiler.
set -euo pipefail

work=${1:-out/pattern-maker}
minutes=${2:-240}
patterns=${GARMENTCODE:-../shared/garmentcode}
processes=${PROCESSES:-2}
# Waiting threads that spin make training many times slower where something else runs as well.
export OMP_WAIT_POLICY=PASSIVE GOMP_SPINCOUNT=0

files=("$patterns/train.jsonl.gz")
[ -f "$patterns/train-2.jsonl.gz" ] && files+=("$patterns/train-2.jsonl.gz")
read -r -a sampled <<< "${MORE:-}"
files+=("${sampled[@]}")
if [ -z "${DATA:-}" ]; then
    DATA=$work/pictures
    swifttailor data build --engine network --patterns "$patterns/validation.jsonl.gz" --split validation --out "$DATA"
    swifttailor data build --engine network --patterns "${files[@]}" --limit "${PICTURED:-3000}" --split train --out "$DATA"
    swifttailor data render "$DATA" --no-plain --random 1 --size 128
fi

train=(swifttailor)
more=()
if ! nvidia-smi > /dev/null 2>&1 && [ "$processes" -gt 1 ]; then
    train=(torchrun --nproc_per_node "$processes" -m swifttailor)
    more+=(--threads 1)
fi
command -v g++ > /dev/null && more+=(--set compiled=true)
edits=${EDITS:-$patterns/edits.jsonl.gz}
[ -f "$edits" ] && more+=(--edits "$edits")
[ -f "$patterns/test.jsonl.gz" ] && more+=(--apart "$patterns/test.jsonl.gz")
[ -f "$work/run/checkpoint.pt" ] && more+=(--resume)
"${train[@]}" train pattern-maker --patterns "${files[@]}" --validation "$patterns/validation.jsonl.gz" --data "$DATA" \
    --out "$work/run" --config small --max-minutes "$minutes" --workers 2 "${more[@]}"
swifttailor train export "$work/run" --out "$work/pattern_maker.zip" --half --data "$DATA"
