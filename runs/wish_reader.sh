#!/usr/bin/env bash
# The wish reader and the reader of people's own words from nothing: patterns, two trainings, the model files.
#
#   GARMENTCODE=FOLDER runs/wish_reader.sh
#
# steps.sh lists the environment, data.sh says how long the patterns take. Then they are measured, 0.15 s of a core
# each, once for these networks and PatternMaker. The first training is 5,000 steps from random weights, half an hour of
# one core of a server (MINUTES ends it earlier). The second goes on from a sentence encoder, all-MiniLM-L6-v2, of which
# scripts/take_sentence_encoder_torch.py says where it is to be had: MINILM is the folder with its vocab.txt and
# model.safetensors; without it, it goes on from the package's weights. Texts in people's own words (runs/spoken) are among
# those that are composed: 1,600 steps, an hour. Both go on where they were interrupted. Ends with
# $WORK/wish-reader/wish_reader.onnx, $WORK/spoken-reader/spoken_reader.onnx and their cards.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

set_values steps=5000
more=()
[ -n "${MINUTES:-}" ] && more+=(--max-minutes "$MINUTES")
spoken=()
if [ -n "$rehearse" ]; then
    little=(batch_size=8 validate_every=4 log_every=2 validation_texts=20)
    set_values steps=8 "${little[@]}" network.width=16 network.layers=1
    spoken+=(steps=4 warmup_steps=2 "${little[@]}")
fi

runs/data.sh patterns
mapfile -t files < <(training_files)
given=(--patterns "${files[@]}" --validation "$work/patterns/validation.jsonl.gz" --apart "$work/patterns/test.jsonl.gz"
    --edits "$work/patterns/all-edits.jsonl.gz" --cache "$work/measured" --threads 1 "${more[@]}")
step reader-trained train wish-reader "${given[@]}" --config small --set "${settings[@]}"
step reader-exported swifttailor train export "$work/wish-reader/run" --out "$work/wish-reader/wish_reader.onnx" --overwrite --half
if [ -n "${MINILM:-}" ]; then
    step encoder-taken "$python" scripts/take_sentence_encoder_torch.py "$MINILM" \
        --list src/swifttailor/networks/word_pieces.txt --start "$work/minilm.safetensors"
    spoken+=("start=$work/minilm.safetensors")
else
    spoken+=(start=src/swifttailor/wishes/spoken_reader.onnx)
fi
step spoken-trained train_into spoken-reader wish-reader "${given[@]}" --spoken runs/spoken/*.jsonl --config spoken --set "${spoken[@]}"
step spoken-exported swifttailor train export "$work/spoken-reader/run" --out "$work/spoken-reader/spoken_reader.onnx" --overwrite --int8
