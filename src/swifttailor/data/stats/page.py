"""One HTML page with everything about a data set: opens in any browser, fetches nothing from elsewhere."""

from __future__ import annotations

import html
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from swifttailor.atomic_files import write_atomically, write_text
from swifttailor.data.stats.numbers import MEASURES, SplitNumbers
from swifttailor.data.stats.sheets import Shown

PAGE, PICTURES = "index.html", "pictures"
_STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; margin: 0 auto; max-width: 1240px; padding: 1rem; color: #222;
  background: #faf9f7 }
h1 { font-size: 1.6rem } h2 { margin-top: 2.5rem; border-top: 1px solid #ddd; padding-top: 1rem }
table { border-collapse: collapse } td, th { padding: .15rem .9rem .15rem 0; text-align: left }
td.n { text-align: right; font-variant-numeric: tabular-nums }
.grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(270px, 1fr)); gap: 1rem }
figure { margin: 0 } figcaption { font-size: .85rem; color: #555 }
svg rect { fill: #47788f } svg text { font-size: 10px; fill: #666 }
article { background: #fff; border: 1px solid #e4e2dd; border-radius: 6px; padding: .5rem }
article img { width: 33.3%; display: inline-block } article p { margin: .3rem 0; font-size: .9rem }
article small { color: #777 } input { font: inherit; padding: .3rem .6rem; width: 24rem; max-width: 100% }
@media (prefers-color-scheme: dark) { body { background: #1c1c1d; color: #ddd } article { background: #262627;
  border-color: #3a3a3b } figcaption, article small { color: #aaa } svg text { fill: #aaa } }
"""
_SCRIPT = """
document.getElementById('find').addEventListener('input', event => {
  const words = event.target.value.toLowerCase().split(/\\s+/).filter(Boolean);
  for (const one of document.querySelectorAll('article')) {
    const text = one.textContent.toLowerCase();
    one.hidden = !words.every(word => text.includes(word));
  }
});
"""


def write_page(
    folder: Path, title: str, numbers: Mapping[str, SplitNumbers], shown: Mapping[str, Sequence[Shown]]
) -> Path:
    """Writes index.html and the pictures it shows.

    Args:
        folder: For the page; made when missing.
        title: Name of the data set.
        numbers: Of each split.
        shown: Samples of each split.

    Returns:
        The page.
    """
    parts = [f"<h1>{_text(title)}</h1>", _overview(numbers)]
    for name, found in numbers.items():
        parts += [f"<h2>{_text(name)}</h2>", _rejections(found), _distributions(found), _claims(found)]
    parts += [
        "<h2>Samples</h2>",
        "<p><input id='find' type='search' placeholder='id or words of the caption'></p>",
    ]
    parts.append("<div class='grid'>")
    for name, samples in shown.items():
        parts += [_article(folder, name, one) for one in samples]
    parts.append("</div>")
    page = (
        f"<!doctype html><html lang='en'><meta charset='utf-8'><title>{_text(title)}</title>"
        "<meta name='viewport' content='width=device-width'>"
        f"<style>{_STYLE}</style><body>{''.join(parts)}<script>{_SCRIPT}</script></body></html>\n"
    )
    return write_text(folder / PAGE, page)


def histogram(values: np.ndarray, bins: int = 28) -> str:
    """An SVG picture of how values (n,) are distributed; what is not finite is left out."""
    known = values[np.isfinite(values)]
    if not len(known):
        return "<p>no values</p>"
    low, high = (float(v) for v in np.quantile(known, (0.002, 0.998)))
    high = high if high > low else low + 1.0
    counts, _ = np.histogram(np.clip(known, low, high), bins=bins, range=(low, high))
    width, height = 270, 84
    step = width / bins
    tallest = max(int(counts.max()), 1)
    bars = "".join(
        f"<rect x='{k * step:.1f}' y='{height - 14 - 70 * c / tallest:.1f}' width='{step - 1:.1f}' "
        f"height='{70 * c / tallest:.1f}'><title>{c}</title></rect>"
        for k, c in enumerate(counts.tolist())
    )
    labels = (
        f"<text x='0' y='{height - 2}'>{low:.4g}</text>"
        f"<text x='{width}' y='{height - 2}' text-anchor='end'>{high:.4g}</text>"
    )
    return f"<svg viewBox='0 0 {width} {height}' role='img'>{bars}{labels}</svg>"


def _overview(numbers: Mapping[str, SplitNumbers]) -> str:
    rows = []
    for name, found in numbers.items():
        n = found.to_json()
        cells = [n["patterns"], n["accepted"], n["rejected"], n["failed"], f"{n['acceptance']:.1%}"]
        cells += [f"{n['megabytes']:.1f}", f"{n['kilobytes_a_sample']:.2f}", "yes" if n["complete"] else "no"]
        rows.append(f"<tr><td>{_text(name)}</td>{''.join(f'<td class=n>{c}</td>' for c in cells)}</tr>")
    heads = ("split", "patterns", "accepted", "rejected", "failed", "share", "MB", "KB a sample", "complete")
    return f"<table><tr>{''.join(f'<th>{h}</th>' for h in heads)}</tr>{''.join(rows)}</table>"


def _rejections(found: SplitNumbers) -> str:
    if not found.reasons:
        return ""
    rows = "".join(f"<tr><td class=n>{n}</td><td>{_text(r)}</td></tr>" for r, n in found.reasons.items())
    return f"<h3>Why patterns gave no sample</h3><table>{rows}</table>"


def _distributions(found: SplitNumbers) -> str:
    figures = "".join(
        f"<figure>{histogram(found.values[name])}<figcaption>{_text(meaning)}</figcaption></figure>"
        for name, meaning in MEASURES.items()
    )
    return f"<h3>Distributions</h3><div class='grid'>{figures}</div>"


def _claims(found: SplitNumbers) -> str:
    total = max(sum(len(s.ids) for s in found.index.shards), 1)
    rows = []
    for name, values in sorted(found.claims.items()):
        shares = ", ".join(f"{_text(v)} {n / total:.1%}" for v, n in values.most_common(14))
        rows.append(f"<tr><td>{_text(name.replace('_', ' '))}</td><td>{shares}</td></tr>")
    return f"<h3>What the garments are</h3><table>{''.join(rows)}</table>" if rows else ""


def _article(folder: Path, split: str, one: Shown) -> str:
    from PIL import Image

    images = []
    for kind in ("front", "back", "render"):
        name = f"{split}-{one.facts['number']:06d}-{kind}.webp"
        picture = Image.fromarray(getattr(one, kind))
        write_atomically(
            folder / PICTURES / name, lambda path, picture=picture: picture.save(path, "WEBP", quality=82)
        )
        images.append(f"<img loading='lazy' src='{PICTURES}/{name}' alt='{kind}'>")
    facts = (
        f"{split} #{one.facts['number']}, {one.facts['panels']} panels, {one.facts['vertices']} vertices, "
    )
    facts += f"strain {one.facts['strain']}, {one.facts['crossings']} crossings, {one.facts['source']}"
    return (
        f"<article>{''.join(images)}<p><b>{_text(one.id)}</b> {_text(one.caption)}</p>"
        f"<small>{_text(facts)}</small></article>"
    )


def _text(value: object) -> str:
    return html.escape(str(value))
