"""Words to garments with the weights of the package: what is asked for is what the files hold."""

from __future__ import annotations

import pytest
from soundness import MADE_FILES, assert_sound, contents

from swifttailor.cli.main import run
from swifttailor.describing import Claim

PROMPTS: dict[str, dict[str, str | float]] = {
    "a sleeveless midi dress with a square neckline": {
        "kind": "dress", "sleeves": "none", "skirt_hem": "midi", "neckline": "square",
    },
    "a long-sleeved top with a V neck": {"kind": "top", "sleeves": "long", "neckline": "v"},
    "a hoodie with long sleeves that reaches the hips": {
        "kind": "top", "hood": "hood", "sleeves": "long", "top_hem": "hip",
    },
    "ankle-length trousers with wide legs": {"kind": "trousers", "leg_hem": "ankle", "legs": "wide"},
    "a pair of shorts": {"kind": "shorts"},
    "a knee-length pencil skirt with a slit at the back": {
        "kind": "skirt", "skirt_hem": "knee", "skirt": "pencil", "slit": "back",
    },
    "a floor-length circle skirt": {"kind": "skirt", "skirt": "circle", "skirt_hem": "floor"},
    "a sleeveless jumpsuit with straight legs": {"kind": "jumpsuit", "sleeves": "none", "legs": "straight"},
    "a strapless mini dress": {"kind": "dress", "shoulders": "strapless", "skirt_hem": "mini"},
    "a cropped top with short sleeves and a round neck": {
        "kind": "top", "top_hem": "cropped", "sleeves": "short", "neckline": "round",
    },
    "a maxi dress with a gathered skirt and elbow-length sleeves": {
        "kind": "dress", "skirt_hem": "maxi", "skirt": "gathered", "sleeves": "elbow",
    },
    "a skirt 60 cm long with a 5 cm waistband": {
        "kind": "skirt", "skirt_length_cm": 60.0, "waistband_cm": 5.0,
    },
    "a knee-length dress with a stand collar and three-quarter sleeves": {
        "kind": "dress", "skirt_hem": "knee", "collar": "stand", "sleeves": "three-quarter",
    },
}  # fmt: skip
"""What each text asks for, written by hand and measured on the pattern that was written to the disk."""


@pytest.mark.parametrize("text", PROMPTS)
def test_what_is_asked_for_is_made(text, tmp_path, capsys):
    out = tmp_path / "out"
    assert run(["generate", text, "--out", str(out), "--no-preview"]) == 0
    _, facts, report = assert_sound(out, MADE_FILES)
    missed = {n: v for n, v in PROMPTS[text].items() if not Claim(n, v).holds(facts)}
    assert not missed
    assert len(report["wishes"]) >= len(PROMPTS[text])
    assert all(wish["holds"] for wish in report["wishes"])


def test_the_same_seed_makes_the_same_bytes_and_another_a_different_garment(tmp_path, capsys):
    made = []
    for name, seed in (("one", "7"), ("again", "7"), ("other", "8")):
        arguments = ["--out", str(tmp_path / name), "--no-preview", "--seed", seed, "--temperature", "1"]
        assert run(["generate", "a dress with sleeves", *arguments]) in (0, 1)
        made.append(contents(tmp_path / name))
    assert made[0] == made[1]
    assert made[0]["pattern.json"] != made[2]["pattern.json"]


def test_a_picture_alone_and_with_words(tmp_path, shipped_patterns, capsys):
    """The picture is of a garment that was sewn a moment before."""
    from PIL import Image

    from swifttailor import Body, sew
    from swifttailor.looks import draw_look, plain_look

    seen = draw_look(
        sew(shipped_patterns["gc_1002218"]).garment, Body.default(), plain_look("front"), size=256
    )
    Image.fromarray(seen).save(tmp_path / "trousers.png")
    photo = str(tmp_path / "trousers.png")
    assert run(["generate", "--image", photo, "--out", str(tmp_path / "alone"), "--no-preview"]) in (0, 1)
    _, facts, report = assert_sound(tmp_path / "alone", MADE_FILES | {"seen.png"})
    assert Claim("kind", "trousers").holds(facts)
    assert report["pictures"]["part"] == "lower" and report["writing"]["refinement"]["compared"] >= 2
    arguments = ["trousers to the knee", "--image", photo, "--out", str(tmp_path / "both"), "--no-preview"]
    assert run(["generate", *arguments]) in (0, 1), (
        "1 where something of the picture cannot be had beside the words"
    )
    _, facts, _ = assert_sound(tmp_path / "both", MADE_FILES | {"seen.png"})
    assert Claim("leg_hem", "knee").holds(facts)
