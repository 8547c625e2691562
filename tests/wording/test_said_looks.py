"""Which colours and sheer cloths a text says of parts, and which of the whole garment."""

from __future__ import annotations

import pytest

from swifttailor.wording.lexicon import read_words
from swifttailor.wording.lexicon.said_looks import said_looks

TABLE = """
a navy dress with a white collar and cuffs | navy | collar white, cuffs white
black dress with red sleeves | black | sleeves red
baseball tee with navy sleeves | | sleeves navy
flight suit off-white with orange shoulders | off-white | shoulders orange
white collar and cuffs | | collar white, cuffs white
red cuffs and a red collar | | cuffs red, collar red
sleeves in black | | sleeves black
white t-shirt with sleeves in black | white | sleeves black
a midi dress with puff sleeves in navy | navy |
navy dress with a white collar and long sleeves | navy | collar white
white blouse with black collar, cuffs and waistband | white | collar black, cuffs black, waistband black
a red collar and sleeves in white | | collar red, sleeves white
make the collar and the cuffs white | | collar white, cuffs white
make the collar white | | collar white
white shirt, the collar is navy | white | collar navy
t-shirt: body white, sleeves navy | | bodice white, sleeves navy
dress with a black top and a white skirt | | bodice black, skirt white
black long sleeve dress | black |
lace sleeve dress | | sleeves lace
pink dress with dark green sleeves | pink | sleeves dark green
black jumpsuit wide legs no sleeves | black |
champagne satin cowl neck maxi slip dress | champagne |
emerald boat neck midi slip dress | emerald |
navy skirt knee length | navy |
a vest, the red puffy one | red |
sleeves in lace, the rest of the dress in satin, ivory | ivory | sleeves lace
coveralls short sleeve orange, leg ends with cuffs | orange |
jumper navy crew neck | navy |
Men T-shirt round neck short sleeve cotton, black | black |
sports bra racerback purple | purple |
apron dress black cross back | black |
maxi dress green puff sleeves | green |
dress white collar | | collar white
track pants with a white stripe down the side | | side_stripes white
just the trousers, white suit like in the film | white |
black and white dress | black white |
red and white striped t-shirt with navy sleeves | red white | sleeves navy
black dress with white polka dots and a white collar | black white | collar white
burgundy dress with an ivory Peter Pan collar | burgundy | collar ivory
navy coat with brass buttons and a black belt | navy | buttons brass, belt black
red coat with gold buttons | red | buttons gold
dress with white piping | | edging white
tracksuit top, white stripes down the sleeves | | side_stripes white
black trousers with red stripes down the legs | black | side_stripes red
dress with black boots | | - black
oversized mesh t-shirt | | all mesh
sheer black dress | black | all sheer
wedding dress with sheer lace sleeves | | sleeves sheer, sleeves lace
chiffon maxi dress with a sheer skirt | | all chiffon, skirt sheer
dress with a tulle skirt | | skirt tulle
organza sleeves on a satin dress | | sleeves organza
make the sleeves sheer | | sleeves sheer
white dress with a back of lace | white | back lace
a contrast waistband | | waistband contrast
jumper with leather sleeves | | sleeves other
vestido de novia con manga larga de encaje y espalda abierta | | sleeves lace
robe blanche avec manches longues en dentelle | blanche | sleeves lace
robe rouge à manches longues | rouge |
vestido de encaje con manga corta | | all lace
polo top, white with green sleeve bands | white | cuffs green
robe noire à col blanc | noire | collar blanc
vestido rojo con mangas negras | rojo | sleeves negras
felpa grigia oversize col cappuccio | grigia |
schwarzes Kleid mit weißem Kragen | schwarzes | collar weißem
Kleid mit Ärmeln aus Spitze | | sleeves lace
beige linnen broek met wijde pijpen | beige |
navy trousers with red braces | navy | bodice red
white shirt with red braces | white | - red
"""
ROWS = [tuple(cell.strip() for cell in row.split("|")) for row in TABLE.strip().splitlines()]


@pytest.mark.parametrize(("text", "colors", "looks"), ROWS, ids=[row[0] for row in ROWS])
def test_looks_are_of_what_they_are_said_of(text, colors, looks):
    words = read_words(text)
    assert " ".join(color.words for color in words.colors) == colors
    told = [(look.part or "-", look.color.words if look.color else look.cloth) for look in words.looks]
    said = [tuple(look.split(" ", 1)) for look in looks.split(", ") if look]
    assert told == said or [pair for pair in told if pair[1] != "contrast"] == said
    assert not words.unknown


def test_words_of_parts_are_no_cloth_of_the_garment():
    assert read_words("black wool dress with leather sleeves").cloths == ("wool",)
    assert read_words("a linen dress with chiffon sleeves").cloths == ("linen",)
    assert read_words("chiffon dress").cloths == ("chiffon",)


def test_what_is_denied_or_worn_by_others_has_no_look():
    assert not read_words("a dress without a white collar").looks
    assert not read_words("a coat over my dress with red sleeves").colors
    (look,) = read_words("the sleeves must not be sheer").looks
    assert (look.part, look.cloth) == ("sleeves", "opaque")


def test_names_of_garments_tell_of_looks_that_nobody_says():
    (look,) = read_words("varsity jacket").looks
    assert (look.part, look.cloth, look.said) == ("sleeves", "contrast", False)
    (look,) = read_words("tulle skirt").looks
    assert (look.part, look.cloth, look.said) == ("all", "tulle", True)


def test_an_apron_over_another_garment_has_its_own_colour():
    text = "a blue dirndl with a white apron"
    reading = read_words(text)
    (apron,) = [look for look in said_looks(text, reading.marks, reading.language) if look.part == "apron"]
    assert apron.color is not None and apron.color.words == "white"
