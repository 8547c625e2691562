"""How well pictures are read."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.evaluation.pictures.reading import SHOWN, ReadPicture, claim_shares, stated_shares
from swifttailor.evaluation.pictures.tables import summary, tables
from swifttailor.picture_reader.labels import statement_labels
from swifttailor.picture_reader.truth import FALSE, TRUE, UNCLEAR

LABELS = statement_labels()
HOOD, NO_HOOD = LABELS.index(("hood", "hood")), LABELS.index(("hood", "none"))
V, ROUND = LABELS.index(("neckline", "v")), LABELS.index(("neckline", "round"))


def picture(
    certain: dict[int, float], judged: dict[int, int], *, number: int = 0, found: bool = True, **more
):
    certainties = np.zeros(len(LABELS), np.float32)
    truths = np.full(len(LABELS), FALSE, np.uint8)
    for k, value in certain.items():
        certainties[k] = value
    for k, value in judged.items():
        truths[k] = value
    look, view = SHOWN[number]
    given = {"panels": True, "mask": 0.8, "off": {"length": 4.0}} | more
    return ReadPicture(0, look, view, found, certainties, truths, **given)


def test_the_likeliest_word_of_a_claim_counts():
    hooded = {HOOD: TRUE, V: UNCLEAR, ROUND: FALSE}
    right = picture({HOOD: 0.6, NO_HOOD: 0.4}, hooded)
    wrong = picture({HOOD: 0.4, NO_HOOD: 0.6}, hooded)
    unseen = picture({HOOD: 0.6}, hooded, found=False)
    shares = claim_shares([right, right, wrong, unseen])
    assert (shares["hood"].good, shares["hood"].of, shares["hood"].value) == (2, 4, 0.5)
    assert "neckline" not in shares, "no word of it is clearly true"
    border = claim_shares([picture({V: 0.9}, {V: UNCLEAR, ROUND: TRUE})])
    assert border["neckline"].value == 1.0, "what is on the border is not false"


def test_of_what_is_sure_so_much_holds():
    pictures = [
        picture({HOOD: 0.95, V: 0.95}, {HOOD: TRUE, V: FALSE, NO_HOOD: FALSE}),
        picture({V: 0.95, ROUND: 0.5}, {V: UNCLEAR, ROUND: TRUE}),
    ]
    held, said = stated_shares(pictures, 0.9)
    assert (held.good, held.of) == (2, 3) and (said.good, said.of) == (1, 2)


def test_tables_show_each_look():
    pictures = [
        picture({HOOD: 0.95}, {HOOD: TRUE}, number=k, off={"length": float(k)}, panels=k < 5)
        for k in range(len(SHOWN))
    ]
    result = summary(pictures)
    assert result["pictures"] == len(SHOWN) and len(result["by_look"]) == len(SHOWN)
    assert result["by_look"]["plain front"]["not_false"] == 1.0
    assert result["by_look"]["held out free"]["panels"] == 0.0
    assert result["measures_cm"]["length"]["plain"] == pytest.approx(0.5)
    text = tables(result)
    assert all(f"{look} {view}" in text for look, view in SHOWN) and "hood" in text


@pytest.mark.needs_torch
def test_the_command_reads_a_split(tmp_path, capsys):
    import json

    import torch

    from swifttailor.cli.main import run
    from swifttailor.pattern import to_specification
    from swifttailor.pattern.drafts import draft
    from swifttailor.picture_reader.export_torch import build_network, export

    lines = [
        json.dumps({"id": n, "pattern": to_specification(draft(n))}) for n in ("t-shirt", "fitted-skirt")
    ]
    (tmp_path / "validation.jsonl").write_text("\n".join(lines))
    command = [
        "data",
        "build",
        "--patterns",
        str(tmp_path / "validation.jsonl"),
        "--out",
        str(tmp_path / "sewn"),
    ]
    assert run([*command, "--engine", "network", "--edge-length", "5", "--workers", "1"]) == 0
    torch.manual_seed(0)
    size = {"image_size": 64, "embedding": 8, "stages": [8, 8, 16, 16], "depths": [1, 1, 1, 1], "width": 24}
    weights = export(build_network(size | {"heads": 2, "mask_width": 8}), {}, tmp_path / "reader.onnx")
    capsys.readouterr()
    command = ["evaluate", "picture-reader", "--weights", str(weights), "--data", str(tmp_path / "sewn")]
    assert run([*command, "--out", str(tmp_path / "out")]) == 0
    shown = capsys.readouterr().out
    assert shown.endswith((tmp_path / "out/tables.txt").read_text()) and "2 of 2 garments" in shown
    result = json.loads((tmp_path / "out/summary.json").read_text())["result"]
    assert result["pictures"] == 2 * len(SHOWN)
    assert all(0 <= group["mask"] <= 1 for group in result["by_look"].values())
