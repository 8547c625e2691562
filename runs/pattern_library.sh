#!/usr/bin/env bash
# The library of known patterns from nothing: patterns, what is true of each, a choice of them.
#
#   GARMENTCODE=FOLDER runs/pattern_library.sh
#
# steps.sh lists the environment, data.sh says how long the patterns take. Then they are measured, 0.05 s of a core
# each; comparing 15,000 takes 10 minutes, checking those that are chosen another 15. USUAL is a list of files of
# patterns that people wear; without it all are from the training patterns. COUNT (12000) says how many there are.
# Ends with $WORK/pattern-library/known_patterns.zip and its card beside it.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

count=${COUNT:-12000} wanted=6000
if [ -n "$rehearse" ]; then
    count=6 wanted=6
fi

runs/data.sh patterns
mapfile -t files < <(training_files)
usual=()
read -ra worn <<< "${USUAL:-}"
[ ${#worn[@]} -gt 0 ] && usual=(--usual "${worn[@]}")
step library-made "$python" scripts/make_pattern_library.py --patterns "${files[@]}" "${usual[@]}" \
    --apart "$work/patterns/validation.jsonl.gz" "$work/patterns/test.jsonl.gz" --count "$count" --wanted "$wanted" \
    --cache "$work/measured" --out "$work/pattern-library/known_patterns.zip"
