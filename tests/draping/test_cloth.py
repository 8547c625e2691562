import numpy as np
import pytest

from swifttailor.draping import FABRICS, Fabric, get_fabric
from swifttailor.draping.cloth import build_cloth
from swifttailor.errors import InputError
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module")
def mesh():
    return mesh_pattern(draft("gathered-skirt").canonical(), 4.0)


def test_presets_are_known_by_name_and_physical():
    assert len(FABRICS) >= 12 and {"cotton", "denim", "silk", "jersey", "leather"} <= set(FABRICS)
    assert all(f.kind and f.source for f in FABRICS.values())
    assert sum(f.is_measured for f in FABRICS.values()) == 9 and not FABRICS["cotton"].is_measured
    # Wang et al. weighed theirs: between a light jacket cloth and 11 oz denim (11 oz/yd^2 are 373 g/m^2).
    assert all(0.1 < f.density < 0.374 for f in FABRICS.values() if f.is_measured)
    # No cloth bends as paper does, and none is stiffer than the solver resolves.
    assert all(5e-7 <= f.bending <= 2e-4 and f.stretch <= 2000 for f in FABRICS.values())
    assert FABRICS["denim"].bending > FABRICS["cotton"].bending > FABRICS["silk"].bending
    assert FABRICS["denim"].density > FABRICS["silk"].density
    assert FABRICS["jersey"].stretch < FABRICS["cotton"].stretch
    with pytest.raises(InputError, match=r"no fabric 'tweed'.*cotton"):
        get_fabric("tweed")
    with pytest.raises(InputError, match="density"):
        Fabric("air", density=0.0, stretch=1.0, bending=0.0)
    with pytest.raises(InputError, match="stretch"):
        Fabric("x", density=0.1, stretch=float("nan"), bending=0.0)


def test_mass_is_area_times_density(mesh):
    cloth = build_cloth(mesh, FABRICS["cotton"])
    area_m2 = sum(abs(p.signed_area()) for p in mesh.pattern.panels) * 1e-4
    assert np.isclose(cloth.mass.sum(), 0.15 * area_m2, rtol=0.02)
    assert (cloth.mass > 0).all()


def test_rest_lengths_are_those_of_the_flat_panels(mesh):
    arrays = build_cloth(mesh, FABRICS["cotton"]).arrays
    lengths: dict[tuple[int, int], list[float]] = {}
    for face in mesh.flat_faces:
        for k in range(3):
            a, b = face[k], face[(k + 1) % 3]
            key = tuple(sorted((int(mesh.weld[a]), int(mesh.weld[b]))))
            length = float(np.linalg.norm(mesh.flat_vertices[a] - mesh.flat_vertices[b]))
            lengths.setdefault(key, []).append(length)
    assert len(lengths) == len(arrays.edges)
    for (a, b), rest in zip(arrays.edges, arrays.rest, strict=True):
        assert rest == pytest.approx(min(lengths[int(a), int(b)]), abs=1e-9)


def test_folded_collars_are_pressed():
    """Nothing bends a collar up along the seams where it is folded; all other edges stay stiff."""
    mesh = mesh_pattern(draft("polo-shirt").canonical(), 3.0)
    pressed, springy = (build_cloth(mesh, FABRICS["cotton"], press=p).arrays.hinges for p in (True, False))
    folds = [seam.vertices for seam in mesh.seams if mesh.pattern.stitches[seam.stitch].right_wrong]
    on_fold = np.any([np.isin(springy[:, :2], vertices).all(axis=1) for vertices in folds], axis=0)
    assert on_fold.sum() >= sum(len(vertices) - 1 for vertices in folds) * 0.9
    np.testing.assert_array_equal(pressed, springy[~on_fold])
    plain = mesh_pattern(draft("t-shirt").canonical(), 4.0)
    both = [build_cloth(plain, FABRICS["cotton"], press=p).arrays.hinges for p in (True, False)]
    np.testing.assert_array_equal(*both)


def test_gathered_seams_are_marked(mesh):
    cloth = build_cloth(mesh, FABRICS["cotton"])
    assert 0 < cloth.gathered.sum() < 0.2 * len(cloth.gathered)


def test_flat_cloth_does_not_bend(mesh):
    """The isometric bending vector of a hinge vanishes in the plane and grows when it is folded."""
    cloth = build_cloth(mesh, FABRICS["cotton"]).arrays
    inner = mesh.representative
    one_panel = np.bincount(mesh.weld) == 1  # vertices off the seams have one flat position
    flat = np.zeros((mesh.vertex_count, 3))
    flat[:, :2] = mesh.flat_vertices[inner]
    sound = one_panel[cloth.hinges].all(axis=1)
    assert sound.sum() > 50
    bend = np.einsum("hk,hkc->hc", cloth.hinge_weights[sound], flat[cloth.hinges[sound]])
    assert np.abs(bend).max() < 1e-9
    flat[:, 2] = 0.05 * flat[:, 0] ** 2
    bend = np.einsum("hk,hkc->hc", cloth.hinge_weights[sound], flat[cloth.hinges[sound]])
    assert np.linalg.norm(bend, axis=1).max() > 0.01
    assert np.allclose(cloth.hinge_weights.sum(axis=1), 0.0, atol=1e-9)


def test_neighbour_lists_are_the_edges(mesh):
    cloth = build_cloth(mesh, FABRICS["cotton"]).arrays
    for v in range(0, mesh.vertex_count, 37):
        rows = slice(cloth.neighbor_start[v], cloth.neighbor_start[v + 1])
        for other, edge in zip(cloth.neighbors[rows], cloth.neighbor_edge[rows], strict=True):
            assert sorted(cloth.edges[edge]) == sorted((v, other))
    degree = np.bincount(cloth.edges.ravel(), minlength=mesh.vertex_count)
    assert np.array_equal(np.diff(cloth.neighbor_start), degree)
    for edge, (first, second) in enumerate(cloth.edge_faces[:200]):
        assert set(cloth.edges[edge]) <= set(cloth.faces[first])
        assert second < 0 or set(cloth.edges[edge]) <= set(cloth.faces[second])
