"""Texts that ask for something else than clothes for people: coats for dogs, refunds, poems."""

from __future__ import annotations

import re

_BREEDS = (
    r"(?:dachshund|greyhound|whippet|labrador|labradoodle|poodle|spaniel|terrier|chihuahua|pug|bulldog|collie"
    r"|beagle|corgi|cockapoo|schnauzer|shih tzu|lurcher)"
)
_ANIMALS = (
    r"(?:dog|doggy|doggie|puppy|pup|cat|kitten|kitty|pet|horse|pony|donkey|rabbit|bunny|hamster|guinea pig"
    rf"|parrot|ferret|tortoise|lamb|husky|german shepherd|doll|teddy bear|{_BREEDS})"
)
_PETS = r"(?:dog|doggy|doggie|pet|doll)"
"""Whose jumpers are their own; a corgi jumper shows corgis."""
_CLOTHES = (
    r"(?:(?:rain|winter|fleece|knitted|christmas|halloween) ?)?(?:coat|jumper|sweater|jacket|clothes|clothing"
    r"|hoodie|raincoat|rug|bandana|harness)s?(?! (?:print|costume))"
)
"""Costumes, pyjamas and onesies of animals are worn by people, and so are donkey jackets."""


def _any_of(*patterns: str) -> re.Pattern[str]:
    return re.compile(rf"(?<![\w-])(?:{'|'.join(patterns)})(?!\w)", re.IGNORECASE)


_OF_ANIMALS = _any_of(
    rf"{_PETS}(?:['’]?s)? {_CLOTHES}",
    rf"{_ANIMALS}['’]?s? (?:clothes|clothing|rug|harness|bandana)(?! (?:print|costume))",
    rf"{_BREEDS} (?:rain)?coats?",
    rf"for (?:my |our |the |an? |his |her |your )?(?:(?!\w+ing )[\w'’-]+ ){{0,2}}?{_ANIMALS}s?"
    r"(?=\s*(?:[.,;:!?()]|$|(?:who|that|which|called|named|with|she|he)(?!\w)))",
    r"hunde(?:mantel|pullover|jacke|kleidung)",
    r"für (?:meinen?|unseren?|den|die|einen?) (?:\w+ )?(?:hund|kater|katze|dackel|pferd)",
    r"pour (?:(?:mon|ma|un|le|notre) )?(?:petit )?(?:chien|chat|cheval)",
    r"para (?:(?:mi|un|el|nuestro) )?(?:perr|gat|caball)[oa]",
)
_SERVICE = _any_of(
    r"refund|money back|rückgabe|rückerstattung|remboursement|reembolso",
    r"(?:return|exchange|send back) (?:this|these|it|them|my|an?|the)(?! (?:favou?r|call))",
    r"where(?:['’]s| is| are) my (?:order|parcel|package|delivery|refund|stuff)",
    r"track(?:ing)? (?:my|number)|cancel my",
    r"(?:my|your|on|about|for|with) order(?: (?:number|no\.?|nr))? ?#?\d{3,}|order #?\d{3,}",
    r"(?:my|your) (?:order|parcel|delivery) (?:has|hasn|is|was|never|still)|delivery (?:cost|time|to)",
    r"opening hours|discount code|voucher code|customer service|forgot my password",
)
_TALK = _any_of(
    r"(?:write|compose|sing|recite|draft)(?: me| us)? (?:an? |the )?(?:[\w-]+ )?"
    r"(?:poem|song|story|essay|letter|e-?mail|haiku|limerick|rap|cv|speech|code|script)",
    r"tell me (?:an? )?(?:[\w-]+ )?(?:joke|story)|who (?:won|is|was|are|invented)|translate",
    r"what(?:['’]s| is) the (?:weather|time|capital|meaning|score|answer)",
    r"how (?:do|old|far|many|are) (?:i|you|is|people)",
    r"(?:what|which) (?:colou?rs?|styles?|sizes?) (?:suits?|go(?:es)?|should|would|looks?|am|is|do|does|are)",
    r"do you (?:ship|deliver|sell|take|accept|speak|know|like|have)",
    r"are you (?:real|human|an? (?:robot|bot|ai|person))",
    r"how (?:does|do) (?:this|it|that|i use)|how much (?:does|do|is|are|will|would)|what can you (?:do|make)",
    r"(?:make|cook|bake|order|bring)(?: me| us) (?:an? |some )?"
    r"(?:sandwich|coffee|tea|cake|pizza|dinner|lunch|breakfast|website)",
    r"(?:schreib|écris|escribe)\w*(?:-moi)?(?: mir)? (?:ein|un|une) \w+",
)
_AGAIN = _any_of(
    r"(?:than|as|like) (?:the )?(?:last time|before|last one|previous one|previously|my last (?:order|one))",
    r"(?:the )?same (?:again|as (?:last time|before|usual))|(?:the|my) usual",
    r"another (?:one )?(?:like (?:it|that)|please)",
)
"""What speaks of a garment that was had before, and does not name it."""
_STORY = 22
"""Words of a text that may speak of a refund and still wish for a garment."""


def is_for_an_animal(text: str) -> bool:
    """Whether an animal or a doll is to wear it: "a coat for my dachshund"."""
    return _OF_ANIMALS.search(text) is not None


def is_an_errand(text: str, *, names_a_garment: bool) -> bool:
    """Whether it asks for a service or for talk, and for no garment.

    Args:
        text: As it was given.
        names_a_garment: Whether it does; then it is no talk, but may still be about one that was bought.
    """
    if len(text.split()) > _STORY:
        return False
    if _SERVICE.search(text) is not None:
        return True
    return not names_a_garment and any(of.search(text) is not None for of in (_TALK, _AGAIN))
