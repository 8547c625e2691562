"""Words for what becomes true of a garment by an edit."""

from __future__ import annotations

from swifttailor.wording.instructions.gain_wording import GainWording, gain
from swifttailor.wording.instructions.gains_below_waist import LOWER_GAINS
from swifttailor.wording.instructions.gains_of_parts import PART_GAINS
from swifttailor.wording.instructions.gains_of_shape import SHAPE_GAINS
from swifttailor.wording.phrases.sleeve_words import SLEEVE_NAMES

_HEMS = {
    "micro": ("very short", "micro-short"),
    "mini": ("mini", "thigh-length", "short"),
    "above the knee": ("end just above the knee", "above-the-knee"),
    "knee": ("knee-length", "reach the knee"),
    "below the knee": ("end below the knee", "cover the knees"),
    "midi": ("midi-length", "calf-length", "mid-calf"),
    "maxi": ("maxi", "maxi-length", "long"),
    "ankle": ("ankle-length", "reach the ankles"),
    "floor": ("floor-length", "full-length", "reach the floor"),
}
_LEG_HEMS = {
    "very short": ("very short",),
    "mid-thigh": ("mid-thigh length", "end at mid-thigh"),
    "thigh": ("end above the knee",),
    "knee": ("knee-length", "end at the knee"),
    "calf": ("calf-length", "end at the calf"),
    "ankle": ("ankle-length", "reach the ankles"),
    "full": ("full-length", "reach the floor"),
}
_TOP_HEMS = {
    "bra": ("very cropped", "end well above the waist"),
    "cropped": ("cropped", "end at the waist"),
    "waist": ("waist-length", "end at the waist"),
    "hip": ("hip-length", "reach the hips"),
    "long": ("long", "cover the seat", "tunic-length"),
}
_NECKLINES = {
    "round": ("round neckline", "round neck"),
    "crew": ("crew neck",),
    "scoop": ("scoop neck", "scooped neckline"),
    "boat": ("boat neck", "bateau neckline"),
    "v": ("V neck", "V neckline"),
    "square": ("square neck", "square neckline"),
    "trapezoid": ("trapezoid neckline", "angular neckline with slanted sides"),
    "s-curve": ("S-curved neckline", "curvy neckline that opens to the shoulders"),
    "pointed": ("pointed, curved neckline", "leaf-shaped neckline"),
    "asymmetric": ("asymmetric neckline", "neckline that differs left and right"),
}


def _lengths() -> list[GainWording]:
    found = []
    for name, words, subject in (
        ("skirt_hem", _HEMS, "{garment}"),
        ("leg_hem", _LEG_HEMS, "legs"),
        ("top_hem", _TOP_HEMS, "{garment}"),
    ):
        for word, texts in words.items():
            value = word.replace(" ", "_")
            asks = [f"make the {subject} {t}" for t in texts]
            asks += [
                f"change the length to {t}"
                for t in texts
                if t.split()[0] not in ("end", "reach", "cover", "just")
            ]
            found.append(gain(f"{name}={value}", 7.0, *asks))
    return found


def _sleeves() -> list[GainWording]:
    found = []
    for word, name in SLEEVE_NAMES.items():
        found.append(
            gain(
                f"sleeves={word}",
                8.0,
                f"add {name} sleeves",
                f"give it {name} sleeves",
                f"sew in {name} sleeves",
                f"put {name} sleeves on it",
                was="sleeves=none",
            )
        )
        found.append(
            gain(
                f"sleeves={word}",
                6.5,
                f"make the sleeves {name}",
                f"change to {name} sleeves",
                f"give it {name} sleeves instead",
                was_not="sleeves=none",
            )
        )
        for side, other in (("left", "right"), ("right", "left")):
            found.append(
                gain(
                    f"{side}_sleeve={word} sleeves={side}_only",
                    7.5,
                    f"leave only one {name} sleeve, on the {side}",
                    f"give it a single {name} sleeve on the {side} and none on the {other}",
                )
            )
            found.append(
                gain(
                    f"{side}_sleeve={word}",
                    7.2,
                    f"add a {name} {side} sleeve",
                    f"sew in a {name} sleeve on the {side}",
                    was="sleeves=none",
                    topic=f"{side} sleeve",
                )
            )
            found.append(
                gain(
                    f"{side}_sleeve={word}",
                    6.0,
                    f"make the {side} sleeve {name}",
                    f"give it a {name} {side} sleeve",
                )
            )
    return found


def _necklines() -> list[GainWording]:
    found = []
    for word, names in _NECKLINES.items():
        texts = [f"change the neckline to a {n}" for n in names]
        texts += [f"give it a {n}" for n in names] + [f"cut a {n}" for n in names[:1]]
        found.append(gain(f"neckline={word}", 6.5, *texts))
    halves = {
        "round": "round",
        "v": "straight to a V",
        "square": "square",
        "trapezoid": "at a slant with a corner",
    }
    halves |= {"s-curve": "in an S-curve", "pointed": "pointed and curved"}
    for side in ("left", "right"):
        for word, name in halves.items():
            found.append(
                gain(
                    f"{side}_neckline={word}",
                    5.0,
                    f"cut the {side} half of the neckline {name}",
                    f"cut the neckline {name} on the {side}",
                    topic=f"{side} neckline",
                )
            )
    return found


GAIN_WORDS: tuple[GainWording, ...] = (
    *PART_GAINS,
    *SHAPE_GAINS,
    *LOWER_GAINS,
    *_lengths(),
    *_sleeves(),
    *_necklines(),
)
"""All of them."""
