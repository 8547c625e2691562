# What the recipes share; each begins with `source steps.sh`. Set in the environment:
#
#   WORK        folder for everything that is made (out/training)
#   PATTERNS    folder of ready-made patterns, those of runs/checksums.txt: nothing is sampled
#   GARMENTCODE checkout of github.com/maria-korosteleva/GarmentCode, to sample them from, where PATTERNS is not given
#   PYTHON      an interpreter with swifttailor[train] (python)
#   CORES       processor cores to use (all)
#   MINUTES     of training, for a recipe of one network; without it what the recipe says
#   START       weights to begin with, of another run or a model file; random ones without it
#   REHEARSE    1: everything in little, in some minutes: 12 of this package's drafts where neither PATTERNS nor
#               GARMENTCODE is given, tiny networks, a few steps. It shows that all parts fit, and learns nothing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

rehearse=${REHEARSE:-}
work=${WORK:-out/training${rehearse:+-rehearsal}}
python=${PYTHON:-python}
cores=${CORES:-$(nproc)}
# Processes that draw pictures beside a training on one core. To start one takes longer than what a rehearsal draws.
beside=${rehearse:+0}
beside=${beside:-1}
# Waiting threads that spin make training many times slower where something else runs as well.
export OMP_WAIT_POLICY=PASSIVE GOMP_SPINCOUNT=0
mkdir -p "$work/done"

swifttailor() { "$python" -m swifttailor "$@"; }

# step NAME COMMAND...: runs a command once, and says how long it took; a recipe that is started again goes on with
# the step that was interrupted.
step() {
    local name=$1 began=$SECONDS
    shift
    if [ -e "$work/done/$name" ]; then
        echo "== $name: done before, in $(cat "$work/done/$name") s"
        return
    fi
    echo "== $name"
    "$@"
    echo $((SECONDS - began)) > "$work/done/$name"
    echo "== $name: $((SECONDS - began)) s"
}

# The patterns to train on.
training_files() { ls "$work"/patterns/train*.jsonl.gz "$work/patterns/drafts.jsonl.gz"; }

# train NETWORK OPTIONS...: a training, or the rest of one, into $work/NETWORK/run.
train() { train_into "$1" "$@"; }

# train_into FOLDER NETWORK OPTIONS...: the same into $work/FOLDER/run.
train_into() {
    local out=$work/$1/run more=()
    [ -f "$out/checkpoint.pt" ] && more+=(--resume)
    "${launch[@]}" train "$2" --out "$out" --workers "$cores" "${@:3}" "${more[@]}"
}
launch=("$python" -m swifttailor)

# set_values FIELD=VALUE...: for the configuration; what is set later counts.
settings=()
set_values() { settings+=("$@"); }
[ -n "${START:-}" ] && set_values "start=$START"
true
