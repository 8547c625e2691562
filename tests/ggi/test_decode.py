import dataclasses
import json

import numpy as np
import pytest
from ggi_patterns import HARD_CASES, any_garment

from swifttailor.cli.ggi import Ggi
from swifttailor.errors import InputError
from swifttailor.garment.formats import read_garment_mesh
from swifttailor.garment.garment import Garment
from swifttailor.ggi import encode
from swifttailor.ggi.decode import decode
from swifttailor.ggi.file import GGI_FILE, read_ggi, write_ggi
from swifttailor.panel_mesh.topology import topology
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A file of images of a T-shirt."""
    path = tmp_path_factory.mktemp("ggi")
    write_ggi(encode(any_garment(draft("t-shirt"), 4.0), 128), path / GGI_FILE)
    return path


def test_methods_are_chosen_by_name(folder):
    images = read_ggi(folder / GGI_FILE)
    assert isinstance(decode(images), Garment)
    assert len(decode(images, "outline", 6.0).vertices) < len(decode(images, "outline", 3.0).vertices)
    assert len(decode(images, "grid").vertices) > 0.9 * images.occupancy.sum()
    with pytest.raises(InputError, match="no method 'dtw'"):
        decode(images, "dtw")
    with pytest.raises(InputError, match="method 'grid'"):
        decode(dataclasses.replace(images, layout=None))
    for method in ("outline", "grid"):
        with pytest.raises(InputError, match="no positions"):
            decode(dataclasses.replace(images, geometry=None), method)


def test_the_grid_needs_no_layout(folder):
    images = read_ggi(folder / GGI_FILE)
    known, unknown = decode(images, "grid"), decode(dataclasses.replace(images, layout=None), "grid")
    assert np.array_equal(known.vertices, unknown.vertices) and np.array_equal(known.faces, unknown.faces)


def test_the_outline_decode_is_a_garments_folder(folder, tmp_path, capsys):
    assert Ggi(out=tmp_path, decode=folder / GGI_FILE, edge_length=3.0).run() == 0
    assert str(tmp_path) in capsys.readouterr().out
    garment = Garment.load(tmp_path)
    assert garment.report["method"] == "outline" and garment.report["edge_length_cm"] == 3.0
    expected = decode(read_ggi(folder / GGI_FILE), "outline", 3.0)
    assert np.abs(garment.vertices - expected.vertices).max() < 1e-5
    counts = topology(garment.faces, len(garment.vertices))
    assert garment.report["topology"] == {
        "components": counts.components,
        "boundary_loops": counts.boundary_loops,
        "euler_characteristic": counts.euler_characteristic,
        "nonmanifold_edges": 0,
    }
    assert {p.name for p in tmp_path.iterdir()} >= {
        "garment.glb",
        "garment.obj",
        "report.json",
        "pattern.json",
    }


@pytest.mark.parametrize("ending", ["obj", "glb"])
def test_the_grid_decode_is_written_as_a_mesh_with_panels(folder, tmp_path, ending):
    assert Ggi(out=tmp_path, decode=folder / GGI_FILE, method="grid").run() == 0
    images = read_ggi(folder / GGI_FILE)
    expected = decode(images, "grid")
    mesh = read_garment_mesh(tmp_path / f"garment.{ending}")
    assert set(mesh.groups) == {p.name for p in images.layout.pattern.panels}
    assert mesh.vertices.shape == expected.vertices.shape and len(mesh.faces) == len(expected.faces)
    low, high = expected.vertices.min(axis=0), expected.vertices.max(axis=0)
    assert np.allclose([mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)], [low, high], atol=1e-3)
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["method"] == "grid" and report["faces"] == len(expected.faces)
    assert report["resolution"] == 128 and set(report["seconds"]) == {"reading", "decoding"}


def test_panels_are_named_by_their_type_where_the_pattern_is_unknown(folder, tmp_path):
    images = read_ggi(folder / GGI_FILE)
    write_ggi(dataclasses.replace(images, layout=None), tmp_path / GGI_FILE)
    Ggi(out=tmp_path / "out", decode=tmp_path / GGI_FILE, method="grid").run()
    names = read_garment_mesh(tmp_path / "out" / "garment.obj").groups
    assert len(names) == len(images.layout.pattern.panels)
    for k, panel in enumerate(images.layout.pattern.panels):
        assert f"{panel.name}_{k}" in names
    with pytest.raises(InputError, match="method 'grid'"):
        Ggi(out=tmp_path / "out", decode=tmp_path / GGI_FILE).run()


def test_a_panel_without_faces_is_written(tmp_path):
    write_ggi(encode(any_garment(HARD_CASES["sliver"](), 8.0), 256), tmp_path / GGI_FILE)
    for method in ("grid", "outline"):
        assert Ggi(out=tmp_path / method, decode=tmp_path / GGI_FILE, method=method).run() == 0
        assert len(read_garment_mesh(tmp_path / method / "garment.glb").faces)


def test_an_edge_length_is_refused_where_it_means_nothing(folder, tmp_path):
    with pytest.raises(InputError, match="the pixels are the vertices"):
        Ggi(out=tmp_path / "out", decode=folder / GGI_FILE, method="grid", edge_length=1.0).run()
    assert not (tmp_path / "out").exists()


def test_equal_images_give_equal_files(folder, tmp_path):
    for method in ("outline", "grid"):
        for name in ("one", "two"):
            Ggi(out=tmp_path / method / name, decode=folder / GGI_FILE, method=method).run()
        for file in ("garment.obj", "garment.glb"):
            one, two = ((tmp_path / method / name / file).read_bytes() for name in ("one", "two"))
            assert one == two
