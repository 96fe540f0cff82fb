"""``a woman opens the door of a parked car``, ``gets out of a taxi``: their vehicle opens it."""

from __future__ import annotations

from scegen.understanding.chunks import Event, Mention
from scegen.understanding.words.tokens import Token

_OPENS = frozenset({"door", "alight"})
_DOORED = frozenset({"car", "van", "truck", "emergency_vehicle"})
_PEOPLE = frozenset({"driver", "pedestrian", "rider"})


def open_from_inside(events: list[Event], tokens: list[Token]) -> None:
    """Makes the vehicle the one whose door opens, and people nobody who do nothing else.

    That is before it is decided whom their nouns mean.
    """
    for event in events:
        around = _around(event, tokens)
        people = [m for m in event.subject if is_somebody(m)]
        if around is None or not people or len(people) < len(event.subject):
            continue
        event.name, event.object = "door", None
        event.pps = [p for p in event.pps if p.target is not around]
        if around.possessed:
            around.same_as, people[-1].drives = people[-1], True
            continue  # "his van": he stands for it
        event.subject = [around]
        besides = {id(m) for e in events for m in e.subject}
        for who in people:
            who.negated = who.negated or id(who) not in besides
    for event in (e for e in events if e.name in _OPENS):
        _on_a_side(event)


def is_somebody(mention: Mention) -> bool:
    """Whether a noun names somebody, and no vehicle ("a driver", "a woman")."""
    return any(h.value in _PEOPLE for h in mention.heads)


def _on_a_side(event: Event) -> None:
    """``on the traffic side``: the side of the vehicle, not of the road."""
    on = [p for p in event.pps if p.names("side")]
    for who in event.subject:
        named = [(p, p.place.mods) for p in who.pps if p.place is not None]
        of_body = [p for p, mods in named if any("of_body" in m.data for m in mods)]
        who.pps = [p for p in who.pps if p not in of_body]
        on += of_body
    event.pps = [p for p in event.pps if p not in on]
    places = [p.place for p in on if p.place is not None]
    event.mods += [m for place in places for m in place.mods if m.cat == "dir"]
    event.j = max([event.j, *(place.j for place in places)])


def _around(event: Event, tokens: list[Token]) -> Mention | None:
    """The vehicle out of which somebody comes, or whose door somebody opens."""
    if event.nominal or event.passive or event.negated:
        return None
    targets: list[object] = [event.object] if event.lemma == "exit" else []
    for prep in event.pps:
        out = "out" in {tokens[event.j - 1].low, tokens[prep.word.i].low}
        opens = event.name in _OPENS and prep.value in {"of", "in", "from"}
        if opens or (out and prep.value in {"of", "in"}):
            targets.append(prep.target)
    if tokens[event.j - 1].low == "of" or event.name == "alight":
        targets.append(event.object)  # "jumps out of a van", "gets off the bus"
    return next((t for t in targets if isinstance(t, Mention) and _doored(t)), None)


def _doored(vehicle: Mention) -> bool:
    """Whether it has a door of its own that opens into the traffic: no bus, no train."""
    head = vehicle.head
    return head is not None and head.value in _DOORED and head.form != "s" and not vehicle.is_ego
