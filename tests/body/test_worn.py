import numpy as np
import pytest

import swifttailor
from swifttailor.body import Body
from swifttailor.body.body_shape import random_shape
from swifttailor.body.carrying import carry_all
from swifttailor.body.pose import Pose
from swifttailor.body.posing import pose_named, random_pose
from swifttailor.body.rig import Rig
from swifttailor.body.surface_distance import SurfaceTree
from swifttailor.body.worn import garment_weights, has_sleeve, legs_and_skirt

GARMENTS = {
    "t-shirt": {"sleeve_length": 55},
    "trousers": {"flare": 20},
    "circle-skirt": {},
    "shirt-dress": {"sleeve_length": 55},
}
POSES = 12


@pytest.fixture(scope="module", params=GARMENTS)
def garment(request):
    made = swifttailor.sew(swifttailor.draft(request.param, **GARMENTS[request.param])).garment
    return request.param, made.vertices.astype(np.float64), made.faces


def test_legs_are_told_from_skirts(garment):
    name, vertices, faces = garment
    side, is_skirt = legs_and_skirt(vertices, faces)
    below = vertices[:, 1] < 70
    if name == "trousers":
        assert set(side[below]) == {-1, 1}
        assert (np.sign(vertices[below, 0]) == side[below]).mean() > 0.9
    else:
        assert not side.any()
    assert is_skirt.all() if name in ("circle-skirt", "shirt-dress") else not is_skirt.any()


def test_what_has_sleeves_is_known(garment):
    name, vertices, _ = garment
    for sign in (1, -1):
        assert has_sleeve(Rig.default(), vertices, sign) == (name in ("t-shirt", "shirt-dress"))


def test_a_wide_tank_top_does_not_rise_with_the_arm():
    made = swifttailor.sew(swifttailor.draft("tank-top", chest_ease=20.0)).garment
    rig, vertices = Rig.default(), made.vertices.astype(np.float64)
    assert not has_sleeve(rig, vertices, 1)
    worn = garment_weights(rig, vertices, made.faces)
    np.testing.assert_allclose(worn.share.sum(axis=1), 1.0, atol=1e-5)
    raised = Pose({"left_arm": (0.0, 0.0, 60.0)})
    (cloth,) = carry_all([(vertices, worn)], rig, raised)
    below = vertices[:, 1] < 126
    assert np.linalg.norm(cloth - vertices, axis=1)[below].max() < 0.5


def test_it_stays_outside_the_body(garment):
    """Hands and arms that touch the cloth of another part are the most of what is left."""
    _, vertices, faces = garment
    rig, body = Rig.default(), Body.default()
    skin, worn = rig.weights_at(body.vertices), garment_weights(rig, vertices, faces)
    inside = []
    for seed in range(POSES):
        chance = np.random.default_rng(seed)
        pose, shape = random_pose(chance), random_shape(chance)
        figure, cloth = carry_all([(body.vertices, skin), (vertices, worn)], rig, pose, shape)
        distance, _ = SurfaceTree.build(figure, body.faces).signed_distance(cloth)
        inside.append((distance < -0.5).mean())
    assert np.mean(inside) < 0.01
    assert np.max(inside) < 0.06


def test_cloth_is_not_torn(garment):
    """Hardly an edge becomes twice as long in any pose."""
    name, vertices, faces = garment
    rig = Rig.default()
    worn = garment_weights(rig, vertices, faces)
    edges = np.unique(np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)

    def lengths(points):
        return np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)

    before = lengths(vertices)
    for seed in range(POSES):
        (cloth,) = carry_all([(vertices, worn)], rig, random_pose(np.random.default_rng(seed)))
        assert (lengths(cloth) > 2 * before + 0.2).mean() < 0.006, (name, seed)


def test_the_hem_of_a_skirt_stays_nearly_level():
    made = swifttailor.sew(swifttailor.draft("circle-skirt")).garment
    rig, vertices, faces = Rig.default(), made.vertices.astype(np.float64), made.faces
    hem = vertices[:, 1] < vertices[:, 1].min() + 2.0
    spread = np.ptp(vertices[hem, 1])
    worn = garment_weights(rig, vertices, faces)
    (cloth,) = carry_all([(vertices, worn)], rig, pose_named("walking"))
    assert np.ptp(cloth[hem, 1]) < spread + 4.0
    assert np.ptp(cloth[hem, 2]) > np.ptp(vertices[hem, 2]) + 5.0, "it opens with the stride"
