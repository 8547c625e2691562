"""Ways to write a caption, from two words to a full description."""

from __future__ import annotations

import re
from collections.abc import Callable

from swifttailor.wording.speech import Phrase, Speech, with_articles, without_article

Style = Callable[[Speech], tuple[str, list[Phrase]]]

# Adjectives stand in this order before the noun: opinion on fit first, length last.
_ORDER = (
    "fit",
    "sides",
    "hem_shape",
    "back",
    "shoulders",
    "neckline",
    "collar",
    "hood",
    "sleeve_shape",
    "sleeves",
)
_LENGTH_ABOUT = ("length", "skirt", "legs")
_STAND_ALONE = frozenset({"length", "fit", "waist", "sides", "hem_shape", "legs"})
"""What adjectives without a noun may speak of."""


def terse(speech: Speech) -> tuple[str, list[Phrase]]:
    """``sleeveless mini dress``."""
    head = speech.say_head()
    adjectives = _adjectives(speech, speech.rng.choice((1, 1, 2, 2, 3)))
    text = " ".join([*(a.text for a in adjectives), head.text])
    return _finish(speech, text), [*adjectives, head]


def phrase(speech: Speech) -> tuple[str, list[Phrase]]:
    """``a sleeveless mini dress with a V neck and a gathered skirt``."""
    noun, said = _noun_phrase(speech, speech.rng.choice((0, 1, 1, 2, 2)))
    features = speech.say_several(speech.rng.choice((1, 2, 2, 3, 4)), "feature")
    text = noun + _with(speech, features)
    return _finish(speech, text), said + features


def description(speech: Speech) -> tuple[str, list[Phrase]]:
    """Several sentences that say most of what there is to say."""
    noun, said = _noun_phrase(speech, speech.rng.choice((0, 1, 1, 2)))
    features = speech.say_several(speech.rng.choice((0, 1, 2, 2)), "feature")
    plural = said[0].plural
    opening = speech.pick("{}.", "{}.", "{}.", "Here are {}." if plural else "Here is {}.", "This is {}.")
    if plural:
        opening = opening.replace("This is", "These are")
    text = _capital(opening.format(noun + _with(speech, features)))
    said += features
    for _ in range(speech.rng.choice((2, 3, 4, 5))):
        if speech.rng.random() < 0.35:
            more = speech.say_several(speech.rng.choice((2, 3)), "feature")
            if not more:
                break
            sentence_text = _features_sentence(speech, more, plural)
            if sentence_text.startswith("Details") and "Details" in text:
                sentence_text = sentence_text.replace("Details:", "They have" if plural else "It has")
            text += " " + sentence_text
            said += more
            continue
        sentence = speech.say("sentence")
        if sentence is None:
            break
        text += " " + _capital(_subject(speech, sentence.text, plural))
        said.append(sentence)
    return text, said


def tags(speech: Speech) -> tuple[str, list[Phrase]]:
    """``dress, knee-length, sleeveless, V neck``."""
    head = speech.say_head()
    said = _notes(speech, speech.rng.choice((2, 3, 4, 5, 6)))
    texts = [without_article(p.text) for p in said]
    separator = speech.pick(", ", ", ", "; ", " / ", " | ")
    if speech.rng.random() < 0.3:
        speech.rng.shuffle(texts)
    text = separator.join([head.text, *texts])
    return (text.lower() if speech.rng.random() < 0.5 else text), [head, *said]


def command(speech: Speech) -> tuple[str, list[Phrase]]:
    """``I want a knee-length dress`` and other ways to ask."""
    text, said = phrase(speech)
    text = _small(text.rstrip("."))
    frame = speech.pick(
        "I want {}.",
        "I would like {}.",
        "I'd like {}, please.",
        "I need {}.",
        "Make me {}.",
        "Make {}.",
        "Design {}.",
        "Please design {}.",
        "Create {}.",
        "Draft a pattern for {}.",
        "Draft {}.",
        "Generate a sewing pattern for {}.",
        "Give me {}.",
        "Sew {}.",
        "Can you make {}?",
        "Could you draft {} for me?",
        "Show me {}.",
        "I am looking for {}.",
        "We need a pattern: {}.",
        "A pattern for {}, please.",
    )
    return frame.format(text), said


def shop(speech: Speech) -> tuple[str, list[Phrase]]:
    """The way a shop writes."""
    head = speech.say_head()
    adjectives = _adjectives(speech, speech.rng.choice((1, 2, 2)))
    features = speech.say_several(speech.rng.choice((2, 3, 3, 4)), "feature")
    noun = " ".join([*(a.text for a in adjectives), head.text])
    listing = speech.listed([f.text for f in features])
    if not features:
        return _capital(noun) + ".", [head, *adjectives]
    verb = "come" if head.plural else "comes"
    frame = speech.pick(
        "Our {noun} {verb} with {listing}.",
        "New in: the {noun} with {listing}.",
        "Meet the {noun}: {listing}.",
        "{Noun} featuring {listing}.",
        "This {noun} is all about {listing}." if not head.plural else "These {noun} are all about {listing}.",
        "The {noun}. Details: {listing}.",
        "{Noun}. {Listing}.",
        "Introducing the {noun}, with {listing}.",
        "This season: {listing} on {a_noun}.",
    )
    text = frame.format(
        noun=noun,
        Noun=_capital(noun),
        a_noun=_determined(speech, noun, head.plural),
        verb=verb,
        listing=listing,
        Listing=_capital(listing),
    )
    return text, [head, *adjectives, *features]


def sheet(speech: Speech) -> tuple[str, list[Phrase]]:
    """A specification in lines or fields, by topic."""
    head = speech.say_head()
    said = _notes(speech, speech.rng.choice((3, 4, 5, 6)))
    fields: dict[str, list[str]] = {"garment": [head.text]}
    for note in said:
        fields.setdefault(_field_name(note), []).append(without_article(note.text))
    join = speech.pick("; ", "\n", ". ")
    colon = speech.pick(": ", " - ")
    lines = [f"{_capital(n) if join != '; ' else n}{colon}{', '.join(v)}" for n, v in fields.items()]
    return join.join(lines), [head, *said]


def hasty(speech: Speech) -> tuple[str, list[Phrase]]:
    """Typed in a hurry: lower case, no articles, ``w/``."""
    head = speech.say_head()
    adjectives = _adjectives(speech, speech.rng.choice((0, 1, 2, 3)))
    features = speech.say_several(speech.rng.choice((0, 1, 2, 3)), "feature", "tag")
    said = [head, *adjectives, *features]
    text = " ".join([*(a.text for a in adjectives), head.text])
    rest = [without_article(f.text) for f in features]
    if rest:
        link = speech.pick(" w/ ", " with ", " ", ", ", " + ")
        text += link + speech.pick(", ", ", ", " and ", " + ", " ").join(rest)
    return re.sub(r"\s+", " ", text.lower().replace(" and ", speech.pick(" and ", " & "))), said


STYLES: dict[str, tuple[Style, float]] = {
    "terse": (terse, 1.0),
    "phrase": (phrase, 2.0),
    "description": (description, 2.5),
    "tags": (tags, 1.0),
    "command": (command, 2.0),
    "shop": (shop, 1.0),
    "sheet": (sheet, 0.6),
    "hasty": (hasty, 1.0),
}
"""Every style and how often it is used."""


def _adjectives(speech: Speech, count: int) -> list[Phrase]:
    """Adjectives in the order in which they stand before a noun."""
    said = speech.say_several(count, "adjective")

    def rank(adjective: Phrase) -> int:
        if adjective.topics & set(_LENGTH_ABOUT):
            return len(_ORDER)
        return min((_ORDER.index(t) for t in adjective.topics if t in _ORDER), default=len(_ORDER) - 1)

    if speech.rng.random() < 0.2:
        return said
    return sorted(said, key=rank)


def _notes(speech: Speech, count: int) -> list[Phrase]:
    """Things said without a sentence around them."""
    said = []
    for _ in range(count):
        alone = speech.say("adjective", about=_STAND_ALONE) if speech.rng.random() < 0.35 else None
        note = alone or speech.say("tag", "feature")
        if note is None:
            break
        said.append(note)
    return said


def _noun_phrase(speech: Speech, count: int) -> tuple[str, list[Phrase]]:
    """An article, adjectives and the head; the head comes first in the list of what was said."""
    head = speech.say_head()
    adjectives = _adjectives(speech, count)
    comma = ", " if len(adjectives) > 1 and speech.rng.random() < 0.4 else " "
    noun = " ".join([comma.join(a.text for a in adjectives), head.text]).strip()
    return _determined(speech, noun, head.plural), [head, *adjectives]


def _determined(speech: Speech, noun: str, plural: bool) -> str:
    if plural:
        return speech.pick(noun, noun, f"a pair of {noun}")
    return with_articles(f"a {noun}")


def _with(speech: Speech, features: list[Phrase]) -> str:
    if not features:
        return ""
    link = speech.pick(" with ", " with ", " with ", " featuring ", ", with ")
    return link + speech.listed([f.text for f in features])


def _features_sentence(speech: Speech, features: list[Phrase], plural: bool) -> str:
    listing = speech.listed([f.text for f in features])
    if plural:
        return speech.pick(f"They have {listing}.", f"Details: {listing}.", f"They come with {listing}.")
    return speech.pick(
        f"It has {listing}.",
        f"Details: {listing}.",
        f"It comes with {listing}.",
        f"It is made with {listing}.",
    )


def _subject(speech: Speech, text: str, plural: bool) -> str:
    """Fills in who a sentence is about."""
    it = "they" if plural else speech.pick("it", "it", "the garment", "the design")
    return text.format(it=it, has="have" if plural else "has", sits="sit" if plural else "sits")


def _field_name(said: Phrase) -> str:
    names = {
        "length": "length",
        "sleeves": "sleeves",
        "sleeve_shape": "sleeves",
        "cuffs": "sleeves",
        "neckline": "neckline",
        "collar": "neckline",
        "hood": "hood",
        "back": "back",
        "waist": "waist",
        "waistband": "waist",
        "skirt": "skirt",
        "hem_shape": "hem",
        "slit": "slits",
        "legs": "legs",
        "leg_cuffs": "legs",
        "fit": "fit",
        "bodice": "bodice",
        "shoulders": "shoulders",
        "armholes": "armholes",
        "sides": "cut",
    }
    return next((names[t] for t in names if t in said.topics), "detail")


def _finish(speech: Speech, text: str) -> str:
    """A capital and a full stop, or neither."""
    return speech.pick(text, _capital(text), f"{_capital(text)}.")


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _small(text: str) -> str:
    """Without the capital of a sentence; A-line and V-neck keep theirs."""
    return text if text[1:2] == "-" else text[:1].lower() + text[1:]
