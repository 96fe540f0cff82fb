"""Applies the rows of meaning to the nouns and verbs of a text, in their order."""

from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.chunks import Chunk, Event, Mention, Place, Prep, Thing
from scegen.understanding.clauses.located import own_lane
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.lexicon import word_list
from scegen.understanding.meaning import placing
from scegen.understanding.meaning.lights import read_lights
from scegen.understanding.meaning.manner import (
    jam,
    mark_answers,
    mark_late,
    note_braking,
    out_of_turn,
    told_by,
    told_with,
)
from scegen.understanding.meaning.roadside import read_thing
from scegen.understanding.phrases.listed import each_side, from_everywhere
from scegen.understanding.semantics.context import (
    Clause,
    Context,
    clause_of,
    clause_of_noun,
    stray_clauses,
    without_nouns,
)
from scegen.understanding.semantics.met import driven_up_to
from scegen.understanding.semantics.rows import say
from scegen.understanding.words.quantities import ends_a_quantity

_BESIDE = frozenset({"overtake", "pass", "bypass", "undertake", "collide"})
"""With these verbs a side is where one gets past or is hit, and nobody comes from there."""
_INTO = frozenset({"lane_change", "cut_in", "cut_off", "merge"})
_LONGEST = 4
"""Words of a conjunction."""
_ASIDE = frozenset({Maneuver.LANE_CHANGE, Maneuver.OVERTAKE})
_PASSING = frozenset({"bypass", "overtake", "block"})
_PAIR = (Approach.LEFT, Approach.RIGHT)
_ALL_TOLD = (
    ("nouns.strips", "nouns own"),
    ("nouns.hider", "verbs nouns"),
    ("nouns.hidden", "nouns verbs"),
    ("nouns.past", "everybody verbs nouns strays"),
    ("positions.any", "verbs"),
    ("positions.up_to", "verbs"),
    ("nouns.place", "nouns strays own"),
    ("nouns.text", "everybody"),
    ("positions.after_all", "everybody"),
    ("nouns.stray", "strays"),
    ("nouns.ways", "verbs"),
    ("movements.to_the_kerb", "verbs"),
    ("nouns.crossed", "verbs nouns"),
)
"""Families asked once everything that happens is known, each of which clauses."""


def interpret(chunks: list[Chunk], events: list[Event], context: Context) -> list[Clause]:
    """Turns events and mentions into statements about the scenario.

    Returns:
        What happens; first who is parked, as where they stand is known to all.
    """
    of_verbs = {
        id(p)
        for e in events
        for p in e.pps
        if _is_of_the_verb(p, e, context.draft.kerb) or _gone_to(p, e, context)
    }
    of_verbs |= {id(p) for c in chunks if isinstance(c, Mention) for p in _then(c, events, context)}
    context.told_in_the_past = any(  # "is hit" tells of now, "was driving" of then
        (e.finite and e.form == "ed" and e.name != "stop" and not e.passive)
        or (e.form in {"ing", "base"} and word_list("was") & {*context.lows(e.i - 3, e.i)})
        for e in events
    )
    told = [clause_of(e) for e in events]
    of_nouns = {id(c): clause_of_noun(c) for c in chunks if isinstance(c, Mention)}
    nouns = list(of_nouns.values())
    for clause in told:
        say("movements.sets_off", clause, context)
    note_braking(told, context)
    for clause in (*nouns, *map(without_nouns, told)):
        say("nouns.numbered", clause, context)
    _named(chunks, events, of_nouns, of_verbs, context)
    mark_answers(events)
    mark_late(events, context)
    placing.line_up(chunks, events, context.draft)
    clauses = sorted(told, key=lambda clause: not clause.tells_parked)
    for clause in clauses:
        _event(clause, context)
    read_lights(clauses, chunks, context)
    out_of_turn(chunks, events, context)
    context.barred |= any(c.event.name in _PASSING for c in clauses)
    of = {
        "everybody": [Clause(Event("", 0, 0, ""), list(context.draft.entities), [])],
        "verbs": clauses,
        "own": [without_nouns(clause) for clause in clauses],
        "nouns": nouns,
        "strays": list(stray_clauses(chunks, [*nouns, *clauses])),
    }
    for family, among in _ALL_TOLD:
        for clause in [c for name in among.split() for c in of[name]]:
            say(family, clause, context)
    return clauses


def _gone_to(prep: Prep, event: Event, context: Context) -> bool:
    """``10 m in front of it, a van changes lanes``, ``… comes from the left``: not there before."""
    comes = any(p.value == "from" and isinstance(p.target, Place) for p in event.pps)
    far = event.name in _INTO and ends_a_quantity(context.tokens, prep.word.i) is not None
    return prep.fronted and prep.value == "ahead" and (comes or far)


def _then(who: Mention, events: list[Event], context: Context) -> list[Prep]:
    """``cuts in when it is 10 m in front``, ``passes; when level with it, …``: not before."""
    there = [p for p in who.pps if p.predicate and p.value in {"ahead", "adjacent"}]
    told = [e for e in events if e.i < who.i] if there else []
    into = [e for e in told[-1:] if e.name in word_list("underway") | _INTO]
    doers = {e for event in (*into, *told) if event in into or event.name in {*_PASSING, "pass"}
             for e in event.doers}  # fmt: skip
    begins = range(max(0, who.i - _LONGEST), who.i)
    opened = {" ".join(context.lows(k, who.i)) for k in begins}
    when = opened & (word_list("triggers") | word_list("at_a_change"))
    return there if when and doers & {*who.entities} else []


def _named(
    chunks: list[Chunk],
    events: list[Event],
    of_nouns: dict[int, Clause],
    of_verbs: set[int],
    context: Context,
) -> None:
    """What nouns say, and the things on and beside the road."""
    handled = {
        id(e.object) for e in events if e.name in {"inert", "send"} and not e.passive
    }  # "kicks a ball"
    idle = {"hide", "collide", "light"}  # "a jam begins there", but not "begins to move"
    acting = {id(m) for e in events for m in e.subject if e.name not in idle or e.children}
    for k, chunk in enumerate(chunks):
        if isinstance(chunk, Mention) and chunk.entities:
            _mention(chunk, of_nouns[id(chunk)], of_verbs, context)
            if id(chunk) not in acting:
                jam(chunk, context)
                say("nouns.idle", of_nouns[id(chunk)], context)
        elif isinstance(chunk, Thing) and id(chunk) not in handled:
            read_thing(chunk, k, chunks, context.draft)
            context.screens += [chunk.i] if chunk.kind == "object" else []
            context.barred |= chunk.lies_there


def _mention(mention: Mention, clause: Clause, of_verbs: set[int], context: Context) -> None:
    placing.adjectives(mention, context)
    say("nouns.noun", clause, context)
    sides = [p for p in mention.pps if p.value in {"from", "in"} and p.names("side")]
    comes = any(p.value == "from" for p in sides)
    for prep in mention.pps:
        if id(prep) in of_verbs or (comes and prep.value == "to" and prep.names("side")):
            continue  # "a pedestrian from left to right": it comes from the left
        if prep.value == "from" and each_side(prep) and len(mention.entities) > 1:
            _spread(prep, mention.entities, context)
            continue
        if prep.value == "behind" and prep.target is None:
            first = placing.before_in_row(mention, context)
            context.ahead(first, mention.entities, Basis(prep.word.i, prep.word.j))
            if first:
                continue
        shared = len(sides) == len(mention.entities) > 1 and prep in sides
        whom = [mention.entities[sides.index(prep)]] if shared else mention.entities
        placing.phrase(prep, whom, None, context)
    for term in mention.mods:
        told_by(term, mention.entities, context)
    say("nouns.named", clause, context)


def _event(clause: Clause, context: Context) -> None:
    event = clause.event
    say("dangers.move_off", clause, context)
    say("constructions.any", clause, context)
    say("standing.any", clause, context)
    _places(clause, context)
    say("positions.access", clause, context)
    failed = event.parent is not None and event.parent.name == "fail"
    say("dangers.answered", clause, context)
    if event.negated or failed or event.name == "overlook":
        say("omissions.any", clause, context)
        return
    say("dangers.unnamed", clause, context)
    say("dangers.drives_on", clause, context)
    told_with(clause, context)
    say(f"movements.{event.name}", clause, context)
    say("dangers.onto_the_road", clause, context)
    say("dangers.after_a_thing", clause, context)
    say(f"dangers.{event.name}", clause, context)
    say("dangers.oncoming", clause, context)
    say("dangers.from_behind", clause, context)
    say("positions.first", clause, context)


def _places(clause: Clause, context: Context) -> None:
    """Where the phrases of a verb put those who act, or on whom it is done."""
    event = clause.event
    say("positions.from_the_side", clause, context)
    aside = any(_ASIDE & e.maneuvers for e in clause.actors)  # "changes left and stays there"
    arrived = word_list("ending_up") | (word_list("keeping") if aside else frozenset())
    ends = event.name == "move" and event.lemma in arrived
    met = clause.targets or driven_up_to(clause, context)
    for prep in event.pps if not ends else []:
        basis = Basis(prep.word.i, prep.word.j)
        if from_everywhere(prep):
            _spread(prep, clause.actors, context)
        elif _from_behind(prep) and event.name in word_list("underway") and met:
            context.ahead(met[:1], clause.actors, basis)
        elif prep.on_mention is None or _starts(event, prep):
            turned = event.passive and event.name != "hide"
            turned = turned and prep.value not in {"behind", "from"}
            whom = clause.targets if turned else clause.actors
            placing.phrase(prep, whom, event, context)


def _spread(prep: Prep, actors: list[Entity], context: Context) -> None:
    """``from all directions``: one to each arm; ``from each side``: one to each of two."""
    basis = Basis(prep.word.i, prep.target.j if prep.target is not None else prep.word.j)
    arms = context.junction.arms or max(len(actors), 1)
    for number, entity in enumerate(actors):
        if not each_side(prep):
            entity.entries, entity.entry_basis = {number % arms}, basis
        elif number < len(_PAIR):
            context.draft.place(entity, None, {_PAIR[number]}, basis)


def _is_of_the_verb(prep: Prep, event: Event, kerb: str) -> bool:
    """``approaches the ego from the left``: not the ego comes from there."""
    who = prep.on_mention
    met = any(p.value in {"into", "with"} and p.target is who for p in event.pps)
    if met and _from_behind(prep):  # "runs into the van from behind"
        return True
    beside = event.name in _BESIDE and prep.names("side", "shoulder") and not _met_there(prep)
    beside = beside and prep.value != "from" and not _stands_there(prep, event, kerb)
    of_verb = beside or _starts(event, prep) or own_lane(event, prep)
    return who is event.object and of_verb


def _stands_there(prep: Prep, event: Event, kerb: str) -> bool:
    """``passes a parked van on the right``: at the kerb, not the side on which one passes it.

    Who "drives past a parked van on the left" passes it on neither.
    """
    who, side = prep.on_mention, prep.place
    parked = who is not None and all(e.parked for e in who.entities)
    past = event.name == "bypass" or any("passes" in p.word.data for p in event.pps)
    return parked and side is not None and (kerb in side.dirs or past)


def _met_there(prep: Prep) -> bool:
    """``hits a cyclist on its right``: where one is who was not told of before."""
    who, side = prep.on_mention, prep.place
    new = who is not None and who.has("det", "indef")
    return new and side is not None and side.head is None and side.has("possessive")


def _from_behind(prep: Prep) -> bool:
    """``hits the van from behind``: behind the van."""
    return prep.outer == "from" and prep.value == "behind" and prep.target is None


def _starts(event: Event, prep: Prep) -> bool:
    """``overtakes the bus from the left`` says where the one who moves comes from.

    So does "crosses the path of the bus from the left"; the ego hits "a car from the left".
    Verbs without a way of their own leave the phrase to the noun ("yields to a bus from …").
    """
    named = prep.on_mention
    target = named is not None and named not in event.subject and bool(named.entities)
    goal = event.object.owner if isinstance(event.object, Place) else event.object
    moved = event.name in word_list("underway") and (goal is None or named in (goal, event.object))
    sided = prep.place is not None and bool({"left", "right"} & {*prep.place.dirs})
    new = event.name == "collide" and named is not None and not named.has("det", "def")
    its = sided and new and all(e.ego for e in event.doers)
    moved = moved and event.lemma != "meet" and not its
    source = prep.value == "from" or (prep.outer == "from" and prep.target is None)
    return source and not (target and not moved)
