from itertools import pairwise

import numpy as np
import pytest

from swifttailor.body import Body, BodyPart
from swifttailor.body.carrying import carry_all
from swifttailor.body.footwear import FOOTWEAR, footwear
from swifttailor.body.hair import HAIR_STYLES, VARIANTS, hair, hair_by_lot, strand_shades
from swifttailor.body.mannequin import mannequin
from swifttailor.body.parts import fill_holes
from swifttailor.body.posing import random_pose
from swifttailor.body.rig import Rig
from swifttailor.body.skin_regions import SkinRegion, skin_regions
from swifttailor.body.surface_distance import SurfaceTree
from swifttailor.errors import InputError


def outward(vertices, faces, middle):
    """(M,) whether each face looks away from a point."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    return np.einsum("ij,ij->i", normal, (a + b + c) / 3 - middle) > 0


SHOWN = [*HAIR_STYLES, *(f"{style}~{1 + k % VARIANTS}" for k, style in enumerate(HAIR_STYLES))]


@pytest.mark.parametrize("style", SHOWN)
def test_hair_covers_the_scalp_and_not_the_face(style):
    vertices, faces = hair(style)
    body = Body.default()
    distance, _ = body.signed_distance(vertices)
    assert np.isfinite(vertices).all() and faces.max() < len(vertices)
    assert (distance < -0.5).mean() < 0.12, "roots of what is tied are hidden, nothing else"
    head = body.vertices[body.vertex_part == BodyPart.HEAD]
    regions = skin_regions(head)
    eyes = head[regions == SkinRegion.EYES]
    low, high = eyes[:, 1].min() - 10, eyes[:, 1].max() + 2
    in_front = (vertices[:, 2] > eyes[:, 2].min()) & (vertices[:, 1] > low) & (vertices[:, 1] < high)
    assert not (in_front & (np.abs(vertices[:, 0]) < 5)).any()
    top = head[regions == SkinRegion.SCALP]
    near = np.linalg.norm(top[:, None] - vertices[None], axis=-1).min(axis=1)
    fullest = 1.7 * HAIR_STYLES[style.partition("~")[0]].thickness
    assert np.quantile(near, 0.95) < max(5.0, fullest + 2.0)
    assert outward(vertices, faces, (0.0, 158.0, 0.0))[: len(faces) // 4].mean() > 0.9


def test_longer_hair_is_longer():
    ends = [hair(style)[0][:, 1].min() for style in ("short", "bob", "shoulder_length", "long")]
    assert all(shorter > longer + 3 for shorter, longer in pairwise(ends))


def test_variants_differ_and_are_the_same_each_time():
    lots = [hair_by_lot(np.random.default_rng(k)) for k in range(200)]
    assert {lot.partition("~")[0] for lot in lots} == set(HAIR_STYLES)
    assert {lot.partition("~")[2] for lot in lots} == {"", *(str(k + 1) for k in range(VARIANTS))}
    shapes = [hair(f"wavy~{k + 1}")[0] for k in range(VARIANTS)]
    for k, one in enumerate(shapes):
        assert all(np.abs(one - other).max() > 1.0 for other in shapes[:k])
    assert hair("wavy~3") is hair("wavy~3")


def test_waves_swing_the_hair_that_falls_and_leave_what_lies_on_the_skull():
    from swifttailor.body.hair import _waved

    style = HAIR_STYLES["wavy"]
    fallen = np.linspace(0.0, 40.0, 26)
    strands = np.zeros((48, 26, 3))
    strands[..., 0], strands[..., 1] = 9.0, 160.0 - fallen
    moved = np.linalg.norm(_waved(strands, style) - strands, axis=-1)
    assert not moved[:, 0].any() and moved.max() <= style.waves + 1e-9
    assert moved[:, -1].min() >= 0.6 * style.waves - 1e-9


def test_strands_are_of_many_shades():
    for style in HAIR_STYLES:
        faces = hair(style)[1]
        shades = strand_shades(style, 0.3, np.random.default_rng(0))
        assert shades.shape == (len(faces),) and (shades > 0).all() and shades.std() > 0.1
        assert (strand_shades(style, 0.0, np.random.default_rng(0)) == 1).all()
        strands = shades[: 48 * 25].reshape(48, 25)
        assert np.abs(np.diff(strands, axis=1)).mean() < np.abs(np.diff(strands, axis=0)).mean()


def test_loose_hair_lies_on_the_chest_and_the_back():
    for style in HAIR_STYLES:
        vertices, _ = hair(style)
        before = vertices[(vertices[:, 1] < 142) & (vertices[:, 2] > 4)]
        assert (len(before) > 20) == bool(HAIR_STYLES[style].before)
        if len(before):
            beside = np.abs(before[:, 0])
            assert beside.min() > 2 and beside.max() < 20, "the middle of the chest stays free"
            distance, _ = Body.default().signed_distance(before)
            assert (distance > 0.5).mean() > 0.9, "a garment fits beneath"
            assert (vertices[vertices[:, 1] < 142][:, 2] < -6).any()


@pytest.mark.parametrize("kind", FOOTWEAR)
def test_shoes_hold_the_feet(kind):
    vertices, faces, sole = footwear(kind)
    assert vertices[:, 1].min() == pytest.approx(-sole)
    # Its openings closed, a shoe has the foot inside, but for what stands over its border.
    closed = SurfaceTree.build(*fill_holes(vertices, faces))
    points = Body.default().vertices
    feet = points[(points[:, 1] < min(FOOTWEAR[kind].instep, FOOTWEAR[kind].top) - 1.5)]
    assert len(feet) > 100
    distance, _ = closed.signed_distance(feet)
    assert (distance < 0.05).mean() > 0.99 and distance.max() < 0.3
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    bottom = (vertices[faces, 1] < -sole + 0.01).all(axis=1)
    assert bottom.sum() > 20
    assert (np.cross(b - a, c - a)[bottom, 1] < 1e-9).mean() > 0.95, "the sole looks down"


def test_a_figure_in_shoes_stands_on_their_soles():
    rig, body = Rig.default(), Body.default()
    vertices, _, sole = footwear("sneakers")
    skin, worn = rig.weights_at(body.vertices), rig.weights_at(vertices)
    for seed in range(6):
        feet, shoes = carry_all(
            [(body.vertices, skin), (vertices, worn)],
            rig,
            random_pose(np.random.default_rng(seed)),
            sole=sole,
        )
        assert feet[:, 1].min() == pytest.approx(sole, abs=1e-6)
        assert 0.0 <= shoes[:, 1].min() < 1.0


def test_regions_lie_where_they_should():
    body = Body.default()
    region = skin_regions(body.vertices)
    counts = np.bincount(region, minlength=len(SkinRegion))
    assert (counts >= 4).all(), dict(zip(SkinRegion, counts, strict=True))
    for label, part in ((SkinRegion.HANDS, (2, 3)), (SkinRegion.FEET, (4, 5)), (SkinRegion.LIPS, (1,))):
        assert np.isin(body.vertex_part[region == label], part).all()
    eyes, lips = body.vertices[region == SkinRegion.EYES], body.vertices[region == SkinRegion.LIPS]
    assert eyes[:, 1].min() > lips[:, 1].max() + 4
    np.testing.assert_array_equal(region, skin_regions(body.vertices * (-1, 1, 1)))
    shell, _ = mannequin(body)
    assert set(skin_regions(shell)) >= {SkinRegion.HANDS, SkinRegion.SCALP, SkinRegion.FEET, SkinRegion.TRUNK}


def test_unknown_names_are_refused():
    for name in ("mohawk", "wavy~0", "wavy~9", "wavy~x", "~1"):
        with pytest.raises(InputError, match=f"no hair style '{name}'; there are cropped.* ~1 to ~8"):
            hair(name)
    with pytest.raises(InputError, match="no hair style 'mohawk'; there are cropped"):
        hair("mohawk")
    with pytest.raises(InputError, match="no footwear 'skis'; there are flats"):
        footwear("skis")
