"""Words for waist, skirt and legs."""

from __future__ import annotations

from swifttailor.wording.phrases.phrase import Wording, adjective, feature, sentence


def _of_dress(needs: str, *texts: str, weight: float = 1.0) -> Wording:
    """About the skirt of a dress, which is named in it."""
    return feature(f"kind=dress {needs}", *texts, weight=weight, topics="skirt_noun")


ADJECTIVES: tuple[Wording, ...] = (
    # Length of dresses and skirts.
    adjective("skirt_hem=micro", "very short", "micro", "micro-mini", weight=2),
    adjective("skirt_hem=mini", "mini", "short", "mini-length", "thigh-length", weight=4),
    adjective("skirt_hem=above_the_knee", "above-the-knee", "above-knee", weight=4),
    adjective("skirt_hem=knee", "knee-length", weight=5),
    adjective("skirt_hem=below_the_knee", "below-the-knee", "below-knee", weight=3),
    adjective("skirt_hem=midi", "midi", "calf-length", "mid-calf", "midi-length", weight=4),
    adjective("skirt_hem=maxi", "maxi", "long", "maxi-length", weight=4),
    adjective("skirt_hem=ankle", "ankle-length", weight=3),
    adjective("skirt_hem=floor", "floor-length", "full-length", "floor-sweeping", weight=3),
    # Tops.
    adjective("top_hem=cropped", "cropped", weight=4),
    adjective("top_hem=bra", "very cropped", "extra-short", "midriff-baring", weight=2),
    adjective("top_hem=waist", "waist-length", "waist-grazing", weight=3),
    adjective("top_hem=high_hip", "high-hip-length", weight=0.7),
    adjective("top_hem=hip", "hip-length", weight=3),
    adjective("top_hem=long", "long", "longline", "tunic-length", weight=3),
    # Legs.
    adjective("leg_hem=very_short", "very short", "micro", weight=2, kinds="trousers shorts"),
    adjective("leg_hem=thigh", "thigh-length", "above-the-knee", weight=2, kinds="shorts"),
    adjective("leg_hem=mid-thigh", "mid-thigh", weight=3, kinds="shorts"),
    adjective("leg_hem=thigh", "short-legged", weight=0.5, kinds="playsuit"),
    adjective("leg_hem=knee", "knee-length", weight=4),
    adjective("leg_hem=calf", "calf-length", "cropped", "mid-calf", weight=4, kinds="trousers shorts"),
    adjective("leg_hem=ankle", "ankle-length", weight=4),
    adjective("leg_hem=full", "full-length", "long", weight=3),
    adjective("legs=wide", "wide-leg", "wide-legged", weight=3),
    adjective("legs=straight", "straight-leg", "straight-cut", weight=2),
    adjective("legs=tapered", "tapered", weight=2, kinds="trousers shorts"),
    adjective("legs=tapered", "tapered-leg", weight=2),
    adjective("legs=slim", "slim", weight=1, kinds="trousers shorts"),
    adjective("legs=slim", "slim-leg", weight=2),
    adjective("legs=flared", "flared", "bootcut@us", weight=2, kinds="trousers shorts"),
    adjective("legs=flared", "flared-leg", weight=2),
    # Waist.
    adjective("rise=high", "high-waisted", "high-rise", "waist-high", weight=1.2),
    adjective("rise=mid", "mid-rise", weight=1.5),
    adjective("rise=low", "low-rise", "hip-slung", "low-waisted", "hipster@uk", weight=2),
    adjective("waist_seam=empire", "empire-waist", "empire-line@uk", weight=2),
    adjective("waist_seam=dropped", "drop-waist", "dropped-waist", weight=2),
    # Skirts.
    adjective("skirt=a-line", "A-line", weight=2, kinds="dress skirt"),
    adjective("skirt=flared", "flared", weight=1, kinds="dress skirt"),
    adjective("skirt=circle", "full-skirted", "full", weight=0.8, kinds="dress skirt"),
    adjective("skirt=tiered", "tiered", weight=2, kinds="dress skirt"),
    adjective("skirt=gathered", "gathered", weight=0.8, kinds="skirt"),
    adjective("skirt=pencil", "pencil-cut", "narrow", weight=0.8, kinds="dress skirt"),
    adjective("hem_shape=high-low", "high-low", "dipped-hem@uk", "hi-lo", weight=2),
    adjective("hem_shape=pointed", "handkerchief-hem", "pointed-hem", weight=1.5),
    adjective("hem_shape=scalloped", "scalloped", weight=1.5),
    adjective("hem_shape=lower_left", "slant-hemmed", "asymmetric-hem", weight=1.5),
    adjective("hem_shape=lower_right", "slant-hemmed", "asymmetric-hem", weight=1.5),
)

FEATURES: tuple[Wording, ...] = (
    # Waist and bands.
    feature("waistband=waist", "a waistband", "a sewn-on waistband", weight=1.5),
    feature("waistband=waist waistband=narrow", "a narrow waistband", "a slim waistband", weight=1.5),
    feature(
        "waistband=waist waistband=wide",
        "a wide waistband",
        "a deep waistband",
        "a broad waistband",
        weight=2,
    ),
    feature(
        "waistband=waist waistband=shaped",
        "a shaped waistband",
        "a contoured waistband",
        "a curved waistband",
    ),
    feature("waistband=waist waistband=straight", "a straight waistband"),
    feature(
        "waistband=waist waistband=loose", "a loose waistband", "a waistband with room to spare", weight=1.5
    ),
    feature(
        "waistband=waist waistband_cm=?", "a waistband {waistband_cm} high", "a {waistband_cm-} waistband"
    ),
    feature("waistband=hem", "a band at the hem", "a hem band", "a banded hem", weight=2),
    feature("waistband=hem waistband=wide", "a wide band at the hem", "a deep hem band", weight=2),
    feature("waistband=hem waistband=narrow", "a narrow hem band", "a narrow band at the bottom"),
    feature(
        "waistband=hem waistband=loose",
        "a loose band at the hem",
        "a hem band that stands away from the body",
        weight=1.5,
    ),
    feature("waistband=hem waistband_cm=?", "a {waistband_cm-} band at the hem"),
    feature("waistband=none", "no waistband", weight=0.15),
    feature("waist_seam=empire", "an empire waist", "a raised waistline", "a seam under the bust", weight=2),
    feature("waist_seam=natural", "a waist seam", "a seam at the waist", "a natural waistline", weight=0.8),
    feature(
        "waist_seam=dropped",
        "a dropped waist",
        "a waistline dropped to the hips",
        "a low waist seam",
        weight=2,
    ),
    # Skirts of dresses.
    _of_dress("skirt=pencil", "a pencil skirt", "a narrow skirt", weight=2),
    _of_dress("skirt=straight", "a straight skirt", weight=2),
    _of_dress("skirt=a-line", "an A-line skirt", "a gently flared skirt", weight=3),
    _of_dress("skirt=flared", "a flared skirt", "a skirt that flares to the hem", weight=1.5),
    _of_dress("skirt=half_circle", "a half-circle skirt", weight=2),
    _of_dress("skirt=three-quarter_circle", "a three-quarter circle skirt", weight=2),
    _of_dress("skirt=circle", "a circle skirt", "a full circle skirt", "a full skirt", weight=2),
    _of_dress("skirt=more_than_a_circle", "a very full skirt", "an extra-full circle skirt", weight=2),
    _of_dress("skirt=gathered", "a gathered skirt", "a skirt gathered at the waist", weight=2),
    _of_dress("skirt=tiered", "a tiered skirt", "a skirt in tiers", weight=1.5),
    _of_dress("tiers=?", "a skirt of {tiers} tiers", "a {tiers}-tier skirt", weight=2),
    _of_dress("gores=?", "a skirt of {gores} gores", "a {gores}-panel skirt", weight=2),
    _of_dress("skirt=gored", "a gored skirt", "a panelled skirt@uk", "a paneled skirt@us"),
    _of_dress("skirt_length_cm=?", "a skirt {skirt_length_cm} long", weight=0.7),
    # Skirts of any garment.
    feature("kind=skirt skirt=narrowing", "sides that narrow to the hem", "a narrow hem", weight=1.5),
    _of_dress("skirt=narrowing", "a skirt that narrows to the hem", weight=1.5),
    feature(
        "skirt=fitted_base",
        "a close fit over the hips and a flare below",
        "a skirt that is narrow down to the flare",
        weight=1.2,
        topics="fit",
    ),
    feature(
        "skirt=fitted_base skirt=tiered",
        "flounces below a fitted top part",
        "tiers set onto a fitted skirt",
        weight=2,
    ),
    feature("skirt=fitted_base skirt=godets", "godets below close-fitting hips", weight=1.5, topics="fit"),
    feature("skirt=godets", "godets", "godets let into the hem", "flared inserts at the hem", weight=2),
    feature("godets=?", "{godets} godets", "{godets} godets set into the hem", weight=2),
    feature("godets=? godet_cm=?", "{godets} godets, each {godet_cm} high"),
    feature("kind=skirt skirt=tiered", "tiers", weight=0.7),
    feature(
        "skirt=tiered skirt=gathered_tiers",
        "gathered tiers",
        "ruffled tiers",
        "gathered flounces",
        weight=1.5,
    ),
    feature("kind=skirt tiers=?", "{tiers} tiers", "{tiers} rows, one below the other", weight=1.5),
    feature("kind=skirt gores=?", "{gores} gores", "{gores} panels", weight=1.5),
    feature(
        "kind=skirt skirt=gathered", "gathers at the waist", "fullness gathered in at the top", weight=1.5
    ),
    feature("kind=skirt skirt=flared", "a flare", "plenty of flare", weight=0.7),
    feature("hips=close", "a close fit at the hips", weight=0.2),
    feature("hips=loose", "room over the hips", weight=0.2),
    feature("skirt=peplum", "a peplum", "a peplum at the waist", weight=3),
    feature("skirt=peplum skirt=circle", "a flared peplum", "a circular peplum", weight=1.5),
    feature("skirt=peplum skirt=gathered", "a gathered peplum", weight=1.5),
    feature("hem_cm=?", "a hem {hem_cm} around", weight=0.3, topics="hem_shape"),
    # Hem and slits.
    feature(
        "hem_shape=high-low",
        "a high-low hem",
        "a hem that dips at the back",
        "a hem longer at the back",
        "a dipped hem@uk",
        weight=3,
    ),
    feature(
        "hem_shape=lower_left",
        "a hem that slants down to the left",
        "a slanted hem, lower on the left",
        "an asymmetric hem",
        weight=2.5,
    ),
    feature(
        "hem_shape=lower_right",
        "a hem that slants down to the right",
        "a slanted hem, lower on the right",
        "an asymmetric hem",
        weight=2.5,
    ),
    feature("hem_shape=pointed", "a handkerchief hem", "a pointed hem", "a zigzag hem", weight=2.5),
    feature("hem_shape=scalloped", "a scalloped hem", "a petal-shaped hem", weight=2.5),
    feature("hem_shape=level", "a level hem", "a straight hem", weight=0.1),
    feature("slit=front", "a front slit", "a slit at the front", weight=2),
    feature("slit=back", "a back slit", "a slit at the back", "a back vent", weight=2),
    feature("slit=left", "a slit on the left", "a left side slit", weight=2),
    feature("slit=right", "a slit on the right", "a right side slit", weight=2),
    feature("slit=left slit=right", "side slits", "slits on both sides", weight=3),
    feature("slit=front slit=back", "slits front and back", weight=3),
    feature("slit_size=high", "a high slit", "a long slit", weight=1.2),
    feature("slit=front slit_size=wedge", "a wedge cut out of the front hem", weight=2),
    feature("slit_size=wedge", "a notch cut out of the hem", "a wedge-shaped cut-out at the hem", weight=2),
    feature("slit_cm=?", "a slit {slit_cm} high", "a {slit_cm-} slit", weight=0.8),
    feature("slit=none", "no slits", weight=0.06),
    # Legs.
    feature("kind=jumpsuit legs=wide", "wide legs", weight=2),
    feature("kind=jumpsuit legs=straight", "straight legs", weight=2),
    feature("kind=jumpsuit legs=tapered", "tapered legs", "legs that narrow to the ankle", weight=2),
    feature("kind=jumpsuit legs=flared", "flared legs", weight=2),
    feature("kind=jumpsuit leg_hem=full", "full-length legs", "long legs", weight=2),
    feature("kind=jumpsuit leg_hem=calf", "calf-length legs", "cropped legs", weight=2),
    feature("kind=jumpsuit leg_hem=ankle", "ankle-length legs", weight=2),
    feature("kind=playsuit leg_hem=thigh", "short legs", weight=1.5),
    feature("legs=wide", "wide legs", weight=0.7),
    feature("legs=tapered", "legs that taper to the hem", weight=0.7),
    feature("leg_cuffs=band", "cuffed legs", "cuffs on the legs", "legs with cuffs", weight=2),
    feature(
        "leg_cuffs=band leg_cuffs=gathered", "legs gathered into cuffs", "legs drawn in by cuffs", weight=2
    ),
    feature(
        "leg_cuffs=flounce", "flounced legs", "a flounce on each leg", "legs that end in flounces", weight=2
    ),
    feature(
        "leg_cuffs=band_and_flounce", "a band and a flounce on each leg", "legs with flounced cuffs", weight=2
    ),
    feature("leg_cuffs=deep", "deep leg cuffs", "legs with long cuffs"),
    feature("leg_cuff_cm=?", "leg cuffs {leg_cuff_cm} deep", weight=0.7),
    feature("leg_cuffs=none", "plain hems", weight=0.1),
    feature("inseam_cm=?", "an inseam of {inseam_cm}", "a {inseam_cm-} inseam", weight=1),
    feature("leg_width_cm=?", "legs {leg_width_cm} around at the hem", weight=0.6),
    feature("length_cm=?", "a length of {length_cm} from shoulder to hem", weight=0.35),
)

SENTENCES: tuple[Wording, ...] = (
    sentence("skirt_hem=micro", "It barely covers the seat.", "It is very short."),
    sentence(
        "skirt_hem=mini", "The hem ends at mid-thigh or higher.", "It is short, ending well above the knee."
    ),
    sentence("skirt_hem=above_the_knee", "It ends just above the knee.", "The hem is above the knee."),
    sentence("skirt_hem=knee", "It ends at the knee.", "The hem touches the knees.", "It is knee-length."),
    sentence("skirt_hem=below_the_knee", "It covers the knees.", "The hem falls below the knee."),
    sentence(
        "skirt_hem=midi", "It falls to mid-calf.", "The hem ends on the calf.", "It comes down to the calves."
    ),
    sentence(
        "skirt_hem=maxi", "It is long, ending near the ankle or lower.", "It reaches down to the ankles."
    ),
    sentence("skirt_hem=ankle", "It reaches the ankle.", "The hem ends around the ankles."),
    sentence("skirt_hem=floor", "It reaches the floor.", "The hem sweeps the floor."),
    sentence("top_hem=cropped", "It is cropped.", "It ends at the waist or above.", weight=0.8),
    sentence("top_hem=bra", "The hem leaves the midriff bare.", "It ends far above the waist."),
    sentence("top_hem=waist", "It ends at the waist.", "The hem sits at the waist."),
    sentence("top_hem=hip", "It ends at the hips.", "The hem falls to the hips."),
    sentence("top_hem=long", "It covers the seat.", "The hem falls below the hips."),
    sentence("leg_hem=thigh", "The legs end above the knee.", "The legs are short."),
    sentence("leg_hem=knee", "The legs end at the knee."),
    sentence("leg_hem=calf", "The legs end at the calf.", "The legs are cropped at the calf."),
    sentence("leg_hem=ankle", "The legs reach the ankle."),
    sentence("leg_hem=full", "The legs are full length.", "The legs reach down to the feet."),
    sentence("kind=dress skirt=a-line", "The skirt is A-line.", "The skirt widens gently to the hem."),
    sentence("kind=dress skirt=flared", "The skirt flares to the hem."),
    sentence("kind=dress skirt=pencil", "The skirt is narrow.", "The skirt is a pencil skirt."),
    sentence("kind=dress skirt=circle", "The skirt is a full circle."),
    sentence("kind=dress skirt=gathered", "The skirt is gathered into the waist."),
    sentence("kind=dress tiers=?", "The skirt has {tiers} tiers."),
    sentence("kind=dress gores=?", "The skirt is cut in {gores} panels."),
    sentence("godets=?", "{godets} godets are let into the hem."),
    sentence("hem_shape=high-low", "The hem dips at the back.", "The hem is shorter in front than behind."),
    sentence("hem_shape=lower_left", "The hem slants down to the left."),
    sentence("hem_shape=lower_right", "The hem slants down to the right."),
    sentence("hem_shape=pointed", "The hem hangs in points.", "The hem ends in points like a handkerchief."),
    sentence("hem_shape=scalloped", "The hem is scalloped."),
    sentence("slit=front", "There is a slit in front."),
    sentence("slit=back", "There is a slit at the back."),
    sentence("slit=left", "There is a slit on the left."),
    sentence("slit=right", "There is a slit on the right."),
    sentence("slit_cm=? slit_size=high", "The slit is high: {slit_cm}."),
    sentence("waistband=waist", "{it} {has} a waistband.", "There is a waistband."),
    sentence("waistband=waist waistband=wide", "The waistband is wide."),
    sentence("waistband=hem", "A band finishes the hem.", "The hem is finished with a band."),
    sentence("waistband=none", "There is no waistband.", weight=0.2),
    sentence("waist_seam=empire", "The waist seam sits high, under the bust."),
    sentence("waist_seam=dropped", "The waist seam sits low, on the hips."),
    sentence("rise=high", "{it} {sits} at the natural waist."),
    sentence("rise=low", "{it} {sits} low on the hips."),
    sentence("legs=wide", "The legs are wide."),
    sentence("legs=tapered", "The legs taper to the hem."),
    sentence("legs=straight", "The legs are straight."),
    sentence("legs=flared", "The legs flare to the hem."),
    sentence("leg_cuffs=band", "The legs end in cuffs."),
    sentence("leg_cuffs=flounce", "The legs end in flounces."),
    sentence("leg_cuffs=band_and_flounce", "Each leg ends in a band with a flounce."),
    sentence(
        "length_cm=?", "It measures {length_cm} from shoulder to hem.", "Length: {length_cm}.", weight=0.6
    ),
    sentence("skirt_length_cm=?", "The skirt is {skirt_length_cm} long.", weight=0.8),
    sentence("inseam_cm=?", "The inseam is {inseam_cm}.", weight=0.8),
)
