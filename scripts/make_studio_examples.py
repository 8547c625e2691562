"""Makes what ships with the studio: examples, the body, what chips and sliders can say.

    .venv/bin/python scripts/make_studio_examples.py [--words-only]

Writes src/swifttailor/studio/shipped_data/ anew: garments of the words below by the networks that ship, hung
to rest by physics. Run it after the networks, the reader of words or the mesh file have changed.
"""

from __future__ import annotations

import argparse
import gzip
import io
import json

from PIL import Image

from swifttailor import Tailor
from swifttailor.body import Body
from swifttailor.garment.preview import draw_preview
from swifttailor.pattern import read_specification
from swifttailor.pattern.garmentcode_reader import MAX_EDGES, MAX_PANELS
from swifttailor.studio.bench.chips import sliders
from swifttailor.studio.bench.claim_labels import claim_options, dimension_options
from swifttailor.studio.bench.documents import caption, tailored_document
from swifttailor.studio.bench.wearer_options import wearer_options
from swifttailor.studio.body_mesh import body_record
from swifttailor.studio.compact_mesh import expand, shrink
from swifttailor.studio.mesh_record import name_of
from swifttailor.studio.shipped import BODY, DOCUMENT, FOLDER, MESH, OPTIONS, THUMBNAIL
from swifttailor.tailor.reading import facts_of

EXAMPLES = {
    "summer-dress": (
        "Summer dress",
        "a midi dress with a V neck, short sleeves and a flared skirt in dusty rose",
        0,
    ),
    "shirt": ("T-shirt", "a white t-shirt with a round neck and short sleeves", 0),
    "trousers": ("Wide trousers", "wide high-waisted trousers in navy", 0),
    "pencil-skirt": ("Pencil skirt", "a knee-length pencil skirt with a back slit in charcoal", 0),
    "jumpsuit": ("Jumpsuit", "a sleeveless jumpsuit with wide legs in olive", 0),
    "hoodie": ("Hoodie", "a loose hoodie with long sleeves in teal", 0),
    "gathered-skirt": ("Gathered skirt", "a gathered midi skirt in mustard", 0),
    "long-dress": ("Long dress", "a long-sleeved maxi dress with a boat neck in burgundy", 0),
}
"""Id: title, prompt, seed; the first is shown when the studio opens."""
THUMBNAIL_SIZE = 280, 360
EDGE_LENGTH = 2.5


def thumbnail(tailored) -> bytes:
    """The garment from the front, (w, h) THUMBNAIL_SIZE, as WebP."""
    width, height = THUMBNAIL_SIZE
    picture = draw_preview(tailored.garment, Body.default(), size=(3 * 2 * width, 2 * height))
    # Three views side by side; the front is the first.
    front = Image.fromarray(picture[:, : 2 * width]).resize(THUMBNAIL_SIZE, Image.Resampling.LANCZOS)
    content = io.BytesIO()
    front.save(content, "WEBP", quality=80, method=6)
    return content.getvalue()


def packed(value: object) -> bytes:
    return gzip.compress(json.dumps(value, separators=(",", ":"), allow_nan=False).encode(), 9, mtime=0)


def refresh_words() -> None:
    """What can be chosen, and what examples say of themselves: after claims, levers or captions changed."""
    options = json.loads(gzip.decompress((FOLDER / OPTIONS).read_bytes()))
    options |= {"claims": claim_options(), "dimensions": dimension_options(), "wearers": wearer_options()}
    (FOLDER / OPTIONS).write_bytes(packed(options))
    for name in options["examples"]:
        path = FOLDER / f"{name}{DOCUMENT}"
        document = json.loads(gzip.decompress(path.read_bytes()))
        facts = facts_of(read_specification(document["pattern"]).pattern)
        path.write_bytes(packed(document | {"dimensions": sliders(facts), "description": caption(facts)}))


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--words-only", action="store_true", help="keep the garments (a second)")
    if parser.parse_args().words_only:
        refresh_words()
        return
    FOLDER.mkdir(exist_ok=True)
    for path in FOLDER.iterdir():
        path.unlink()
    body = shrink(body_record().data)
    (FOLDER / BODY).write_bytes(body)
    options = {
        "examples": list(EXAMPLES),
        "body": name_of(expand(body)),
        "claims": claim_options(),
        "dimensions": dimension_options(),
        "wearers": wearer_options(),
        "of_patterns": {"panels": MAX_PANELS, "edges": MAX_EDGES},
    }
    (FOLDER / OPTIONS).write_bytes(packed(options))  # documents name the body
    tailor = Tailor.load()
    for name, (title, prompt, seed) in EXAMPLES.items():
        made = tailor.generate(prompt, seed=seed, edge_length=EDGE_LENGTH, finish=True)
        work = tailored_document(made, origin="example", prompt=prompt, edge_length=EDGE_LENGTH, title=title)
        mesh = shrink(work.meshes[0].data)
        document = work.answer | {"mesh": name_of(expand(mesh))}
        (FOLDER / f"{name}{DOCUMENT}").write_bytes(packed(document))
        (FOLDER / f"{name}{MESH}").write_bytes(mesh)
        (FOLDER / f"{name}{THUMBNAIL}").write_bytes(thumbnail(made))
        size = sum(p.stat().st_size for p in FOLDER.glob(f"{name}.*"))
        print(f"{name}: {size / 1000:.0f} kB; {made.report['quality']['accepted']}; {'; '.join(made.notes)}")
    total = sum(path.stat().st_size for path in FOLDER.iterdir())
    print(f"{total / 1000:.0f} kB in all")


if __name__ == "__main__":
    main()
