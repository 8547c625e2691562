"""Garments as shops name them, with what a dictionary of fashion says of them."""

from __future__ import annotations

import time

import pytest

from swifttailor.describing import Claim
from swifttailor.wording import read_words

NAMES = """
milkmaid midi dress      : kind=dress skirt_hem=midi neckline=square sleeve_shape=puffed skirt=gathered
prairie maxi dress       : kind=dress skirt_hem=maxi collar=stand sleeves=long
tube maxi dress          : kind=dress skirt_hem=maxi shoulders=strapless
bandage mini dress       : kind=dress skirt_hem=mini fit=close hips=close
hoodie mini dress        : kind=dress skirt_hem=mini hood=hood
T-shirt maxi dress       : kind=dress skirt_hem=maxi sleeves=short bodice=undarted
tank midi dress          : kind=dress skirt_hem=midi neckline=scoop sleeves=none
kaftan midi dress        : kind=dress skirt_hem=midi sleeve_shape=wide fit=loose
slip maxi                : kind=dress skirt_hem=maxi straps=narrow
corset midi              : kind=dress skirt_hem=midi shoulders=strapless fit=close
a shirt midi in blue     : kind=dress skirt_hem=midi collar=lapel sleeves=long
wrap knee length dress   : kind=dress skirt_hem=knee neckline=v
prairie maxi skirt       : kind=skirt skirt_hem=maxi skirt=gathered
rara mini skirt          : kind=skirt skirt_hem=mini skirt=tiered
cargo maxi skirt         : kind=skirt skirt_hem=maxi
sarong midi skirt        : kind=skirt skirt_hem=midi
wide leg cropped jeans   : kind=trousers leg_hem=calf legs=wide
denim mini skirt         : kind=skirt skirt_hem=mini skirt=a-line
tulip dress              : kind=dress skirt=narrowing skirt_hem=knee
petal hem dress          : kind=dress hem_shape=scalloped
slinky dress             : kind=dress fit=close hips=close
ruched mini dress        : kind=dress fit=close skirt_hem=mini
smocked maxi dress       : kind=dress fit=close skirt=gathered skirt_hem=maxi
paper bag midi skirt     : kind=skirt skirt=gathered skirt_hem=midi
light blue jeans         : kind=trousers leg_hem=full
a boned top              : kind=top shoulders=strapless fit=close
a tent shape dress       : kind=dress bodice=flared
a flowy midi skirt       : kind=skirt skirt=flared skirt_hem=midi
rib knit dress           : kind=dress fit=close sleeves=long
rugby dress              : kind=dress collar=lapel sleeves=long
utility dress            : kind=dress collar=lapel sleeves=long waist_seam=natural
trench dress             : kind=dress collar=lapel sleeves=long
waistcoat dress          : kind=dress neckline=v sleeves=none
Sabrina dress            : kind=dress neckline=boat
cowl neck dress          : kind=dress straps=narrow sleeves=none neck_depth=low
bias cut dress           : kind=dress straps=narrow skirt_hem=midi
cape gown                : kind=dress skirt_hem=floor
tulle gown               : kind=dress skirt_hem=floor skirt=circle
coquette dress           : kind=dress skirt_hem=mini sleeve_shape=puffed
Wednesday Addams dress   : kind=dress sleeves=long collar=lapel
apron dress              : kind=dress sleeves=none
skirtall                 : kind=dress sleeves=none
LWD                      : kind=dress skirt_hem=mini
debs dress               : kind=dress skirt_hem=floor
aso ebi gown             : kind=dress skirt=fitted_base skirt_hem=floor
wearable blanket         : kind=dress hood=hood fit=oversized
changing robe            : kind=dress hood=hood sleeves=long
bubble hem skirt         : kind=skirt skirt=gathered
pelmet skirt             : kind=skirt skirt_hem=micro
paperbag waist skirt     : kind=skirt skirt=gathered
scarf hem skirt          : kind=skirt hem_shape=pointed
fold over skirt          : kind=skirt skirt_hem=maxi
lappa                    : kind=skirt
barrel jeans             : kind=trousers legs=tapered hips=loose leg_hem=ankle
horseshoe trousers       : kind=trousers legs=tapered hips=loose
puddle jeans             : kind=trousers legs=wide leg_hem=full
cigarette jeans          : kind=trousers legs=slim leg_hem=ankle
low rise jeans           : kind=trousers rise=low
pleated trousers         : kind=trousers legs=tapered rise=high
wide leg sweatpants      : kind=trousers legs=wide
flared joggers           : kind=trousers legs=flared
tearaway pants           : kind=trousers legs=straight
Gurkha trousers          : kind=trousers rise=high
gharara                  : kind=trousers legs=flared
trackie dacks            : kind=trousers
leather shorts           : kind=shorts leg_hem=thigh
Gurkha shorts            : kind=shorts rise=high
half pants               : kind=shorts
cami bodysuit            : kind=playsuit straps=narrow sleeves=none
tie front top            : kind=top neckline=v top_hem=cropped
bandana top              : kind=top shoulders=strapless hem_shape=pointed
longline waistcoat       : kind=top neckline=v sleeves=none top_hem=long
cropped trench coat      : kind=top top_hem=waist collar=lapel
barn jacket              : kind=top collar=lapel sleeves=long
coach jacket             : kind=top collar=lapel
teddy fleece             : kind=top sleeves=long
"""
_ROWS = [row.split(" : ") for row in NAMES.strip().splitlines()]


def _claims(said: str) -> list[Claim]:
    pairs = [claim.split("=") for claim in said.split()]
    return [Claim(name, value if name == "hem_shape" else value.replace("_", " ")) for name, value in pairs]


@pytest.mark.parametrize(("text", "said"), [(text.strip(), said.strip()) for text, said in _ROWS])
def test_names_of_shops_mean_what_dictionaries_say(text, said):
    reading = read_words(text)
    assert not reading.unknown
    missing = [claim for claim in _claims(said) if reading.certainty(claim) is None]
    assert not missing, [(i.claim, i.certainty) for i in reading.implications]


def test_low_rise_jeans_are_not_flared_and_pleated_trousers_no_paperbags():
    flared, belt = Claim("legs", "flared"), "belt"
    assert read_words("low rise jeans").certainty(flared) is None
    assert read_words("hipsters").certainty(flared) is not None
    assert belt not in [lack.what for lack in read_words("pleated trousers").lacks]
    assert belt in [lack.what for lack in read_words("paperbag trousers").lacks]


@pytest.mark.parametrize(
    "text",
    [
        "a denim jacket, midi, over it",
        "white shirt, midi skirt",
        "a mini",
        "a black and white midi dress",
        "a mini, the corset in red",
        "a wool coat midi",
    ],
)
def test_lengths_stand_where_no_name_is_parted_by_them(text):
    words = [mark.word.lower() for mark in read_words(text).marks]
    assert all(word.split(" ")[0] in text.lower() for word in words)
    assert [word for word in words if word in ("midi", "mini", "midi skirt", "midi dress")]
    assert not any(word.endswith("corset") and "mini" in word for word in words)


def test_names_are_read_in_little_time():
    texts = [text.strip() for text, _ in _ROWS]
    read_words("a warm up")
    begin = time.process_time()
    for text in texts:
        read_words(f"{text} please")
    assert (time.process_time() - begin) / len(texts) < 0.005
