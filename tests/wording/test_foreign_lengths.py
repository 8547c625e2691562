"""German, French and Spanish words for how long skirts, tops, legs and sleeves are."""

from __future__ import annotations

import pytest

from swifttailor.wording.lexicon import read_words

SAID = {
    "de": {
        "skirt_hem=mini": "Minikleid | ein kurzes Kleid | Kleid, oberschenkellang | Rock bis zur Mitte des Oberschenkels"
        " | Rock bis Mitte Oberschenkel | ein ziemlich kurzer Rock",
        "skirt_hem=above the knee": "Kleid kurz über dem Knie | Rock, der über dem Knie endet | Kleid knapp über dem Knie"
        " | ein Rock oberhalb vom Knie | das Kleid soll kurz überm Knie enden"
        " | Rock eine Handbreit über dem Knie | kniefreies Kleid",
        "skirt_hem=knee": "knielanges Kleid | Kleid in Knielänge | ein Rock bis zum Knie | Rock bis zu den Knien"
        " | Kleid bis ans Knie | Kleid, das bis zu den Knien geht | Rock auf Kniehöhe"
        " | Kleid knie lang | Rock bis Knie | knieumspielendes Kleid | Kleid, Saum am Knie",
        "skirt_hem=below the knee": "Rock knapp unter dem Knie | Kleid bis unters Knie | Rock unterhalb vom Knie"
        " | Kleid bis kurz unter das Knie | kniebedeckendes Kleid | kniebedeckender Rock | ein Kleid, das die Knie bedeckt"
        " | Rock über die Knie",
        "skirt_hem=midi": "wadenlanges Kleid | ein Rock bis zur Wade | Kleid bis zu den Waden | Midikleid | Midirock"
        " | Rock in Midilänge | Kleid bis Mitte Wade | mittellanges Kleid | Kleid bis zur Wadenmitte | halblanger Rock"
        " | Rock in Wadenlänge | Kleid bis über die Wade",
        "skirt_hem=maxi": "Maxikleid | ein langes Kleid | Kleid in Maxilänge | ein langer Rock",
        "skirt_hem=ankle": "knöchellanges Kleid | Rock bis zum Knöchel | Kleid bis zu den Knöcheln | Rock in Knöchellänge"
        " | Kleid bis auf die Knöchel | Rock bis Knöchel",
        "skirt_hem=floor": "bodenlanges Kleid | Rock bis zum Boden | Kleid bis auf den Boden | Kleid in Bodenlänge"
        " | ein Rock bis zu den Füßen | fußlanges Kleid | Kleid, das den Boden berührt | Rock bis Boden",
        "top_hem=cropped": "bauchfreies Oberteil | Oberteil, bauchfrei | Shirt oberhalb des Bauchnabels",
        "top_hem=waist": "Bluse bis zur Taille | taillenlanges Oberteil | Bluse in Taillenlänge",
        "top_hem=hip": "hüftlange Bluse | Pullover bis zur Hüfte | Bluse bis zu den Hüften | Oberteil in Hüftlänge"
        " | Bluse auf Hüfthöhe",
        "top_hem=long": "Bluse über den Po | Pullover bis über den Po | Oberteil, das den Po bedeckt"
        " | pobedeckendes Oberteil | eine lange Bluse | Bluse bis über den Hintern",
        "leg_hem=knee": "knielange Hose | Hose bis zum Knie | Jumpsuit mit knielangen Beinen",
        "leg_hem=calf": "wadenlange Hose | Hose bis zur Wade | Hose in Wadenlänge | 3/4-lange Hose",
        "leg_hem=ankle": "knöchellange Hose | Hose bis zum Knöchel | Hose in Knöchellänge",
        "leg_hem=full": "lange Hose | bodenlange Hose | Hose mit langen Beinen | Hose bis zum Boden",
        "sleeves=none": "ärmelloses Kleid | Kleid ohne Ärmel | Bluse, keine Ärmel",
        "sleeves=short": "kurzärmliges Kleid | kurzärmelige Bluse | Kleid mit kurzen Ärmeln | Bluse mit kurzem Arm"
        " | Kleid, Kurzarm | Kurzarmbluse | Kurzarmkleid | Bluse mit Kurzarm | Kleid mit kurzem Ärmel | Ärmel kurz, Kleid",
        "sleeves=elbow": "Kleid mit halblangen Ärmeln | Bluse mit Ärmeln bis zum Ellbogen | ellbogenlange Ärmel, Kleid"
        " | Kleid mit halbem Arm | Halbarmbluse | Bluse mit Ärmeln bis zu den Ellbogen | Ärmel in Ellbogenlänge, Bluse",
        "sleeves=three-quarter": "Kleid mit 3/4-Ärmeln | Bluse mit dreiviertellangen Ärmeln | Kleid mit Dreiviertelarm"
        " | Bluse mit Dreiviertel-Ärmeln | Kleid mit 3/4 langen Ärmeln | Bluse mit 3/4-Arm | Ärmel bis unter den Ellbogen, Bluse"
        " | 7/8-Ärmel, Bluse",
        "sleeves=long": "langärmliges Kleid | langärmelige Bluse | Kleid mit langen Ärmeln | Bluse mit langem Arm"
        " | Langarmbluse | Langarmkleid | Bluse, Langarm | Kleid mit langem Ärmel | Bluse mit Ärmeln bis zum Handgelenk",
        "sleeves=extra-long": "Pullover mit überlangen Ärmeln | Pulli mit Ärmeln über die Hände | Pulli mit extralangen Ärmeln",
    },
    "fr": {
        "skirt_hem=mini": "une robe courte | jupe courte | robe mi-cuisse | jupe à mi-cuisse"
        " | robe jusqu'à mi-cuisse | jupe à mi-cuisses | minijupe",
        "skirt_hem=above the knee": "robe au-dessus du genou | jupe juste au-dessus du genou"
        " | une robe qui s'arrête au-dessus des genoux | jupe au dessus du genou | robe dessus du genou",
        "skirt_hem=knee": "robe au genou | jupe aux genoux | robe longueur genou | robe jusqu'au genou"
        " | jupe qui arrive au genou | une jupe jusqu'aux genoux | robe à hauteur du genou | jupe à hauteur de genou"
        " | robe arrivant aux genoux | robe à longueur de genou | jupe au niveau du genou",
        "skirt_hem=below the knee": "jupe sous le genou | robe en dessous du genou | jupe au-dessous des genoux"
        " | robe sous les genoux | une jupe qui couvre les genoux | robe juste sous le genou | robe qui cache les genoux",
        "skirt_hem=midi": "jupe mi-longue | robe mi-mollet | jupe à mi-mollet | robe aux mollets"
        " | robe mi-longue | jupe au mollet | robe jusqu'aux mollets | jupe longueur midi | jupe longueur mollet"
        " | robe jusqu'à mi-mollet",
        "skirt_hem=maxi": "robe longue | jupe longue | jupe maxi longue",
        "skirt_hem=ankle": "robe à la cheville | jupe aux chevilles | robe longueur cheville | jupe jusqu'aux chevilles"
        " | robe jusqu'à la cheville | une jupe qui tombe aux chevilles | robe à hauteur des chevilles",
        "skirt_hem=floor": "robe jusqu'au sol | jupe au ras du sol | robe longueur sol | robe qui touche le sol"
        " | robe jusqu'aux pieds | jupe jusqu'à terre | robe à ras le sol | robe traînant au sol",
        "top_hem=cropped": "haut court, nombril à l'air | top raccourci | haut au-dessus du nombril",
        "top_hem=waist": "chemisier à la taille | haut jusqu'à la taille | blouse longueur taille",
        "top_hem=hip": "blouse aux hanches | haut jusqu'aux hanches | pull longueur hanches | chemisier sur les hanches",
        "top_hem=long": "chemisier long | haut qui couvre les fesses | pull sous les fesses | haut couvrant les fesses"
        "",
        "leg_hem=knee": "pantalon au genou | short au genou | pantalon jusqu'aux genoux | bermuda jusqu'au genou",
        "leg_hem=calf": "pantalon mi-mollet | pantalon à mi-mollet | pantalon court | pantalon 3/4",
        "leg_hem=ankle": "pantalon à la cheville | pantalon 7/8 | pantalon longueur cheville | pantalon 7/8e"
        " | pantalon aux chevilles",
        "leg_hem=full": "pantalon long | pantalon jusqu'au sol | pantalon jusqu'aux pieds",
        "sleeves=none": "robe sans manches | robe sans manche | blouse sans aucune manche",
        "sleeves=short": "robe à manches courtes | blouse manches courtes | chemisier à manche courte"
        " | robe avec des manches courtes | les manches courtes, blouse | robe, manches : courtes",
        "sleeves=elbow": "robe à manches mi-longues | blouse manches au coude | robe avec manches jusqu'au coude"
        " | blouse à manches aux coudes | robe demi-manches | blouse manche mi-longue",
        "sleeves=three-quarter": "robe à manches trois-quarts | blouse manches 3/4 | robe manches trois quart"
        " | blouse avec des manches 3/4 | robe aux manches trois quarts | blouse à manches 7/8",
        "sleeves=long": "robe à manches longues | blouse manches longues | chemisier à manche longue"
        " | robe avec de longues manches | blouse manches jusqu'au poignet | robe à longues manches",
        "sleeves=extra-long": "pull à manches très longues | pull à manches extra longues | pull manches qui couvrent les mains",
    },
    "es": {
        "skirt_hem=mini": "minivestido | un vestido corto | falda corta | vestido a medio muslo | minifalda"
        " | falda hasta medio muslo | vestido cortito | falda por medio muslo",
        "skirt_hem=above the knee": "vestido por encima de la rodilla | falda sobre la rodilla"
        " | vestido encima de las rodillas | falda un poco por encima de la rodilla | vestido arriba de la rodilla"
        " | falda por encima de las rodillas",
        "skirt_hem=knee": "vestido hasta la rodilla | falda a la rodilla | vestido a la altura de la rodilla"
        " | falda hasta las rodillas | vestido por la rodilla | vestido largo a la rodilla | falda de largo rodilla"
        " | vestido que llegue a la rodilla | vestido a las rodillas",
        "skirt_hem=below the knee": "falda por debajo de la rodilla | vestido bajo la rodilla | falda debajo de las rodillas"
        " | vestido que cubra las rodillas | falda abajo de la rodilla | vestido que tape la rodilla",
        "skirt_hem=midi": "vestido midi | falda a media pierna | vestido a media pantorrilla | falda por la pantorrilla"
        " | falda hasta la pantorrilla | vestido hasta media pantorrilla | falda de largo midi | vestido semilargo",
        "skirt_hem=maxi": "vestido largo | falda larga | maxivestido | vestido maxi | maxifalda",
        "skirt_hem=ankle": "vestido hasta el tobillo | falda a los tobillos | vestido hasta los tobillos | falda tobillera"
        " | vestido por el tobillo | falda a la altura del tobillo",
        "skirt_hem=floor": "vestido hasta el suelo | falda al suelo | vestido hasta los pies | vestido hasta el piso"
        " | vestido que roza el suelo | falda a ras de suelo | vestido largo hasta el suelo",
        "top_hem=cropped": "top corto, ombligo al aire | camiseta ombliguera | blusa por encima del ombligo",
        "top_hem=waist": "blusa hasta la cintura | blusa de largo hasta la cintura",
        "top_hem=hip": "blusa hasta la cadera | jersey largo a la cadera | blusa hasta las caderas | blusa por la cadera",
        "top_hem=long": "blusa larga | blusa que cubra el trasero | jersey largo | camisa que tape el trasero",
        "leg_hem=knee": "pantalón hasta la rodilla | pantalones a la rodilla | pantalón por la rodilla",
        "leg_hem=calf": "pantalón a media pierna | pantalón a media pantorrilla | pantalón pesquero",
        "leg_hem=ankle": "pantalón tobillero | pantalones al tobillo | pantalón hasta el tobillo | pantalón 7/8",
        "leg_hem=full": "pantalón largo | pantalones largos | pantalón hasta el suelo | pantalones hasta los pies",
        "sleeves=none": "vestido sin mangas | blusa sin manga",
        "sleeves=short": "vestido de manga corta | blusa con mangas cortas | vestido manga corta"
        " | blusa con las mangas cortas | blusa de manguita corta",
        "sleeves=elbow": "vestido con mangas hasta el codo | blusa de manga al codo | vestido de media manga"
        " | blusa con mangas por el codo | vestido de mangas a la altura del codo",
        "sleeves=three-quarter": "vestido con manga francesa | blusa de manga tres cuartos | vestido con mangas 3/4"
        " | blusa con mangas francesas | vestido manga 3/4 | blusa de mangas tres cuartos",
        "sleeves=long": "vestido de manga larga | blusa con mangas largas | vestido manga larga"
        " | blusa con mangas hasta la muñeca | vestido de mangas largas",
        "sleeves=extra-long": "jersey con mangas muy largas | jersey con mangas extralargas | jersey de mangas que cubren las manos",
    },
}
ROWS = [
    pytest.param(language, text.strip(), claim, id=f"{language}: {text.strip()}")
    for language, claims in SAID.items()
    for claim, texts in claims.items()
    for text in texts.split(" | ")
]


@pytest.mark.parametrize(("language", "text", "claim"), ROWS)
def test_lengths_are_read_in_other_languages(language, text, claim):
    reading = read_words(text)
    found = {f"{i.claim.name}={i.claim.value}" for i in reading.implications}
    assert claim in found
    name = claim.partition("=")[0]
    assert [each for each in found if each.startswith(f"{name}=")] == [claim]
    assert not reading.unknown


@pytest.mark.parametrize("language", SAID)
def test_every_length_has_words_in_each_language(language):
    lengths = {claim for claims in SAID.values() for claim in claims}
    assert set(SAID[language]) == lengths
