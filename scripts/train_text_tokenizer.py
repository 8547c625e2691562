"""Makes src/swifttailor/pattern_maker/text_tokens.json from captions and instructions of the training split.

.venv/bin/python scripts/train_text_tokenizer.py ../shared/garmentcode/train.jsonl.gz

Of every tenth pattern fifty captions are written, of every fiftieth some instructions: about a minute of CPU.
The result is part of trained weights: running this again makes them useless.
"""

from __future__ import annotations

import gzip
import json
import sys
from collections import Counter
from collections.abc import Iterator
from itertools import pairwise

from swifttailor.atomic_files import write_text
from swifttailor.data.edits.pairs import geometric_pairs
from swifttailor.describing import measure_facts
from swifttailor.networks.text_tokenizer import BYTES, SHIPPED, TextTokenizer, words_of
from swifttailor.pattern import Pattern, read_specification
from swifttailor.wording.captions import write_captions
from swifttailor.wording.instructions.writer import write_instruction

TOKENS = 1024
EVERY, CAPTIONS = 10, 50
EVERY_EDITED, INSTRUCTIONS = 50, 25
LEAST = 2
"""A pair that is found less often is not merged."""


def main(files: list[str]) -> None:
    words: Counter[bytes] = Counter()
    texts = 0
    for text in training_texts(files):
        words.update(words_of(text))
        texts += 1
    merges = find_merges(words, TOKENS - BYTES)
    tokenizer = TextTokenizer(tuple(merges))
    write_text(SHIPPED, tokenizer.to_json(), overwrite=True)
    tokens = sum(n * len(tokenizer.encode(w.decode("utf-8"), 100).tokens) for w, n in words.items())
    print(f"{texts} texts, {len(words)} words; {tokenizer.size} tokens, {tokens / texts:.1f} a text")


def training_texts(files: list[str]) -> Iterator[str]:
    for number, pattern in enumerate(patterns(files)):
        if number % EVERY == 0:
            facts = measure_facts(pattern)
            for caption in write_captions(facts, range(number * CAPTIONS, (number + 1) * CAPTIONS)):
                yield caption.text
        if number % EVERY_EDITED == 0:
            for pair in geometric_pairs(pattern, number, count=2):
                before, after = measure_facts(pair.base), measure_facts(pair.edited)
                for seed in range(INSTRUCTIONS):
                    instruction = write_instruction(before, after, seed)
                    if instruction is not None:
                        yield instruction.text


def patterns(files: list[str]) -> Iterator[Pattern]:
    for file in files:
        with gzip.open(file, "rt") as lines:
            for line in lines:
                sample = json.loads(line)
                yield read_specification(sample["pattern"], name=sample["id"]).pattern


def find_merges(words: Counter[bytes], count: int) -> list[tuple[int, int]]:
    """The most frequent pair of neighbours is joined, again and again; of equals the least."""
    spelled = {word: list(word) for word in sorted(words)}
    merges: list[tuple[int, int]] = []
    while len(merges) < count:
        pairs: Counter[tuple[int, int]] = Counter()
        for word, tokens in spelled.items():
            for pair in pairwise(tokens):
                pairs[pair] += words[word]
        if not pairs:
            break
        best = min(pairs, key=lambda pair: (-pairs[pair], pair))
        if pairs[best] < LEAST:
            break
        made = BYTES + len(merges)
        merges.append(best)
        for word, tokens in spelled.items():
            spelled[word] = _joined(tokens, best, made)
    return merges


def _joined(tokens: list[int], pair: tuple[int, int], made: int) -> list[int]:
    joined: list[int] = []
    k = 0
    while k < len(tokens):
        if tuple(tokens[k : k + 2]) == pair:
            joined.append(made)
            k += 2
        else:
            joined.append(tokens[k])
            k += 1
    return joined


if __name__ == "__main__":
    main(sys.argv[1:])
