"""Writes the model file of a reader of people's own words anew, without training it again.

``python scripts/export_spoken_reader_torch.py [FILE] [--out FILE]``

The weights are those that the file holds, rounded to bytes already; the graph is what this version's
``swifttailor train export --int8`` writes. The JSON card says what it did, with the checksum of the new file.
"""

from __future__ import annotations

import argparse
import hashlib
import json
from pathlib import Path

from swifttailor.cli.train_export import MOST_APART_INT8
from swifttailor.networks.byte_storage import round_to_bytes
from swifttailor.networks.graph_weights_torch import graph_weights
from swifttailor.networks.half_storage import round_to_half
from swifttailor.wishes.export_torch import build_network, compare, export
from swifttailor.wishes.reader import SHIPPED_SPOKEN, WishReader


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("file", type=Path, nargs="?", default=SHIPPED_SPOKEN)
    parser.add_argument("--out", type=Path, help="the same file, where it is not given")
    options = parser.parse_args()
    out = options.out or options.file
    beside = json.loads(options.file.with_suffix(".json").read_text(encoding="utf-8"))
    card = WishReader.load_spoken(options.file).card
    network = build_network(card["config"]["network"]).eval()
    network.load_state_dict(graph_weights(options.file, network))
    round_to_half(network)
    round_to_bytes(network)
    export(network, card, out, int8=True)
    apart, reach = compare(WishReader.load_spoken(out), network)
    assert apart < MOST_APART_INT8 * reach, (apart, reach)
    written = out.read_bytes()
    beside["file"] = {"bytes": len(written), "sha256": hashlib.sha256(written).hexdigest()}
    out.with_suffix(".json").write_text(
        json.dumps(beside, indent=1, allow_nan=False) + "\n", encoding="utf-8"
    )
    print(
        f"Wrote {out}, {len(written) / 1e6:.1f} MB; at most {apart:.2g} of {reach:.2g} from torch's logits."
    )


if __name__ == "__main__":
    main()
