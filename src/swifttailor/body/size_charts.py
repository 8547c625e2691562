"""Size charts: which body a size is for."""

from __future__ import annotations

import functools
import re
from dataclasses import dataclass
from importlib import resources

from swifttailor.errors import InputError

FIGURES = ("women", "men", "children")
REGIONS = ("EU", "UK", "US")
_FIGURE_WORDS = {
    "women": "women woman womens women's lady ladies misses female w",
    "men": "men man mens men's gents gent male m's",
    "children": "children child childrens children's kid kids kid's girl girls boy boys girl's boy's",
}
_REGION_WORDS = {"EU": "eu eur european german de fr", "UK": "uk gb british", "US": "us usa american"}
_WORDS = {
    word: (kind, value)
    for kind, table in (("figure", _FIGURE_WORDS), ("region", _REGION_WORDS))
    for value, words in table.items()
    for word in words.split()
} | {"size": ("", ""), "sized": ("", ""), "sz": ("", "")}
_LETTERS = {"2XL": "XXL", "EXTRA-LARGE": "XL", "XXXL": "3XL", "XXXXL": "4XL"}


@dataclass(frozen=True)
class Size:
    """One size of a chart."""

    figure: str
    """``women``, ``men`` or ``children``."""
    region: str
    """``EU``, ``UK``, ``US`` or ``letters``."""
    label: str
    measures: dict[str, float]
    """Of the body that it is for, by `body_measures.MEASURES`, cm."""

    @property
    def title(self) -> str:
        """For people, and for `find_size`: ``women EU 44``."""
        region = "" if self.region == "letters" else f"{self.region} "
        return f"{self.figure} {region}{self.label}"


@functools.cache
def charts() -> dict[tuple[str, str], dict[str, Size]]:
    """All charts, by figure and region, and in them the sizes by their labels."""
    found: dict[tuple[str, str], dict[str, Size]] = {}
    for figure in FIGURES:
        text = resources.files("swifttailor.body").joinpath(f"sizes/{figure}.txt").read_text("utf-8")
        for line in text.splitlines():
            words = line.split()
            if not words or line.startswith("#"):
                continue
            if line.startswith("["):
                region = line.strip("[] ")
                found[figure, region] = {}
            elif words[0] == "size":
                names = words[1:]
            else:
                measures = {n: float(v) for n, v in zip(names, words[1:], strict=True) if v != "-"}
                found[figure, region][words[0]] = Size(figure, region, words[0], measures)
    return found


def find_size(text: str) -> Size:
    """The size that a text names: ``44``, ``UK 12``, ``men EU 50``, ``children 128``, ``M``.

    Without a figure women's sizes are meant, without a region EU sizes or letters.

    Raises:
        InputError: There is no such size; the text lists those that there are.
    """
    figure, region, labels = None, None, []
    for word in re.sub(r"(?i)\b(eu|uk|us)(?=\d)", r"\1 ", text.replace("-", " ").replace(",", " ")).split():
        kind, value = _WORDS.get(word.lower(), ("label", word.upper()))
        if kind == "figure":
            figure = value
        elif kind == "region":
            region = value
        elif kind == "label":
            labels.append(_LETTERS.get(value, value))
    figure = figure or "women"
    if len(labels) != 1:
        raise InputError(f"'{text}' names no size. {_accepted(figure, region)}")
    (label,) = labels
    known = charts()
    for chart in [region] if region else ["EU", "letters"]:
        one = known.get((figure, chart), {}).get(label)
        if one is not None:
            return one
    raise InputError(f"There is no size '{text}'. {_accepted(figure, region)}")


def size_run(text: str) -> list[Size]:
    """The sizes from one to another of a chart, ``36-46`` or ``men 46-54``, or a list of sizes, ``36,40``.

    Raises:
        InputError: There is no such size, or no two of one chart.
    """
    match = re.fullmatch(r"\s*(.*?)(\S+)\s*(?:-|\.\.|\bto\b)\s*(\S+)\s*", text)
    if match is None:
        return [find_size(one) for one in text.split(",")]
    before, low, high = match.groups()
    first, last = find_size(f"{before} {low}"), find_size(f"{before} {high}")
    chart = list(charts()[first.figure, first.region].values())
    if first.region != last.region or chart.index(first) >= chart.index(last):
        raise InputError(
            f"'{text}' is not a run of sizes. Give the smallest and the largest of one chart, such as 36-46."
        )
    return chart[chart.index(first) : chart.index(last) + 1]


def _accepted(figure: str, region: str | None) -> str:
    lists = [
        f"{name}: {', '.join(chart)}"
        for (whose, name), chart in charts().items()
        if whose == figure and region in (None, name)
    ]
    others = ", ".join(f"'{other} ...'" for other in FIGURES if other != figure)
    shown = "; ".join(lists) or f"no {region} sizes"
    return f"For {figure} there are {shown}. Others: {others}."
