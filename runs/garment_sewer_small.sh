#!/usr/bin/env bash
# From patterns to the small GarmentSewer: data, training, model file.
#
#   runs/garment_sewer_small.sh [WORK [MINUTES]]
#
# WORK (out/garment-sewer) holds the data set, the run and the model file; MINUTES (150) is for the training alone.
# Everything goes on where it was interrupted when it is started again. On two CPU cores the data take about 5 s a
# pattern on each, the training what MINUTES says; on a GPU the same script uses it. GARMENTCODE names the folder of
# the patterns (train.jsonl.gz, validation.jsonl.gz).
set -euo pipefail

work=${1:-out/garment-sewer}
minutes=${2:-150}
patterns=${GARMENTCODE:-../shared/garmentcode}
# Waiting threads that spin make training many times slower where something else runs as well.
export OMP_WAIT_POLICY=PASSIVE GOMP_SPINCOUNT=0

for split in train validation; do
    files=("$patterns/$split".jsonl.gz)
    [ "$split" = train ] && [ -f "$patterns/train-2.jsonl.gz" ] && files+=("$patterns/train-2.jsonl.gz")
    swifttailor data build --patterns "${files[@]}" --out "$work/data" --split "$split" ||
        [ $? -eq 1 ]  # a few patterns crashed or took too long
done

resume=()
[ -f "$work/run/checkpoint.pt" ] && resume=(--resume)
swifttailor train garment-sewer --data "$work/data" --out "$work/run" --config small \
    --max-minutes "$minutes" --workers 2 "${resume[@]}"
swifttailor train export "$work/run" --out "$work/garment_sewer.onnx" --half
