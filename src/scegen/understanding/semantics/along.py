"""People on foot who keep to their side of the road."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from scegen.scenario.vocabulary import Maneuver
from scegen.understanding.chunks import Mention, Place, Prep
from scegen.understanding.lexicon import word_list
from scegen.understanding.phrases.which_road import AGAINST, ALONG
from scegen.understanding.semantics.context import Clause, Context

_LEAVING = frozenset({"off", "from"})
_REACH = 24
_WAYS = frozenset({"road", "highway", "side", "shoulder", "lane", "centerline", "middle",
                   "bike_lane"})  # fmt: skip


def _keeps_along(clause: Clause, context: Context) -> bool:
    """``walks along the road``, ``runs down the street``, ``on the pavement``: not across."""
    event = clause.event
    opening = {id(p): context.tokens[p.word.i].low for p in event.pps}
    left = [p.target for p in event.pps if opening[id(p)] in _LEAVING]
    aside = any(p.kind == "sidewalk" and all(p is not n for n in left) for p in clause.places())
    walks = event.name == "walk"
    free = not any(Maneuver.CROSS in e.maneuvers for e in clause.walkers)
    along = (
        (event.name in {"walk", "move"} and any(_lengthwise(p, context) for p in event.pps))
        or (free and event.how(ALONG, AGAINST, "wrong_way") is not None)  # "the way the ego drives"
        or any(_from_or_to_a_vehicle(p, context) for p in event.pps)
        or (walks and _ahead_in_a_lane(event.pps, context))
        or (walks and free and _says(clause, context, word_list("along_the_traffic")))
    )
    over = event.object  # "runs along the road"
    own = context.tokens[event.j - 1].low in word_list("lengthwise")
    along |= own and isinstance(over, Place) and over.kind in _WAYS
    words = {*opening.values(), *(context.tokens[m.j - 1].low for m in event.dirs)}
    return aside or (along and words.isdisjoint(word_list("across")))  # "straight across"


def _ahead_in_a_lane(preps: list[Prep], context: Context) -> bool:
    """``walks ahead of the ego in its lane``."""
    ahead = any((p.word.cat, p.value) == ("locus", "ahead") for p in preps)
    lanes = [p for p in preps if isinstance(p.target, Place) and p.target.kind == "lane"]
    within = any(context.tokens[p.word.i].low == "in" for p in lanes)
    sided = any(p.value == "from" for p in preps)
    return ahead and within and not sided


def _says(clause: Clause, context: Context, phrases: Iterable[str]) -> bool:
    """Whether one of some phrases stands after the verb, before the end of its clause."""
    after = context.lows(clause.event.i, clause.event.i + _REACH)
    end = next((k for k, word in enumerate(after) if word in {".", ";"}), len(after))
    words = f" {' '.join(after[:end])} "
    return any(f" {phrase} " in words for phrase in phrases)


def _from_or_to_a_vehicle(prep: Prep, context: Context) -> bool:
    """``walks away from the ego``, ``runs towards the car``: in its lane, not across."""
    towards = context.tokens[prep.word.i].low in {"towards", "toward", "away"}
    who = prep.target.entities if isinstance(prep.target, Mention) else []
    return towards and any(e.is_vehicle and not e.parked for e in who)


def _lengthwise(prep: Prep, context: Context) -> bool:
    place = prep.target
    if not isinstance(place, Place):
        return False
    along = context.tokens[prep.word.i].low in word_list("lengthwise") and place.kind in _WAYS
    same = place.kind == "direction" and prep.value == "in"  # "in the direction of travel"
    same = same or (prep.value == "with" and "rear" in place.dirs)  # "with its back to the ego"
    edge = place.kind in {"side", "shoulder"} and prep.value == "in" and not place.dirs
    return along or same or edge


FACTS: dict[str, Callable[[Clause, Context], bool]] = {
    "keeps_along": _keeps_along,
    "heads_towards": lambda clause, c: _says(clause, c, word_list("facing")),
    "heads_with": lambda clause, c: _says(clause, c, word_list("with_the_traffic")),
}
"""Words of conditions that ask for a way along the road."""
