import dataclasses

import numpy as np
import pytest
from ggi_patterns import HARD_CASES, any_garment, rectangle
from grid_reference import remesh as plain_remesh
from grid_reference import stitch as plain_stitch
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.errors import GeometryError, InputError
from swifttailor.ggi import encode
from swifttailor.ggi.grid_decode import decode_grid
from swifttailor.ggi.pockets import fill_pockets
from swifttailor.ggi.remesh import PixelGrid, remesh
from swifttailor.ggi.slits import open_grid, seam_sides
from swifttailor.ggi.stitching import StitchingImage
from swifttailor.ggi.warping import warp
from swifttailor.panel_mesh.topology import edge_faces, topology
from swifttailor.pattern import Edge, EdgeRef, Panel, Pattern, Stitch
from swifttailor.pattern.drafts import draft, list_drafts


def counts(faces, vertex_count):
    found = topology(np.asarray(faces, np.int32), vertex_count)
    assert found.nonmanifold_edges == 0
    return found.components, found.boundary_loops, found.euler_characteristic


def counts_of(garment):
    return counts(garment.faces, len(garment.vertices))


def around(face):
    """A face from its least corner on: the same whichever corner it was begun with."""
    k = face.index(min(face))
    return face[k:] + face[:k]


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 2**32 - 1), st.integers(2, 14), st.floats(0.3, 1.0))
def test_remeshing_agrees_with_the_plain_way(seed, size, share):
    rng = np.random.default_rng(seed)
    panel = np.where(rng.random((size, size)) < share, rng.integers(0, 2, (size, size)), -1)
    positions = rng.normal(size=(size, size, 3))
    grid = PixelGrid.of(panel)
    faces = grid.pixels[remesh(grid, positions.reshape(-1, 3)[grid.pixels])]
    assert sorted(around(tuple(f)) for f in faces.tolist()) == sorted(
        around(f) for f in plain_remesh(panel, positions)
    )


def test_wanted_diagonals_are_taken():
    grid = PixelGrid.of(np.zeros((2, 2), int))
    positions = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 5, 0]])
    shorter = {frozenset(f) for f in remesh(grid, positions).tolist()}
    assert shorter == {frozenset({0, 1, 2}), frozenset({1, 2, 3})}
    forced = {frozenset(f) for f in remesh(grid, positions, np.array([[3, 0]])).tolist()}
    assert forced == {frozenset({0, 1, 3}), frozenset({0, 2, 3})}


def tube():
    """Front and back, sewn along both sides, the back gathered."""
    front, back = rectangle("front", 20.0, 30.0), rectangle("back", 27.0, 44.0, clockwise=True)
    sides = (Stitch(EdgeRef("front", 1), EdgeRef("back", 0)), Stitch(EdgeRef("front", 3), EdgeRef("back", 2)))
    return Pattern((front, back), sides)


@pytest.mark.parametrize("pattern", [tube(), HARD_CASES["sleeve"](), HARD_CASES["right_wrong"]()])
def test_without_slits_and_tips_decoding_is_the_papers(pattern):
    images = encode(any_garment(pattern, 3.0), 64)
    sewn = images.stitching
    pairs = sewn.pixels[warp(sewn.fraction.astype(float), sewn.start)].tolist()
    place, faces = plain_stitch(plain_remesh(images.panel, images.geometry), pairs, images.geometry)
    decoded = decode_grid(images)
    assert counts_of(decoded) == counts(
        np.unique(np.array(faces), return_inverse=True)[1].reshape(-1, 3), len({v for f in faces for v in f})
    )
    # The diagonals beside seams may differ; the vertices may not.
    for pixel, vertex in zip(decoded.flat_pixels.tolist(), decoded.weld.tolist(), strict=True):
        assert np.abs(decoded.vertices[vertex] - place[pixel]).max() < 1e-4
    assert len(decoded.faces) == pytest.approx(len(faces), rel=0.01)


@pytest.mark.parametrize("resolution", [64, 128, 256])
@pytest.mark.parametrize("case", ["dart", "right_wrong", "sleeve"])
def test_hard_cases_keep_their_topology(case, resolution):
    garment = any_garment(HARD_CASES[case](), 2.0)
    assert counts_of(decode_grid(encode(garment, resolution))) == counts_of(garment)


def test_a_cuff_thinner_than_a_pixel_joins_what_is_sewn_to_it():
    garment = any_garment(HARD_CASES["sliver"](), 8.0)
    images = encode(garment, 256)
    decoded = decode_grid(images)
    sliver = [p.name for p in images.layout.pattern.panels].index("sl_left_cuff_f")
    assert not (decoded.face_panel == sliver).any()
    assert counts_of(decoded) == counts_of(garment)


def godet(gap):
    """A panel slit open from its hem, a wedge sewn into the slit, and the two sides sewn together."""
    slit = np.array(
        [[0, 0], [20 - gap / 2, 0], [20, 25], [20 + gap / 2, 0], [40, 0], [40, 40], [0, 40]], float
    )
    wedge = np.array([[0, 0], [12, 0], [6, 24.3]])
    panels = (Panel("skirt_front", slit, (Edge(),) * 7), Panel("ins_skirt_front_0", wedge, (Edge(),) * 3))
    stitches = (
        Stitch(EdgeRef("skirt_front", 1), EdgeRef("ins_skirt_front_0", 2)),
        Stitch(EdgeRef("skirt_front", 2), EdgeRef("ins_skirt_front_0", 1)),
    )
    return Pattern(panels, stitches)


@pytest.mark.parametrize("gap", [0.02, 0.4, 1.0, 2.0])
@pytest.mark.parametrize("resolution", [64, 100, 256])
def test_slits_for_godets_stay_open(gap, resolution):
    garment = any_garment(godet(gap), 2.0)
    images = encode(garment, resolution)
    decoded = decode_grid(images)
    assert counts_of(decoded) == counts_of(garment) == (1, 1, 1)
    # Both sides of the slit have vertices of their own, an edge of the wedge between them.
    first, second = decoded.seams
    assert len(set(first.tolist()) & set(second.tolist())) <= 2


def test_a_pixel_with_both_sides_of_a_slit_shows_one_and_the_other_comes_from_its_partner():
    garment = any_garment(godet(0.02), 2.0)
    # Space is the wedge's own plane, so that its two edges are far apart although the slit's sides are not.
    images = encode(garment, 100)
    wedge = [p.name for p in images.layout.pattern.panels].index("ins_skirt_front_0")
    slit = 1 - wedge
    grid = PixelGrid.of(images.panel)
    sides = seam_sides(grid, images.stitching)
    place = np.zeros((len(grid.pixels), 3))
    place[:, 0] = np.where(grid.panel == wedge, (grid.pixels % 100).astype(float), 0.0)
    for k in range(2):
        pixels, fraction = images.stitching.side(k, 0)
        other, there = images.stitching.side(k, 1)
        if images.panel.ravel()[pixels[0]] != slit:
            pixels, fraction, other, there = other, there, pixels, fraction
        shown = images.stitching.ids.ravel()[pixels] == k + 1
        value = np.interp(fraction, there, other % 100)
        place[np.searchsorted(grid.pixels, pixels[shown]), 0] = value[shown]
    geometry = np.zeros((100, 100, 3), np.float32)
    geometry.reshape(-1, 3)[grid.pixels] = place
    decoded = decode_grid(dataclasses.replace(images, geometry=geometry))
    for k, seam in enumerate(decoded.seams):
        other, _ = images.stitching.side(
            k, 1 if images.panel.ravel()[images.stitching.side(k, 0)[0][0]] == slit else 0
        )
        assert np.isin(
            np.round(decoded.vertices[seam][2:-2, 0]), (other % 100) + np.arange(-1, 2)[:, None]
        ).all()
    assert len(sides.link)


def test_a_tip_narrower_than_a_pixel_leaves_no_crumbs():
    needle = Panel("left_collar_front", np.array([[0, 0], [60.0, 0.0], [60.0, 8.0]]), (Edge(),) * 3)
    cloth = rectangle("left_ftorso", 60.0, 30.0)
    pattern = Pattern((needle, cloth), (Stitch(EdgeRef("left_collar_front", 0), EdgeRef("left_ftorso", 2)),))
    garment = any_garment(pattern, 2.0)
    for resolution in (32, 50, 64, 128):
        decoded = decode_grid(encode(garment, resolution))
        assert counts_of(decoded) == counts_of(garment) == (1, 1, 1)


def needles(height):
    """Two needles sewn to a cloth side by side, their tips meeting, and to each other."""
    cloth = Panel(
        "left_ftorso", np.array([[0, 0], [60, 0], [60, 30], [30, 30], [0, 30]], float), (Edge(),) * 5
    )
    one = Panel("left_collar_front", np.array([[30.0, 0], [60, 0], [60, height]]), (Edge(),) * 3)
    other = Panel("left_collar_back", np.array([[0.0, 0], [30, 0], [0, height]]), (Edge(),) * 3)
    stitches = (
        Stitch(EdgeRef("left_ftorso", 2), EdgeRef("left_collar_front", 0)),
        Stitch(EdgeRef("left_ftorso", 3), EdgeRef("left_collar_back", 0)),
        Stitch(EdgeRef("left_collar_front", 2), EdgeRef("left_collar_back", 1)),
    )
    return Pattern((cloth, one, other), stitches)


@pytest.mark.parametrize("height", [3.0, 4.0, 5.0, 7.0])
def test_where_tips_meet_no_holes_are_left(height):
    garment = any_garment(needles(height), 2.0)
    assert counts_of(garment) == (1, 1, 1)
    for resolution in (64, 80, 96, 112, 128):
        assert counts_of(decode_grid(encode(garment, resolution))) == (1, 1, 1)


def test_crumbs_beyond_a_neck_narrower_than_a_pixel_are_left_out():
    # A strap of an eighth of a pixel with a tab at its end, which hangs by nothing that a grid could show.
    corners = [
        [0, 0],
        [40, 0],
        [40, 30],
        [20.25, 30],
        [20.25, 50],
        [21, 50],
        [21, 51],
        [20.2, 51],
        [20.2, 30],
    ]
    panel = Panel("left_ftorso", np.array([*corners, [0, 30]], float), (Edge(),) * 10)
    garment = any_garment(Pattern((panel,)), 2.0)
    images = encode(garment, 128)
    decoded = decode_grid(images)
    assert counts_of(decoded) == counts_of(garment) == (1, 1, 1)
    top = images.layout.to_pixels(0, [[20.0, 30.0]])[0, 1]
    assert images.occupancy[int(top) + 10 :].any()
    assert decoded.flat_pixels.max() // 128 <= top + 1


def slit(width, sewn=False):
    """A panel cut in from its hem, aslant, so that its pixels close it here and there."""
    corners = [[0, 0], [20 - width, 0], [24, 30], [20 + width, 0], [40, 0], [40, 40], [0, 40]]
    panel = Panel("skirt_back", np.array(corners, float), (Edge(),) * 7)
    stitch = Stitch(EdgeRef("skirt_back", 1), EdgeRef("skirt_back", 2))
    return Pattern((panel,), (stitch,) if sewn else ())


@pytest.mark.parametrize("width", [0.2, 0.5, 0.8, 1.2])
def test_slits_that_are_not_sewn_leave_no_holes(width):
    garment = any_garment(slit(width), 2.0)
    for resolution in (48, 64, 80, 128):
        assert counts_of(decode_grid(encode(garment, resolution))) == (1, 1, 1)


def test_only_small_holes_that_no_seam_borders_on_are_filled():
    panel = np.zeros((40, 40), int) - 1
    panel[2:38, 2:38] = 3
    panel[5, 5:9] = panel[10:16, 20:30] = -1
    panel[20, 20] = panel[21, 21] = -1
    geometry = np.random.default_rng(0).normal(size=(40, 40, 3))
    geometry[panel < 0] = np.nan
    nothing = StitchingImage(
        np.zeros((40, 40), np.uint16), np.zeros(0, np.int32), np.zeros(0), np.zeros(1, int)
    )
    filled, positions = fill_pockets(panel, geometry, nothing)
    assert filled[5, 5:9].tolist() == [3] * 4 and filled[20, 20] == filled[21, 21] == 3
    assert (filled[10:16, 20:30] == -1).all() and (filled >= 0).sum() == (panel >= 0).sum() + 6
    assert np.array_equal(positions[panel >= 0], geometry[panel >= 0])
    assert np.isfinite(positions[filled >= 0]).all()
    ring = [geometry[r, c] for r in (19, 20, 21) for c in (19, 20, 21) if panel[r, c] >= 0]
    assert np.allclose(positions[20, 20], np.mean(ring, axis=0))

    beside = StitchingImage(
        np.ones((40, 40), np.uint16), np.array([4 * 40 + 4]), np.zeros(1), np.array([0, 1])
    )
    filled, _ = fill_pockets(panel, geometry, beside)
    assert (filled[5, 5:9] == -1).all() and filled[20, 20] == 3
    panel[19, 20] = 4  # a hole between two panels is none
    filled, _ = fill_pockets(panel, geometry, nothing)
    assert filled[20, 20] == -1


def test_triangles_across_a_dart_are_removed():
    images = encode(any_garment(HARD_CASES["dart"](), 2.0), 64)
    grid = PixelGrid.of(images.panel)
    sides = seam_sides(grid, images.stitching)
    positions = images.geometry.reshape(-1, 3)[grid.pixels].astype(float)
    faces = remesh(grid, positions, sides.links)
    opened = open_grid(grid, faces, sides)
    assert 0 < len(faces) - len(opened.faces) < 60
    centers = opened.vertex_pixel[opened.faces]
    at = np.stack([grid.pixels % 64, grid.pixels // 64], axis=1)[centers].mean(axis=1) + 0.5
    panel = [p.name for p in images.layout.pattern.panels].index("skirt_front")
    inside = at[grid.panel[centers[:, 0]] == panel]
    local = images.layout.to_local(panel, inside)
    within = (np.abs(local[:, 0] - 20) < 4 * (local[:, 1] - 38) / 14 - 1.5) & (local[:, 1] > 42)
    assert not within.any()


@pytest.mark.parametrize("resolution", [64, 96, 112])
@pytest.mark.parametrize(
    "pattern", [draft("trousers"), draft("fitted-dress"), HARD_CASES["dart"](), godet(0.4)]
)
def test_what_has_one_face_only_is_known(pattern, resolution):
    images = encode(any_garment(pattern, 3.0), resolution)
    grid = PixelGrid.of(images.panel)
    sides = seam_sides(grid, images.stitching)
    positions = images.geometry.reshape(-1, 3)[grid.pixels].astype(float)
    opened = open_grid(grid, remesh(grid, positions, sides.links), sides)
    edges, faces_at = edge_faces(opened.faces.astype(np.int32))
    assert np.array_equal(np.unique(np.sort(opened.open_edges, axis=1), axis=0), edges[faces_at == 1])
    assert opened.open_edges.max() < opened.rim_count


def test_a_seam_through_the_middle_of_cloth_parts_it():
    """Images of a network need not make sense; what comes of them still has to be a surface."""
    panel = np.full((12, 12), -1)
    panel[1:11, 1:11] = 0
    grid = PixelGrid.of(panel)
    row = 5 * 12 + np.arange(3, 9)
    stitching = StitchingImage(
        np.zeros((12, 12), np.uint16),
        np.concatenate([row, row - 48]),
        np.tile(np.linspace(0, 1, 6), 2),
        np.array([0, 6, 12]),
    )
    sides = seam_sides(grid, stitching)
    opened = open_grid(grid, remesh(grid, np.zeros((100, 3)), sides.links), sides)
    edges, faces_at = edge_faces(opened.faces.astype(np.int32))
    assert np.array_equal(np.unique(np.sort(opened.open_edges, axis=1), axis=0), edges[faces_at == 1])
    assert len(opened.open_edges) > 36 + 10 and len(opened.faces) < 162


@pytest.mark.parametrize("resolution", [72, 96, 112])
def test_darts_of_a_pixel_are_sewn_the_right_way(resolution):
    garment = any_garment(draft("trousers"), 3.0)
    assert counts_of(decode_grid(encode(garment, resolution))) == counts_of(garment)


def test_the_hand_of_the_cloth_is_found_in_the_images():
    for name, stitches in (("right_wrong", [False]), ("sleeve", [True]), ("dart", [True] * 4)):
        images = encode(HARD_CASES[name](), 128)
        sides = seam_sides(PixelGrid.of(images.panel), images.stitching)
        assert sides.cloth_on_left[::2].all()
        assert (~sides.cloth_on_left[1::2]).tolist() == stitches


PINCHED = ("blazer", "coat")
"""Where the notch of a lapel ends in the seam of the collar, two corners become one vertex."""


@pytest.mark.parametrize("name", [d.name for d in list_drafts()])
def test_every_draft_keeps_its_topology(name):
    garment = any_garment(draft(name), 4.0)
    decoded = decode_grid(encode(garment, 192))
    found, true = counts_of(decoded), counts_of(garment)
    assert found[:2] == true[:2] and 0 <= true[2] - found[2] <= (1 if name in PINCHED else 0)
    assert (decoded.faces != np.roll(decoded.faces, 1, axis=1)).all()
    assert np.array_equal(decoded.weld[decoded.flat_faces], decoded.faces)
    assert len(decoded.seams) == len(garment.pattern.stitches)


def test_sewn_pixels_become_one_vertex_in_their_middle():
    images = encode(any_garment(tube(), 3.0), 64)
    decoded = decode_grid(images)
    grid = PixelGrid.of(images.panel)
    seen = images.geometry.reshape(-1, 3).astype(float)
    for vertex in np.unique(np.concatenate(decoded.seams)):
        pixels = np.unique(decoded.flat_pixels[decoded.weld == vertex])
        assert len(pixels) >= 2
        assert np.allclose(decoded.vertices[vertex], seen[pixels].mean(axis=0), atol=1e-3)
    for k in range(2):
        ends = [images.stitching.side(k, b)[0][[0, -1]] for b in (0, 1)]
        for one, other in zip(*ends, strict=True):
            weld = decoded.weld[np.isin(decoded.flat_pixels, [one, other])]
            assert len(set(weld.tolist())) == 1
    assert len(grid.pixels) > len(decoded.vertices)


def test_faces_run_anticlockwise_in_the_image():
    decoded = decode_grid(encode(any_garment(draft("hoodie"), 3.0), 128))
    a, b, c = (decoded.uv[decoded.flat_faces[:, k]] for k in range(3))
    u, w = b - a, c - a
    assert (u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0] > 0).all()


def test_images_that_cannot_be_decoded_are_refused():
    images = encode(any_garment(tube(), 3.0), 64)
    with pytest.raises(InputError, match="no positions"):
        decode_grid(encode(tube(), 64))
    broken = images.geometry.copy()
    broken[images.occupancy] = np.nan
    with pytest.raises(InputError, match="not finite"):
        decode_grid(dataclasses.replace(images, geometry=broken))
    sewn = images.stitching
    astray = StitchingImage(sewn.ids, np.zeros_like(sewn.pixels), sewn.fraction, sewn.start)
    with pytest.raises(InputError, match="no panel"):
        decode_grid(dataclasses.replace(images, stitching=astray))
    backwards = StitchingImage(sewn.ids, sewn.pixels, 1 - sewn.fraction, sewn.start)
    with pytest.raises(InputError, match="order of its seam"):
        decode_grid(dataclasses.replace(images, stitching=backwards))


def test_images_without_a_single_triangle_are_refused():
    thin = Pattern((rectangle("wb_front", 60.0, 0.01),))
    with pytest.raises(GeometryError, match="two pixels wide"):
        decode_grid(encode(any_garment(thin, 3.0), 64))


def test_no_stitches_are_no_seams():
    garment = any_garment(Pattern((rectangle("a", 20.0, 30.0), rectangle("b", 9.0, 9.0))), 3.0)
    decoded = decode_grid(encode(garment, 64))
    assert decoded.seams == () and counts_of(decoded) == (2, 2, 2)
    assert np.array_equal(decoded.weld, np.arange(len(decoded.vertices)))
