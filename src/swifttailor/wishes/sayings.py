"""What people say of a garment in other words than those of parts and changes, put into plain ones.

"Gather them into a cuff", "it slides off my waist", "cut both sides open to the thigh" and "can it not be there" name
what is wanted by what is done, felt or seen. They are rewritten before an instruction is read, so that everything
behind this has to know one way of saying it.
"""

from __future__ import annotations

import re
from functools import cache

from swifttailor.describing.differences import Step
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.facts import GarmentFacts
from swifttailor.wishes.change_parts import changes_of
from swifttailor.wishes.change_words import find_changes, find_parts
from swifttailor.wishes.mentions import find_mentions

_THE = r"(?:the|my|her|his|its|their|your|those|these|this|that|both(?: the| of the)?|all(?: the| of the)?)"
_OFF_VERB = (
    r"(?:lose|losing|ditch|bin|scrap|shed|chuck|nix|axe|dump|strip|banish|eliminate|delete|scrub|omit"
    r"|remove|take off|take away|get rid of|do away with|do without|cut off|chop off|lop off|get shot of)"
)
_CUT_VERB = r"(?:chop|hack|lop|rip|tear|snip|slice|whip|saw|strip|shear|get|have|cut|take)"
_BOTH = r"(?:both|the two|each|either|two)"
_SOMEWHAT = (
    r"(?:just )?(?:a |the )?(?:wee |tiny |little )?"
    r"(?:bit|touch|tad|little|shade|smidge|smidgen|mite|rather|slightly|somewhat|kinda|kind of|sort of"
    r"|uncomfortably|awfully|terribly|horribly|ridiculously)"
)
_VERY = r"(?:really|very|super|so|incredibly|extremely)"
_ADJECTIVE = (
    r"(?:tight|snug|loose|baggy|long|short|wide|broad|narrow|big|small|large|roomy|high|low|deep|full|puffy|poofy"
    r"|floppy|close|clingy|skimpy|revealing|boxy|bulky|shallow)"
)
_IN_LEGS = frozenset({"trousers", "shorts", "jumpsuit", "playsuit"})
_LOWER = frozenset({"trousers", "shorts", "skirt"})
_SKIRTED = frozenset({"dress", "skirt"})
_SEAMED = frozenset({"dress", "jumpsuit", "playsuit"})
_BODICED = frozenset({"dress", "top", "tunic", "jumpsuit", "playsuit"})
_Saying = tuple[str, str, frozenset[str] | None]

_SAYINGS: tuple[_Saying, ...] = (
    (r"(?P<n>an?|one|two|three|four|five|six|\d[\d.,/]*) (?:more|extra|additional) (?P<u>cms?|centimet\w+|inch(?:es)?|ins?|mm)\b", r"\g<n> \g<u> more", None),
    # What goes.
    (
        rf"{_CUT_VERB} {_THE} (?P<what>sleeves?|legs|skirt|hem|dress|trousers|pants|jeans|top|shirt)(?: right| clean| straight)* off(?: just| right| somewhere)? (?:at|to|by|above|below) "
        r"(?:the |my )?(?P<level>elbows?|knees?|ankles?|wrists?|thighs?|mid-thigh|calf|calves|mid-calf|hips?|waist|shoulders?)\b",
        r"the \g<what> to the \g<level>",
        None,
    ),
    (
        r"(?:can|could|may|might|would|should|must|shall) (?:the|that|this|my|those|these|its) (?:\w+ )?(?P<what>sleeves?|collar|hood|cuffs?|waistband|peplum|ruffles?|frills?|lapels?)"
        r"(?: please| just)? (?:go|go away|disappear|vanish|be gone|come off|not be there|be left off|be removed)\b",
        r"remove the \g<what>",
        None,
    ),
    (
        r"(?:can|could|may|might|would|should|must|shall) (?:the|that|this|my) (?:high|roll|polo|turtle|funnel|rolled|stand-up) ?(?:neck|collar)(?: please| just)?"
        r" (?:go|go away|disappear|vanish|be gone|come off|not be there|be left off|be removed)\b",
        "remove the collar",
        None,
    ),
    (rf"{_OFF_VERB} {_THE}\b(?! (?:left|right)\b)", "remove the", None),
    (rf"(?:drop|kill|cut|skip|without) (?:my|its|her|his|those|these|that) (?=\w)", "remove the ", None),
    (
        rf"{_CUT_VERB} {_THE} (?P<what>sleeves?|collar|hood|cuffs?|straps?|waistband|band|peplum|tiers?|ruffles?|frills?|turtleneck|lapels?)"
        r"(?: right| clean| straight| completely| altogether| entirely)* off(?: completely| altogether| entirely| please)*\b(?! (?:just |right |somewhere )?(?:at|above|below|to|by|past|\d|an? (?:inch|hand)))",
        r"remove the \g<what>",
        None,
    ),
    (r"(?P<what>sleeves?|collar|hood|cuffs?|waistband|peplum|ruffles?) (?:is|are|has|have|needs?|must|should|can|could)(?: got)?(?: to)?"
     r" (?:go|come off|be gone|disappear|vanish|be binned|get lost)\b", r"remove the \g<what>", None),
    (r"(?:take|get|pull|leave|let) (?:the |those |all the |its )?(?P<what>godets|gathers|gathering|pleats|ruffles?|tiers|darts|frills?|flounces?|wedges|slits?) (?:out|away)\b|flatten (?:the |those )?(?P<flat>tiers|gathers|ruffles?|frills?|flounces?)\b",
     "{gone}", None),
    (r"(?:sew|stitch|close|seal|zip|pin|shut) (?:up )?(?:the |that |my |those |both )?(?:left |right |side |back |front )?(?P<what>slits?|splits?|vents?)(?: up| shut| closed)*\b", r"no \g<what>", None),
    # Shoulders and sleeves of one side.
    (
        r"(?:(?:off|bare|over|on) (?:the |my )?(?:one|a single) shoulder|one[- ]shoulder(?:ed)?)\b[^.;]*?"
        r"\b(?:nothing|bare|no strap|no sleeve|none|open|free|uncovered|naked|exposed)\b[^.;]*?\b(?P<side>left|right)\b"
        r"(?: (?:side|shoulder|one|arm|hand side))*(?: at all)?",
        r"bare \g<side> shoulder",
        _BODICED,
    ),
    (
        r"(?:one[- ]shoulder(?:ed)?|(?:off|on|over) one shoulder)\b[^.;]*?\b(?:keep|keeping|only|just|leave|with)\b[^.;]*?\b"
        r"(?:the )?(?P<side>left|right)\b(?: (?:side|shoulder|strap|one))*",
        r"one strap on the \g<side>",
        _BODICED,
    ),
    (r"(?:off|down from|slipping off) (?:the |my )(?P<side>left|right) shoulder\b", r"bare \g<side> shoulder", _BODICED),
    (r"(?:nothing|no strap|bare skin|no cloth|no fabric) (?:at all )?on (?:the |my )?(?P<side>left|right)(?: side| shoulder)?\b(?: at all)?",
     r"bare \g<side> shoulder", _BODICED),
    (r"(?:left|leave|have|make|with) (?:the |my )?(?P<side>left|right) shoulder (?:bare|uncovered|free|naked|exposed|open)\b",
     r"bare \g<side> shoulder", _BODICED),
    (r"(?:just |only )?(?:the |a )?(?:one|single|1) sleeve\W{1,3}(?:only |just )?(?:on |over |for )?(?:the |my )(?P<side>left|right)(?: arm| side)?(?: only)?\b",
     r"\g<side> sleeve only", _BODICED),
    # Where the waist seam is.
    (
        r"(?:raise|move|bring|lift|put|take|shift|hike|hoist|pull|have) (?P<what>it|the (?:waist\w*|seam|waist seam|skirt))(?: back)?(?: up)?(?: to)?(?: just| right)?"
        r" (?:under|below|beneath|underneath|at) (?:the|my|her) (?:bust|bosom|boobs?|breasts?|chest|bra|bustline)\b",
        "empire waist",
        _SEAMED,
    ),
    (r"(?:waist\w*|waist seam|seam|skirt)(?: to| should| must| can)?(?: be| sit| start| begin| go)?(?: right| just| directly)? (?:under|below|beneath|underneath) (?:the|my|her) (?:bust|bosom|boobs?|breasts?|chest|bra|bustline)\b",
     "empire waist", _SEAMED),
    (
        r"(?:a |the |my )?(?:proper|normal|natural|ordinary|usual|regular|real|true|actual|standard) waist(?:line| seam)?"
        r"(?: (?:in|at) (?:the|its|my) (?:ordinary|usual|normal|right|natural|proper|real) (?:place|position|spot|height))?"
        r"(?: (?:rather than|instead of|not) (?:under|below|at|on) (?:the |my )?\w+)?\b",
        "waist at the natural waist",
        _SEAMED,
    ),
    (r"(?:waist\w*|seam)(?: \w+){0,3} (?:in|at|to) (?:the|its|my) (?:ordinary|usual|normal|right|natural|proper|real|own) (?:place|position|spot|height|waist)\b",
     "waist at the natural waist", _SEAMED),
    (r"(?:waist\w*|seam)(?: \w+){0,4} where (?:my|a|the|her) (?:actual |real |natural )?waist (?:actually |really )?(?:is|should be|belongs|sits)\b",
     "waist at the natural waist", _SEAMED),
    # Hems, slits.
    (r"(?P<what>hem|hemline|bottom|bottom edge|skirt)(?: to| should| must| could| can)?(?: \w+)? (?:come|comes|coming|run|runs|running|go|goes|end|ends|ending|finish|drop|drops|dip|dips|falls?|cut)"
     r"(?: down)? (?:to|in|into) (?:a |one |two )?(?:sharp |deep |little )?points?\b", "pointed hem", None),
    (r"(?:a |sharp )?points? (?:at|on|in|to) the (?:front |back )?hem(?:line)?\b", "pointed hem", None),
    (r"(?:neck|neckline)(?: to| should| must| could| can)? (?:come|comes|coming|run|go|goes|end|ends|dip|dips)(?: down)? (?:to|in|into) a (?:sharp |deep )?point\b",
     "V neck", _BODICED),
    (
        rf"(?:cut|slash|slit|split|open|rip|slice) (?:it |the skirt |the dress |the hem )?(?:up |open )?(?:at |on |along |up |down )?{_BOTH} (?:the )?sides?"
        r"(?: seams?)?(?: open| up)*(?: (?:right |all the way )?(?:up )?to (?:the |my )?(?P<to>top of (?:the |my )?thighs?|thighs?|mid-?thigh|hips?|knees?))?\b",
        "slits on both sides {to}",
        None,
    ),
    (
        r"(?:cut|slash|slit|split|open|rip|slice) (?:it |the skirt |the dress |the hem |me )?(?:up |open )?(?:at |on |along |up |down )?(?:the |my )?(?P<side>left|right|front|back)"
        r"(?: side| leg| seam)*(?: open| up)*(?: (?:right |all the way )?(?:up )?to (?:the |my )?(?P<to>top of (?:the |my )?thighs?|thighs?|mid-?thigh|hips?|knees?))?(?![ -]\w*(?:sleeve|neck|shoulder))\b",
        "slit {side} {to}",
        _SKIRTED,
    ),
    (r"(?:hem )?sweep (?P<to>to|of|at) (?=\d)", "hem circumference ", _SKIRTED),
    (r"(?:one|a|the|either) side (?:left )?(?:open|slit|split|slashed)(?: up)?(?: (?:right |all the way )?(?:up )?to (?:the |my )?(?P<to>top of (?:the |my )?thighs?|thighs?|mid-?thigh|hips?|knees?))?\b", "slit left {to}", _SKIRTED),
    (r"(?:the )?(?P<side>left|right) side (?:left )?(?:open|slit|split|slashed)(?: up)?(?: (?:right |all the way )?(?:up )?to (?:the |my )?(?P<to>top of (?:the |my )?thighs?|thighs?|mid-?thigh|hips?|knees?))?\b", "slit {side} {to}", _SKIRTED),
    (r"both sides (?:left )?(?:open|slit|split|slashed)(?: up)?(?: (?:right |all the way )?(?:up )?to (?:the |my )?(?P<to>top of (?:the |my )?thighs?|thighs?|mid-?thigh|hips?|knees?))?\b", "slits on both sides {to}", None),
    # Cuffs and gathers.
    (
        r"(?:gather(?:ed|ing)?|draw|pull|nip|cinch|catch) (?:(?:them|it|the (?:legs|bottoms|trousers|hems?|ends?|leg ends?|ankles?)|these) )?(?:all )?(?:in )?(?:in)?to"
        r" (?:a |some |an )?(?:\w+ )?(?:cuffs?|bands?|elastics?|elastication)(?: (?:at|on|round|around|by) (?:the |my )?ankles?)?\b",
        "with gathered leg cuffs, ankle length",
        frozenset({"trousers"}),
    ),
    (r"(?:gather(?:ed|ing)?|draw|pull|nip|cinch|catch) (?:(?:them|the (?:legs|trousers|hems?|ends?|leg ends?)) )(?:all )?(?:in )?(?:at|round|around) (?:the |my )?ankles?\b",
     "with gathered leg cuffs", frozenset({"trousers", "jumpsuit"})),
    (
        r"(?:gather(?:ed|ing)?|draw|pull|nip|cinch|catch|drawn|pulled)(?: (?:them|it|the (?:sleeves|ends?|sleeve ends?)))?(?: in)? (?:at|round|around) (?:the |my )?wrists?\b",
        "bishop sleeves",
        _BODICED,
    ),
    (
        r"(?:blow|puff|pump|plump|balloon|inflate|billow) (?:the |my |those )?sleeves (?:up|out)\b|(?:blow|puff|pump|plump|inflate) (?:up|out) (?:the |my |those )?sleeves\b",
        "balloon sleeves",
        _BODICED,
    ),
    (
        r"(?:no|without|lose the|remove the|take out the|flatten the|less|fewer) (?:gathers?|gathering|puff|puffs|pleats|fullness|ease) (?:at|in|on|along|round|around) (?:the )?"
        r"(?:sleeve )?(?:caps?|crowns?|heads?|tops? of (?:the )?sleeves?)\b|(?:flat|smooth|plain) (?:sleeve )?(?:caps?|crowns?|heads?)\b",
        "smooth set-in sleeves",
        _BODICED,
    ),
    # What is felt.
    (r"i can(?:'t|not| not|t) (?:even )?(?:get|lift|raise|kick|swing|move) my (?:leg|knee)s?(?: up| high| properly)*(?: in (?:this|it|these))?\b", "", _LOWER | _SKIRTED),
    (
        r"(?:i (?:have|need) to |i'm |i am )?(?:keep|keeps|have to keep|always|constantly|forever|need to keep)(?: on)? (?:having to )?(?:hitch|hoik|yank|haul|pull|hold|tug|hik|hoist)(?:e?ing)?"
        r" (?:it|them|these|this|those|the \w+|my \w+) (?:back )?up\b",
        "{grip}",
        None,
    ),
    (r"(?:it|they|these|this|the (?:skirt|waist|waistband|trousers|pants|shorts))?\s?(?:keeps? )?(?:just )?(?:slid(?:e|es|ing)|slip(?:s|ping)?|fall(?:s|ing)?|drop(?:s|ping)?|com(?:e|es|ing)) (?:right )?(?:off|down|over)(?: from| over| past| below)? (?:of )?(?:my|the|her|his) (?:waist|hips?|bum|bottom|backside|bones)\b",
     "{grip}", _LOWER),
    (r"(?:it|they|these|this|the (?:dress|top|bodice|front))? ?(?:keeps?|won't stop) (?:slid|slipp|fall)ing (?:down|off)\b(?! (?:my|the|her) shoulder)", "{grip}", None),
    (r"(?:won't|will not|doesn't|don't|does not|never) stay up\b", "{grip}", None),
    (r"(?:it|they|the (?:straps?|neckline|neck|top|dress))?\s?(?:keeps? )?(?:slid(?:e|es|ing)|slip(?:s|ping)?|fall(?:s|ing)?|drop(?:s|ping)?) (?:right )?(?:off|down) (?:of )?(?:my|the|her|his|both) shoulders?\b",
     "the neckline is too wide", _BODICED),
    (r"(?:some )?(?:more|a bit more|a little more) (?:coverage|cover) (?:at|on|over|round|around|for|up) (?:the |my |her )?(?:top|bust|bosom|chest|cleavage|breasts?|boobs?|front|neck|d[ée]collet\w+|collarbones?)\b",
     "a higher neckline", _BODICED),
    (r"(?:cover|hide|cover up|conceal) (?:the |my |her |up )?(?:collarbones?|cleavage|bust|bosom|chest|breasts?|boobs?|d[ée]collet\w+)\b|(?:collarbones?|cleavage|bust|bosom|breasts?|boobs?|d[ée]collet\w+) (?:mustn't|must not|shouldn't|should not|can't|cannot|may not|isn't to|is not to)(?: be)? (?:show|shown|be seen|seen|peek|visible)\b|(?:collarbones?|cleavage|bust|bosom|breasts?|boobs?|d[ée]collet\w+) (?:must|should|has to|have to|needs? to)(?: all)? be (?:covered|hidden)\b",
     "higher neckline", _BODICED),
    (r"close (?:up )?(?:the |that |my )?(?:v|v-neck|v neck|neckline|neck|front)(?: up)?\b(?! behind| at the back)", "higher neckline", _BODICED),
    (r"(?:show|see|reveal|flash|expose) (?:off )?(?:a bit |a little |some |much )?(?:more |some )(?:of )?(?:my |the |her )?(?:collarbones?|neck|cleavage|chest|d[ée]collet\w+|bust)\b", "deeper neckline", _BODICED),
    (r"(?:show|see|reveal|flash|expose) (?:off )?(?:a bit |a little |some |much )?(?:more |some )(?:of )?(?:my |the |her )?back\b", "lower back", _BODICED),
    (r"(?:my |the )?bra (?:strap )?(?:shows?|is showing|can be seen|peeks? out|sticks? out)(?: through)? (?:at|in|on) (?:the |my )?back\b", "higher back", _BODICED),
    # Narrow skirts.
    (r"(?:needs? to be|has to be|should be|must be|to be|want it|make it|i want the skirt|make the skirt) so (?P<how>narrow|tight|slim|close)\b(?: that)?[^.,;]*", r"should be a pencil skirt", _SKIRTED),
    (r"(?:think )?(?:a )?mermaid(?:'s)? without (?:the|a|its|her) tail\b", "pencil skirt", _SKIRTED),
    # How far down.
    (r"(?:(?:down |all the way |right )*to|reach|reaching|touch|touching|cover|covering|meet|hit) (?:the|my|his|her) (?:shoes?|feet|foot|toes|heels?|instep|ground)\b", "{feet}", None),
    (r"(?P<part>\b(?:trousers|pants|legs|bottoms)) (?:bottoms|hems)\b", r"\g<part>", _IN_LEGS),
    # What is no wish.
    (r"(?:(?:at|i'm|i am|being|only|just|barely|nearly|over|under) )*(?:four|five|six|4|5|6)(?: ?(?:foot|ft|feet)|')(?: ?(?:nothing|one|two|three|four|five|six|seven|eight|nine|ten|eleven|\d{1,2})\b\"?)?(?: and a half)?(?: (?:tall|here|of me))*\b(?! of)", "", None),
    (r"(?:normal|ordinary|regular|standard|proper|usual|plain old|bog[- ]standard) (?=(?:collar|sleeves?|cuffs?|hem|waistband|neckline|neck|straps?)\b)", "", None),
    (r"(?:(?:please |can you |could you |let me have |i(?:'d| would)? (?:need|want|like) |let it out |(?:give|allow|add|need|want|take|have) )+)?(?:(?:me|us|it|her|him) )?(?:another|an extra|some|about|maybe|say)? ?(?P<n>(?:an?|one|half an?|two|three|four|five|\d[\d.,/]*) ?(?:cms?|centimet\w+|inch(?:es)?|in|\"|mm))(?: (?:more|extra|or so))? (?:there|here)\b",
     r"by \g<n>", None),
    (r"(?:so|too) (?:narrow|tight|slim|close)(?: that)?,? (?:i|she|you|one|we) (?:can't|cannot|can not|can hardly|can barely|can scarcely|could not|couldn't) (?:even )?(?:walk|stride|climb|run|cycle|take a step|take steps|get into the car)\b[^.;,]*",
     "wider hem", _SKIRTED),
    (r"(?:i |she |we )?(?:keep|keeps|always|constantly|am always|am forever|kept)?(?: on)? ?(?:tread|tripp|stepp|stumbl|walk|stand)ing (?:on|over|up) (?:it|them|the (?:hems?|skirt|legs|trousers|dress|ends|bottoms?))\b|i (?:tread|trip|step|stumble|walk|stand) (?:on|over) (?:it|them|the (?:hems?|skirt|legs|trousers|dress|ends|bottoms?))\b",
     "{drag}", None),
    (r"(?:(?:it|they|the \w+) )?(?:pools?|puddles?|bunch(?:es)?|crumples?|piles? up|gathers?|scrapes?|sweeps?|drags?|trails?)(?: up)? (?:on|along|over|round|around|at) (?:the|my) (?:floor|ground|feet|ankles|shoes|pavement|street)\b",
     "{drag}", None),
    (r"(?:my )?(?:hands?|fingers?|fingertips|knuckles|thumbs) (?:disappear|vanish|get lost|are lost|are hidden|hide)s? (?:in|inside|under|up) (?:the |my |those )?sleeves?\b|sleeves? (?:swallow|cover|eat|hide|drown|go over|hang over|come over|fall over|flop over)s?(?: up)? (?:my |the )?(?:whole )?(?:hands?|fingers?|fingertips|knuckles|thumbs)\b",
     "the sleeves are too long", _BODICED),
    (r"(?:it |this |the \w+ )?(?:rutscht|rutschen|glisse|glissent|se me cae|se me caen|se me baja|se me bajan)(?: mir)?(?: \w+)?(?: runter| herunter| hinunter| vers le bas)?\b", "{grip}", None),
    # In other languages.
    (r"(?:taille|naht|taillennaht|rock)\b[^.;,]*\bunter (?:der|die|meiner|meine) brust\b|(?:taille|couture)\b[^.;,]*\bsous la poitrine\b|(?:cintura|talle|costura)\b[^.;,]*\bdebajo del (?:pecho|busto)\b",
     "empire waist", _SEAMED),
    (r"(?:taille|naht|taillennaht)\b[^.;,]*\b(?:natürlichen?|normalen?|richtigen?) (?:taille|stelle|höhe|platz)\b|(?:natürliche|normale) taille\b|taille naturelle\b|(?:cintura|talle) natural\b", "waist at the natural waist", _SEAMED),
    (r"(?:taille|naht|taillennaht)\b[^.;,]*\bauf (?:die|der|den) hüften?\b|(?:taille)\b[^.;,]*\b(?:sur|aux) (?:les )?hanches\b|taille basse\b|(?:cintura|talle)\b[^.;,]*\ba las? caderas?\b", "dropped waist", _SEAMED),
    (r"saum\b[^.;,]*\bspitz\w*(?: zulaufen\w*| zulaufend\w*)?|spitzer saum\b|ourlet\b[^.;,]*\ben pointe\b|(?:bajo|dobladillo)\b[^.;,]*\ben (?:punta|pico)\b", "pointed hem", None),
    # Measures that have a name of their own.
    (r"(?P<n>(?:an?|one|half an?|two|three|\d[\d.,/]*) ?(?:cm|centimet\w+|inch(?:es)?|in|\"|mm)) (?:more|extra)(?: room| space| please)? (?:in|at|round|around|on|for|across|over) (?:the|my) (?P<part>waist|hips|chest|bust|belly|tummy|thighs?|seat)\b",
     r"the \g<part> wider by \g<n>", None),
)
"""Pattern, plain words, and the kinds of garments it is said of; braces are filled in by `_filled`."""
_GRIP = {
    **dict.fromkeys(("skirt", "trousers", "shorts"), "a tighter waist"),
    **dict.fromkeys(("dress", "top", "tunic", "jumpsuit", "playsuit"), "a tighter chest"),
}
_DRAG = dict.fromkeys(("trousers", "shorts", "jumpsuit", "playsuit"), "shorten the legs")
_FEET = {
    **dict.fromkeys(("trousers", "jumpsuit"), "full length legs"),
    **dict.fromkeys(("dress", "skirt"), "to the floor"),
}
_HIGH = re.compile(r"thigh|hip")
_NOT_THERE = re.compile(
    r"[^.;!?]*(?:(?:can|could|may|might|would|should) (?:it|they|that|this|those|that bit|the thing)(?: all| just| please| simply| maybe)*"
    r" (?:not be there|not be|go|go away|disappear|vanish|be gone|come off|be left off|be left out|be removed)"
    r"|(?:i|we) (?:just |really )?(?:don't|do not|dont) want (?:it|them|that|those)(?: (?:there|any ?more|at all))?"
    r"|(?:get|be|am) rid of (?:it|them)|take (?:it|them|that|those) (?:right |clean )?(?:off|away))"
    r"(?: please| altogether| at all)?\s*(?=$|[.;!?])"
)
_CAN_GO = frozenset({"collar", "hood", "sleeves", "cuffs", "band", "leg_cuffs", "slit"})
_NAME_OF = {"band": "waistband", "leg_cuffs": "leg cuffs"}
_MADE_OF_IT = re.compile(
    r"(?:,? so(?: that)?|because|and then) (?:it|she|he|they|this) (?:looks?|reads?|feels?|seems?)(?: more)?(?: like)? [^.;,]*"
)
_LOOKS = re.compile(
    r"(?:makes?|making) (?:me|her|him|us) (?:look|feel|seem|appear)(?: like| as if)?(?: an?)? [^.;,]*"
)
_SAID_TO_BE = re.compile(
    rf"(?:^|(?<=[.;,!?] )|(?<=\band )|(?<=\bbut ))(?P<before>(?:(?:it|it's|its|it is|they|they're|these|this|that|the \w+(?: \w+)?|my \w+|feels?|fits?|looks?|is|are|'s) )*)"
    rf"(?:{_SOMEWHAT}|(?:(?<=is )|(?<=are )|(?<='s )|(?<='re )|(?<=feel )|(?<=feels )|(?<=fits )|(?<=looks )){_VERY}) (?P<adjective>{_ADJECTIVE})(?= (?:round|around|at|in|on|across|over|under|for|there|here|below|above)\b|\s*(?:$|[.,;!?]))"
)
_TOO_IN_OTHERS = re.compile(r"(?<!\w)me (?:queda|va|viene|están?|quedan|van)(?: un poco| muy| algo| bastante)? (?=\w)")
_CLOSE_AROUND = re.compile(
    r"(?P<before>(?:^|(?<=[.;,!?] ))(?:(?:it|it's|its|it is|this|they|they're|is|are|feels?|fits?|still|the \w+) )*)"
    r"(?P<close>tight|snug|close|loose|baggy|saggy) (?=(?:across|round|around|over|under) (?:the|my|her|his) )"
)
"""What is said to be tight around a part of the body is felt to be so, where nobody asks for it."""
_ASKS = re.compile(r"(?<!\w)(?:make|made|want|wants|like|should|be|become|prefer|give|need|needs|have)(?!\w)")


def plainly(text: str, kind: str) -> str:
    """An instruction with such sayings put plainly; the rest as it is.

    Args:
        text: In any case.
        kind: Of the garment that it is about.
    """
    small = text.lower().replace("\u2019", "'")
    if len(small) != len(text):
        return text
    text = _not_there(small) or small
    for pattern, plain, kinds in _compiled():
        if kinds is None or kind in kinds:
            text = pattern.sub(lambda found, plain=plain: _filled(found, plain, kind), text)
    text = _MADE_OF_IT.sub(lambda found: found[0] if _asks_something(found[0]) else "", text)
    text = _LOOKS.sub("", text) if len(re.split(r"[.;,!?]", text)) > 1 else text
    text = _CLOSE_AROUND.sub(lambda found: found[0] if _ASKS.search(found["before"]) else f"{found['before']}too {found['close']} ", text)
    text = _TOO_IN_OTHERS.sub("demasiado ", text)
    return _SAID_TO_BE.sub(_too, text)


def _too(found: re.Match[str]) -> str:
    """What is said to be a bit tight is too tight, where nobody asks that it be so."""
    return found[0] if _ASKS.search(found["before"]) else f"{found['before']}too {found['adjective']}"


def _asks_something(said: str) -> bool:
    return bool(find_changes(said)) or any(p.part != "all" for p in find_parts(said))


def _not_there(text: str) -> str | None:
    """A sentence that ends in "can it not be there", as the removal of what it spoke of last."""
    found = _NOT_THERE.search(text)
    if found is None:
        return None
    before = [p for p in find_parts(text[: found.end()]) if p.part in _CAN_GO]
    own = [p for p in before if p.start >= found.start()]
    if not before:
        return None
    part = (own or before)[-1].part
    return f"{text[: found.start()]} remove the {_NAME_OF.get(part, part)} {text[found.end() :]}".strip()


def _filled(found: re.Match[str], plain: str, kind: str) -> str:
    if "{" not in plain:
        return found.expand(plain)
    groups = found.groupdict()
    side = groups.get("side") or ""
    high = "thigh high" if _HIGH.search(groups.get("to") or "") else ""
    sides = {"left": "on the left", "right": "on the right", "front": "in front", "back": "at the back"}
    if plain.startswith("slit"):
        many = "side slits" if plain.startswith("slits") else f"slit {sides.get(side, sides['left'])}"
        return f"{many}, {high} slits" if high else many
    if plain == "{gone}":
        return f"remove the {groups.get('what') or groups.get('flat')}"
    return plain.format(grip=_GRIP.get(kind, "tighter"), feet=_FEET.get(kind, found[0]), drag=_DRAG.get(kind, "shorten the hem"))


@cache
def _compiled() -> tuple[tuple[re.Pattern[str], str, frozenset[str] | None], ...]:
    return tuple([(re.compile(rf"(?<![\w-]){pattern}"), plain, kinds) for pattern, plain, kinds in _SAYINGS])


_TO = re.compile(
    r"(?<!\w)(?P<part>[^\W\d]+(?: [^\W\d]+)?)(?: (?:width|girth|wide|circumference))?"
    r"(?: (?:down|up|in|out|narrowed|widened|cut|taken|reduced|increased|should be|to be))* (?:to|at|of|=) (?:about |only |just )?$"
)
_STRAPS = re.compile(
    r"(?<!\w)(?P<part>shoulder straps?|straps?)(?:,? (?:about|of|at|only|just|width|wide|should be|to be|be|around|maybe|like|please|are|thin|narrow|broad))*,? $"
)
_BY = re.compile(r" ?(?:wider|narrower|thinner|longer|shorter|more|less|off|in|out|up|down)(?!\w)")
_THINNER = re.compile(r"(?<!\w)(?:thinner|narrower|slimmer|skinnier|smaller)(?!\w)")
_ACROSS = re.compile(r" (?:wide|across|broad|round|around)(?!\w)")
_NARROW_CM = 3.0
"""Straps of less are narrow ones, however narrow they can be cut."""


def with_targets(text: str, kind: str, facts: GarmentFacts) -> str:
    """An instruction in which girths that are to end at a number are to change by the difference.

    Args:
        text: In lower case: "strap width down to half an inch".
        kind: Of the garment.
        facts: Of the garment, which says how wide it is now.
    """
    for mention in reversed([m for m in find_mentions(text) if m.is_length]):
        said = _TO.search(text[: mention.start])
        if said is None and not _BY.match(text, mention.end):
            said = _STRAPS.search(text[: mention.start])
        parts = [p for p in find_parts(said[0]) if p.part != "all"] if said else []
        if said is None or not parts:
            continue
        part = parts[-1]
        steps = [c for c in changes_of(part.part, "width", 1, kind, 1.0) if isinstance(c, Step)]
        if not steps or QUANTITIES[steps[0].quantity].stated is not None:
            continue
        now = QUANTITIES[steps[0].quantity].of(facts)
        if now is None or abs(mention.value - now) < 0.1:
            continue
        way = "wider" if mention.value > now else "narrower"
        plain = f"{part.word} {way} by {abs(mention.value - now):.1f} cm"
        if part.part == "straps" and mention.value < min(_NARROW_CM, now):
            plain = "narrow straps"
        if plain == "narrow straps":
            text = _THINNER.sub(lambda found: " " * len(found[0]), text[: mention.start]) + text[mention.start :]
        behind = _ACROSS.match(text, mention.end)
        text = text[: said.start() + part.start] + plain + text[behind.end() if behind else mention.end :]
    return text
