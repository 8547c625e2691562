"""Writing instructions: two garments and a seed in, a text and the changes it asks for out."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass

from swifttailor.describing.claims import Claim, claims_of
from swifttailor.describing.differences import QUANTITIES, Change, Gain, Step, find_differences
from swifttailor.describing.facts import GarmentFacts
from swifttailor.inches import CM_PER_INCH
from swifttailor.wording.captions.styles import phrase
from swifttailor.wording.instructions.requests import GainWording, gain_words, step_words
from swifttailor.wording.speech import Speech, with_articles

MOST_CHANGES = 4
"""An instruction asks for no more at once; where more is different, it says what to make instead."""
_WITH_AMOUNT = 0.35
_INCHES = 0.3


@dataclass(frozen=True)
class Instruction:
    """A text that asks for changes."""

    text: str
    changes: tuple[Change, ...]

    def holds(self, before: GarmentFacts, after: GarmentFacts) -> bool:
        """Whether an edited garment does all that is asked."""
        return all(change.holds(before, after) for change in self.changes)


@dataclass(frozen=True)
class Request:
    """One thing that could be asked for."""

    topic: str
    importance: float
    texts: tuple[str, ...]
    changes: tuple[Change, ...]


def write_instruction(before: GarmentFacts, after: GarmentFacts, seed: int = 0) -> Instruction | None:
    """Writes an instruction that leads from one garment to another.

    Args:
        before: Facts of the original.
        after: Facts of the edited garment.
        seed: Decides which of the differences are named, and how.

    Returns:
        The instruction, which holds between the two; None where no difference is seen, or none that there
        are words for.
    """
    instruction = _write(before, after, seed)
    return instruction if instruction is not None and instruction.holds(before, after) else None


def _write(before: GarmentFacts, after: GarmentFacts, seed: int) -> Instruction | None:
    rng = random.Random(f"instruction {seed}")
    halves = _halves_changed(before, after)
    if halves == "less":
        request = _half_left(before, after)
        if request is not None:
            return Instruction(_sentence([rng.choice(request.texts)], rng), request.changes)
    requests = find_requests(before, after, rng)
    if not requests:
        return None
    if halves == "more" or len(requests) > MOST_CHANGES + (rng.random() < 0.3):
        remade = _restate(before, after, rng)
        if remade is not None:
            return remade
    chosen = sorted(requests, key=lambda r: -r.importance)[:MOST_CHANGES]
    rng.shuffle(chosen)
    clauses = [_fill(rng.choice(r.texts), before, after) for r in chosen]
    changes = tuple(dict.fromkeys(change for r in chosen for change in r.changes))
    return Instruction(_sentence(clauses, rng), changes)


def find_requests(before: GarmentFacts, after: GarmentFacts, rng: random.Random) -> list[Request]:
    """What could be asked for, at most one request for each topic."""
    gains, steps = find_differences(before, after)
    gains = tuple(
        g
        for g in gains
        if not _only_uncovered(g.claim, before, after) and not _of_both_sleeves(g.claim, after)
    )
    found: dict[str, list[Request]] = {}
    for request in (*_of_gains(gains, before, after), *_of_steps(steps, rng)):
        found.setdefault(request.topic, []).append(request)
    _leave_out_consequences(found, before, after)
    chosen = []
    for requests in found.values():
        most = max(r.importance for r in requests)
        # A gain and a step that say nearly the same take turns.
        chosen.append(rng.choice([r for r in requests if r.importance > most - 1.0]))
    return chosen


def _halves_changed(before: GarmentFacts, after: GarmentFacts) -> str:
    """Whether the edited garment has halves (upper, skirt, legs) that the original lacks, or just fewer."""
    was, now = (
        {n for n, part in (("upper", f.torso), ("skirt", f.skirt), ("legs", f.trousers)) if part}
        for f in (before, after)
    )
    if was == now:
        return ""
    return "less" if now < was else "more"


def _half_left(before: GarmentFacts, after: GarmentFacts) -> Request | None:
    """Asks to leave just the upper or the lower half."""
    lower = "trousers" if before.trousers else "skirt"
    gained = {g.claim.name: g for g in find_differences(before, after)[0]}
    if after.torso is None:
        texts = (f"keep only the {lower}", "remove the bodice", f"take off the top, leaving just the {lower}")
        kind = gained.get("kind")
        return Request("kind", 10.0, texts, (kind,)) if kind else None
    top = Gain(Claim("kind", "top"))
    changes: tuple[Change, ...] = (gained["kind"],) if "kind" in gained else ()
    if (
        before.trousers is None
    ):  # a short dress may be a long top: that it is a top now is not all that is meant
        changes = (Step("length", -1), *([top] if top.holds(before, after) else []))
    texts = (
        f"remove the {lower}",
        f"take the {lower} off",
        "keep only the bodice",
        "leave just the top part",
    )
    return Request("kind", 10.0, texts, changes) if changes else None


def _of_gains(gains: Sequence[Gain], before: GarmentFacts, after: GarmentFacts) -> list[Request]:
    gained = {g.claim for g in gains}
    was, now = set(claims_of(before)), set(claims_of(after))
    found = []
    for wording in gain_words():
        if wording.claims[0] in gained and now.issuperset(wording.claims) and _fits(wording, was):
            changes = tuple(Gain(c) for c in wording.claims)
            found.append(Request(wording.topic, wording.importance, wording.texts, changes))
    return found


def _fits(wording: GainWording, was: set[Claim]) -> bool:
    return was.issuperset(wording.was) and was.isdisjoint(wording.was_not)


def _of_both_sleeves(claim: Claim, after: GarmentFacts) -> bool:
    """Whether a claim about one sleeve is as true of the other, and better said of both."""
    left, right = after.left_sleeve, after.right_sleeve
    if claim.name not in ("left_sleeve", "right_sleeve") or left is None or right is None:
        return False
    return abs(left.length - right.length) < QUANTITIES["sleeve length"].least


def _only_uncovered(claim: Claim, before: GarmentFacts, after: GarmentFacts) -> bool:
    """Whether a neckline is as it was, and is spoken of only because a collar or the other half is gone."""
    face = "back" if claim.name.startswith("back") else "front"
    was, now = (f.back_neck if face == "back" else f.front_neck for f in (before, after))
    if was is None or now is None:
        return False
    if claim.name in ("neck_depth", "back_depth"):
        return not QUANTITIES["neck depth" if face == "front" else "back depth"].seen(was.depth, now.depth)
    halves = [(was.left, now.left), (was.right, now.right)]
    if claim.name in ("left_neckline", "right_neckline"):
        halves = [halves[0 if claim.name.startswith("left") else 1]]
    elif claim.name not in ("neckline", "back_neckline"):
        return False
    return all(a is not None and b is not None and a.shape == b.shape for a, b in halves)


def _of_steps(steps: Sequence[Step], rng: random.Random) -> list[Request]:
    found = []
    for step in steps:
        words = step_words()[step.quantity, step.direction]
        change = Step(step.quantity, step.direction)
        texts = words.texts
        if words.texts_by and rng.random() < _WITH_AMOUNT and step.amount is not None:
            text, amount = _amount(step.amount, rng)
            texts = tuple(t.replace("{by}", text) for t in words.texts_by)
            change = Step(step.quantity, step.direction, amount)
        found.append(Request(words.topic, words.importance, texts, (change,)))
    return found


def _leave_out_consequences(
    found: dict[str, list[Request]], before: GarmentFacts, after: GarmentFacts
) -> None:
    """Drops what only follows from something else that is asked for."""
    bands = [f.waistband.height if f.waistband else 0.0 for f in (before, after)]
    if "waistband" in found and abs(after.length - before.length) < abs(bands[1] - bands[0]) + 4.0:
        found.pop("length", None)
    if "waist" in found and "length" in found:
        found.pop("waist" if after.skirt is None and after.trousers is None else "length")
    if "neck_width" in found:
        found.pop("shoulders", None) if before.strapless == after.strapless else None
    if any(t in found for t in ("neckline", "shoulders", "sleeves")):
        found.pop("sides", None)
    if any(f"{side}_neckline" in found for side in ("left", "right")):
        found.pop("neckline", None)
    for one, other in (("sleeve_end", "sleeve_shape"), ("sleeve_head", "sleeve_shape")):
        if one in found and other in found:
            least = min((one, other), key=lambda t: max(r.importance for r in found[t]))
            del found[least]
    for consequence, causes in _FOLLOWS.items():
        if consequence in found and any(c in found for c in causes):
            kept = [r for r in found[consequence] if r.importance >= 5.0]
            if kept:
                found[consequence] = kept
            else:
                del found[consequence]
    if "length" in found and "skirt" in found:
        # The hem of a flared skirt grows with its length.
        kept = [r for r in found["skirt"] if not any(isinstance(c, Step) for c in r.changes)]
        if kept:
            found["skirt"] = kept
        else:
            del found["skirt"]


_FOLLOWS: dict[str, tuple[str, ...]] = {
    "bodice": ("fit", "waistband", "skirt"),
    "band_width": ("fit",),
    "back": ("neck_width",),
    "armholes": ("sleeves",),
    "sleeve_gathers": ("cuffs", "sleeves"),
}
"""What seldom needs saying where one of the others is said."""


def _restate(before: GarmentFacts, after: GarmentFacts, rng: random.Random) -> Instruction | None:
    """Says what to make of it, where too much is different to list."""
    claims = claims_of(after)
    for _ in range(8):
        speech = Speech(rng, claims, "uk" if rng.random() < 0.5 else "us", "cm", numbers=False)
        text, said = phrase(speech)
        stated = tuple(dict.fromkeys(c for p in said for c in p.claims))
        new = [c for c in stated if not c.holds(before)]
        if len(new) >= 2 and any(c.name == "kind" for c in stated):
            noun = text.rstrip(".")
            noun = noun if noun[1:2] == "-" else noun[:1].lower() + noun[1:]
            frame = rng.choice(("turn it into {}", "make it {}", "change it to {}", "rework it as {}"))
            return Instruction(_sentence([frame.format(noun)], rng), tuple(Gain(c) for c in stated))
    return None


def _amount(cm: float, rng: random.Random) -> tuple[str, float]:
    """An amount in words, and what it is in cm as it was said."""
    if rng.random() < _INCHES:
        inches = max(round(cm / CM_PER_INCH * 2) / 2, 0.5)
        unit = rng.choice(("inches", "in")) if inches > 1 else "inch"
        return f"{inches:g} {unit}", round(inches * CM_PER_INCH, 2)
    rounded = max(float(round(cm)), 1.0)
    return f"{rounded:g} cm", rounded


def _fill(text: str, before: GarmentFacts, after: GarmentFacts) -> str:
    names = {"top": "top", "dress": "dress", "skirt": "skirt"}
    band = before.waistband or after.waistband
    text = text.format(
        garment=names.get(before.kind, "garment"),
        band="hem band" if band is not None and band.at_hem else "waistband",
    )
    for verb in ("end", "reach", "cover"):  # "make the skirt reach the knee" needs no adjective's grammar
        text = text.replace(f"make the legs {verb}", f"let the legs {verb}")
    return with_articles(text)


def _sentence(clauses: list[str], rng: random.Random) -> str:
    if len(clauses) > 1:
        link = rng.choice((" and ", " and ", ", and ", ", then "))
        body = ", ".join(clauses[:-1]) + link + clauses[-1]
    else:
        body = clauses[0]
    frame = rng.choice(
        (
            "{C}.",
            "{C}.",
            "{C}",
            "{c}",
            "Please {c}.",
            "{C}, please.",
            "Can you {c}?",
            "Could you {c}?",
            "I want you to {c}.",
            "I'd like you to {c}.",
            "Now {c}.",
            "Edit it: {c}.",
            "Keep the rest and {c}.",
        )
    )
    return frame.format(C=body[:1].upper() + body[1:], c=body)
