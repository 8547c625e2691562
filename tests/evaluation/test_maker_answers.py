"""Asking, keeping answers, going on, drawing samples, scoring."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from maker_standins import DRAFTS, EDITS, StandIn, copy, given, refuse, truth, write_edits, write_patterns

from swifttailor.errors import InputError
from swifttailor.evaluation.maker import ask as ask_module
from swifttailor.evaluation.maker.ask import Asking, ask_all, batches
from swifttailor.evaluation.maker.book import ANSWERS, SAMPLES, SETTINGS, Book, open_books
from swifttailor.evaluation.maker.questions import (
    EditSet,
    PatternSet,
    Question,
    edit_questions,
    generation_questions,
    seed_of,
)
from swifttailor.evaluation.maker.sampling import sample_all, summarize_samples
from swifttailor.evaluation.maker.scores import (
    CHANCE,
    INPUT,
    OTHER,
    OURS,
    TOKENS,
    TRUTH,
    score_answers,
    summarize_task,
)
from swifttailor.evaluation.maker.sheet import Shown, chosen, write_sheets
from swifttailor.evaluation.maker.tables import sampling_text, task_text
from swifttailor.evaluation.patterns import summarize_patterns
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.pattern import Edge, Panel, Pattern
from swifttailor.pattern.drafts import draft
from swifttailor.pattern_maker.temperatures import USUAL_TEMPERATURE
from swifttailor.picture_reader.reading import PartReading, PictureReading
from swifttailor.render import Camera
from swifttailor.tailor import Order, Tailor
from swifttailor.tailor.looking import SeenPicture
from swifttailor.wishes.heard import Heard
from swifttailor.workers.work_folder import FolderLock

TINY_SEWER = Path(__file__).parents[1] / "garment_sewer" / "tiny_sewer.onnx"
HOW = Asking(temperature=0.0, network_alone=True, seed=7)


@pytest.fixture(scope="module")
def texts(tmp_path_factory) -> list[Question]:
    """One question for each draft."""
    patterns = PatternSet.read([write_patterns(tmp_path_factory.mktemp("texts"))])
    return generation_questions(patterns, tuple(DRAFTS), ("text",), bool, 0)


@pytest.fixture(scope="module")
def edits(tmp_path_factory) -> list[Question]:
    folder = tmp_path_factory.mktemp("edits")
    patterns = PatternSet.read([write_patterns(folder)])
    return edit_questions(EditSet.read(write_edits(folder), patterns), tuple(EDITS), patterns, 2)


@pytest.fixture
def pairs(monkeypatch):
    """Two questions are answered together."""
    monkeypatch.setattr(ask_module, "BATCH", 2)


@pytest.fixture
def book(tmp_path):
    opened = Book(tmp_path / ANSWERS)
    yield opened
    opened.close()


def lines(book: Book) -> list[dict]:
    return [json.loads(line) for line in book._file.path.read_text().splitlines()]


def test_questions_of_one_task_go_together(texts, edits, pairs):
    found = [[q.key for q in part] for part in batches([*texts[:3], *edits])]
    keys = [q.key for q in (*texts[:3], *edits)]
    assert found == [keys[:2], keys[2:3], keys[3:5], keys[5:7]]
    assert list(batches([])) == []


def test_answers_are_kept_and_not_asked_for_again(texts, pairs, book, tmp_path):
    maker = StandIn(texts, truth)
    done: list[int] = []
    answers = ask_all(Tailor(maker), texts, book, HOW, progress=done.append)
    assert maker.asked == [[q.key for q in texts[:2]], [q.key for q in texts[2:]]] and done == [2, 2]
    assert [a.pattern for a in answers] == [q.truth for q in texts]
    record = lines(book)[1]
    assert record["question"] == texts[1].key and record["text"] == texts[1].text
    assert record["together"] == 2 and record["seconds"] == {"writing": 0.5} and record["errors"] == 0
    book.close()
    again = Book(tmp_path / ANSWERS)
    silent = StandIn(texts, refuse)
    kept = ask_all(Tailor(silent), texts, again, HOW)
    assert silent.asked == [] and [a.record for a in kept] == [a.record for a in answers]
    assert [a.pattern for a in kept] == [a.pattern for a in answers]
    again.close()


def test_how_a_network_of_others_decodes_cannot_be_chosen(texts, book):
    asking = replace(HOW, decoding="free")
    answers = ask_all(Tailor(StandIn(texts, truth)), texts, book, asking)
    assert {a.pattern for a in answers} == {None}
    assert all("How a StandIn decodes cannot be chosen" in a.record["error"] for a in answers)


def test_interrupted_it_goes_on_as_if_it_had_not_been(texts, pairs, book, tmp_path):
    """However it ended: two lines were written of the first two questions, half a one of the third."""

    def interrupt(question, seed, temperature):
        if question is texts[2]:
            raise KeyboardInterrupt
        return question.truth

    with pytest.raises(KeyboardInterrupt):
        ask_all(Tailor(StandIn(texts, interrupt)), texts, book, HOW)
    assert [r["question"] for r in lines(book)] == [q.key for q in texts[:2]]
    whole = Book(tmp_path / "whole.jsonl")
    ask_all(Tailor(StandIn(texts, truth)), texts, whole, HOW)
    book.close()
    (tmp_path / ANSWERS).write_text(
        "".join((tmp_path / "whole.jsonl").read_text().splitlines(keepends=True)[:3])[:-40]
    )
    again = Book(tmp_path / ANSWERS)
    assert len(again) == 2
    maker = StandIn(texts, truth)
    ask_all(Tailor(maker), texts, again, HOW)
    assert maker.asked == [[q.key for q in texts[2:]]]
    assert lines(again) == lines(whole)
    whole.close()
    again.close()


def test_a_batch_of_which_some_answers_are_missing_is_asked_as_before(texts, pairs, tmp_path):
    """Alone, a question would be answered by other last digits."""
    whole = Book(tmp_path / "whole.jsonl")
    ask_all(Tailor(StandIn(texts, truth)), texts, whole, HOW)
    (tmp_path / ANSWERS).write_text((tmp_path / "whole.jsonl").read_text().splitlines(keepends=True)[0])
    again = Book(tmp_path / ANSWERS)
    maker = StandIn(texts, truth)
    ask_all(Tailor(maker), texts, again, HOW)
    assert maker.asked[0] == [q.key for q in texts[:2]]
    assert lines(again) == lines(whole)
    whole.close()
    again.close()


def test_every_question_has_its_own_seed(texts, pairs, book):
    seen: dict[str, int] = {}

    def note(question, seed, temperature):
        assert temperature == 0.8
        seen[question.id] = seed
        return question.truth

    ask_all(Tailor(StandIn(texts, note)), texts, book, replace(HOW, temperature=0.8))
    assert len(set(seen.values())) == len(texts)


def test_of_those_asked_together_only_the_one_without_an_answer_has_none(texts, book):
    maker = StandIn(texts, lambda q, s, t: refuse(q, s, t) if q.id == "long" else q.truth)
    answers = ask_all(Tailor(maker), texts, book, HOW)
    assert [a.pattern is None for a in answers] == [False, False, True, False]
    assert answers[2].record["error"] == "No answer to long."
    assert [len(part) for part in maker.asked] == [4, 1, 1, 1, 1]


def test_answers_to_other_questions_are_refused(texts, book, tmp_path):
    ask_all(Tailor(StandIn(texts, truth)), texts, book, HOW)
    other = replace(texts[0], text="something else")
    with pytest.raises(InputError, match="something else was asked"):
        ask_all(Tailor(StandIn([other], truth)), [other], book, HOW)
    book.close()
    (tmp_path / ANSWERS).write_text('{"question": "text/shirt"}\n')
    with pytest.raises(InputError, match="holds a line that is not an answer"):
        Book(tmp_path / ANSWERS)
    (tmp_path / ANSWERS).write_text(
        json.dumps({"question": texts[0].key, "attempt": 0, "asked": texts[0].fingerprint, "pattern": {}})
        + "\n"
    )
    damaged = Book(tmp_path / ANSWERS)
    with pytest.raises(InputError, match="'text/shirt' is damaged"):
        ask_all(Tailor(StandIn(texts, truth)), texts[:1], damaged, HOW)
    damaged.close()


def test_a_folder_keeps_to_its_settings_and_is_used_by_one(tmp_path):
    folder = tmp_path / "new" / "results"
    with open_books(folder, {"seed": 1, "attempts": 2}) as (answers, samples):
        assert len(answers) == len(samples) == 0
        with pytest.raises(InputError, match="Another evaluation is at work"):
            FolderLock(folder, "evaluation")
    assert {p.name for p in folder.iterdir()} >= {ANSWERS, SAMPLES, SETTINGS}
    with open_books(folder, {"attempts": 2, "seed": 1}):
        pass
    with pytest.raises(InputError, match="seed was 1, now 2"), open_books(folder, {"seed": 2, "attempts": 2}):
        pass
    (folder / SETTINGS).write_text("[]")
    with pytest.raises(InputError, match="not a JSON object"), open_books(folder, {}):
        pass
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="Choose another --out"), open_books(tmp_path / "file", {}):
        pass


class Unsteady:
    """Writes a T-shirt without a seam at first, then shirts, whatever it is asked for."""

    def __init__(self) -> None:
        self.asked: list[tuple[list[str], float, int]] = []

    def generate_all(self, requests, *, seed, temperature, draw):
        self.asked.append(([r.text for r in requests], temperature, draw))
        shirt = draft("t-shirt")
        return [given(shirt if draw else replace(shirt, stitches=shirt.stitches[1:])) for _ in requests]


def test_what_is_measured_is_what_people_get(texts, edits, book, monkeypatch):
    """The same pattern as `generate` and `edit` give: written again, altered, with the same settings."""
    monkeypatch.setattr(Heard, "drafts", ())  # else nobody is asked to write
    asking = Asking(seed=7)
    asked = [texts[0], edits[0]]
    writer, sewer = Unsteady(), GarmentSewer.load(TINY_SEWER)
    kept = ask_all(Tailor(writer, sewer), asked, book, asking)
    shown = writer.asked.copy()
    usual = Tailor(writer, sewer)
    seeds = [seed_of(7, q.key, "answer") for q in asked]
    described = usual.generate(asked[0].text, seed=seeds[0])
    instructed = usual.edit(asked[1].before, asked[1].text, seed=seeds[1])
    assert writer.asked[len(shown) :] == shown and len(shown) > 1, "asked as often, in the same words"
    assert {t for _, t, draw in shown if draw == 0} == {USUAL_TEMPERATURE}
    for answer, made in zip(kept, (described, instructed), strict=True):
        assert answer.pattern.canonical() == made.pattern
        record, report = answer.record, made.report
        assert record["altered"] == report["alterations"]["cuts"]
        assert record["attempts"] == len(report["writing"]["failed_attempts"]) + 1
        assert 1 <= record["until_sound"] <= record["attempts"]
        assert {"reading", "drawing"} <= set(record["seconds"])
    assert {"writing", "altering"} <= set(kept[0].record["seconds"])
    assert instructed.report["alterations"]["of_the_pattern_to_edit"]
    scored = score_answers(kept)
    assert summarize_task("text", scored[:1]).attempts == kept[0].record["attempts"] > 1


def test_a_question_that_a_tailor_gives_up_has_no_answer(texts, book):
    """Every pattern crosses itself: nobody gets a garment, and so nothing is measured."""
    asking = Asking(seed=7, attempts=2)
    writer = StandIn(texts, lambda q, s, t: BOW_TIE)
    tailor = Tailor(writer, GarmentSewer.load(TINY_SEWER))
    (kept,) = ask_all(tailor, texts[:1], book, replace(asking, alter=False))
    assert kept.pattern is None and "None of the 2 patterns" in kept.record["error"]
    assert len(writer.asked) == 2


BOW_TIE = Pattern((Panel("pant_f_l", [[0.0, 0.0], [40.0, 40.0], [40.0, 0.0], [0.0, 40.0]], (Edge(),) * 4),))
"""Not sound, and not to be mended without a guess."""


class Unlucky:
    """Answers with bad patterns some times, then with the truth."""

    def __init__(self, bad: dict[str, int]) -> None:
        self.bad, self.calls = bad, dict.fromkeys(bad, 0)

    def __call__(self, question: Question, seed: int, temperature: float) -> Pattern:
        assert temperature == 1.0
        self.calls[question.id] += 1
        return BOW_TIE if self.calls[question.id] <= self.bad[question.id] else question.truth


def test_samples_are_drawn_until_one_is_sound(texts, book, tmp_path):
    bad = {"shirt": 0, "short": 2, "long": 9, "trousers": 0}
    maker = StandIn(texts, Unlucky(bad))
    found = sample_all(maker, texts, book, 3, 0)
    left = ["text/short", "text/long"]
    assert maker.asked == [[f"text/{id}" for id in bad], left, left]
    counts = [(s.written.count, s.written.sound) for s in found]
    assert counts == [(1, True), (3, True), (3, False), (1, True)]
    assert [gate for gate, _ in found[1].written.failures] == ["check", "check"]
    summary = summarize_samples(found)
    assert summary.written.mean == 2.0 and summary.written.succeeded == 3
    assert (summary.samples, summary.sound, summary.checked) == (4, 2, 2)
    assert (summary.closed, summary.paired) == (4, 4)
    kept = [r for r in lines(book) if "pattern" in r]
    assert [(r["question"], r["attempt"]) for r in kept] == [
        ("text/shirt", 0),
        ("text/trousers", 0),
        ("text/short", 2),
    ]
    book.close()
    again = Book(tmp_path / ANSWERS)
    silent = StandIn(texts, refuse)
    assert summarize_samples(sample_all(silent, texts, again, 3, 0)) == summary and silent.asked == []
    more = sample_all(StandIn(texts, Unlucky(dict(bad, long=0))), texts, again, 5, 0)
    assert [s.written.count for s in more] == [1, 3, 4, 1]
    again.close()


def test_samples_that_fail_to_decode_count_as_attempts(texts, book):
    (question, *_) = texts
    summary = summarize_samples(sample_all(StandIn(texts, refuse), [question], book, 2, 0))
    assert summary.written.mean == 2.0 and not summary.written.succeeded
    assert summary.written.failures == {"decode": 2, "check": 0, "mesh": 0}
    assert (summary.closed, summary.paired, summary.sound_mended) == (0, 0, 0)


def test_what_is_mended_is_judged_beside_what_was_written(texts, book, monkeypatch):
    """The first pattern is sound only when it is mended, the second as it was written."""
    from swifttailor.evaluation.maker import sampling

    (question, *_) = texts
    written = {1: BOW_TIE, 2: question.truth}
    calls: list[int] = []

    def choose(question, seed, temperature):
        calls.append(seed)
        return written[len(calls)]

    class Mends(StandIn):
        def generate_all(self, requests, **more):
            return [
                replace(g, pattern=question.truth, changes=(object(),))
                for g in super().generate_all(requests, **more)
            ]

    monkeypatch.setattr(sampling, "first_fault", _fault)
    (found,) = sample_all(Mends([question], choose), [question], book, 20, 0)
    assert (found.written.count, found.mended.count) == (2, 1) and len(set(calls)) == 2
    summary = summarize_samples([found])
    assert (summary.sound, summary.sound_mended) == (0, 1)


def _fault(pattern: Pattern):
    return ("check", "bow tie") if len(pattern.panels) == 1 else None


def test_the_right_answers_score_full_marks(texts, book):
    scored = score_answers(ask_all(Tailor(StandIn(texts, truth)), texts, book, HOW))
    result = summarize_task("text", scored)
    patterns, adherence = dict(result.patterns), dict(result.adherence)
    assert list(patterns) == [OURS, TOKENS, OTHER] and list(adherence) == [OURS, TRUTH, CHANCE]
    for row in (patterns[OURS], patterns[TOKENS]):
        assert row.missing == 0
        for name in ("panels_right", "edges_by_name", "edges_in_order", "stitches"):
            assert row.aipparel[name].mean == 1
        assert row.aipparel["vertex_cm"].mean < 1e-4 and row.by_name["structure_right"].mean == 1
    truths = [q.truth for q in texts]
    assert patterns[OTHER] == summarize_patterns(truths[1:] + truths[:1], truths)
    assert adherence[OURS].whole.share == adherence[TRUTH].whole.share == 1
    assert adherence[CHANCE].whole.held == 0 and adherence[CHANCE].claims.made == adherence[OURS].claims.made
    assert (result.mended, result.faulty) == (0, 0) and result.seconds == {"writing": 0.5 / 4}
    for one in scored:
        line = json.loads(json.dumps(one.to_json(), allow_nan=False))
        assert line["aipparel"]["panels_right"] and line["measured"] and line["asked_for"]
        assert all(each["holds"] for each in line["asked_for"])
    text = task_text(result)
    assert "== From text: 4 questions ==" in text and "another pattern" in text and "by chance" in text


def test_wrong_answers_score_what_they_are_worth(texts, book):
    """The answer to each question is the pattern of the next; one has none."""
    wrong = {q.id: other.truth for q, other in zip(texts, texts[1:] + texts[:1], strict=True)}
    maker = StandIn(texts, lambda q, s, t: refuse(q, s, t) if q.id == "long" else wrong[q.id])
    scored = score_answers(ask_all(Tailor(maker), texts, book, HOW))
    result = summarize_task("text", scored)
    predicted = [None if q.id == "long" else wrong[q.id] for q in texts]
    assert dict(result.patterns)[OURS] == summarize_patterns(predicted, [q.truth for q in texts])
    ours = dict(result.adherence)[OURS]
    held = [each["holds"] for s in scored for each in s.to_json()["asked_for"]]
    assert (ours.claims.held, ours.claims.made) == (sum(held), len(held))
    assert ours.unmeasured == 1 and ours.whole.held == 0
    missing = scored[2].to_json()
    assert missing["missing"] and missing["error"] == "No answer to long." and not missing["measured"]


def test_copying_is_worth_as_much_as_its_row_says(edits, book):
    result = summarize_task("edit", score_answers(ask_all(Tailor(StandIn(edits, copy)), edits, book, HOW)))
    patterns, adherence = dict(result.patterns), dict(result.adherence)
    assert list(patterns) == [OURS, TOKENS, INPUT] and list(adherence) == [OURS, TRUTH, INPUT]
    assert patterns[OURS].aipparel["panels_right"] == patterns[INPUT].aipparel["panels_right"]
    near = patterns[INPUT].aipparel["vertex_cm"]
    assert patterns[OURS].aipparel["vertex_cm"].mean == pytest.approx(near.mean, abs=1e-6) and near.mean > 0.5
    assert patterns[INPUT].aipparel["edges_in_order"].mean > 0.9, "panels are paired in canonical order"
    assert adherence[OURS].claims == adherence[INPUT].claims and adherence[INPUT].claims.held == 0
    assert adherence[TRUTH].whole.share == 1
    assert "input unchanged" in task_text(result) and "paper: PatternMaker" in task_text(result)


def test_sampling_is_printed_beside_the_paper(texts, book):
    summary = summarize_samples(sample_all(StandIn(texts, truth), texts[:2], book, 20, 0))
    shown = sampling_text({"text": summary}, 20)
    assert "paper: AIpparel, text" in shown and "3.76" in shown and "1.00" in shown


def test_sheets_show_answers_from_the_nearest_to_the_farthest(edits, texts, book, tmp_path):
    from PIL import Image

    maker = StandIn([*texts, *edits], lambda q, s, t: copy(q, s, t) if q.before else refuse(q, s, t))
    scored = score_answers(ask_all(Tailor(maker), [*edits, *texts[:1]], book, HOW))
    ordered = chosen(scored[:4], 4)
    distances = [s.score.by_name.vertex_cm for s in ordered]
    assert distances == sorted(distances) and len(ordered) == 4
    assert chosen(scored[:4], 2) == [ordered[0], ordered[-1]] and chosen(scored, 0) == chosen([], 3) == []
    written = write_sheets(tmp_path, "edit", [Shown(s, None) for s in ordered])
    assert written == [tmp_path / "sheet-edit-01.png"]
    unanswered = write_sheets(tmp_path, "text", [Shown(scored[4], None)])
    with Image.open(written[0]) as wide, Image.open(unanswered[0]) as narrow:
        assert wide.width > narrow.width and wide.height > 3 * narrow.height


class Looking:
    """A tailor that sees garments on given parts of the body in every picture."""

    def __init__(self, *parts: str) -> None:
        mask = np.ones((4, 4), np.float32)
        worn = tuple(PartReading(part, 0.9, (), (), (), mask) for part in parts)
        self.reading = PictureReading(worn, Camera(), (0, 0, 4, 4))
        self.picture_reader = self

    def look(self, image):
        return SeenPicture(image, self.reading)


def test_of_a_person_in_two_garments_the_one_that_is_asked_for_counts(texts):
    by_id = {question.id: question for question in texts}
    shown = Order(image=np.zeros((4, 4, 3), np.uint8))

    def part(id, *parts):
        order = ask_module._of_its_part(Looking(*parts), shown, by_id[id])
        assert all(isinstance(one, SeenPicture) for one in order.images)
        return order.part

    assert part("shirt", "upper", "lower") == "upper" and part("short", "upper", "lower") == "lower"
    assert part("short", "upper") is None, "what is taken for another garment is the answer"
    unread = Order("a skirt")
    assert ask_module._of_its_part(Looking("upper"), unread, by_id["short"]) is unread
    blind = Looking("upper")
    blind.picture_reader = None
    assert ask_module._of_its_part(blind, shown, by_id["short"]) is shown
