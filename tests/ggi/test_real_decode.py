"""Both decodes on real patterns of GarmentCode."""

import gzip
import json

import numpy as np
import pytest
from ggi_patterns import any_garment

from swifttailor.ggi import encode
from swifttailor.ggi.grid_decode import decode_grid
from swifttailor.ggi.outline_decode import decode_outline
from swifttailor.panel_mesh.topology import topology
from swifttailor.pattern import read_specification

TIPS = ("gc_1000595", "gc_1002203", "gc_1002395")
"""Where seams meet at tips narrower than a pixel."""
GODETS = ("gc_1001770",)
CIRCLE = ("gc_1000270",)
FREE_SLITS = ("gc_1002852", "gc_1005248")
FOLDS = ("gc_1002621",)
"""Where sewing lays the two sides of a tip upon each other."""


@pytest.fixture(scope="module")
def patterns(garmentcode_folder):
    with gzip.open(garmentcode_folder / "validation.jsonl.gz", "rt") as lines:
        records = [json.loads(line) for line in lines]
    return {r["id"]: read_specification(r["pattern"]).pattern.canonical() for r in records}


def counts(garment):
    found = topology(np.asarray(garment.faces, np.int32), len(garment.vertices))
    assert found.nonmanifold_edges == 0
    return found.components, found.boundary_loops, found.euler_characteristic


@pytest.mark.parametrize("name", [*TIPS, *GODETS, *CIRCLE, *FREE_SLITS, *FOLDS])
def test_godets_slits_and_tips_keep_their_topology(patterns, name):
    garment = any_garment(patterns[name], 2.0)
    images = encode(garment, 256)
    assert counts(decode_grid(images)) == counts(garment)
    assert counts(decode_outline(images.layout, images.geometry, 2.0)) == counts(garment)


def test_nearly_all_patterns_keep_their_topology(patterns):
    some = list(patterns.values())[::15]
    kept = 0
    for pattern in some:
        garment = any_garment(pattern, 4.0)
        images = encode(garment, 256)
        kept += counts(decode_grid(images)) == counts(garment)
        decoded = decode_outline(images.layout, images.geometry, 4.0)
        assert np.array_equal(decoded.faces, garment.faces)
    assert kept >= 0.95 * len(some) - 1
