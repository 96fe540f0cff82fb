"""Whom somebody lets go first, and who goes on after a stop."""

from scegen.scenario.acts import ActKind
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.chunks import Mention, Thing
from scegen.understanding.entity import Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause

_GOES = frozenset({"pass", "cross", "move", "enter", "turn", "walk", "overtake", "merge"})
_ACROSS = frozenset({Approach.LEFT, Approach.RIGHT, Approach.OPPOSITE})
_HOLDING, _NEAR = frozenset({"wait", "stop"}), 5


def let_by(clause: Clause, text: Telling) -> list[Entity]:
    """Whom one lets go first: ``gives way to``, ``lets it pass``, ``stops for``."""
    event = clause.event
    if event.name == "yield":
        return clause.targets or _coming_across(clause, text)
    if event.lemma == "let":
        past = word_list("past_by").intersection(text.context.lows(event.j, event.j + _NEAR))
        return clause.targets if past or any(c.name in _GOES for c in event.children) else []
    if goes_after(clause):
        return _gone_before(clause, text)
    if event.name not in _HOLDING:
        return []
    given = [p for p in event.pps if p.value == "for"]
    named = [p.target for p in given if isinstance(p.target, Mention)]
    if given and not named:  # "waits for a gap in the oncoming traffic"
        named = [p.target for p in event.pps if isinstance(p.target, Mention)]
    awaited = [] if named else _until_gone(clause, text)
    if awaited:
        return awaited
    if not named and event.name == "wait":
        return _coming_across(clause, text)
    return [e for mention in named for e in mention.entities if e not in clause.actors]


def goes_after(clause: Clause) -> bool:
    """Whether somebody goes across, behind whom it lets by or after it."""
    going = all(Maneuver.CROSS in e.maneuvers for e in clause.actors)
    return going and clause.event.name in _GOES


def _gone_before(clause: Clause, text: Telling) -> list[Entity]:
    """``crosses behind the ego``, ``crosses after it has passed``: who crosses lets that one by."""
    backing = text.draft.causing(HazardKind.REVERSING)
    behind = [p.who for p in clause.event.pps if p.value == "behind" and p.who and not p.outer]
    there = [e for m in behind for e in m.entities if e.stands is None and e not in backing]
    for told in [] if there else text.within(*text.bounds(clause.event.i)):
        if told.event.name == "pass" and told.event.perfect and told.event.object is None:
            there += told.actors
    return [e for e in there if e.moving_vehicle and e not in clause.actors]


def _until_gone(clause: Clause, text: Telling) -> list[Entity]:
    """``waits until two cars are through``, ``stops until he has crossed``."""
    event, (_, end) = clause.event, text.bounds(clause.event.i)
    after = (w for w in text.subs if event.j <= w.i < end)
    sub = next((w for w in after if text.tokens[w.i].low in word_list("until")), None)
    between = text.within(event.j, sub.i) if sub is not None else []
    if sub is None or any(s.event.finite for s in between):
        return []
    who = next((m for m in text.mentions if sub.j <= m.i < end and not m.possessor), None)
    if who is None:
        return []
    told = [s.event for s in text.within(sub.j, end) if s.event.finite and s.actors == who.entities]
    if told:
        clears = told[0].lemma == "clear"
        gone = clears or told[0].name in _GOES or (told[0].perfect and told[0].name != "leave")
    else:
        marks = (k for k in range(who.j, end) if text.tokens[k].kind == "punct")
        rest = text.context.lows(who.j, next(marks, end))
        gone = not word_list("past_by").isdisjoint(rest)
    return [e for e in who.entities if gone and e not in clause.actors and not e.still]


def go_on(text: Telling) -> None:
    """Those who stop and go on afterwards wait."""
    kept = text.found.acts
    for stop in [a for a in kept if a.kind is ActKind.STOP and a.entity.is_vehicle]:
        later = [a for a in kept if a.entity is stop.entity and a.i > stop.i]
        same = text.bounds(stop.i)
        letting = [a for a in later if a.kind is ActKind.GIVE_WAY and text.bounds(a.i) == same]
        if letting:
            stop.kind, stop.into, stop.into_basis = ActKind.WAIT, letting[0].into, letting[0].basis
            kept.remove(letting[0])
        elif stop.into is not None or any(a.kind is ActKind.TURN for a in later):
            stop.kind = ActKind.WAIT
    for rest in [a for a in kept if a.kind is ActKind.WAIT]:  # who has paused crosses on
        own = [a for a in kept if a.entity is rest.entity and a.i > rest.i]
        kept[:] = [a for a in kept if a not in own or a.kind is not ActKind.CROSS]
    for act in kept:
        before = act.when.act if act.when is not None else None
        if before is not None and (before not in kept or before.kind is ActKind.GIVE_WAY):
            act.when = None  # that the other goes first says it


def _coming_across(clause: Clause, text: Telling) -> list[Entity]:
    """``a pedestrian crosses, the ego waits``: whoever comes across its way just before."""
    event = clause.event
    other = [p for p in event.pps if p.value != "for" or not isinstance(p.target, Thing)]
    if not all(e.is_vehicle and not e.parked for e in clause.actors) or other or event.object:
        return []  # "waits for a gap" says no more of whom than "waits"
    before = [s for s in text.scenes if s.event.i < event.i]
    before = [s for s in before if event.sentence - s.event.sentence <= 1]
    for told in reversed(before):
        if told.event.negated or told.actors == clause.actors:
            continue
        from_side = any(p.value == "from" and p.names("side") for p in told.event.pps)
        others = [e for e in told.actors if e not in clause.actors]
        meets = [e for e in others if from_side or Maneuver.CROSS in e.maneuvers]
        return meets or [e for e in others if "opposite" in e.dirs]
    seen = [p.entity for p in text.draft.placements if p.approaches <= _ACROSS and not p.reference]
    seen = [e for e in seen if e.moving_vehicle and e not in clause.actors]
    return seen[:1] if event.name == "yield" else []
