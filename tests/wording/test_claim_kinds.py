"""What claims say about kinds, claim by claim."""

from __future__ import annotations

from swifttailor.describing.claims import CLAIM_TYPES
from swifttailor.wording.claim_kinds import fits_kind, implied_kind


def test_what_only_legs_or_skirts_have_says_so():
    for name in CLAIM_TYPES:
        of_legs = name.startswith(("leg_", "legs", "inseam"))
        of_skirts = name.startswith(("skirt", "slit", "tiers", "gores", "godet", "hem_cm"))
        assert fits_kind(name, "trousers") or not of_legs, name
        assert fits_kind(name, "skirt") or not of_skirts, name
        assert not (fits_kind(name, "top") and (of_legs or of_skirts)), name
        if name.startswith(("sleeve", "neck", "collar", "shoulders", "straps", "chest", "top_hem")):
            assert fits_kind(name, "top") and not fits_kind(name, "skirt"), name


def test_parts_tell_the_kind():
    def kind(*names):
        return implied_kind([type("Of", (), {"name": name}) for name in names])

    assert kind("legs") == ("trousers",) and kind("legs", "sleeves") == ("jumpsuit",)
    assert kind("godets") == ("skirt",) and kind("gores", "neckline") == ("dress",)
    assert kind("hood") == ("top",) and kind("rise") == ()
