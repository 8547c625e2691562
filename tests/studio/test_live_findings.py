"""While something is dragged, findings are those of what is drawn, not of what was mended to be sewn."""

from __future__ import annotations

import gzip
import json
from pathlib import Path

SAMPLES = Path(__file__).parents[1] / "garmentcode_patterns" / "patterns.jsonl.gz"


def test_a_fault_that_sewing_mends_for_itself_is_found(client):
    """The point of a dart lies 3 mm outside the hem."""
    with gzip.open(SAMPLES, "rt") as lines:
        samples = {s["id"]: s["pattern"] for s in map(json.loads, lines)}
    pattern = samples["gc_1000067"]
    pattern["pattern"]["panels"]["pant_b_l"]["vertices"][6][1] = -0.3
    body = {"client": "tests-findings", "sequence": 1, "pattern": pattern}
    answer = client.post("/api/live", json=body).json()
    assert answer["status"] == "sewn" and answer["mesh"]
    assert [(f["code"], f["panel"]) for f in answer["findings"]] == [("near-crossing", "pant_b_l")]
    assert answer["findings"][0]["points"]
