"""Numbers of a text, and what they are said of."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.text.spoken_hems import spoken_bounds, spoken_hem, spoken_slit
from swifttailor.wishes.text.spoken_measures import can_measure, spoken_measures
from swifttailor.wording.lexicon import read_words


def stated(text, kind):
    return {m.claim.name: m.claim.value for m in spoken_measures(text, kind) if m.claim is not None}


@pytest.mark.parametrize(
    ("text", "kind", "claims"),
    [
        ("tapered legs, leg opening 18 cm", "trousers", {"leg_width_cm": 36}),
        ("Trousers, inside leg 78, hem circumference 44", "trousers", {"inseam_cm": 78, "leg_width_cm": 44}),
        ("jeans with a 32 inseam", "trousers", {"inseam_cm": 81.28}),
        ("Two-tier skirt. First tier 30 cm. Total 75.", "skirt", {"tiers": 2, "skirt_length_cm": 75}),
        ("hem circumference at least 3 m", "skirt", {"hem_cm": 330}),
        ("shorts, inseam anywhere from 18 to 22 cm", "shorts", {"inseam_cm": 20}),
        ("a skirt, about 70 cm", "skirt", {"skirt_length_cm": 70}),
        ("skirt, fitted to the thigh, 75 cm", "skirt", {"skirt_length_cm": 75}),
        ("three tiers: 20, 25, 30", "skirt", {"tiers": 3, "skirt_length_cm": 75}),
        ("boat neck 28 cm across", "top", {}),
        ("skirt with six godets, 75 cm long", "skirt", {"godets": 6, "skirt_length_cm": 75}),
        ("the neckline a square one, exactly 16 cm deep from the shoulder", "dress", {"neck_depth_cm": 16}),
        ("bodice with the back cut in a v, 12 inches deep", "top", {"back_depth_cm": 30.48}),
        ("a 16 cm deep square neckline", "dress", {"neck_depth_cm": 16}),
        ("scoop neck 14 cm deep in front", "dress", {"neck_depth_cm": 14}),
        ("Kleid, Rückenausschnitt 25 cm tief", "dress", {"back_depth_cm": 25}),
        ("back neck depth: 18 cm", "dress", {"back_depth_cm": 18}),
        ("v neck, cuffs 8 cm deep", "top", {"cuff_cm": 8}),
        ("vestido largo, cintura 62 cm", "dress", {}),
        ("Kleid, Oberweite 92 cm", "dress", {}),
        ("sleeve 25 cm long from the shoulder", "top", {"sleeve_cm": 25}),
        ("sleeve width 50 cm, gathered to an 8 cm cuff", "top", {"sleeve_width_cm": 50, "cuff_cm": 8}),
        ("a turtleneck collar about six centimetres high", "dress", {"collar_cm": 6}),
        ("A-line dress, side slits 10 cm", "dress", {"slit_cm": 10}),
        ("5 gores, midi, flared", "skirt", {"gores": 5}),
        ("Flare the hem to 320 cm", "skirt", {"hem_cm": 320}),
        ("Rock, Länge 65 cm", "skirt", {"skirt_length_cm": 65}),
        ("between 60 and 70 cm long", "skirt", {"skirt_length_cm": 65}),
        ("trousers, 104 cm long", "trousers", {"inseam_cm": 72}),
        ("Hose, 100 cm lang", "trousers", {"inseam_cm": 68}),
        ("trousers, 185 cm", "trousers", {}),
        ("pants, 100cm", "trousers", {"inseam_cm": 68}),
        ("shorts 40 cm long", "shorts", {"inseam_cm": 8}),
        ("jeans, length 32", "trousers", {"inseam_cm": 81.28}),
        ("trousers with 20 cm slits", "trousers", {"slit_cm": 20}),
        ("a skirt with two slits", "skirt", {}),
        (
            'a jumper, 20" from underarm... no, make that 26 inches from the shoulder',
            "top",
            {"length_cm": 66.04},
        ),
    ],
)
def test_a_number_is_said_of_the_measure_beside_it(text, kind, claims):
    assert stated(text, kind) == pytest.approx(claims)


def test_a_length_from_the_knee_leads_there():
    two, four = (stated(f"{n} inches above the knee", "skirt")["skirt_length_cm"] for n in ("two", "four"))
    assert two - four == pytest.approx(5.1, abs=0.1)
    middle = stated("dress two to four inches above the knee", "dress")["length_cm"]
    assert middle == pytest.approx(stated("dress three inches above the knee", "dress")["length_cm"], abs=0.1)
    assert stated("5 cm below the knee", "skirt")["skirt_length_cm"] > two


def test_measures_of_the_wearer_and_changes_are_no_measures_of_the_garment():
    assert stated("my hips are 110, waist 80", "skirt") == {}
    assert stated("one inch off the hem", "trousers") == {}
    assert stated('36" bust, fitted top', "top") == {}


@given(st.text(max_size=80), st.sampled_from([None, "dress", "skirt", "trousers"]))
def test_any_text_can_be_read(text, kind):
    for measure in spoken_measures(text, kind):
        assert 0 <= measure.mention.start < measure.mention.end <= len(text)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("dress, hem dropping toward the right", "lower right"),
        ("Skirt that is more long behind than before", "high-low"),
        ("a skirt, shorter in front", "high-low"),
        ("longer on the left", "lower left"),
        ("a longer zip at the back", None),
        ("a dress", None),
    ],
)
def test_a_hem_that_is_longer_on_one_side(text, value):
    claim = spoken_hem(text, "dress")
    assert (None if claim is None else claim.value) == value
    assert spoken_hem(text, "trousers") is None


def test_bounds_and_slits():
    def claims(text):
        return [(c.name, c.value) for c in spoken_bounds(text, read_words(text))]

    assert claims("a dress, on no account anything shorter than the middle of my calves") == [
        ("skirt_hem", "midi")
    ]
    assert claims("a dress, not too short") == []
    text = "a gown, slit to mid-thigh on the right"
    found = spoken_slit(text, read_words(text))
    assert found is not None and found.value == "right"
    assert spoken_slit("a gown", read_words("a gown")) is None


def test_a_number_behind_a_comma_is_of_what_stands_right_behind_it():
    (said,) = spoken_measures("skirt, knee length, 15 cm slit at the back", "skirt")
    assert said.claim == Claim("slit_cm", 15.0)


def test_no_sleeve_is_as_long_as_a_length_of_cloth():
    assert not can_measure(Gain(Claim("sleeve_cm", 200.0)))
    assert can_measure(Gain(Claim("sleeve_cm", 60.0))) and can_measure(Gain(Claim("sleeves", "long")))
