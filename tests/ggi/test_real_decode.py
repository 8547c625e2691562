"""Both decodes on real patterns of GarmentCode."""

import numpy as np
import pytest
from ggi_patterns import any_garment

from swifttailor.ggi import encode
from swifttailor.ggi.grid_decode import decode_grid
from swifttailor.ggi.outline_decode import decode_outline
from swifttailor.panel_mesh.topology import topology
from swifttailor.pattern import read_specification

SHIPPED = ("gc_1000981", "gc_1002038", "gc_1000326")
"""Beside the tests: godets, a circle, slits, tiers."""
TIPS = ("gc_1000595", "gc_1002203", "gc_1002395")
"""Where seams meet at tips narrower than a pixel."""
GODETS = ("gc_1001770",)
CIRCLE = ("gc_1000270",)
FREE_SLITS = ("gc_1002852", "gc_1005248")
FOLDS = ("gc_1002621",)
"""Where sewing lays the two sides of a tip upon each other."""


@pytest.fixture(scope="module")
def patterns(real_samples):
    samples = real_samples("repository", "validation")
    return {s["id"]: read_specification(s["pattern"]).pattern.canonical() for s in samples}


def counts(garment):
    found = topology(np.asarray(garment.faces, np.int32), len(garment.vertices))
    assert found.nonmanifold_edges == 0
    return found.components, found.boundary_loops, found.euler_characteristic


@pytest.mark.parametrize("name", [*SHIPPED, *TIPS, *GODETS, *CIRCLE, *FREE_SLITS, *FOLDS])
def test_godets_slits_and_tips_keep_their_topology(patterns, name):
    if name not in patterns:
        pytest.skip("validation.jsonl.gz is not there")
    garment = any_garment(patterns[name], 2.0)
    images = encode(garment, 256)
    assert counts(decode_grid(images)) == counts(garment)
    assert counts(decode_outline(images.layout, images.geometry, 2.0)) == counts(garment)


def test_nearly_all_patterns_keep_their_topology(patterns):
    some = list(patterns.values())
    some = some[:20:3] + some[20::20]
    kept = 0
    for pattern in some:
        garment = any_garment(pattern, 4.0)
        images = encode(garment, 256)
        kept += counts(decode_grid(images)) == counts(garment)
        decoded = decode_outline(images.layout, images.geometry, 4.0)
        assert np.array_equal(decoded.faces, garment.faces)
    assert kept >= 0.95 * len(some) - 1
