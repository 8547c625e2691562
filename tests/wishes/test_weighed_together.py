"""What is asked for, weighed against what else is."""

from __future__ import annotations

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.corrections.weighed_together import (
    other_slits,
    weighed_all,
    without_flare,
    without_flared_legs,
)
from swifttailor.wishes.drafts.refused_looks import as_not_refused
from swifttailor.wishes.reader import Wish

FROM_THE_KNEE, KNEE = Claim("skirt", "fitted base"), Claim("skirt_hem", "knee")
CLOSE, LOOSE = Claim("hips", "close"), Claim("fit", "loose")


def wished(*claims: Claim, certainty: float = 0.99) -> list[Wish]:
    return [Wish(Gain(claim), certainty) for claim in claims]


def test_what_flares_from_the_knee_hardly_ends_there():
    likely = wished(KNEE, certainty=0.5)
    assert without_flare([*wished(FROM_THE_KNEE), *likely]) == tuple(wished(FROM_THE_KNEE))
    assert without_flare(wished(FROM_THE_KNEE, KNEE)) == tuple(wished(FROM_THE_KNEE, KNEE))
    assert without_flare(likely) == tuple(likely)


def test_gores_that_flare_from_the_knee_are_no_flounce():
    gored = wished(Claim("skirt", "gored"))
    assert weighed_all([*gored, *wished(FROM_THE_KNEE)], ()) == tuple(gored)
    assert weighed_all(wished(FROM_THE_KNEE), ()) == tuple(wished(FROM_THE_KNEE))


def test_a_loose_one_of_a_close_name_is_not_close():
    assert weighed_all(wished(LOOSE, CLOSE), {CLOSE}) == tuple(wished(LOOSE))
    assert weighed_all(wished(LOOSE, CLOSE), ()) == tuple(wished(LOOSE, CLOSE))


def test_one_slit_is_refused_elsewhere():
    left = [Claim("slit", "left")]
    assert Claim("slit", "right") in other_slits("a skirt with a side slit", left)
    assert not other_slits("a skirt with a slit on each side", left)
    assert not other_slits("side slits", left)


def test_a_v_that_must_not_be_deep_is_shallow():
    draft = NamedDraft.parse("t-shirt(neckline=v;neck_depth=16)")
    assert dict(as_not_refused(draft, [Claim("neck_depth", "low")]).options)["neck_depth"] == 12.5
    assert as_not_refused(draft, []) == draft


def test_a_slit_on_the_side_is_one():
    both = [Claim("slit", "left"), Claim("slit", "right")]
    assert other_slits("a skirt w/ slit on the side", both) == (Claim("slit", "right"),)
    assert not other_slits("a skirt with slits on the sides", both)
    assert not other_slits("a shirt with a slit on the side", [*both, Claim("kind", "top")])


def test_wide_legs_that_taper_are_roomy_at_the_hips():
    wide, tapered, roomy = Claim("legs", "wide"), Claim("legs", "tapered"), Claim("hips", "loose")
    found = without_flared_legs(wished(wide, tapered), ())
    assert [wish.change for wish in found] == [Gain(tapered), Gain(roomy)]
    cuffed = wished(wide, tapered, Claim("leg_cuffs", "band"))
    assert without_flared_legs(cuffed, ()) == tuple(cuffed)
