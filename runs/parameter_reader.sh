#!/usr/bin/env bash
# The parameter reader from nothing: patterns with their design parameters, what is read in pictures of some, a training.
#
#   GARMENTCODE=FOLDER runs/parameter_reader.sh
#
# steps.sh lists the environment, data.sh says how long the patterns take. MORE is a list of files of further patterns with
# designs (scripts/sample_garmentcode.py), SEWN one of splits of sewn garments, such as those of picture_reader.sh, of
# which 1,000 each are read. Patterns are measured, 0.05 s of a core each, pictures read, 0.1 s each; the training is some
# minutes of one core. Ends with $WORK/parameter-reader/parameter_reader.onnx and its card beside it.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

runs/data.sh patterns
mapfile -t files < <(training_files)
read -ra more <<< "${MORE:-}"
read -ra sewn <<< "${SEWN:-}"
options=(--patterns "${files[@]}" "${more[@]}" --most-read 1000)
if [ -n "$rehearse" ]; then  # the drafts of a rehearsal have no parameters; some designs are drawn by lot
    options=(--draw 40 --steps 4)
fi
[ ${#sewn[@]} -gt 0 ] && options+=(--data "${sewn[@]}")
mkdir -p "$work/parameter-reader"
step parameter-reader-made "$python" scripts/train_parameter_reader_torch.py "${options[@]}" \
    --apart "$work/patterns/validation.jsonl.gz" "$work/patterns/test.jsonl.gz" --cache "$work/measured" \
    --out "$work/parameter-reader/parameter_reader.onnx"
