"""Loose tops: front and back have equal room over the hips, and both side seams are equally long."""

import numpy as np
import pytest

import swifttailor
from swifttailor import Body
from swifttailor.pattern.drafts.figure import Figure

FIGURE = Figure.of(Body.default().measurements)


def hem_half(pattern: swifttailor.Pattern, side: str) -> float:
    """Half of the width of the hem of the left front or back, cm."""
    corners = pattern.panel(f"left_{side}torso").vertices
    return float(np.abs(corners[corners[:, 1] < corners[:, 1].min() + 8.0, 0]).max())


@pytest.mark.parametrize("options", [{}, {"waist_shaping": 3.0, "chest_ease": 3.0}, {"flare": 12.0}])
def test_front_and_back_have_equal_room_at_the_hem(options: dict[str, float]) -> None:
    pattern = swifttailor.draft("t-shirt", length=22.0, **options)
    body = FIGURE.girth_below_waist(22.0)
    front, back = (hem_half(pattern, side) for side in "fb")
    assert front - body.front == pytest.approx(back - body.back, abs=0.05)
    assert front + back > body.front + body.back + 1.0


def test_bent_sides_end_wider_than_straight_ones() -> None:
    straight, bent = (
        swifttailor.draft("t-shirt", length=22.0, chest_ease=3.0, waist_shaping=w) for w in (0.0, 3.0)
    )

    assert sum(hem_half(bent, s) for s in "fb") >= sum(hem_half(straight, s) for s in "fb") + 1.0


@pytest.mark.parametrize("name", ["shirt", "polo-shirt"])
def test_close_shirts_bend_in_and_have_room_at_the_hips(name: str) -> None:
    shirt = swifttailor.draft(name, chest_ease=4.0, waist_shaping=2.5)
    body = FIGURE.girth_below_waist(22.0)
    assert 2 * sum(hem_half(shirt, side) for side in "fb") >= body.girth + 4.0
    straight = swifttailor.draft(name, chest_ease=4.0)
    assert sum(hem_half(shirt, s) for s in "fb") > sum(hem_half(straight, s) for s in "fb")


@pytest.mark.parametrize("name", ["denim-jacket", "bomber-jacket"])
def test_bands_of_short_jackets_lie_close(name: str) -> None:
    jacket = swifttailor.draft(name)
    low = [jacket.panel(f"wb_{side}").vertices for side in ("front", "back")]
    band = sum(float(np.ptp(corners[:, 0])) for corners in low)
    assert band < FIGURE.girth_below_waist(14.0).girth + 4.0


def test_close_camisoles_bend_in_and_have_equal_room_at_the_hem() -> None:
    close = swifttailor.draft("camisole", chest_ease=3.0, flare=0.0, waist_shaping=2.0)
    body = FIGURE.girth_below_waist(20.0)
    front, back = (hem_half(close, side) for side in "fb")
    assert front - body.front == pytest.approx(back - body.back, abs=0.05)
    assert front + back > body.front + body.back


@pytest.mark.parametrize("name", ["t-shirt", "shirt", "sweatshirt"])
def test_very_wide_tops_narrow_to_the_hem_and_others_do_not(name: str) -> None:
    wide, wider = (swifttailor.draft(name, chest_ease=ease, length=32.0) for ease in (18.0, 34.0))
    grown = sum(hem_half(wider, side) - hem_half(wide, side) for side in "fb")
    assert 1.0 < grown < 0.5 * (34.0 - 18.0) / 2 + 0.5
    flared = swifttailor.draft("t-shirt", chest_ease=34.0, length=32.0, flare=4.0)
    plain = swifttailor.draft("t-shirt", chest_ease=34.0, length=32.0)
    assert sum(hem_half(flared, side) - hem_half(plain, side) for side in "fb") > 6.0


@pytest.mark.parametrize("options", [{"waist_shaping": 1.0}, {"waist_shaping": 2.5, "stretch": 5.0}, {}])
def test_tops_of_jersey_leave_little_room_over_the_hips(options: dict[str, float]) -> None:
    top = swifttailor.draft("t-shirt", length=22.0, chest_ease=8.0, **options)
    body = FIGURE.for_cloth(options.get("stretch", 0.0) / 100).girth_below_waist(22.0)
    room = 2 * sum(hem_half(top, side) for side in "fb") - body.girth
    assert 2.0 < room < 6.0


def test_loose_tops_of_jersey_narrow_to_the_hem() -> None:
    loose, usual = (swifttailor.draft("t-shirt", length=22.0, chest_ease=ease) for ease in (16.0, 8.0))
    assert sum(hem_half(loose, side) - hem_half(usual, side) for side in "fb") < 2.0
