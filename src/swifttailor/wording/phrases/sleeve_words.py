"""Words for sleeves: a length, a shape and an end, put together."""

from __future__ import annotations

from swifttailor.wording.phrases.phrase import Wording, feature, sentence

_LENGTHS: dict[str, tuple[str, ...]] = {
    "cap": ("cap sleeves", "tiny cap sleeves"),
    "short": ("short sleeves", "sleeves that end above the elbow"),
    "elbow": ("elbow-length sleeves", "half sleeves", "sleeves to the elbow"),
    "three-quarter": (
        "three-quarter sleeves",
        "3/4 sleeves",
        "three-quarter-length sleeves",
        "bracelet sleeves",
    ),
    "long": ("long sleeves", "full-length sleeves", "wrist-length sleeves"),
    "extra-long": ("extra-long sleeves", "sleeves that cover the hands"),
}
SLEEVE_NAMES: dict[str, str] = {
    "cap": "cap",
    "short": "short",
    "elbow": "elbow-length",
    "three-quarter": "three-quarter",
    "long": "long",
    "extra-long": "extra-long",
}
"""Lengths before a noun."""
_SHAPES: dict[str, tuple[str, ...]] = {
    "slim": ("slim", "narrow"),
    "wide": ("wide", "full", "roomy"),
    "puffed": ("puff", "puffed", "gathered"),
    "balloon": ("balloon",),
    "bell": ("bell", "flared"),
    "tapered": ("tapered", "tapering"),
}
_ENDS: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("cuffs=band", ("with cuffs", "ending in cuffs", "with band cuffs", "finished with plain cuffs")),
    (
        "cuffs=band sleeve_shape=gathered_end",
        ("gathered into cuffs", "gathered into band cuffs", "caught in at the cuff"),
    ),
    (
        "cuffs=flounce",
        ("with flounced cuffs", "ending in flounces", "with flared cuffs", "with a ruffle at the end"),
    ),
    (
        "cuffs=band_and_flounce",
        (
            "with a band and a flounce at the end",
            "ending in a cuff with a frill",
            "with ruffled cuffs on a band",
        ),
    ),
    (
        "cuffs=band_and_flounce sleeve_shape=gathered_end",
        ("gathered into a band that ends in a flounce", "gathered into frilled cuffs"),
    ),
    ("cuffs=deep", ("with deep cuffs", "with long cuffs")),
    ("cuffs=band cuff_cm=?", ("with {cuff_cm-} cuffs", "with cuffs {cuff_cm} long")),
    (
        "sleeve_shape=puffed",
        ("gathered at the shoulder", "puffed at the shoulder", "gathered into the armhole"),
    ),
    ("sleeve_shape=tapered", ("that narrow to the end", "narrowing toward the wrist")),
    ("sleeve_shape=bell", ("that widen to the end", "flaring out at the end")),
    ("sleeve_shape=balloon", ("that balloon out above the cuff",)),
    ("sleeve_cm=?", ("{sleeve_cm} long", "of {sleeve_cm}", "({sleeve_cm})")),
    ("sleeve_width_cm=?", ("{sleeve_width_cm} around at the top",)),
)


def _feature(needs: str, texts: tuple[str, ...], weight: float) -> Wording:
    return feature(needs, *texts, weight=weight, topics="sleeve noun")


def _features() -> list[Wording]:
    found = []
    for length, names in _LENGTHS.items():
        found.append(_feature(f"sleeves={length}", names, 3.0))
        short = SLEEVE_NAMES[length]
        for shape, adjectives in _SHAPES.items():
            texts = tuple(f"{short} {a} sleeves" for a in adjectives) + tuple(
                f"{a}, {short} sleeves" for a in adjectives[:1]
            )
            found.append(_feature(f"sleeves={length} sleeve_shape={shape}", texts, 1.5))
        for end, tails in _ENDS:
            texts = tuple(f"{short} sleeves {tail}" for tail in tails)
            found.append(_feature(f"sleeves={length} {end}", texts, 0.8))
    for shape, adjectives in _SHAPES.items():
        found.append(_feature(f"sleeve_shape={shape}", tuple(f"{a} sleeves" for a in adjectives), 1.2))
    for end, tails in _ENDS:
        found.append(_feature(end, tuple(f"sleeves {tail}" for tail in tails), 0.5))
    for word in SLEEVE_NAMES:
        for side, opposite in (("left", "right"), ("right", "left")):
            short = SLEEVE_NAMES[word]
            one = (
                f"one {short} sleeve on the {side}",
                f"a single {short} sleeve, on the {side}",
                f"a {short} {side} sleeve and none on the {opposite}",
            )
            found.append(_feature(f"sleeves={side}_only {side}_sleeve={word}", one, 3.0))
        for other in SLEEVE_NAMES:
            if other != word:
                texts = (
                    f"a {SLEEVE_NAMES[word]} left sleeve and a {SLEEVE_NAMES[other]} right one",
                    f"a {SLEEVE_NAMES[other]} sleeve on the right and a {SLEEVE_NAMES[word]} one on the left",
                )
                found.append(_feature(f"left_sleeve={word} right_sleeve={other} sides=different", texts, 3.0))
    found.append(_feature("sleeves=left_only", ("a left sleeve only", "one sleeve, the left"), 1.5))
    found.append(_feature("sleeves=right_only", ("a right sleeve only", "one sleeve, the right"), 1.5))
    unequal = ("sleeves of different lengths", "one sleeve longer than the other", "unequal sleeves")
    found.append(_feature("sleeves=unequal", unequal, 1.5))
    found.append(_feature("sleeves=none shoulders=both", ("no sleeves", "bare arms"), 1.5))
    return found


FEATURES: tuple[Wording, ...] = tuple(_features())
"""Sleeves after "with"."""


SENTENCES: tuple[Wording, ...] = (
    sentence("sleeves=short", "The sleeves are short.", "The sleeves end above the elbow."),
    sentence("sleeves=elbow", "The sleeves reach the elbow.", "The sleeves end around the elbow."),
    sentence(
        "sleeves=three-quarter",
        "The sleeves end between elbow and wrist.",
        "The sleeves are three-quarter length.",
    ),
    sentence("sleeves=long", "The sleeves are long.", "The sleeves reach the wrist."),
    sentence("sleeves=long sleeve_shape=gathered_end", "The long sleeves are gathered into their cuffs."),
    sentence("sleeves=long cuffs=none", "The long sleeves end without cuffs."),
    sentence(
        "sleeve_shape=puffed",
        "The sleeve heads are gathered.",
        "Gathers puff the sleeves up at the shoulder.",
    ),
    sentence("sleeve_shape=bell", "The sleeves flare out to their ends."),
    sentence("sleeve_shape=slim", "The sleeves are narrow.", "The sleeves fit closely."),
    sentence("sleeve_shape=wide", "The sleeves are very wide.", "The sleeves are cut full."),
    sentence("cuffs=band", "The sleeves have cuffs.", "Cuffs finish the sleeves."),
    sentence("cuffs=flounce", "Flounces finish the sleeves.", "The sleeves end in flounces."),
    sentence("cuffs=band_and_flounce", "Each sleeve ends in a band with a flounce."),
    sentence("cuffs=deep", "The cuffs are deep."),
    sentence("sleeve_cm=?", "The sleeves are {sleeve_cm} long.", "Sleeve length: {sleeve_cm}."),
    sentence("sleeves=left_only", "Only the left arm has a sleeve."),
    sentence("sleeves=right_only", "Only the right arm has a sleeve."),
)
