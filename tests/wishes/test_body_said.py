"""Girths, heights, weights, sizes and ages of wearers, in the words of several languages."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.wishes.wearers.wearer_words import hear_wearer

_INCH = 2.54


@pytest.mark.parametrize(
    ("text", "measures"),
    [
        (
            "Hose, ich bin 1,58 m gross, Brust 98, Taille 86, Hüfte 106",
            {"height": 158, "bust": 98, "waist": 86, "hips": 106},
        ),
        ("robe, poitrine 98, tour de taille 86, hanches 106", {"bust": 98, "waist": 86, "hips": 106}),
        ("camisa, pecho 128 cintura 124 y mido 1.70", {"bust": 128, "waist": 124, "height": 170}),
        ("bathrobe, belly 150cm, to the shins", {"waist": 150}),
        ("robe, I have 92-74-101", {"bust": 92, "waist": 74, "hips": 101}),
        ("dress, my measurements: 40, 34, 44", {"bust": 40 * _INCH, "waist": 34 * _INCH, "hips": 44 * _INCH}),
        ("B 98 W 80 H 104 kaftan", {"bust": 98, "waist": 80, "hips": 104}),
        (
            "dress, bust 52 inches, waist 46, hips 58",
            {"bust": 52 * _INCH, "waist": 46 * _INCH, "hips": 58 * _INCH},
        ),
        (
            "sundress, bust 31, waist 25, hips 34",
            {"bust": 31 * _INCH, "waist": 25 * _INCH, "hips": 34 * _INCH},
        ),
        ("38 chest waistcoat", {"bust": 38 * _INCH}),
        ("I'm six foot one, trousers", {"height": 185}),
        ("a dress for someone of five foot two", {"height": 157}),
        ("my son is six foot four, trousers", {"height": 193}),
        ("I'm 185 cm tall, trousers, inside leg 94 cm", {"height": 185, "inseam": 97.0}),
        ("I'm 185 cm tall, trousers, inside leg 80 cm", {"height": 185}),
        ("chinos 34x32 khaki", {"waist": 34 * _INCH, "inseam": 88.0}),
        ("camisa cuello 42", {"neck": 42}),
        ("shirt, collar 16.5", {"neck": 16.5 * _INCH}),
        ("a black dress, 36C", {"underbust": 36 * _INCH, "bust": 39 * _INCH}),
        ("blazer 42R", {"bust": 42 * _INCH, "height": 178}),
        ("je mesure 1m65, une jupe", {"height": 165}),
        ("soy bajita, falda", {"height": 157}),
        ("soy alta, 1,85, pantalón", {"height": 185}),
        ("mido 1 metro 55, vestido", {"height": 155}),
        ("maxi dress, I am tall, 190 cm", {"height": 190}),
        ("petite 150 cm dress", {"height": 150}),
        ("36-32 chinos", {"waist": 36 * _INCH, "inseam": 88.0}),
        ("42 long blazer", {"bust": 42 * _INCH, "height": 187}),
        ("ich bin sehr groß, Mantel", {"height": 186}),
    ],
)
def test_measures_of_a_body_are_read(text, measures):
    wearer = hear_wearer(text).wearer
    assert wearer is not None and wearer.measures == pytest.approx(measures)


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ("pijama para mi abuela, talla 52", "women EU 50"),
        ("robe taille 46", "women EU 44"),
        ("je fais du 44, une robe", "women EU 42"),
        ("taglia 48 gonna", "women EU 42"),
        ("Bluse Gr. 48, weiß", "women EU 48"),
        ("jumpsuit size 24", "women UK 24"),
        ("bridesmaid dress US 14W", "women US 14"),
        ("kurta 3XL", "women 3XL"),
        ("Herrenhemd XXL", "men XXL"),
        ("size 16/18 tunic", "women UK 18"),
        ("Kurzgröße 22, Jeans", "women EU 44"),
        ("plus size 3x kimono", "women 3XL"),
        ("for my son (11), football shorts", "children UK 11"),
        ("my grandson is 3, dungarees", "children EU 98"),
        ("2T dress", "children EU 98"),
        ("size 40 long blazer", "women EU 40"),
        ("t-shirt hombre talla XL", "men XL"),
        ("je suis ronde, une robe d'été", "women EU 50"),
        ("Kinderkleid Größe 128", "children EU 128"),
        ("blouse pour mon fils de 8 ans", "children UK 8"),
        ("T-shirt für meinen Sohn, 8 Jahre", "children UK 8"),
        ("vestido para mi hija de siete años", "children UK 7"),
        ("trousers grey boy 9 years slim", "children UK 9"),
        ("hoodie age 6-7", "children UK 7"),
        ("robe pour ma fille", "children EU 128"),
    ],
)
def test_sizes_and_ages_are_read(text, size):
    wearer = hear_wearer(text).wearer
    assert wearer is not None and wearer.size == size


@pytest.mark.parametrize(
    "text", ["Strampler fürs Baby, 3 Monate", "onesie 18 months", "Body Größe 62", "pyjama pour bébé"]
)
def test_babies_get_the_smallest_body_and_it_is_said(text):
    heard = hear_wearer(text)
    assert heard.wearer is not None and heard.wearer.size == "children EU 98"
    assert any("baby" in note for note in heard.notes)


def test_a_size_beyond_the_chart_is_the_nearest_and_it_is_said():
    heard = hear_wearer("tunic 7XL")
    assert heard.wearer is not None and heard.wearer.size == "women 4XL"
    assert any("7XL" in note for note in heard.notes)


def test_a_weight_beside_a_height_is_read():
    wearer = hear_wearer("Overall for mechanic, 188 cm 95 kg").wearer
    assert wearer is not None and (wearer.measures, wearer.weight) == ({"height": 188.0}, 95.0)


@pytest.mark.parametrize(
    "text",
    [
        "a wedding dress with a train 1.50 m long",
        "60 cm waist to hem skirt",
        "polo neck 12 cm high",
        "v neck 40 cm jumper",
        "kimono 1.60 m wide fabric",
        "a 21st birthday dress",
        "a jumper like the one I had 10 years ago",
        "50er Jahre Kleid",
        "robe années 60",
        "dress for my baby shower",
        "a baby tee",
        "tee for a 15 year old boy",
        "vestido para la boda de mi hija",
        "col rond, grosse maille",
        "a skirt 5 cm below the waist",
        "finished chest 104 cm",
        "saya, largo desde la cintura 60 cm",
        "tank dress, sizes S-XL",
        "jeans, sizes 28-36",
        "sleeves 1.50",
    ],
)
def test_what_is_of_the_garment_is_no_wearers(text):
    heard = hear_wearer(text)
    assert heard.wearer is None and heard.rest == text


def test_a_leg_beside_a_waist_stays_with_the_garment():
    assert hear_wearer("jeans W34 L32").rest == "jeans, inside leg 81 cm"


_NAMES = {
    "bust": ["bust", "chest", "Brust", "Oberweite", "poitrine", "tour de poitrine", "pecho", "busto"],
    "waist": ["waist", "belly", "Taille", "Bauch", "tour de taille", "cintura", "barriga"],
    "hips": ["hips", "hip", "Hüfte", "hanches", "tour de hanches", "cadera", "caderas"],
}


@settings(max_examples=60, deadline=None)
@given(
    st.lists(st.sampled_from(list(_NAMES)), min_size=1, max_size=3, unique=True),
    st.data(),
    st.sampled_from([" cm", "cm", ""]),
    st.sampled_from([" ", ": ", " = "]),
)
def test_every_name_with_a_number_is_a_girth_in_any_order(keys, data, unit, between):
    wanted = {key: float(data.draw(st.integers(75, 145))) for key in keys}
    said = ", ".join(f"{data.draw(st.sampled_from(_NAMES[k]))}{between}{wanted[k]:g}{unit}" for k in keys)
    wearer = hear_wearer(f"dress, {said}").wearer
    assert wearer is not None and wearer.measures == pytest.approx(wanted)


@settings(max_examples=40, deadline=None)
@given(st.integers(30, 56), st.integers(26, 52), st.integers(32, 58), st.integers(0, 2))
def test_one_measure_in_inches_puts_all_in_inches(bust, waist, hips, marked):
    values = {"bust": bust, "waist": waist, "hips": hips}
    parts = [
        f"{name} {value}{' inches' if k == marked else ''}" for k, (name, value) in enumerate(values.items())
    ]
    wearer = hear_wearer(f"dress, {', '.join(parts)}").wearer
    assert wearer is not None
    assert wearer.measures == pytest.approx({name: _INCH * value for name, value in values.items()})


@settings(max_examples=40, deadline=None)
@given(
    st.integers(140, 205),
    st.sampled_from(
        ["ich bin {m}", "je mesure {m}", "mido {p}", "I am {cm} cm", "{cm} cm groß", "height {cm}"]
    ),
)
def test_heights_are_read_as_they_are_written(tall, form):
    metres = f"{tall / 100:.2f}"
    said = form.format(m=metres.replace(".", ",") + " m", p=metres, cm=tall)
    wearer = hear_wearer(f"{said}, a coat").wearer
    assert wearer is not None and wearer.measures == {"height": float(tall)}


def test_a_dress_before_a_size_is_what_is_made():
    assert hear_wearer("red dress size 12").rest == "red dress"
    assert hear_wearer("my dress size is 12, a coat").rest == "a coat"


def test_a_size_that_nobody_has_is_no_childs():
    heard = hear_wearer("size 99 dress")
    assert heard.rest == "dress" and any("no body of size 99" in note for note in heard.notes)
    child = hear_wearer("size 98 dress").wearer
    assert child is not None and child.size == "children EU 98"
