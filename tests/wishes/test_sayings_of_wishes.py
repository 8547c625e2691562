"""Sayings in descriptions, and the garments that they describe."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.descriptions.hearing import hear_description
from swifttailor.wishes.descriptions.sayings_of_wishes import plainly_wished, without_asides
from swifttailor.wishes.reader import WishReader


@pytest.fixture(scope="module")
def reader() -> WishReader:
    return WishReader.load()


@pytest.mark.parametrize(
    ("text", "sure"),
    [
        (
            "mini dress, one sleeve puffed, the other shoulder completely bare",
            {"shoulders=bare left", "sleeves=right only", "sleeve_shape=puffed"},
        ),
        ("mermaid gown, tight to the knees and then it goes out", {"skirt_hem=floor", "skirt=fitted base"}),
        ("skirt, fitted down to the knee, then kicks out", {"skirt=fitted base"}),
        ("a long gown fitted to the knee, then it flares out", {"skirt=fitted base"}),
        ("shorts that end just over the knee", {"leg_hem=knee"}),
        ("a slim skirt", {"skirt=straight"}),
        ("a loose basketball short that comes to my knees", {"kind=shorts", "leg_hem=knee"}),
        ("a column dress with a slit up to the knee", {"kind=dress", "slit=left"}),
        ("the physio suggested a wraparound, to mid calf", {"kind=skirt", "skirt_hem=midi"}),
        ("a skirt that twirls when I dance", {"kind=skirt", "skirt=circle"}),
        ("like a prom dress but shorter", {"kind=dress", "skirt_hem=knee"}),
        ("a dress that covers my arms and knees", {"skirt_hem=below the knee", "sleeves=three-quarter"}),
        ("a jacket with neck who stand up", {"kind=top", "collar=stand"}),
        ("short fitted jacket with nipped waist", {"kind=top", "fit=close", "top_hem=high hip"}),
        ("Winterjacke, kurz, mit Stehkragen", {"kind=top", "top_hem=hip", "collar=stand"}),
        ("a top for jeans, long sleeves", {"kind=top", "sleeves=long"}),
        ("we have a barn dance and I own nothing with a full skirt", {"kind=dress", "skirt=flared"}),
        ("something warm for under my coat", {"kind=top", "sleeves=long"}),
        ("something to wear with a skirt", {"kind=top"}),
        ("a gown with sleeves like angel wings", {"sleeve_shape=bell"}),
        ("tank top with wide straps and deep armholes", {"armholes=deep", "straps=wide"}),
        ("a dress, sleeves yes, collar no", {"kind=dress", "collar=none"}),
        ("a pullover without the arms for under my suit", {"kind=top", "sleeves=none"}),
        ("short dress, right shoulder covered left one bare", {"shoulders=bare left"}),
        ("I have a girl to dress and no budget, so it's a long gathered skirt", {"kind=skirt"}),
        ("top with sleeves like a bell", {"sleeve_shape=bell"}),
        ("trousers that stop between the knee and the ankle", {"leg_hem=calf"}),
        ("a blouse, sleeves between the elbow and the wrist", {"sleeves=three-quarter"}),
        ("dress with sleeves down to the knuckles", {"sleeves=extra-long"}),
        (
            "a column in satin, cut high in front and daringly low behind",
            {"kind=dress", "skirt=straight", "neck_depth=high", "back_depth=low"},
        ),
        ("Dress. One slit, right side only, 10 inches up from the hem.", {"slit=right", "slit_cm=25.4"}),
        ("a skirt with triangles let in", {"skirt=godets"}),
        ("a pant, very large down, tight up", {"legs=flared", "hips=close"}),
        ("shorts, but something that from a distance might be a skirt", {"kind=shorts", "legs=wide"}),
        ("dress with sleeves that are tight at the shoulder and wide at the wrist", {"sleeve_shape=bell"}),
        ("trousers, narrow at the thigh and wide at the bottom", {"legs=flared"}),
        ("trousers that are loose around the hips but narrow at the ankle", {"legs=tapered", "hips=loose"}),
        ("a top that is wider at the hem than at the chest", {"bodice=flared"}),
        ("a tunic that widens towards the hem", {"bodice=flared"}),
        ("a shirt, getting wider towards the bottom", {"bodice=flared"}),
        ("a dress that flares out from the waist", {"skirt=flared"}),
        ("a blouse with sleeves widening towards the wrist", {"sleeve_shape=bell"}),
        ("a blouse with sleeves that taper to the wrist", {"sleeve_shape=tapered"}),
        ("jeans, slim to the knee and flared below it", {"legs=flared"}),
        (
            "a dress so tight to the knee she can hardly walk and then exploding into a great flare",
            {"skirt=fitted base"},
        ),
        ("a skirt, flared from the knee", {"skirt=fitted base"}),
        (
            "trousers, narrow at the bottom so nothing catches, roomy at the thigh",
            {"legs=tapered", "hips=loose"},
        ),
        ("trousers that are narrow at the ankle", {"legs=tapered"}),
        ("a dress, the skirt goes out", {"skirt=flared"}),
        ("a skirt that must reach the ankle when I sit", {"skirt_hem=floor"}),
        ("bodice to the waist, square neck", {"kind=top", "fit=close", "bodice=darted"}),
        ("a top, neck 10 deep", {"neck_depth_cm=10.0"}),
        ("v neck 15 cm deep, sleeveless top", {"neck_depth_cm=15.0", "neckline=v"}),
        ("a circle skirt with a 4 cm waistband, 74 cm in all", {"waistband_cm=4.0", "skirt_length_cm=74.0"}),
        ("a blouse, sleeves gathered to an 8 cm cuff", {"sleeve_shape=balloon", "cuff_cm=8.0"}),
        ("top with sleeves with flounced cuffs", {"cuffs=flounce"}),
        ("tunic with slits on the side", {"slit=left", "slit=right"}),
        ("tunic with slits up to the waist", {"slit=left", "slit=right", "slit_size=high"}),
        ("top with long but not wide sleeves", {"sleeves=long"}),
        ("a dress without a waist seam", {"bodice=undarted"}),
        ("long black dress, no waist shaping", {"bodice=undarted"}),
        ("dress with shot sleeves", {"sleeves=short"}),
        ("dress, one long sleeve, other shoulder bare", {"shoulders=bare left", "right_sleeve=long"}),
        ("witch dress with enormous sleeves", {"sleeve_shape=bell"}),
        ("long cardigan, three quarter sleeves", {"sleeves=three-quarter"}),
        ("wedding dress, sweetheart neck, lace sleeves", {"sleeves=long"}),
        ("eine Hose, ab dem Knie ausgestellt", {"legs=flared"}),
        ("pantalon évasé à partir du genou", {"legs=flared"}),
        ("pantalón acampanado desde la rodilla", {"legs=flared"}),
        ("a skirt cut from half a circle", {"skirt=half circle"}),
        ("a quarter circle skirt", {"skirt=a-line"}),
        ("a quarter circle dress", {"skirt=a-line"}),
        ("Viertelkreisrock", {"skirt=a-line"}),
        ("a three-quarter circle skirt", {"skirt=three-quarter circle"}),
        ("a frilly skirt with 4 layers", {"tiers=4.0"}),
        ("top, the right sleeve missing", {"sleeves=left only"}),
        ("leggings, nothing below the knee", {"leg_hem=knee"}),
        ("a dress, long on one side, short on the other", {"hem_shape=lower left"}),
        ("a dress with one long and one short sleeve", {"sleeves=unequal"}),
        ("a dress with a V at the front and at the back", {"neckline=v", "back_neckline=v"}),
        ("I don't want any sleeves, any collar or any slit. A dress", {"sleeves=none", "slit=none"}),
        ("blk dress, shrt slvs, v nk", {"neckline=v"}),
        ("ein Kleid mit halblangen Ärmeln", {"sleeves=elbow"}),
        ("a skrit, strait, to the nee", {"kind=skirt", "skirt=straight", "skirt_hem=knee"}),
        ("a dress, dark but not sad, and with long sleeves", {"sleeves=long"}),
        ("a top with one long sleeve", {"kind=top", "sleeves=right only", "right_sleeve=long"}),
        ("something to sleep in", {"kind=dress"}),
        ("something light to wear over my bikini", {"kind=dress"}),
        ("something to wear with my jeans", {"kind=top"}),
        ("something nice over leggings", {"kind=tunic"}),
        ("trousers to go with a dress shirt", {"kind=trousers"}),
        ("leggings that don't reach the ankle", {"kind=trousers", "leg_hem=calf"}),
        ("trousers that get narrower and narrower", {"legs=tapered"}),
        ("a skirt to dance salsa in", {"kind=skirt", "skirt=flared"}),
        ("a jacket, but it mustn't have a hood", {"kind=top"}),
        ("a pant, very large down", {"kind=trousers"}),
        ("a pant, very large down, tight up", {"kind=trousers", "legs=flared"}),
        ("a cool dress with sleeves to cover my arms a little", {"kind=dress", "sleeves=elbow"}),
        ("pantalon large taille haute", {"kind=trousers", "legs=wide", "rise=high"}),
        ("Trompetenrock", {"kind=skirt", "skirt=fitted base"}),
    ],
)
def test_a_saying_describes_what_it_means(reader, text, sure):
    heard = hear_description(text, reader)
    found = {
        f"{w.change.claim.name}={w.change.claim.value}" for w in heard.sure if isinstance(w.change, Gain)
    }
    assert sure <= found


@pytest.mark.parametrize(("text", "kind", "unknown"), [("Fledermauskleid", "dress", "Fledermaus")])
def test_a_german_compound_of_an_unknown_word_is_still_a_garment(reader, text, kind, unknown):
    heard = hear_description(text, reader)
    assert heard.kind == kind and heard.unread == (unknown,)


def test_what_no_word_of_a_short_text_is_about_is_no_more_than_likely(reader):
    sure = {w.change for w in hear_description("princess seam dress", reader).sure}
    assert Gain(Claim("sleeve_shape", "puffed")) not in sure and Gain(Claim("kind", "dress")) in sure


def test_one_slit_refuses_others(reader):
    never = hear_description("a dress with one slit, right side only", reader).never
    assert Claim("slit", "left") in never and Claim("slit", "right") not in never
    assert Claim("slit", "left") not in hear_description("a dress with slits", reader).never
    beside_a_side = hear_description("a column gown, slit to mid-thigh on the right", reader).never
    assert Claim("slit", "left") in beside_a_side and Claim("slit", "right") not in beside_a_side


def test_a_skirt_with_godets_that_swings_is_not_flared_from_the_waist(reader):
    heard = hear_description("a skirt with lots of godets that swings", reader)
    assert Gain(Claim("skirt", "flared")) not in [w.change for w in heard.sure]


def test_a_french_neckline_that_is_not_to_be_deep(reader):
    never = hear_description("un haut, encolure en V, mais pas trop profonde", reader).never
    assert Claim("neck_depth", "plunging") in never


@given(st.text(max_size=80))
def test_any_text_can_be_put_plainly(text):
    assert isinstance(plainly_wished(text), str)


@pytest.mark.parametrize("text", ["a red dress to the knee", "trousers with a high waist", "one sleeve"])
def test_what_is_plain_stays_as_it_is(text):
    assert plainly_wished(text) == text


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("mini skirt, but not too short", "mini skirt"),
        ("top with sleeves past elbow", "top with three quarter sleeves"),
        ("a jumper with one sleeve left off on purpose", "a jumper right sleeve only"),
        ("sweater with extra long arms", "sweater with extra long sleeves"),
        ("gown, neckline down to THERE", "gown, plunging v neckline"),
        ("oversized band t i can sleep in", "oversized longline t-shirt"),
        ("a jacket which falls down in the front like water", "a waterfall jacket"),
        ("a tunic parti-coloured red and gold", "a tunic red, with a red left half and a gold right half"),
    ],
)
def test_what_people_say_of_lengths_and_sleeves_is_put_plainly(text, plain):
    assert plainly_wished(without_asides(text)) == plain


@pytest.mark.parametrize("text", ["2 m of linen", "polo-neck, 300 pcs", "jeans with a rope round the middle"])
def test_amounts_of_cloth_and_pieces_are_no_measures(text):
    assert not re.search(r"\d|rope", plainly_wished(without_asides(text)))


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("shirt with the neck of Chinese", "shirt with the mandarin collar"),
        ("a dress with sleeves of butterfly", "a dress with butterfly sleeves"),
        ("a top with collar of polo", "a top with polo collar"),
        ("a shirt, collar of the polo shirt", "a shirt, collar of the polo shirt"),
        ("pullover with neck who falls down", "pullover with cowl collar"),
        ("trousers with rubber in waist", "trousers with elastic waist"),
        ("joggers with elastic at the ankles", "joggers with elastic cuffs"),
        ("nightgown, frill at the neck and wrists", "nightgown, frill at the neck and frilled cuffs"),
        ("a skirt with ruffles along the hem", "a skirt with frill hem"),
    ],
)
def test_details_that_are_told_by_their_place_or_word_by_word_are_put_plainly(text, plain):
    assert plainly_wished(text) == plain


@pytest.mark.parametrize(
    ("text", "never"),
    [
        ("leggings that don't reach the ankle", "leg_hem=ankle"),
        ("trousers that end above the ankle", "leg_hem=ankle"),
        ("A trouser whose legs become more and more narrow", "legs=wide"),
        ("ground crew trousers", "neckline=crew"),
    ],
)
def test_a_network_adds_nothing_that_words_speak_against(reader, text, never):
    heard = hear_description(text, reader)
    told = [*heard.sure, *heard.likely]
    assert never not in {f"{w.change.claim.name}={w.change.claim.value}" for w in told}


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("a jacket, collar yes, hood no.", "a jacket, with collar, no hood."),
        ("black joggers in grey short leg", "black joggers in grey, petite"),
        ("legs so wide they look like a skirt", "palazzo trousers"),
        ("slouchy off one shoulder sweater dress", "slouchy wide neckline sweater dress"),
        ("an evening dress, off one shoulder", "an evening dress, off one shoulder"),
        ("collar that rises behind the head", "high standing collar"),
        ("that dress i saw on tiktok", "that dress "),
        ("a dress in a small green and white check", "a dress in a green and white small check"),
        ("an apron for the girls in the shop", "an apron in the shop"),
        ("a dress for the girls, they are 8 years old", "a dress for the girls, they are 8 years old"),
        ("we run a small tearoom", "tearoom"),
        ("a smock, sleeves a bit short of the wrist", "a smock, sleeves 53 cm"),
        ("trousers that zip off at the knee", "trousers zip-off legs"),
        ("a tunic, deep ribbed polo neck", "a tunic, roll neck"),
        ("a mandarin collar shirt, band 3 cm", "a mandarin collar shirt, collar 3 cm"),
        ("goes straight to school", "goes to school"),
        ("the play is set in a mill", "the play in a mill"),
        ("trousers, wide legs from the hip, cuffed", "trousers, wide legs from the hip, turn ups"),
        ("polo, 180 gsm, slim", "polo,, slim"),
        ("a knit in 12 colours, slim", "a knit , colourways, slim"),
        ("a knit, offered in oat and rust; please show it in rust", "a knit,, in rust, colourways"),
        ("a knit, available in navy, black and cream", "a knit,, in navy, colourways"),
        ("a red dress, black at the neck", "a red dress, with a black neckline"),
        ("a blouse with tiny flowers", "a blouse with small flowers"),
        ("she rides a lot and needs breeches", "she rides a lot and needs riding breeches"),
        ("shooting breeches", "shooting breeches"),
        ("a jacket with cover of head", "a jacket with hood"),
        ("shirt no arm for the gym", "tank top for the gym"),
        ("a vest, very big hole for arm", "a vest, deep armholes"),
        ("a long-ish skirt to mid calf", "a skirt to mid calf"),
        ("a factory in 1943", "a factory in the 1940s"),
        ("a tight bodice open at the breast", "a tight bodice plunging neckline"),
        ("a clergy shirt, black, tab collar", "a clergy shirt, black"),
        ("a slip dress with a white t-shirt under it", "a slip dress over a white t-shirt"),
        ("trousers tapering to an 18 cm opening", "trousers tapered legs, leg opening 18 cm"),
        ("a long-ish skirt", "a midi skirt"),
        ("dress, loose, long-ish", "dress, loose, midi"),
        ("jumper, long-ish sleeves", "jumper, long sleeves"),
        ("shortish dress", "above the knee dress"),
        ("skirt who turns when I dance", "full circle skirt"),
        ("linen skirt, midi, that moves when I walk", "linen skirt, midi, full circle"),
        ("v neck but not a BIG v", "v neck, not low"),
        ("a cardigan, it is now mostly holes", "a cardigan, "),
        ("my jumper has had it, same again", "my jumper , same again"),
        ("cardigan with holes for my thumbs", "cardigan with holes for my thumbs"),
        ("sleeves wide enough for a jacket underneath", "sleeves"),
        ("blouse, long loose sleeves", "blouse, long loose sleeves"),
        ("trousers for a long flight", "trousers for a flight"),
        ("shirt for my boyfriend", "shirt for my husband"),
        ("boyfriend jeans for my boyfriend", "boyfriend jeans for my husband"),
        ("tight under the bust and then just hangs loose", "empire line, loose skirt"),
        ("a top that shows off my shoulders", "a top off the shoulder"),
        ("a summer wedding", "wedding guest"),
        ("my wedding in May", "my wedding in May"),
        ("a bathing suit for men", "a swim shorts for men"),
        ("a skirt, waistband 3.5, side zip", "a skirt, 3.5 cm waistband, side zip"),
        ("un décolleté en V devant et derrière", "un décolleté en V, dos en V"),
        ("Kleid, V-Ausschnitt vorne und hinten", "Kleid, V-Ausschnitt, V-Rücken"),
    ],
)
def test_what_is_answered_or_likened_is_put_plainly(text, plain):
    assert without_asides(text) == plain


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("a top, 100% cotton", "a top, cotton"),
        ("a skirt 10% longer", "a skirt 10% longer"),
        ("she doesnt like her arms showing", "with three quarter sleeves"),
        ("a dress, I hate my upper arms", "a dress, with three quarter sleeves"),
        ("something to hide my knees", "hem below the knee"),
        ("for my cousins summer wedding", "for wedding guest"),
        ("batwing jumper off one shoulder", "batwing jumper with a slouchy wide neckline"),
        ("bodysuit with orange panels", "bodysuit with orange side panels"),
        ("joggers with three white stripes", "joggers with three white stripes down the sides"),
        ("navy trousers with a red stripe", "navy trousers with a red stripe down the sides"),
        ("tracksuit bottoms with red stripes", "tracksuit bottoms with red stripes down the sides"),
        ("tracksuit jacket with red stripes", "tracksuit jacket with red stripes down the sleeves"),
        ("trousers with red stripes", "trousers with red stripes"),
        ("shorts with a white stripe on the hem", "shorts with a white stripe on the hem"),
        ("black dungarees with short legs", "black short dungarees"),
    ],
)
def test_what_would_be_read_as_something_else_is_put_plainly(text, plain):
    assert without_asides(text) == plain


@pytest.mark.parametrize(
    ("text", "never"),
    [
        ("a column dress with a slit up to the knee", "skirt_hem=knee"),
        ("I want a jacket for the train journey", "skirt_hem=floor"),
        ("short fitted jacket with nipped waist", "waist_seam=natural"),
        ("a skirt, I go straight to the office", "skirt=straight"),
    ],
)
def test_what_a_saying_does_not_mean_is_not_heard(reader, text, never):
    sure = hear_description(text, reader).sure
    assert never not in {
        f"{w.change.claim.name}={w.change.claim.value}" for w in sure if isinstance(w.change, Gain)
    }


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("pregnant, need a work dress", ", need a work maternity dress"),
        ("I'm pregnant with twins. Uniform trousers?", ". maternity Uniform trousers?"),
        ("ich bin schwanger und brauche ein Kleid", " und brauche ein UmstandsKleid"),
        ('we say "sarafan"', "called sarafan"),
        ("thin straps that cross over at the back", "thin cross back straps"),
        (
            "a blouse that opens all the way down the front",
            "a blouse that buttons all the way down the front",
        ),
        ("no zips no laces", "no zips no drawstring"),
        ("too hot for jeans. a skirt", "no jeans. a skirt"),
        ("trousers falling straight from there", "trousers falling straight from there"),
        ("my sister's wedding, something green", "wedding guest, something green"),
        ("my team plays darts, shirts", "my team plays games, shirts"),
        ("a floral dress on a dark background", "a floral dress on black"),
        ("slit 30 cm long, skirt", "30 cm slit, skirt"),
        ("knee length minus 5 cm", "5 cm above the knee"),
        ("trousers for my dad, he's in a wheelchair", "trousers for my dad with an elastic waist"),
        ("a dress that grows with my bump", "a maternity dress"),
        ("a top the colour of the sky", "a top sky blue"),
        ("tie dye in blues", "tie dye in blue"),
        ("a gown with a train", "a gown with a train"),
        ("a skirt straight to the knee", "a skirt straight to the knee"),
    ],
)
def test_asides_of_stories_are_put_plainly(text, plain):
    assert without_asides(text) == plain


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("a swimsuit with a bit of a skirt", "a skirted swimsuit"),
        ("golf skirt with built-in shorts", "golf skort"),
        ("skirt with shorts", "skirt with shorts"),
        ("racerback top with a wide band underneath", "racerback top with an underband"),
        ("nap pants, no strings", "nap pants, no drawstring"),
        ("I'm six months pregnant, black work trousers", "I'm six months pregnant, black maternity trousers"),
        ("capris with a little notch at the side of the hem", "capris with small side slits"),
    ],
)
def test_what_goes_over_and_under_legs_is_put_plainly(text, plain):
    assert plainly_wished(text) == plain


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("boxy blouse that goes over the head", "boxy blouse with a keyhole neck, no collar, no buttons"),
        ("pull-on blouse, blue", "blouse with a keyhole neck, no collar, no buttons, blue"),
        (
            "blouse without buttons, elbow sleeves",
            "blouse with a keyhole neck, no collar, no buttons, elbow sleeves",
        ),
        ("blouse with no zip and no buttons", "blouse with a keyhole neck, no collar, no buttons"),
        ("cream blouse, over the head", "cream blouse with a keyhole neck, no collar, no buttons"),
        (
            "blouse with no buttons, just slip it over my head",
            "blouse with a keyhole neck, no collar, no buttons",
        ),
        ("blouse without buttons, frilled collar", "blouse without buttons, frilled collar"),
        ("v neck blouse without buttons", "v neck blouse without buttons"),
        ("blouse without buttons at the back", "blouse without buttons at the back"),
        ("blouse, neckline 9 cm deep", "blouse, neckline 9 cm deep, no collar"),
        ("shirt collar blouse, neckline 9 cm deep", "shirt collar blouse, neckline 9 cm deep"),
        ("blouse, 3/4 sleeves gathered onto a 3 cm band", "blouse, 3/4 sleeves gathered into 3 cm cuffs"),
        ("blouse, sleeve 42 cm ending in a 3 cm band", "blouse, sleeve 42 cm with 3 cm cuffs"),
        ("top with sleeves, 3 cm hem band", "top with sleeves, 3 cm hem band"),
        ("oversized jumper, sleeves too long", "oversized jumper with sleeves past the hands"),
        ("jumper, sleeves too long for my arms", "jumper, sleeves too long for my arms"),
        ("tee with batwing sleeves", "batwing tee"),
        ("dolman sleeves T-shirt", "batwing tee"),
        ("batwing sleeved tee dress", "batwing sleeved tee dress"),
    ],
)
def test_how_tops_are_put_on_and_end_is_put_plainly(text, plain):
    assert plainly_wished(text) == plain
