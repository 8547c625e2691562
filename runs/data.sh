#!/usr/bin/env bash
# The data of all trainings from nothing: patterns, drapes, pictures.
#
#   GARMENTCODE=FOLDER runs/data.sh [PART...]
#   PATTERNS=FOLDER runs/data.sh [PART...]
#
# PART is patterns, drapes or pictures, all without any. steps.sh lists the environment. Interrupted at any moment and
# started again, it goes on where it stopped.
#
# patterns  into $WORK/patterns, by GarmentCode's own programs at the commit below: seeds and split rule are in
#           scripts/arrange_patterns.py. 9,432 patterns take about 21,000 attempts, 2 to 3 hours of one core; the edits
#           another; 600 drafts a minute.
# drapes    into $WORK/garments: about 5 s of a core a pattern, 8 hours of one core for the 6,233 patterns of train,
#           train-2, validation and test.
# pictures  of the drapes, and into $WORK/sewn of garments that GarmentSewer sews (that of the package; SEWER=FILE for
#           another) of SEWN patterns (6000): half a second of a core a garment, as much for its pictures.
source "$(dirname "${BASH_SOURCE[0]}")/steps.sh"

commit=d449629979028123a5c4dc9e732a2ec19b7fce31
few=${rehearse:+12}

patterns() {
    mkdir -p "$work/patterns" "$work/sampled"
    if [ -n "${PATTERNS:-}" ]; then
        step ready-made take_patterns
    elif [ -n "$rehearse" ] && [ -z "${GARMENTCODE:-}" ]; then
        step sampled scripts_sample_drafts "$few" 1 "$work/sampled/1000000.jsonl.gz" "$work/patterns/edits.jsonl.gz"
        step arranged "$python" scripts/arrange_patterns.py --few "$few" "$work/sampled" "$work/patterns"
    else
        require_checkout
        step environment make_environment
        while read -r start count; do
            step "sampled-$start" sample --start "$start" --count "$count" --out "$work/sampled/$start.jsonl.gz"
        done < <("$python" scripts/arrange_patterns.py --series ${few:+--few "$few"})
        local check=(--check runs/designs.txt)
        [ -n "$rehearse" ] && check=(--few "$few")
        step arranged "$python" scripts/arrange_patterns.py "${check[@]}" "$work/sampled" "$work/patterns"
        for split in train validation test; do
            step "edits-$split" sample --edits-of "$work/patterns/$split.jsonl.gz" --out "$work/sampled/edits-$split.jsonl.gz"
        done
        cat "$work"/sampled/edits-{train,validation,test}.jsonl.gz > "$work/patterns/edits.jsonl.gz"
    fi
    step drafts scripts_sample_drafts "${few:-600}" 1000 "$work/patterns/drafts.jsonl.gz" "$work/sampled/draft-edits.jsonl.gz"
    cat "$work/patterns/edits.jsonl.gz" "$work/sampled/draft-edits.jsonl.gz" > "$work/patterns/all-edits.jsonl.gz"
}

take_patterns() {
    (cd "$PATTERNS" && sha256sum --check --quiet) < runs/checksums.txt
    local name
    while read -r _ name; do
        if [ -z "$rehearse" ] || [ "$name" = edits.jsonl.gz ]; then
            cp -f "$PATTERNS/$name" "$work/patterns/$name"
        else  # head ends the pipe before gzip has written all
            { gzip -dc "$PATTERNS/$name" || true; } 2> /dev/null | head -n "$((few / 2))" | gzip -n > "$work/patterns/$name"
        fi
    done < runs/checksums.txt
}

require_checkout() {
    if [ -z "${GARMENTCODE:-}" ] || ! [ -f "$GARMENTCODE/pattern_sampler.py" ]; then
        echo "Give PATTERNS, a folder of the files of runs/checksums.txt, or GARMENTCODE, a checkout:" >&2
        echo "  git clone https://github.com/maria-korosteleva/GarmentCode && git -C GarmentCode checkout $commit" >&2
        exit 2
    fi
    local found
    found=$(git -C "$GARMENTCODE" rev-parse HEAD)
    if [ "$found" != "$commit" ]; then
        echo "'$GARMENTCODE' is at commit $found; the patterns are those of $commit:" >&2
        echo "  git -C $GARMENTCODE checkout $commit" >&2
        exit 2
    fi
}

make_environment() {
    local uv
    uv=$(scripts/find_uv.sh)
    "$uv" venv --quiet --allow-existing "$work/garmentcode-env"
    "$uv" pip install --quiet --python "$work/garmentcode-env/bin/python" -r runs/garmentcode-requirements.txt
}

# PYTHONHASHSEED: GarmentCode writes stitches in the order of sets.
sample() {
    PYTHONHASHSEED=0 OMP_NUM_THREADS=1 "$work/garmentcode-env/bin/python" scripts/sample_garmentcode.py "$GARMENTCODE" \
        --workers "$cores" "$@"
}

scripts_sample_drafts() {
    "$python" scripts/sample_drafts.py --count "$1" --start "$2" --out "$3" --edits "$4"
}

drapes() {
    local split files limits=(--time-limit 30)
    [ -n "$rehearse" ] && limits=(--time-limit 600 --edge-length 6)
    for split in validation test train; do  # those to evaluate with first, so that twins of theirs are refused
        files=("$work/patterns/$split".jsonl.gz)
        [ "$split" = train ] && [ -f "$work/patterns/train-2.jsonl.gz" ] && files+=("$work/patterns/train-2.jsonl.gz")
        step "drapes-$split" build --split "$split" --out "$work/garments" --patterns "${files[@]}" \
            --largest 8000 "${limits[@]}"
    done
}

pictures() {
    local looks=2
    [ -n "$rehearse" ] && looks=8
    step pictures-of-drapes swifttailor data render "$work/garments" --no-plain --random "$looks" --size 128 --workers "$cores"
    local network=(--engine network ${SEWER:+--sewer-weights "$SEWER"} --out "$work/sewn") files
    mapfile -t files < <(training_files)
    local sewn=${SEWN:-6000}
    [ -n "$rehearse" ] && sewn=4
    step sewn-train build "${network[@]}" --split train --patterns "${files[@]}" --limit "$sewn"
    step pictures-of-sewn swifttailor data render "$work/sewn" --no-plain --random 1 --size 128 --workers "$cores"
}

# A few patterns may crash or take too long (exit code 1); a data set that cannot be built is another matter.
build() { swifttailor data build --workers "$cores" "$@" || [ $? -eq 1 ]; }

for part in "${@:-patterns drapes pictures}"; do
    for one in $part; do
        case $one in
            patterns | drapes | pictures) "$one" ;;
            *) echo "'$one' is no part of the data; patterns, drapes and pictures are." >&2; exit 2 ;;
        esac
    done
done
