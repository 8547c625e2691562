"""Prints that texts ask for, and languages and spellings that are told."""

from __future__ import annotations

import pytest

from swifttailor.wishes.looks.heard_print import asks_for_plain, heard_print, print_line
from swifttailor.wishes.looks.naps import nap_of, puffed
from swifttailor.wishes.text.lexicon_spelling import guessed_name, lexicon_spelling
from swifttailor.wording.lexicon import foreign_language, read_words


def asked(text):
    return heard_print(text, read_words(text))


@pytest.mark.parametrize(
    ("text", "kind", "colors"),
    [
        ("navy and white striped top", "stripes", ("#1f2a44", "#ffffff")),
        ("a red dress with white polka dots", "dots", ("#ab252e", "#ffffff")),
        ("white dots on a dark blue dress", "dots", ("#1d2f5e", "#ffffff")),
        ("dress with red dots", "dots", ("#f4f1e8", "#ab252e")),
        ("a Breton top", "stripes", ("#f4f1e8", "#1f2a44")),
        ("gingham skirt in red", "checks", ("#ab252e", "#f4f1e8")),
    ],
)
def test_colours_have_their_places_in_a_print(text, kind, colors):
    found = asked(text)
    assert found is not None and (found.kind, found.colors) == (kind, colors)


def test_dark_figures_are_pale_on_a_dark_ground():
    ground, figure = (int(color[1:3], 16) for color in asked("navy shorts with little anchors").colors[:2])
    assert figure > ground + 100


def test_direction_and_size_are_obeyed():
    down = asked("shirt with 2 cm vertical stripes")
    assert down is not None and (down.size("angle"), down.size("width"), down.size("gap")) == (90, 2, 2)
    around = asked("stripy dress, horizontal")
    assert around is not None and around.size("angle") == 0
    dots = asked("dots 3 cm wide")
    assert dots is not None and dots.size("radius") == 1.5
    assert "down the body" in print_line(down) and "2 and 2 cm" in print_line(down)


@pytest.mark.parametrize(
    ("text", "angle", "width"),
    [
        ("a striped shirt", 90, 1.2),
        ("striped pyjama bottoms", 90, 1.2),
        ("wide striped shirt", 90, 6),
        ("shirt with 3 cm stripes", 90, 3),
        ("shirt with horizontal stripes", 0, 2.5),
        ("striped pyjama top", 90, 1.2),
        ("a striped nightshirt", 90, 1.2),
        ("a striped polo shirt", 0, 2.5),
        ("a striped tee", 0, 2.5),
        ("a striped jumper", 0, 2.5),
    ],
)
def test_stripes_run_down_shirts_and_trousers_and_around_knits(text, angle, width):
    found = asked(text)
    assert found is not None and (found.size("angle"), found.size("width")) == (angle, width)


def test_no_print_is_heard_where_none_is_asked_for():
    assert asked("a plain blue dress") is None and asks_for_plain(read_words("a plain blue dress"))
    assert asked("a dress without stripes") is None and asks_for_plain(read_words("a dress without stripes"))
    assert asked("a dress") is None and not asks_for_plain(read_words("a dress"))


@pytest.mark.parametrize(
    ("text", "language"),
    [
        ("czarna sukienka do kolan bez rękawów", "Polish"),
        ("en klänning med långa ärmar", "Swedish"),
        ("黒いロングスカート", "Japanese"),
        ("赤いワンピース、長袖", "Japanese"),
        ("abito da sera nero senza spalline", None),
        ("een spijkerbroek met wijde pijpen", None),
        ("saia preta até o joelho", None),
        ("a nice dress with pockets", None),
        ("robe noire sans manches", None),
    ],
)
def test_languages_that_are_not_read_are_told(text, language):
    assert foreign_language(text, read_words(text).unknown) == language


def test_spellings_that_sound_alike_are_put_right_and_others_are_guesses():
    assert lexicon_spelling("assymetric") == "asymmetric"
    assert lexicon_spelling("batteau") == "bateau"
    assert lexicon_spelling("hoddie") == "hoodie"
    assert lexicon_spelling("wuzzle") is None and lexicon_spelling("cardagan") is None
    assert guessed_name(["cardagan"]) == ("cardagan", "cardigan")
    assert guessed_name(["wuzzle"]) is None


def test_a_print_has_all_colours_that_its_name_says() -> None:
    found = heard_print("a tie dye t-shirt", read_words("a tie dye t-shirt"))
    assert found is not None
    assert len(set(found.colors)) == 4
    assert "#f0b63f" in found.colors


@pytest.mark.parametrize(
    ("text", "kind", "colors"),
    [
        ("a broderie anglaise blouse", "dots", ("#f7f6f1", "#b4b1aa")),
        ("a crochet top", "dots", ("#f2ebde", "#b3a48f")),
        ("sequin mini skirt silver", "motif", ("#737373", "#c0c0c0", "#efefef")),
    ],
)
def test_holes_and_sequins_are_in_the_colour_of_their_cloth(text, kind, colors):
    found = heard_print(text, read_words(text))
    assert found is not None and (found.kind, found.colors) == (kind, colors)


@pytest.mark.parametrize(
    ("text", "motif", "first"),
    [
        ("leopard print leggings", "leopard", "#cfa266"),
        ("a tunic, PRINT: LEOPARD", "leopard", "#cfa266"),
        ("blue zebra print top", "zebra", "#f4f1e8"),
        ("brown cow print skirt", "cowhide", "#f4f1e8"),
        ("Hawaiian shirt, big palm leaves", "palms", "#f4f1e8"),
        ("navy shirt with palm leaves", "palms", "#1f2a44"),
        ("brown and orange paisley maxi dress", "paisley", "#6b4423"),
        ("harlequin costume in red and yellow", "lozenges", "#ab252e"),
        ("patchwork jeans, blue and cream", "patchwork", "#365c96"),
        ("poncho, mexican style stripes", "serape", "#c92f38"),
        ("kimono with cranes", "cranes", "#33507a"),
        ("pale blue pyjamas with small dogs on it", "dogs", "#bcd4e6"),
        ("qipao in red with gold pattern", "medallions", "#ab252e"),
        ("black robe with a silver pattern", "medallions", "#000000"),
        ("navy dress with a little pattern", "sprigs", "#1f2a44"),
        ("surcoat with a white cross on red", "crosses", "#ab252e"),
    ],
)
def test_figured_prints_are_of_their_kind_on_their_ground(text, motif, first):
    found = heard_print(text, read_words(text))
    assert found is not None and (found.motif, found.colors[0]) == (motif, first)


@pytest.mark.parametrize(
    ("text", "kind", "colors"),
    [
        ("lumberjack shirt red and black check", "checks", ("#ab252e", "#000000")),
        ("buffalo plaid jacket, black and white", "checks", ("#000000", "#ffffff")),
        ("wool trousers, brown check", "plaid", ("#6b4423", "#4b3220", "#977b62")),
        ("blue checked blouse", "checks", ("#365c96", "#f4f1e8")),
        ("kilt in green tartan", "plaid", ("#40724f", "#263846", "#c7d1c2")),
        ("tartan kilt", "plaid", ("#b0242d", "#1e3a36", "#eadfc6")),
    ],
)
def test_checks_have_the_colours_that_are_named(text, kind, colors):
    found = heard_print(text, read_words(text))
    assert found is not None and (found.kind, found.colors) == (kind, colors)


def test_a_spiral_goes_through_colours_that_divide_its_six():
    for named in (
        "",
        " in blue",
        " in purple and green",
        " in red, white and blue",
        " in red, blue, green and pink",
    ):
        found = heard_print(f"tie dye t-shirt{named}", read_words(f"tie dye t-shirt{named}"))
        assert found is not None and len(found.colors) in (2, 3, 6)


@pytest.mark.parametrize(
    ("text", "nap"),
    [
        ("pink fluffy dressing gown", "curls"),
        ("teddy bear coat", "curls"),
        ("sherpa jacket", "curls"),
        ("sweater with cables", "cables"),
        ("Aran jumper", "cables"),
        ("gold sequins dress", "sequins"),
        ("sparkly pink party dress", "sequins"),
        ("burgundy velvet dress", "pile"),
        ("metallic gold skirt", "foil"),
        ("a gold lamé top", "foil"),
        ("red flamenco skirt", None),
        ("brown fur coat", "fur"),
        ("grey marl hoodie", "marl"),
        ("a natural linen shirt", "linen"),
        ("Leinenhose", "linen"),
        ("a dress with a long line in the front", None),
        ("a coat with a fur collar", None),
        ("a coat with a sherpa collar", None),
        ("a parka with a fur hood", None),
        ("a teddy coat with a fur collar", "curls"),
        ("corduroy skirt", None),
        ("a grey coat with a velvet collar", None),
        ("flamenco dress", None),  # which has "lame" in it
        ("cotton dress", None),
    ],
)
def test_the_face_of_cloth_is_drawn(text, nap):
    assert nap_of(read_words(text)) == nap


@pytest.mark.parametrize(
    ("text", "shown", "first", "second"),
    [
        ("dress with tiny flowers", "sprigs", "#f4f1e8", "#b0485a"),
        ("housecoat, little blue flowers", "sprigs", "#f4f1e8", "#365c96"),
        ("white dress with small pink flowers", "sprigs", "#ffffff", "#f2a9bb"),
        ("maybe navy, with a little pattern", "sprigs", "#1f2a44", "#f4f1e8"),
        ("red dress with tiny white dots", "dots", "#ab252e", "#ffffff"),
        ("black dress with big white polka dots", "dots", "#000000", "#ffffff"),
        ("a small blue dotted dress", "dots", "#365c96", "#f4f1e8"),
        ("mini skirt plaid pleated like in clueless", "plaid", "#ebc436", "#f6edc4"),
        ("Cher Horowitz suit", "plaid", "#ebc436", "#f6edc4"),
        ("red tartan skirt like in Clueless", "plaid", "#ab252e", None),
    ],
)
def test_small_figures_and_checks_of_films(text, shown, first, second):
    found = heard_print(text, read_words(text))
    assert found is not None and shown in (found.kind, found.motif)
    assert found.colors[0] == first and second in (None, found.colors[1])


def test_sizes_before_colours_are_those_of_the_figures():
    radii = [
        heard_print(text, read_words(text)).size("radius")
        for text in ("red with tiny white dots", "red with white dots", "red with big white dots")
    ]
    assert radii == [0.15, 0.8, 2.5]
    assert heard_print("I am clueless, a skirt", read_words("I am clueless, a skirt")) is None


@pytest.mark.parametrize("color", ["#1f2a44", "#ab252e", "#17151a", "#f4f1e8"])
def test_cushions_are_of_the_hue_of_their_cloth(color):
    cloth = puffed(color, 8.5)
    parts = [[int(one[k : k + 2], 16) / 255 for k in (1, 3, 5)] for one in cloth.colors]
    hues = [(max(rgb) - min(rgb)) / max(rgb) for rgb in parts]
    assert cloth.ground == color and max(parts[0]) < max(parts[1]) <= max(parts[2])
    assert max(hues) - min(hues) < 0.08, "no greyer"


@pytest.mark.parametrize(
    ("text", "motif", "colors"),
    [
        ("red white and blue striped dress", "rainbow", ("#ab252e", "#ffffff", "#365c96")),
        ("colour block dress red, white and blue", "blocks", ("#ab252e", "#ffffff", "#365c96")),
        ("ombre dress from pink to orange", "ombre", ("#f2a9bb", "#e69680", "#d98244")),
        ("blue ombre dress", "ombre", ("#e7ebf2", "#8ea4c4", "#365c96")),
        ("ombre dress, white", "ombre", ("#ffffff", "#8f94a2", "#1f2a44")),
        ("black and white zigzag dress", "zigzag", ("#000000", "#ffffff")),
        ("brown herringbone tweed trousers", "herringbone", ("#6b4423", "#452f1f")),
        ("pink camo leggings", "camouflage", ("#f2a9bb", "#9a6e7b", "#f3d1d4", "#4e3a42")),
        ("purple galaxy hoodie", "galaxy", ("#12142e", "#432f5d", "#63417d", "#8e769d", "#ffffff")),
        ("white dress with rabbits", "rabbits", ("#ffffff", "#b1afad", "#e6a8ae", "#4a3d3a")),
    ],
)
def test_fading_colours_and_bands_of_several(text, motif, colors):
    found = asked(text)
    assert found is not None and (found.motif, found.colors) == (motif, colors)


@pytest.mark.parametrize(
    ("text", "colors"),
    [
        ("windowpane skirt", ("#efeadf", "#efeadf", "#3a4f70")),
        ("grey windowpane blazer", ("#808080", "#808080", "#d7d5ce")),
        ("beige windowpane check coat, blue", ("#d9c8a9", "#d9c8a9", "#365c96")),
        ("tattersall shirt, black on white", ("#ffffff", "#ffffff", "#000000")),
        ("Prince of Wales check trousers", ("#b3b1ab", "#74757a", "#4a6a8f")),
    ],
)
def test_some_checks_are_lines_or_greys(text, colors):
    found = asked(text)
    assert found is not None and (found.kind, found.colors) == ("plaid", colors)


@pytest.mark.parametrize(
    ("text", "kind", "first"),
    [
        ("a checked blazer", "plaid", "#777a82"),
        ("checked trousers", "plaid", "#777a82"),
        ("check flannel shirt", "checks", "#a3262c"),
        ("a checked dress", "checks", "#f4f1e8"),
    ],
)
def test_checks_without_a_colour_are_those_of_their_cloth(text, kind, first):
    found = heard_print(text, read_words(text))
    assert found is not None and (found.kind, found.colors[0]) == (kind, first)
