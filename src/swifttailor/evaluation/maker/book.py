"""Answers on disk: a line of JSON each, written when they are given, so that work can go on after any end."""

from __future__ import annotations

import json
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from swifttailor.data.builder.code_version import code_version
from swifttailor.errors import InputError
from swifttailor.evaluation.kept_settings import keep_settings
from swifttailor.evaluation.maker.questions import Question
from swifttailor.output_folder import FolderLock
from swifttailor.workers.interruption import sigterm_as_interrupt
from swifttailor.workers.work_folder import RecordFile

SETTINGS, ANSWERS, SAMPLES = "settings.json", "answers.jsonl", "samples.jsonl"
FORMAT = "swifttailor answers 1"


class Book:
    """The answers to some questions, several to each where they are samples."""

    def __init__(self, path: Path) -> None:
        """Opens the file, or makes it.

        Raises:
            InputError: It cannot be read or written, or holds something else.
        """
        try:
            self._file = RecordFile(path)
        except OSError as error:
            raise InputError(
                f"Cannot read or write '{path}': {error.strerror or error}. Choose another --out."
            ) from error
        self._commit = code_version()["commit"]
        self._records: dict[tuple[str, int], dict[str, Any]] = {}
        for record in self._file.found:
            try:
                key = str(record["question"]), int(record["attempt"])
                str(record["asked"])
            except (KeyError, TypeError, ValueError) as error:
                raise InputError(
                    f"'{path}' holds a line that is not an answer ({error!r}). Choose another --out."
                ) from error
            self._records.setdefault(key, record)

    def __len__(self) -> int:
        return len(self._records)

    def get(self, question: Question, attempt: int = 0) -> dict[str, Any] | None:
        """What was answered; None where nothing was yet.

        Raises:
            InputError: Another question had that name when it was answered.
        """
        record = self._records.get((question.key, attempt))
        if record is not None and record["asked"] != question.fingerprint:
            raise InputError(
                f"'{self._file.path}' has an answer to '{question.key}', but something else was asked: the "
                "pattern, or the words that this version of SwiftTailor finds for it, were others. "
                "Choose another --out."
            )
        return record

    def add(self, question: Question, attempt: int, content: dict[str, Any]) -> dict[str, Any]:
        """Keeps an answer, unless there is one already; returns the one that counts.

        Raises:
            InputError: It cannot be written.
        """
        known = self.get(question, attempt)
        if known is not None:
            return known
        record = {"question": question.key, "attempt": attempt, "asked": question.fingerprint}
        # As it will be read again, so that going on later makes no difference.
        record = json.loads(json.dumps(record | content | {"commit": self._commit}, allow_nan=False))
        self._file.add(record)
        self._records[question.key, attempt] = record
        return record

    def commits(self) -> list[str]:
        """Commits of the code that answers were made with."""
        return sorted({str(r.get("commit", "")) for r in self._records.values()})

    def close(self) -> None:
        """Closes the file."""
        self._file.close()


@contextmanager
def open_books(folder: Path, settings: dict[str, Any]) -> Generator[tuple[Book, Book]]:
    """The answers and samples in a folder, which nobody else works on meanwhile.

    Args:
        folder: Created when missing.
        settings: What decides the answers, as JSON values; must be as before where there are some.

    Raises:
        InputError: The folder cannot be used, or its answers were made in another way.
    """
    try:
        lock = FolderLock(folder, "evaluation")
    except OSError as error:
        raise InputError(
            f"Cannot use '{folder}': {error.strerror or error}. Choose another --out."
        ) from error
    with lock, sigterm_as_interrupt():
        keep_settings(folder / SETTINGS, {"format": FORMAT} | settings, "answers", (ANSWERS, SAMPLES))
        answers, samples = Book(folder / ANSWERS), Book(folder / SAMPLES)
        try:
            yield answers, samples
        finally:
            answers.close()
            samples.close()
