"""Numbers of what takes no part: ``the wind speed is 15 m/s``, ``an exit is 300 m ahead``."""

from scegen.understanding.amounts.figures import Figure, has_a_size
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Thing
from scegen.understanding.lexicon import word_list

INSTEAD = "it is said of what takes no part; left out"


def of_something_else(figure: Figure) -> bool:
    """Whether the words that lead up to a number name something else, and nobody.

    Phrases do so that name no measure: "in a wind of 15 m/s", not "at a minimum gap of 20 m".
    """
    if figure.role not in word_list("of_somebody"):
        return False
    text, known, foreign, apart = figure.text, False, False, False
    acting = {s.event.i for s in text.scenes if s.actors or s.event.nominal}
    for chunk in reversed([c for c in text.chunks if figure.start <= c.i < figure.i]):
        if isinstance(chunk, Event) and chunk.i in acting:
            return False
        if chunk.cat == "rel" or (isinstance(chunk, Mention) and chunk.entities):
            return False
        if text.find("its_own", chunk.i, chunk.j):
            return False  # "my speed was …"
        opens = chunk.value == "(" or (chunk.cat == "prep" and chunk.value not in {"of", "for"})
        apart = apart or (opens and not foreign)
        if chunk.value == ":" and apart:
            return False  # "a first case: at 10 km/h the ego …"
        if chunk.cat == "conj" or chunk.value == "," or (chunk.value == ":" and known | foreign):
            break
        if foreign and opens and not (known or apart):
            break
        noun = _noun(chunk, figure)
        known = known or isinstance(chunk, Thing) or bool(noun & word_list("of_whoever"))
        foreign = foreign or not noun <= word_list("of_whoever") | word_list("fillers")
    return foreign and not (apart and _in_a_title(figure))


def _in_a_title(figure: Figure) -> bool:
    """``CCRs at 50 km/h: the ego …``: nothing that has a speed of its own is named."""
    text = figure.text
    named = [c for c in text.chunks if figure.start <= c.i < figure.i and _noun(c, figure)]
    ends = figure.role == "speed" and text.low(figure.j, figure.j + 1) == " : "
    return ends and all(not text.tokens[c.j - 1].text[1:].islower() for c in named)  # "CCRs"


def _noun(chunk: Chunk, figure: Figure) -> set[str]:
    """The words of what may have a number of its own, if it does."""
    place = isinstance(chunk, Place) and chunk.prep is None and chunk.owner is None
    named = place and figure.role not in {"speed", "rate"}
    named = named or (isinstance(chunk, Thing) and not has_a_size(chunk))
    named = named or chunk.cat in {"unknown", "noted"}
    named = named or (isinstance(chunk, Mention) and figure.role == "duration")
    at = chunk.head if isinstance(chunk, Thing) and chunk.head is not None else chunk
    return {t.low for t in figure.text.tokens[at.i : at.j]} if named else set()
