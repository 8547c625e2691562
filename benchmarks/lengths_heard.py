"""How many texts that say where a garment ends are heard as they are meant: texts put together by rule.

python benchmarks/lengths_heard.py [--misses]

Each of some garments is said to end at each level of the body that makes sense for it, in every phrasing,
with every article; sleeves likewise. So holes are found where nobody has happened to write.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator

from machine import describe
from swifttailor.describing.differences import Gain
from swifttailor.tailor import Order, Tailor

_SKIRTS = {
    **{"knee": ("knee",), "calf": ("midi",), "mid-calf": ("midi",), "ankle": ("ankle", "maxi")},
    **{"floor": ("floor", "maxi"), "ground": ("floor", "maxi")},
    **{"mid-thigh": ("mini", "micro"), "thigh": ("mini", "micro")},
}
_LEGS = {
    **{"knee": ("knee",), "calf": ("calf",), "mid-calf": ("calf",), "shin": ("calf",), "ankle": ("ankle",)},
    **{"floor": ("full",), "mid-thigh": ("mid-thigh", "thigh")},
}
_TOPS = {
    **{"hip": ("hip", "high hip"), "hip bone": ("high hip", "hip"), "waist": ("waist", "cropped")},
    **{"mid-thigh": ("long",)},
}
_SLEEVES = {"elbow": ("elbow",), "wrist": ("long",)}
_GARMENTS = {
    **dict.fromkeys(("dress", "skirt", "gown", "sundress", "coat", "nightie"), ("skirt_hem", _SKIRTS)),
    **dict.fromkeys(("trousers", "jeans", "culottes"), ("leg_hem", _LEGS)),
    "shorts": ("leg_hem", {level: _LEGS[level] for level in ("knee", "mid-thigh")}),
    "jumpsuit": ("leg_hem", {level: _LEGS[level] for level in ("calf", "ankle", "floor")}),
    **dict.fromkeys(("top", "jumper", "blouse"), ("top_hem", _TOPS)),
}
_FORMS = (
    *("{t} to {l}", "{t} down to {l}", "{t} that stops at {l}", "{t} stopping at {l}", "{t} ending at {l}"),
    *("{t} that ends at {l}", "{t} finishing at {l}", "{t} reaching {l}", "{t} that reaches {l}"),
    *("{t} that goes to {l}", "{t} that comes to {l}", "{t} that comes down to {l}", "{t} falling to {l}"),
    *("{t} hitting {l}", "{t} that hits {l}", "{t}, {l} length", "{t}, to {l}", "{t} as far as {l}"),
    *("{t} all the way to {l}", "{t} that sits at {l}", "{t} that lands at {l}", "{t} with the hem at {l}"),
    *("{t}, hem at {l}", "I want a {t} which should end at {l}", "{t} long enough to reach {l}"),
    "{t} cut off at {l}",
)
_OF_SLEEVES = (
    *("sleeves to {l}", "sleeves down to {l}", "sleeves that stop at {l}", "sleeves ending at {l}"),
    *(
        "sleeves that end at {l}",
        "sleeves reaching {l}",
        "sleeves that reach {l}",
        "sleeves finishing at {l}",
    ),
    *("sleeves that come to {l}", "{l}-length sleeves", "{l} length sleeves", "sleeve to {l}"),
    *("arms down to {l}", "sleeves as far as {l}", "sleeves, to {l}", "sleeves that hit {l}"),
    "sleeves cut off at {l}",
)
_ARTICLES = ("the ", "my ", "her ", "")
_WITHOUT_ARTICLE = ("mid-calf", "mid-thigh")
"""Levels that are said without one in every phrasing; others only behind "to"."""

Text = tuple[str, str, tuple[str, ...], str]
"""What is typed, the name of the claim, its values that will do, and the phrasing."""


def main() -> None:
    """Hears all of them and counts."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--misses", action="store_true", help="print what is missed")
    misses = parser.parse_args().misses
    tailor = Tailor.load()
    count, missed = 0, Counter[str]()
    for text, name, values, form in texts():
        gains = [wish.change for wish in tailor.read(Order(text)).said if isinstance(wish.change, Gain)]
        heard = [gain.claim.value for gain in gains if gain.claim.name == name]
        count += 1
        if not set(values).intersection(heard):
            missed[form] += 1
            if misses:
                print(f"  {text!r}: {name} is {heard or 'not heard'}")
    print(describe())
    print(f"{count} texts, heard as meant: {1 - missed.total() / count:.1%}")
    for form, number in missed.most_common(8):
        print(f"  {number} missed of {form!r}")


def texts() -> Iterator[Text]:
    """All of them."""
    for garment, (name, levels) in _GARMENTS.items():
        for level, values in levels.items():
            for form in _FORMS:
                for article in _articles(form, level):
                    yield form.format(t=garment, l=article + level), name, values, form
    for garment in ("dress with ", "top with ", "jumper, "):
        for level, values in _SLEEVES.items():
            for form in _OF_SLEEVES:
                for article in ("",) if form.startswith("{l}") else _ARTICLES[:-1]:
                    yield garment + form.format(l=article + level), "sleeves", values, form


def _articles(form: str, level: str) -> tuple[str, ...]:
    if "{l} length" in form:
        return ("",)
    return _ARTICLES if level in _WITHOUT_ARTICLE or form == "{t} to {l}" else _ARTICLES[:-1]


if __name__ == "__main__":
    main()
