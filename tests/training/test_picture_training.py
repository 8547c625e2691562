"""Training the picture reader."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

pytestmark = pytest.mark.needs_torch


def tiny_config(**more):
    from swifttailor.training.picture_config import EyesSize, PictureConfig

    network = EyesSize(
        image_size=32,
        embedding=8,
        stages=(8, 16, 32, 32),
        depths=(1, 1, 1, 1),
        width=32,
        heads=2,
        mask_width=8,
    )
    values = {
        "network": network,
        "steps": 60,
        "batch_size": 6,
        "block": 6,
        "echo": 1,
        "variation": 0.0,
        "learning_rate": 4e-3,
        "warmup_steps": 5,
        "ema": 0.9,
        "validate_every": 1000,
        "validation_garments": 2,
        "precision": "float32",
    }
    return PictureConfig(**(values | more))


def run_of(data, out, *, config=None, **options):
    from swifttailor.training.picture_loop_torch import train

    return train(
        config or tiny_config(),
        [data / "train"],
        out,
        validation=[data / "validation"],
        workers=0,
        threads=1,
        **options,
    )


def test_it_learns_resumes_and_is_written(data, tmp_path, capsys):
    from safetensors.numpy import load_file

    from swifttailor.cli.train_export import TrainExport
    from swifttailor.errors import InputError
    from swifttailor.picture_reader.reader import PictureReader

    card = run_of(data, tmp_path / "run")
    lines = [json.loads(line) for line in (tmp_path / "run/metrics.jsonl").read_text().splitlines()]
    totals = [line["total"] for line in lines if "total" in line]
    assert totals[-1] < 110, "far below what random weights lose (173)"
    assert card["data"]["train"]["garments"] == 6 and card["validation"]["pictures"] == 12
    assert 0 <= card["validation"]["not_false"] <= 1 and set(card["validation"]["by_look"]) >= {
        "held out front"
    }

    run_of(data, tmp_path / "again", stop_after=23)
    run_of(data, tmp_path / "again", resume=True)
    once, again = (load_file(tmp_path / name / "weights.safetensors") for name in ("run", "again"))
    assert all(np.array_equal(once[name], again[name]) for name in once), "interrupted, and the same"

    path = tmp_path / "reader.onnx"
    assert TrainExport(source=tmp_path / "run", out=path, half=True).run() == 0
    reader = PictureReader.load(path)
    assert reader.card["model"] == "PictureReader" and reader.size == 32
    assert (reader.scales == (1.0, 0.0)).all()
    assert TrainExport(source=tmp_path / "run", out=path, data=data / "validation", overwrite=True).run() == 0
    assert "certainties are off by" in capsys.readouterr().out
    scales = PictureReader.load(path).scales
    assert (scales != (1.0, 0.0)).any() and np.isfinite(scales).all()
    written = tmp_path / "run" / "card.json"
    written.write_text(json.dumps(card | {"labels_sha256": "0"}))
    with pytest.raises(InputError, match="other statements"):
        TrainExport(source=tmp_path / "run", out=path, overwrite=True).run()


def test_begins_where_the_model_file_ended(data, tmp_path):
    """Norms that the file has folded away go by the batch again, and the network says the same with them."""
    import torch

    from swifttailor.cli.train_export import TrainExport
    from swifttailor.data.pictures.bank import PictureBank
    from swifttailor.training.picture_loop_torch import PictureTask
    from swifttailor.training.processes_torch import Processes

    config = tiny_config(
        network=replace(tiny_config().network, image_size=192), steps=12
    )  # another size is resampled in the file
    run_of(data, tmp_path / "run", config=config)
    path = tmp_path / "reader.onnx"
    assert TrainExport(source=tmp_path / "run", out=path, half=True).run() == 0

    banks = [PictureBank([data / name]) for name in ("train", "validation")]
    task = PictureTask(replace(config, start=str(path)), *banks, Processes.start(), workers=0)
    pictures = torch.cat([task.batches[step][0] for step in range(8)])
    guess = torch.cat([task.batches[step][1] for step in range(8)])
    with torch.no_grad():
        read, learning = (task.network.train(mode)(pictures, guess) for mode in (False, True))
    for one, other in zip(read, learning, strict=True):
        assert (one - other).abs().max() < 0.02 * (1 + one.abs().max())


@pytest.fixture(scope="module")
def designs(data, tmp_path_factory):
    """A file with designs of all but one of the garments."""
    from swifttailor.data.pictures.bank import PictureBank
    from swifttailor.parameter_reader.drawn import drawn_designs
    from swifttailor.parameter_reader.placed_designs import PlacedDesigns
    from swifttailor.programs.read_parameter import ReadParameter

    ids = PictureBank([data / "train"]).ids
    parameters = (
        ReadParameter("meta.upper", ("FittedShirt", "Shirt", None)),
        ReadParameter("shirt.length", (0.8, 1.2, 1.8), (1.0, 1.5)),
    )
    drawn = dict(zip(ids[1:], (design for design, _ in drawn_designs(1)), strict=False))
    path = tmp_path_factory.mktemp("designs") / "designs.safetensors"
    PlacedDesigns.of(drawn, parameters).write(path)
    return path


def test_it_learns_design_parameters_of_the_garments_whose_designs_are_known(data, designs, tmp_path):
    from swifttailor.cli.train_export import TrainExport
    from swifttailor.parameter_reader.placed_designs import PlacedDesigns
    from swifttailor.picture_reader.reader import PictureReader

    card = run_of(data, tmp_path / "run", config=tiny_config(log_every=5), designs=designs)
    lines = [json.loads(line) for line in (tmp_path / "run/metrics.jsonl").read_text().splitlines()]
    losses = [line["designs"] for line in lines if "designs" in line]
    assert min(losses[-3:]) < 0.75 * losses[0]
    assert card["data"]["train"]["designs"] == 5 and card["config"]["network"]["design_values"] == [3, 3]
    path = tmp_path / "reader.onnx"
    assert TrainExport(source=tmp_path / "run", out=path, int8=True).run() == 0
    reader = PictureReader.load(path)
    assert reader.parameters == PlacedDesigns.read(designs).parameters


def test_begins_with_a_reader_that_says_no_designs(data, designs, tmp_path):
    """All else is as the file has it; once there is something that says designs, that is as well."""
    from safetensors.numpy import load_file

    from swifttailor.cli.train_export import TrainExport
    from swifttailor.data.pictures.bank import PictureBank
    from swifttailor.parameter_reader.placed_designs import PlacedDesigns
    from swifttailor.training.picture_loop_torch import PictureTask
    from swifttailor.training.processes_torch import Processes

    network = replace(tiny_config().network, image_size=192)  # another size is resampled in the file
    config = tiny_config(network=network, steps=1)
    run_of(data, tmp_path / "before", config=config)
    before = tmp_path / "before.onnx"
    assert TrainExport(source=tmp_path / "before", out=before).run() == 0
    run_of(data, tmp_path / "after", config=replace(config, start=str(before)), designs=designs)
    after = tmp_path / "after.onnx"
    assert TrainExport(source=tmp_path / "after", out=after).run() == 0

    banks = [PictureBank([data / name]) for name in ("train", "validation")]
    placed = PlacedDesigns.read(designs)
    sized = replace(network, design_values=placed.values)
    for path, run in ((before, "before"), (after, "after")):
        config = replace(config, network=sized, start=str(path))
        task = PictureTask(config, *banks, Processes.start(), designs=placed, workers=0)
        weights = load_file(tmp_path / run / "weights.safetensors")
        ours = task.network.state_dict()
        assert all(name in ours for name in weights) and ("design.values" in weights) == (run == "after")
        for name in ("says.panels", "looks.questions", "design.values"):
            assert name not in weights or np.allclose(ours[name].cpu().numpy(), weights[name])


def test_a_frozen_trunk_stays_while_the_rest_learns(data, tmp_path):
    from safetensors.numpy import load_file

    from swifttailor.errors import InputError

    with pytest.raises(InputError, match="frozen_stages is 4"):
        tiny_config(frozen_stages=4)
    run_of(data, tmp_path / "before", config=tiny_config(steps=1))
    start = tmp_path / "before/weights.safetensors"
    with pytest.raises(InputError, match="frozen_stages is 5"):
        tiny_config(start=str(start), frozen_stages=5)
    for stages in (4, 2):
        out = tmp_path / f"after {stages}"
        run_of(data, out, config=tiny_config(steps=3, start=str(start), frozen_stages=stages))
        before, after = (load_file(path / "weights.safetensors") for path in (tmp_path / "before", out))
        still = ("embedder.", *(f"stages.{k}." for k in range(stages)))
        same = {name: np.array_equal(before[name], after[name]) for name in before}
        trunk = [name for name in before if name.startswith(still)]
        assert len(trunk) > 10 and all(same[name] for name in trunk)
        assert stages == 4 or not any(same[name] for name in same if name.startswith("stages.3."))
        for name in ("says.panels", "mask.0.weight", "looks.questions", "places"):
            assert not same[name], name


def test_what_does_not_matter_of_a_design_is_not_learnt(data, designs):
    import torch

    from swifttailor.parameter_reader.placed_designs import PlacedDesigns
    from swifttailor.training.design_table_torch import DesignTable

    placed = PlacedDesigns.read(designs)
    ids = ["nobody's", *placed.rows]
    table = DesignTable(ids, placed)
    numbers = torch.arange(len(ids))[:, None]
    told = table.answers(numbers, torch.ones(len(ids), 1, 2, dtype=torch.bool))
    assert told.shape == (len(ids), 1, 2, 3) and not told[0].any()
    assert torch.allclose(told[1:, 0].sum(-1), torch.from_numpy(placed.matter).float())
    assert (told[1:, 0].argmax(-1)[placed.matter] == torch.from_numpy(placed.places)[placed.matter]).all()
    assert not table.answers(numbers, torch.zeros(len(ids), 1, 2, dtype=torch.bool)).any()
    first = torch.tensor([True, False]).expand(len(ids), 1, 2)
    assert (table.answers(numbers, first).any(-1) == (told.any(-1) & first)).all()
    none = torch.zeros(len(ids), 1, 0, dtype=torch.bool)
    assert DesignTable(ids, None).answers(numbers, none).shape == (len(ids), 1, 0, 0)


def test_garments_that_are_judged_by_are_not_learnt_from(data, tmp_path):
    from swifttailor.errors import InputError
    from swifttailor.training.picture_loop_torch import train

    with pytest.raises(InputError, match="no garments to draw: all 2 are among"):
        train(tiny_config(), [data / "validation"], tmp_path, validation=[data / "validation"], workers=0)


def test_a_pool_shows_each_picture_as_often_in_changing_company(data):
    """As many blocks are drawn as `echo` asks for; a training that goes on begins with the last ones."""
    import torch

    from swifttailor.data.pictures.bank import PictureBank
    from swifttailor.training.picture_batch_torch import PictureBatches

    bank = PictureBank([data / "train"])
    config = tiny_config(
        pool=120, block=6, batch_size=10, echo=2, plain=1.0, studio=0.0, nothing=0.0, several=0.0
    )
    shown, together, batches = [], set(), PictureBatches(bank, config, workers=0)
    drawn = []
    take = batches._take
    batches._take = lambda number: drawn.append(number) or take(number)
    for step in range(60):
        pictures, guess, truth = batches[step]
        assert pictures.shape == (10, 3, 32, 32) and guess.shape == (10, 7) and truth.view.shape == (10, 6)
        shown.append([hash(one.numpy().tobytes()) for one in pictures])
        together |= {frozenset(pair) for pair in zip(shown[-1], shown[-1][1:], strict=False)}
    # 59 * 10 pictures before the last step, of 6 a block, each shown twice; some blocks are ahead.
    assert drawn == list(range(59 * 10 // (6 * 2) + 1 + 8))
    times = np.unique([one for row in shown for one in row], return_counts=True)[1]
    assert len(times) > 220 and times.max() < 40 and all(len(set(row)) >= 8 for row in shown)
    assert len(together) > 450, "others beside them each time"

    again = PictureBatches(bank, config, workers=0)
    late = again[59]
    assert len(again._pool) == 9 * 6, "a pool that begins anew holds the last blocks"
    assert again._pool.added == batches._pool.added
    assert torch.isfinite(late[0]).all()


def test_what_a_pool_holds_is_that_of_the_blocks(data):
    import torch

    from swifttailor.data.pictures.bank import PictureBank
    from swifttailor.training.picture_batch_torch import PictureBatches
    from swifttailor.training.picture_pool_torch import PicturePool

    batches = PictureBatches(PictureBank([data / "train"]), tiny_config(), workers=0)
    pool = PicturePool(12, torch.device("cpu"))
    for number in range(3):  # the third pushes out the first
        pool.add(batches.blocks[number])
    assert len(pool) == 12 and pool.added == 3
    taken = pool.take(np.array([1, 7, 11]))
    for row, (number, place) in enumerate([(2, 1), (1, 1), (1, 5)]):
        for name, column in vars(batches.blocks[number]).items():
            np.testing.assert_array_equal(taken[name][row].numpy(), column[place], err_msg=name)


def test_masks_and_views_move_with_their_picture():
    import torch

    from swifttailor.training.picture_batch_torch import moved

    size = 64
    pictures, masks, views = torch.zeros(5, 3, size, size), torch.zeros(5, 2, 16, 16), torch.zeros(5, 6)
    places = torch.full((5, 3, 16, 16), torch.nan)
    places[:, :, 5:7, 9:11] = torch.tensor([0.1, 0.2, 0.3])[:, None, None]
    pictures[:, :, 20:28, 36:44] = 1.0
    masks[:, 0, 5:7, 9:11] = 1.0
    views[:, 4], views[:, 5] = 40 / size - 0.5, 24 / size - 0.5
    seen, covered, there, found = moved(pictures, masks, places, views, torch.Generator().manual_seed(1), 1.0)
    across = (torch.arange(size) + 0.5) / size - 0.5
    cells = (torch.arange(16) + 0.5) / 16 - 0.5
    areas = []
    for k in range(5):
        weight = seen[k, 0] / seen[k, 0].sum()
        x, y = float((weight.sum(0) * across).sum()), float((weight.sum(1) * across).sum())
        np.testing.assert_allclose([x, y], found[k, 4:6].numpy(), atol=0.01)
        share = covered[k, 0] / covered[k, 0].sum()
        xm, ym = float((share.sum(0) * cells).sum()), float((share.sum(1) * cells).sum())
        np.testing.assert_allclose([x, y], [xm, ym], atol=0.035)
        areas.append(float(seen[k, 0].sum()) / 64)
        assert (covered[k, 0][there[k, 0].isfinite()] > 0.2).all() and there[k, 0].isfinite().any()
        np.testing.assert_allclose(there[k, 2][there[k, 2].isfinite()], 0.3, atol=1e-6)
    np.testing.assert_allclose(np.sqrt(areas), np.exp(found[:, 3].numpy()), rtol=0.03)
    assert len({round(a, 3) for a in areas}) == 5
    same = moved(pictures, masks, places, views, torch.Generator().manual_seed(1), 0.0)
    torch.testing.assert_close(same[0], pictures, atol=1e-5, rtol=0)
    torch.testing.assert_close(same[2], places, equal_nan=True)
    torch.testing.assert_close(same[3], views)


def test_guesses_are_about_right_and_lacking_now_and_then():
    import torch

    from swifttailor.picture_reader.close_ups import WHOLE
    from swifttailor.training.picture_batch_torch import guessed

    views = torch.tensor([[0.0, 1.0, 0.1, -0.7, 0.05, -0.02]]).expand(4000, 6)
    figures = torch.ones(4000, dtype=torch.long)
    whole = torch.full((4000,), WHOLE)
    guess = guessed(views, figures, whole, torch.Generator().manual_seed(0), 0.3)
    assert (guessed(views, figures, 0 * whole, torch.Generator().manual_seed(0), 0.3)[:, 6] == 1).all()
    known = guess[:, 6] == 1
    assert 0.27 < float((~known).float().mean()) < 0.33 and not guess[~known].any()
    off = (guess[known, :6] - views[known]).abs()
    assert 0.01 < float(off[:, 3].median()) < 0.06 and float(off[:, 4].median()) < 0.02
    assert float(off[:, 3].max()) > 0.12


def test_the_loss_is_least_where_the_reading_is_true():
    import torch

    from swifttailor.picture_reader.close_ups import WHOLE, told_by
    from swifttailor.picture_reader.network_torch import Reading
    from swifttailor.picture_reader.panel_kinds import PANEL_KINDS
    from swifttailor.training.picture_config import LossWeights
    from swifttailor.training.picture_losses_torch import reading_losses
    from swifttailor.training.picture_truth_torch import Answers

    chance = torch.Generator().manual_seed(0)
    statements, dimensions, panels = (table.shape[1] for table in told_by())

    def lots(*shape):
        return (torch.rand(*shape, generator=chance) < 0.5).float()

    measures = torch.randn(2, 2, dimensions, generator=chance)
    truth = Answers(
        present=torch.tensor([[1.0, 0.0], [1.0, 1.0]]),
        told=torch.ones(2, 2, dtype=torch.bool),
        whole=torch.tensor([True, True]),
        placed=torch.tensor([True, True]),
        statements=lots(2, 2, statements),
        clear=lots(2, 2, statements).bool(),
        has=lots(2, 2, dimensions),
        measured=lots(2, 2, dimensions).bool(),
        measures=measures,
        panels=lots(2, 2, panels),
        named=lots(2, 2, panels).bool(),
        boxes=torch.randn(2, 2, panels, 5, generator=chance),
        view=torch.randn(2, 6, generator=chance),
        figures=torch.tensor([1, 1]),
        masks=lots(2, 2, 3, 3),
        places=torch.randn(2, 3, 3, 3, generator=chance),
        kinds=torch.randint(0, 4, (2, 3, 3), generator=chance),
        seams=lots(2, 3, 3),
        designs=torch.nn.functional.one_hot(torch.randint(0, 5, (2, 2, 4), generator=chance), 5).float(),
    )

    def sure(values):
        return 20 * (2 * values - 1)

    reading = Reading(
        sure(truth.present),
        sure(truth.statements),
        sure(truth.has),
        torch.stack([measures, torch.full_like(measures, -3.0)], -1),
        sure(truth.panels),
        truth.boxes,
        truth.view,
        sure(torch.nn.functional.one_hot(truth.figures, 3).float()),
        sure(truth.masks),
        truth.places,
        sure(torch.nn.functional.one_hot(truth.kinds, len(PANEL_KINDS)).float()).permute(0, 3, 1, 2),
        sure(truth.seams)[:, None],
        sure(truth.designs),
    )
    best = reading_losses(reading, truth, LossWeights())
    assert all(float(best[name]) < 1e-3 for name in best if name not in ("widths", "total"))
    for name in Reading._fields:
        worse = reading._replace(**{name: -getattr(reading, name)})
        assert reading_losses(worse, truth, LossWeights())["total"] > best["total"] + 0.1, name
    group = truth._replace(figures=torch.tensor([2, 2]))
    lost = reading_losses(reading._replace(masks=-reading.masks, view=-reading.view), group, LossWeights())
    bare = truth._replace(kinds=torch.full((2, 3, 3), -1))
    lost_on_bare = reading_losses(reading._replace(seams=-reading.seams), bare, LossWeights())
    assert float(lost_on_bare["kinds"]) == float(lost_on_bare["seams"]) == 0, "no garment, no panels"
    assert float(lost["figures"]) > 10 and float(lost["masks"]) == float(lost["view"]) == 0
    astray = reading._replace(masks=-reading.masks, view=-reading.view)
    lost = reading_losses(astray, truth._replace(placed=torch.tensor([False, False])), LossWeights())
    assert float(lost["masks"]) == 0 < float(lost["view"]), "nobody knows where it is"
    sides = torch.tensor([[1.0, 1, 0, 0, 0, 0]])
    astray = reading._replace(view=reading.view + 9 * (1 - sides))
    lost = reading_losses(astray, truth._replace(placed=torch.tensor([False, False])), LossWeights())
    assert float(lost["view"]) == 0, "but clothes show their fronts"
    half = truth._replace(told=torch.tensor([[True, False], [True, False]]))
    other = reading._replace(present=reading.present * torch.tensor([1.0, -1.0]))
    assert float(reading_losses(other, half, LossWeights())["present"]) < 1e-3, (
        "nobody told what covers the legs"
    )
    assert float(reading_losses(other, truth, LossWeights())["present"]) > 10
    unclear = reading._replace(statements=torch.where(truth.clear, reading.statements, -reading.statements))
    assert float(reading_losses(unclear, truth, LossWeights())["statements"]) < 1e-3, (
        "the border counts nothing"
    )
    near = truth._replace(whole=torch.tensor([False, False]))
    untold = reading._replace(
        present=-reading.present,
        figures=-reading.figures,
        has=torch.where(truth.measured, reading.has, -reading.has),
        measures=torch.where(truth.measured[..., None], reading.measures, reading.measures + 9),
        panels=torch.where(truth.named, reading.panels, -reading.panels),
        boxes=torch.where(truth.named[..., None], reading.boxes, reading.boxes + 9),
    )
    of_near = reading_losses(untold, near, LossWeights())
    assert abs(float(of_near["total"] - best["total"])) < 1e-2, "what a close-up does not tell counts nothing"
    small = torch.from_numpy(told_by().statements[:WHOLE].any(axis=0))
    for which, times in ((small, 5.0), (~small, 1.0)):
        wrong = torch.where(truth.clear & which, -reading.statements, reading.statements)
        once, more = (
            reading_losses(reading._replace(statements=wrong), truth, LossWeights(details=details))
            for details in (1.0, 5.0)
        )
        assert float(once["statements"]) > 10
        assert torch.allclose(more["statements"], times * once["statements"], rtol=1e-3)
