#!/usr/bin/env bash
# Prints the path of a working uv; where there is none, fetches it with pip into .uv/ beside this script's
# folder. Works without venv or ensurepip, and where pip refuses to touch the system ("externally managed").
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

works() { "$1" --version >/dev/null 2>&1; }

for candidate in uv "$PWD/.uv/bin/uv" "$HOME/.local/bin/uv" "$HOME/.cargo/bin/uv"; do
    if works "$candidate"; then
        command -v "$candidate"
        exit 0
    fi
done

python=$(command -v python3 || command -v python || true)
if [ -z "$python" ]; then
    echo "Neither uv nor Python was found. Install Python 3.11 or later, or uv (https://docs.astral.sh/uv)." >&2
    exit 1
fi
echo "uv was not found; fetching it with pip into .uv/ ..." >&2
{
    "$python" -m pip install --quiet --target .uv --upgrade uv ||
        { "$python" -m venv .uv && .uv/bin/python -m pip install --quiet uv; } ||
        "$python" -m pip install --quiet --user uv
} >&2
for candidate in "$PWD/.uv/bin/uv" "$("$python" -m site --user-base)/bin/uv"; do
    if works "$candidate"; then
        echo "$candidate"
        exit 0
    fi
done
echo "uv could not be installed with pip. Install it by hand: https://docs.astral.sh/uv" >&2
exit 1
