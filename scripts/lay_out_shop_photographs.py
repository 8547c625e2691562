"""Lays out shops' photographs of dressed people as `train picture-reader --photographs` wants them.

``python scripts/lay_out_shop_photographs.py FOLDER GARMENTS.jsonl --out DIR [--longest 640]``

FOLDER is ``catalog/product`` of the sample data of a shop of Magento's kind, with photographs like
``v/d/vd01-rd_main.jpg``: product, colour, view. GARMENTS (one of scripts/shop_garments) says of each product
which part of the body it covers, its claims, what else is worn, and from which side each view shows it; views
of details are left out. Writes DIR/garments.jsonl and DIR/images, of all colours.
"""

from __future__ import annotations

import argparse
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from PIL import Image

from swifttailor.data.pictures.photograph_lists import OF_GARMENTS, SIDES

NAMED = re.compile(r"(?P<product>[a-z]+\d+)-[a-z]+(?P<view>[_-].*)")
WHOLE, UPPER, LOWER = (92.0, 190.0), (125.0, 105.0), (52.0, 118.0)
"""Level of the middle and height of what photographs of dresses, tops and what covers legs show, cm."""
ONE_PIECE = {"dress", "jumpsuit", "playsuit"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("garments", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--longest", type=int, default=640)
    options = parser.parse_args()
    lines = options.garments.read_text(encoding="utf-8").splitlines()
    products = {row["product"]: row for row in map(json.loads, lines)}
    images = options.out / "images"
    images.mkdir(parents=True)
    rows = []
    for path, row in _photographs(options.folder, products):
        with Image.open(path) as opened:
            opened.draft("RGB", (options.longest, options.longest))
            image = opened.convert("RGB")
        image.thumbnail((options.longest, options.longest))
        image.save(images / path.name, quality=95)
        rows.append(json.dumps({"image": f"images/{path.name}", **row}))
    (options.out / OF_GARMENTS).write_text("\n".join(rows) + "\n", encoding="utf-8")


def _photographs(folder: Path, products: dict[str, Any]) -> Iterator[tuple[Path, dict[str, Any]]]:
    for path in sorted(folder.glob("*/*/*.jpg")):
        named = NAMED.fullmatch(path.stem)
        product = products.get(named["product"]) if named else None
        view = product["views"].get(named["view"]) if named and product else None
        if product and view and view["side"] in SIDES:
            yield path, _row(product, view)


def _row(product: dict[str, Any], view: dict[str, Any]) -> dict[str, Any]:
    """A line of the list, but for the image."""
    part, side = product["part"], view["side"]
    hidden = {*view.get("hides", ()), *(("neckline",) if side == "back" else ())}
    claims = {name: words for name, words in product["claims"].items() if name not in hidden}
    one_piece = part == "upper" and bool(ONE_PIECE & set(product["claims"].get("kind", ())))
    middle, seen = WHOLE if one_piece else UPPER if part == "upper" else LOWER
    row = {"group": product["product"], "side": side, part: claims, "middle": middle, "seen": seen}
    beside = "lower" if part == "upper" else "upper"
    if product.get("other") and side == "front":
        row[beside] = product["other"]
    elif one_piece or (part == "lower" and not product.get("other")):
        row[beside] = None  # what covers legs is shown from the bare waist down
    return row


if __name__ == "__main__":
    main()
