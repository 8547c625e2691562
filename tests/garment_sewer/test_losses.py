"""Every loss against a plain reference, and at the truth."""

from __future__ import annotations

from dataclasses import replace

import loss_reference as reference
import numpy as np
import pytest

from swifttailor.errors import InputError
from swifttailor.garment_sewer.losses import PAPER_LOSSES, LossWeights

ALL = LossWeights(
    unit_cm=10, edge=2, edge_band=1, stitching=3, normals=4, seam_pairs=5, gradient=6, strain=7, penetration=8
)


@pytest.fixture
def truth():
    """Two images of 7 x 9 pixels with two panels each, values of no meaning."""
    import torch

    from swifttailor.garment_sewer.losses_torch import Truth

    chance = np.random.default_rng(0)
    panel = np.full((2, 7, 9), -1)
    panel[:, 1:6, 1:4] = 0
    panel[0, 1:5, 5:9] = 1
    panel[1, 2:7, 6:8] = 1
    contour = (panel >= 0) & (chance.random(panel.shape) < 0.3)
    occupied = np.flatnonzero(panel >= 0)
    sides = np.full((3, 2, 4), -1)
    for k in range(3):
        for b in range(2):
            n = int(chance.integers(1, 5))
            sides[k, b, :n] = chance.choice(occupied, n)
    tensors = {
        "target": chance.normal(0, 5, (2, 3, 7, 9)),
        "occupancy": (panel >= 0)[:, None],
        "local": chance.normal(0, 3, (2, 2, 7, 9)),
        "edge_distance": chance.integers(0, 4, panel.shape),
    }
    return Truth(
        **{name: torch.tensor(value, dtype=torch.float32) for name, value in tensors.items()},
        panel=torch.tensor(panel),
        contour=torch.tensor(contour),
        ignores_arms=torch.tensor(chance.random(panel.shape) < 0.5),
        pairs=torch.tensor(chance.choice(occupied, (6, 2))),
        sides=torch.tensor(sides),
    )


@pytest.fixture
def predicted(truth):
    import torch

    return truth.target + torch.tensor(np.random.default_rng(1).normal(0, 2, (2, 3, 7, 9))).float()


@pytest.fixture(scope="module")
def body_field(body_distance):
    from swifttailor.garment_sewer.body_field_torch import BodyField

    return BodyField(body_distance)


@pytest.mark.needs_torch
def test_losses_are_what_they_say(predicted, truth, body_field, body_distance):
    from swifttailor.garment_sewer.losses_torch import compute_losses

    moved, moved_truth = predicted.clone(), replace(truth, target=truth.target.clone())
    for image in (moved, moved_truth.target):
        image[:, 1] += 110  # into the body
    losses = compute_losses(moved, moved_truth, ALL, body_field)
    p, t = moved.numpy() / 10, moved_truth.target.numpy() / 10
    panel, contour = truth.panel.numpy(), truth.contour.numpy()
    near = (panel >= 0) & (truth.edge_distance.numpy() <= 1)
    points = moved.permute(0, 2, 3, 1).reshape(-1, 3).double().numpy()
    distance, _ = body_distance.sample(points, truth.ignores_arms.numpy().ravel())
    depth = np.maximum(0.2 - distance.reshape(panel.shape), 0)[panel >= 0] / 10
    expected = {
        "regression": reference.mean_error(p, t, panel >= 0),
        "edge": reference.mean_error(p, t, near),
        "stitching": reference.chamfer(p, truth.sides.numpy()),
        "normals": reference.normals(p, panel),
        "seam_pairs": reference.seam_pairs(p, t, truth.pairs.numpy()),
        "gradient": reference.gradient(p, t, panel, contour),
        "strain": reference.stretch(p, truth.local.numpy() / 10, panel, contour, 0.03),
        "penetration": depth.mean(),
    }
    assert set(losses) == {*expected, "total"}
    for name, value in expected.items():
        assert value > 0, name
        assert losses[name].item() == pytest.approx(value, rel=2e-3), name
    weights = {"regression": 1, **{name: getattr(ALL, name) for name in expected if name != "regression"}}
    assert losses["total"].item() == pytest.approx(sum(expected[n] * w for n, w in weights.items()), rel=2e-3)


@pytest.mark.needs_torch
def test_at_the_truth_only_what_the_truth_itself_costs_remains(truth, body_field):
    from swifttailor.garment_sewer.losses_torch import compute_losses

    losses = compute_losses(truth.target, truth, ALL, body_field)
    for name in ("regression", "edge", "seam_pairs", "gradient"):
        assert losses[name].item() == 0


@pytest.mark.needs_torch
def test_what_has_no_weight_is_not_computed(predicted, truth):
    from swifttailor.garment_sewer.losses_torch import compute_losses

    losses = compute_losses(predicted, truth, LossWeights(edge=0, seam_pairs=0))
    assert set(losses) == {"regression", "total"}
    assert set(compute_losses(predicted, truth, PAPER_LOSSES)) == {
        *("regression", "edge", "stitching", "normals", "total")
    }


@pytest.mark.needs_torch
def test_no_loss_looks_at_empty_pixels(predicted, truth, body_field):
    import torch

    from swifttailor.garment_sewer.losses_torch import compute_losses

    other = torch.where(truth.panel[:, None] >= 0, predicted, torch.full_like(predicted, 1e4))
    before, after = (compute_losses(x, truth, ALL, body_field) for x in (predicted, other))
    for name, value in before.items():
        assert after[name].item() == pytest.approx(value.item()), name


@pytest.mark.needs_torch
def test_slopes_are_finite_even_where_pixels_coincide(truth, body_field):
    import torch

    from swifttailor.garment_sewer.losses_torch import compute_losses

    same = torch.zeros_like(truth.target).requires_grad_()
    compute_losses(same, truth, ALL, body_field)["total"].backward()
    assert torch.isfinite(same.grad).all()


@pytest.mark.needs_torch
def test_a_batch_without_stitches_costs_nothing_for_them(predicted, truth):
    import torch

    from swifttailor.garment_sewer.losses_torch import compute_losses

    bare = replace(
        truth, pairs=torch.zeros((0, 2), dtype=torch.long), sides=torch.zeros((0, 2, 4), dtype=torch.long)
    )
    losses = compute_losses(predicted, bare, ALL.__class__(stitching=1))
    assert losses["stitching"].item() == losses["seam_pairs"].item() == 0


@pytest.mark.needs_torch
def test_field_on_tensors_is_the_field(body_distance, body_field):
    import torch

    chance = np.random.default_rng(2)
    points = chance.uniform([-120, -20, -60], [120, 220, 60], (2000, 3))
    legs = chance.random(2000) < 0.5
    expected, _ = body_distance.sample(points, legs)
    image = torch.tensor(points, dtype=torch.float32).T.reshape(1, 3, 40, 50).requires_grad_()
    found = body_field.distance(image, torch.tensor(legs).reshape(1, 40, 50))
    assert np.allclose(found.detach().numpy().ravel(), expected, atol=1e-2)
    found.sum().backward()
    assert torch.isfinite(image.grad).all()


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"edge": -1}, "losses.edge is -1"),
        ({"strain": float("nan")}, "losses.strain"),
        ({"unit_cm": 0}, "unit"),
        ({"regression": 0}, "nothing says"),
        ({"normals": "much"}, "a number is expected"),
    ],
)
def test_impossible_weights_are_refused(values, said):
    with pytest.raises(InputError, match=said):
        LossWeights(**values)
