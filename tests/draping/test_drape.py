import numpy as np
import pytest

import swifttailor
from swifttailor.body import Body
from swifttailor.draping import drape
from swifttailor.draping.attachment import find_attachment
from swifttailor.draping.placement import place_vertices
from swifttailor.draping.simulation import SimulationSettings
from swifttailor.errors import InputError, PatternError
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.topology import topology
from swifttailor.pattern import Edge, EdgeRef, Panel, Pattern, Placement, Stitch
from swifttailor.pattern.check import hangs_from_shoulders
from swifttailor.pattern.drafts import draft

COARSE = 4.0


@pytest.fixture(scope="module")
def shirt():
    return drape(draft("t-shirt"), edge_length=COARSE)


@pytest.fixture(scope="module")
def skirt():
    return drape(draft("circle-skirt"), edge_length=COARSE)


def test_public_name_is_the_function(shirt):
    assert swifttailor.drape is drape


@pytest.mark.parametrize("name", ["shirt", "skirt"])
def test_a_draft_is_draped_well(name, request):
    garment = request.getfixturevalue(name)
    quality = garment.report["quality"]
    assert quality["accepted"] and quality["reasons"] == []
    assert quality["static"] and not quality["fell_off"]
    assert quality["penetrating_fraction"] == 0.0 and quality["max_penetration_cm"] == 0.0
    assert quality["seam_gap_max_cm"] == 0.0 and quality["components"] == 1
    assert quality["self_intersections"] <= 30 and quality["body_intersections"] <= 35
    assert 0.0 <= quality["strain_p50"] <= quality["strain_p95"] < 0.1
    measured = topology(garment.faces, len(garment.vertices))
    assert measured.nonmanifold_edges == measured.inconsistent_edges == 0
    assert (Body.default().signed_distance(garment.vertices)[0] > 0).all()


def test_what_slides_down_is_given_up_and_said_so():
    """A tube of 240 cm around the chest, and nothing that would hold it."""
    corners = [[-60.0, 0.0], [60.0, 0.0], [60.0, 50.0], [-60.0, 50.0]]
    front = Panel("front", corners, (Edge(),) * 4, Placement((0.0, 80.0, 25.0)))
    back = Panel("back", corners[::-1], (Edge(),) * 4, Placement((0.0, 80.0, -25.0)))
    sides = tuple(Stitch(EdgeRef("front", k), EdgeRef("back", k)) for k in (1, 3))
    lowest = min(Body.default().measurements.armpit_level - 10, 130 - 5)
    quality = drape(Pattern((front, back), sides, "tube"), edge_length=8.0).report["quality"]
    assert quality["fell_off"] and not quality["accepted"] and not quality["static"]
    assert len([r for r in quality["reasons"] if r.startswith("not where it is worn")]) == 1
    assert "did not come to rest" not in quality["reasons"]
    # It was left while falling, not on the floor.
    assert lowest - 15 - 5 < quality["top_cm"] < lowest - 15
    assert quality["frames"] < 120


def test_area_is_kept(shirt):
    corners = shirt.vertices[shirt.faces]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    flat = sum(abs(p.signed_area()) for p in shirt.pattern.panels)
    assert area.sum() == pytest.approx(flat, rel=0.05)


def test_the_shirt_is_worn_as_a_shirt(shirt):
    """Sleeves on the arms, left on the wearer's left, the front in front."""
    names = [p.name for p in shirt.pattern.panels]

    def middle(name):
        chosen = shirt.mesh.flat_panel == names.index(name)
        return shirt.flat_positions[chosen].mean(axis=0)

    assert middle("left_sleeve_f")[0] > 20 > -20 > middle("right_sleeve_f")[0]
    assert middle("left_ftorso")[2] > 3 and middle("left_btorso")[2] < -3
    assert abs(middle("left_ftorso")[0] + middle("right_ftorso")[0]) < 1.5
    m = Body.default().measurements
    assert shirt.vertices[:, 1].max() > m.shoulder_level - 5


def test_outside_faces_out(shirt):
    centers = shirt.vertices[shirt.faces].mean(axis=1)
    corners = shirt.vertices[shirt.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    on_torso = np.abs(centers[:, 0]) < 12
    outward = centers[on_torso] * [1, 0, 1]
    assert ((normals[on_torso] * outward).sum(axis=1) > 0).mean() > 0.95


def test_the_skirt_hangs_from_the_waist(skirt):
    m = Body.default().measurements
    assert abs(skirt.vertices[:, 1].max() - m.waist_level) < 8
    assert skirt.vertices[:, 1].min() < m.hips_level - 20


def test_same_input_same_bytes_in_any_order(shirt):
    pattern = draft("t-shirt")
    shuffled = Pattern(
        pattern.panels[::-1], tuple(Stitch(s.second, s.first, s.right_wrong) for s in pattern.stitches[::-1])
    )
    again = drape(shuffled, edge_length=COARSE)
    assert again.vertices.tobytes() == shirt.vertices.tobytes()


def test_a_seed_jitters_the_start(shirt):
    other = drape(draft("t-shirt"), edge_length=COARSE, seed=7)
    assert other.vertices.tobytes() != shirt.vertices.tobytes()
    assert np.linalg.norm(other.vertices - shirt.vertices, axis=1).mean() < 3.0
    assert other.report["quality"]["accepted"]


def test_fabric_matters(skirt):
    heavy = drape(draft("circle-skirt"), edge_length=COARSE, fabric="denim")
    assert heavy.report["fabric"] == "denim"
    assert np.abs(heavy.vertices - skirt.vertices).max() > 0.5


def test_progress_reaches_the_end():
    seen = []
    settings = SimulationSettings(sewing_frames=5, settling_frames=1, max_frames=40)
    drape(
        draft("tank-top"),
        edge_length=6.0,
        settings=settings,
        progress=lambda stage, share: seen.append((stage, share)),
    )
    assert seen[0][0] == "meshing" and seen[-1] == ("draping", 1.0)
    assert all(0 <= share <= 1 for _, share in seen)


def test_arguments_are_checked():
    pattern = draft("tank-top")
    with pytest.raises(InputError, match=r"no engine 'maya'.*xpbd, newton"):
        drape(pattern, engine="maya")
    with pytest.raises(InputError, match="no fabric"):
        drape(pattern, fabric="felt")
    with pytest.raises(InputError, match="seed"):
        drape(pattern, seed=-1)
    with pytest.raises(PatternError, match="does not exist"):
        drape(Pattern(pattern.panels, (Stitch(EdgeRef("nobody", 0), EdgeRef("left_ftorso", 0)),)))


def test_attachments():
    m = Body.default().measurements
    shirt, trousers = draft("t-shirt"), draft("trousers")
    assert hangs_from_shoulders(shirt) and not hangs_from_shoulders(trousers)
    neck = find_attachment(mesh_pattern(shirt, 5.0), m)
    assert neck.at_first.all() and neck.levels.min() > m.armpit_level
    held = find_attachment(mesh_pattern(trousers, 5.0), m)
    assert len(held.vertices) > 10 and (held.levels == m.waist_level).all() and not held.at_first.any()
    low = find_attachment(mesh_pattern(draft("jeans", below_waist=8.0), 5.0), m)
    assert low.levels.max() <= m.waist_level - 6.0 and low.levels.min() > m.hips_level
    high = find_attachment(mesh_pattern(draft("trousers", below_waist=-4.0), 5.0), m)
    assert high.levels.min() == pytest.approx(m.waist_level + 4.0, abs=0.5)
    # Without labels the topmost free edges are held instead.
    from dataclasses import replace

    bare = Pattern(
        tuple(replace(p, edges=tuple(replace(e, label="") for e in p.edges)) for p in trousers.panels),
        trousers.stitches,
    )
    mesh = mesh_pattern(bare, 5.0)
    top = find_attachment(mesh, m).vertices
    start = place_vertices(mesh)
    assert len(top) > 10 and start[top, 1].min() > np.percentile(start[:, 1], 80)


def test_sleeves_can_start_further_out():
    mesh = mesh_pattern(draft("hoodie").canonical(), 5.0)
    near, out = place_vertices(mesh), place_vertices(mesh, sleeves_out=True)
    moved = np.abs(out - near).max(axis=1)
    names = [p.name for p in mesh.pattern.panels]
    torso = np.isin(mesh.flat_panel, [k for k, n in enumerate(names) if "torso" in n])
    inner = np.setdiff1d(mesh.weld[torso], mesh.weld[~torso])
    assert moved[inner].max() == 0.0
    assert np.abs(out[:, 0]).max() >= np.abs(near[:, 0]).max()
