"""Between whom a distance or a time lies, and when: at the start, the contact, or as one acts."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

from scegen.scenario.acts import ActKind
from scegen.scenario.spacings import CONTACT, LENGTHWISE, START, Measure
from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.amounts.telling import CHANGING, Telling
from scegen.understanding.chunks import Mention, Place
from scegen.understanding.entity import Entity
from scegen.understanding.happenings import Amount, Doing, Since
from scegen.understanding.lexicon import word_list

_AHEAD = {Approach.AHEAD}
_PAIR = 2
_BRACKET = 3


def row_of(figure: Figure) -> list[tuple[Entity, Entity]]:
    """``two cars drive ahead of the ego with 20 m between each``: from one to the next."""
    scene = figure.scene
    column = scene is not None and scene.event.how("row") is not None  # "in a column, 2 s headway"
    if not (column or figure.words_around.opens("in_a_row")):
        return []
    text = figure.text
    own = {id(c.owner) for c in text.chunks if isinstance(c, Place)}  # "in the ego's lane"
    spoken = [m for m in text.mentions if figure.start <= m.i < figure.i and id(m) not in own]
    if figure.words_around.after.startswith(" apart ") and spoken and len(spoken[-1].entities) > 1:
        spoken = spoken[-1:]  # "the ego meets three standing cars, 10 m apart"
    members = list(dict.fromkeys(e for m in spoken for e in m.entities))
    leaders = {
        e: [x for x in members if (x, {Approach.AHEAD}) in text.stand(x, e)] for e in members
    }
    members.sort(key=lambda e: len(leaders[e]), reverse=True)
    pairs = list(pairwise(members))
    known = all(b in leaders[a] for a, b in pairs)
    # or in whichever order: they are alike
    return pairs if known or (not any(leaders.values()) and _in_one_file(members, text)) else []


def each_from(figure: Figure) -> tuple[list[tuple[Entity, Entity]], list[Amount]]:
    """``they are 20 m and 45 m ahead``: each of two so far from a third, by a number of its own."""
    text, quantity = figure.text, figure.quantity
    named = (figure.subject, figure.actors, text.spoken_of(figure.start, figure.i))
    who = next((w for w in named if len(w) == len(quantity.parts)), [])
    other = next((e for e in (*text.named(figure.noun), text.ego) if e not in who), None)
    if other is None or not quantity.joined:
        return [], []
    each = (replace(figure.amount, value=part.value) for part in quantity.each(len(who)))
    return [(entity, other) for entity in who], list(each)


def _in_one_file(members: list[Entity], text: Telling) -> bool:
    """``three cars stand in the ego's lane``: one behind the other, the first named in front."""
    ego = text.ego
    if ego in members or len({e.kind for e in members}) != 1:
        return False
    if not all((e, _AHEAD) in text.stand(e, ego) or e.stands for e in members):
        return False
    for leader, follower in pairwise(members):
        text.draft.place(leader, follower, {Approach.AHEAD}, leader.basis)
    return True


def pair_of(figure: Figure) -> tuple[Entity, Entity] | None:
    """Who lies how far from whom."""
    text, noun, subject = figure.text, figure.noun, figure.subject
    ending = text.found.ending
    if figure.role == "overlap" and ending is not None and len(ending.between) == _PAIR:
        return ending.between[0], ending.between[1]  # of those who touch
    if " the next " in f"{' '.join(figure.words_around.after.split()[:4])} ":
        return None  # "each 3 m clear of the next"
    if (meeting := before_they_meet(figure)) is not None:
        return (meeting[0], meeting[1]) if len(meeting) > 1 else None
    named = text.named(noun) if noun is None or not noun.possessed else []
    word = figure.after[0] if figure.after is not None else None
    located = word is not None and word.cat == "locus"
    before = [m for m in text.mentions if m.i < figure.i]
    holds = ((m, p) for m in text.mentions for p in m.pps if located and p.word is word)
    holder = [m for m, p in holds if p.fronted or m.i < figure.i]  # "10 m ahead of it a bus"
    if holder and len(holder[0].entities) == 1 and named:
        subject = holder[0].entities  # "beside a van which is 60 m ahead of the ego": the van
    for scene in text.within(figure.start, figure.i) if located else []:
        out = any(p.outer == "from" or p.value == "between" for p in scene.event.pps)
        if out and any(p.word is word and p.on_mention is None for p in scene.event.pps):
            subject = scene.actors or subject  # "steps out from behind a van 20 m ahead of the ego"
    pronoun = isinstance(noun, Mention) and noun.pronoun is not None
    named = [] if pronoun and named == subject else named  # "and the ego, 15 m behind it"
    pairs = [m.entities for m in before if len(m.entities) == _PAIR]
    between = two_between(figure) or (pairs[-1:] if figure.led_by == "apart" else [])
    if between:
        return between[-1][0], between[-1][1]
    bracketed = _bracketed(figure)
    if bracketed is not None and subject and bracketed not in subject:
        return subject[0], bracketed
    by_verb = figure.role in {"overlap", "headway", "ttc"} or not (named or located)
    # "follows a car 30 m behind it", "follows a truck 25 m in front of it"
    by_verb = by_verb or (pronoun and figure.does == "follow")
    targets = figure.scene.targets if figure.scene is not None else []
    if by_verb and figure.actors and targets:
        if figure.role == "lateral_offset" and subject == targets[:1]:
            return targets[0], figure.actors[0]  # "approaches a van offset by 0.3 m"
        told = [e for e in figure.actors if subject == [e]]  # "one 15 m and the other 40 m behind"
        return (told or figure.actors)[0], targets[0]
    subject = [e for e in subject if e not in named] or [e for e in figure.actors if e not in named]
    if subject and named and (located or figure.role != "overlap"):
        return subject[0], named[0]
    first = subject[0] if subject else named[0] if named else text.ego
    other = text.counterpart(first, text.spoken_of(0, figure.i))
    return (first, other) if other is not None and other is not first else None


def two_between(figure: Figure) -> list[list[Entity]]:
    """``45 m remain between the van and the car``, ``the gap between them is 45 m``: the pair."""
    tokens, extents = figure.text.tokens, word_list("lies_between")
    mentions = [m for m in figure.text.mentions if figure.start <= m.i < figure.end]
    opened = ((m, m.prep.i) for m in mentions if m.prep and tokens[m.prep.i].low == "between")
    first = next((m for m, k in opened if k == figure.j or tokens[k - 1].low in extents), None)
    who = [e for m in mentions if first in (m, m.joined) for e in m.entities] if first else []
    return [who] if len(who) == _PAIR else []


def before_they_meet(figure: Figure) -> list[Entity] | None:
    """``3 s before it would hit a van``, ``before reaching it``, ``before we meet``: those who do.

    However many the clause names; None where no clause says so.
    """
    if figure.role != "ttc" or not figure.words_around.after.startswith(" before "):
        return None
    following = (s for s in figure.text.scenes if s.event.i > figure.i)
    meets = next((s for s in following if s.event.name in {"collide", "approach"}), None)
    if meets is None or not (meets.targets or meets.event.name == "approach"):
        return None
    return list(dict.fromkeys([*meets.actors, *meets.targets, *figure.actors]))


def _bracketed(figure: Figure) -> Entity | None:
    """``in front of a stationary target (TTC 3 s)``: to whom it is."""
    tokens = figure.text.tokens
    near = range(figure.i - 1, max(-1, figure.i - 1 - _BRACKET), -1)
    opening = next((k for k in near if tokens[k].low == "("), -1)
    before = [m for m in figure.text.mentions if m.j == opening and m.entities]
    first: Entity | None = before[0].entities[0] if before else None
    return first


def tell_order(figure: Figure, measure: Measure, one: Entity, other: Entity) -> None:
    """``15 m behind``: who is said to be there, if no place of the two is said.

    Who changes lanes "15 m ahead" comes there by that; "15 m before a van" it goes from behind.
    Of "ego and target at 50 km/h, gap 12 m" the target is ahead.
    """
    way = {" behind ": Approach.BEHIND, " ahead ": Approach.AHEAD, " in front ": Approach.AHEAD}
    way |= {} if other.ego else {" before ": Approach.BEHIND}
    said = next((a for w, a in way.items() if figure.words_around.after.startswith(w)), None)
    vehicles = one.is_vehicle and other.is_vehicle and not (one.parked or other.parked)
    comes = {Maneuver.LANE_CHANGE} if figure.led_by != "before" else set()
    sideways = {Maneuver.CROSS, *comes} & (one.maneuvers | other.maneuvers)
    draft, basis = figure.text.draft, figure.amount.basis
    if said is not None and vehicles and not sideways and not figure.text.stand(one, other):
        draft.place(one, other, {said}, basis)
    two = [e for e in (one, other) if not e.ego]
    if measure not in LENGTHWISE or len(two) != 1 or not two[0].is_vehicle:
        return
    entity = two[0]
    placed = any(entity in (p.entity, p.reference) or p.entity.ego for p in draft.placements)
    beside = bool(entity.maneuvers & {Maneuver.LANE_CHANGE, Maneuver.CROSS})
    if not (placed or figure.text.context.meeting or beside or entity.parked or entity.heading):
        reason = "a gap along the road is one to who is ahead"
        draft.place(entity, None, {Approach.AHEAD}, basis.because(reason))


_ANSWERING = frozenset({ActKind.BRAKE, ActKind.STOP, ActKind.CHANGE_LANE})
_INTO = frozenset({ActKind.CHANGE_LANE, ActKind.OVERTAKE, ActKind.SWERVE, ActKind.CROSS,
                   ActKind.OPEN_DOOR})  # fmt: skip
_BEGINNING = frozenset({"try", "light", "inert"})
"""``starts to brake``: what is begun is told after it."""


def moment(figure: Figure, measure: Measure, one: Entity, other: Entity) -> Doing | str:
    """An act, the contact or the start."""
    if measure is Measure.OVERLAP_PERCENT:
        return CONTACT
    text, start = figure.text, figure.start
    acts = [a for a in text.found.acts if a.entity in (one, other)]
    if measure is Measure.LATERAL_GAP_M:
        passing = [a for a in acts if a.kind is ActKind.OVERTAKE and start <= a.i < figure.end]
        return passing[-1] if passing else START
    begun = _as_it_begins(figure, acts)
    starts = text.find("starts", start, figure.end) and not begun
    if measure not in LENGTHWISE or starts:
        return START
    own = figure.verb
    told = {own.i} if own is not None and own.i < figure.i else set()
    into = (
        begun[-1:]
        or [a for a in acts if a.kind in _INTO and told & a.places]
        or [a for a in acts if _in_trigger(a, figure)]
        or _revealed_by(figure, one, other)
        or _of_its_doer(figure, acts)
        or [a for a in _opens_with(figure, acts) if _goes_in(a)]
    )
    if into:
        return into[0]  # "when it has passed it moves in 15 m ahead of the ego"
    here = [a for a in acts if any(start <= i < figure.i for i in a.places)]
    here_into = [a for a in here if _goes_in(a)]
    if not here_into:  # "brakes at a TTC of 3 s", "brakes with 6 m/s² 20 m ahead of the ego"
        then = [a for a in here if told & a.places] or _opens_with(figure, acts)
        here_into = [a for a in then if measure is Measure.TTC_S or a.kind in CHANGING]
    return here_into[-1] if here_into else _until_it_brakes(text, one, other, acts)


def _goes_in(doing: Doing) -> bool:
    """Whether one comes where the other drives: a gap is one as it begins to."""
    return doing.kind in _INTO or (doing.kind is ActKind.SET_OFF and doing.entity.pulls_out)


def _until_it_brakes(text: Telling, one: Entity, other: Entity, acts: list[Doing]) -> Doing | str:
    """Between two who are as fast: as far as when the one in front brakes."""
    unequal = one.speed is not None and other.speed is not None and one.speed != other.speed
    if unequal or any(e.still or not e.is_vehicle for e in (one, other)):
        return START
    leader = text.in_file(one, other)[1]
    later = next((a for a in acts if a.kind in _ANSWERING and a.always), None)
    return later if later is not None and later.entity is leader else START


def _opens_with(figure: Figure, acts: list[Doing]) -> list[Doing]:
    """``at a TTC of 2 s the lead car brakes``, ``10 m ahead of the ego a van swerves``: then."""
    text = figure.text
    if any(figure.start <= m.i < figure.i for m in text.mentions):
        return []
    told = [c.event for c in text.within(figure.j, figure.end) if not c.event.embedded]
    told = [e for e in told if e.finite or e.form != "ing"]  # "of a van standing there the ego …"
    verbs = [event.i for event in told if event.name not in _BEGINNING]
    return [a for a in acts if a.places & {*verbs[:1]}]


def _as_it_begins(figure: Figure, acts: list[Doing]) -> list[Doing]:
    """``20 m at the start of its lane change``, ``the gap is 20 m then``: those told before."""
    text = figure.text
    if text.find("at_that_moment", figure.start, figure.end):
        return [a for a in acts if a.i < figure.start and not text.acts(figure.start, figure.end)]
    at, end = text.find("onsets", figure.start, figure.end) or (0, 0)
    named = text.within(end, end + 3) or text.find("manoeuvres", at, end + 3)
    return [a for a in acts if a.i < at] if named else []


def _of_its_doer(figure: Figure, acts: list[Doing]) -> list[Doing]:
    """``a van, 40 m ahead and doing 100 km/h, moves into our lane``: as it begins to do so."""
    text = figure.text
    if figure.after is None or text.within(figure.start, figure.i):
        return []
    named = text.spoken_of(figure.start, figure.i)
    over = [a for a in acts if a.kind is ActKind.CHANGE_LANE and a.i > figure.j]
    return [a for a in over if named[:1] == [a.entity] and a.i < figure.end][:1]


def _in_trigger(doing: Doing, figure: Figure) -> bool:
    """``… is 150 m away when the ego pulls out``: at that moment."""
    for told in doing.places:
        clause = figure.clause_of(told)
        if clause is None or not figure.start <= told < figure.end:
            continue
        if not clause[0] <= figure.i < clause[1] and clause[2] in word_list("triggers"):
            return True
    return False


def since(text: Telling, at: Doing | str, one: Entity, other: Entity) -> Since:
    """``when it has changed lanes``; what somebody reveals who leaves the lane."""
    if not isinstance(at, Doing) or at.kind is not ActKind.CHANGE_LANE:
        return "begin"
    over = any(s.event.perfect and s.event.i in at.places for s in text.scenes)
    return "end" if over or at.entity not in (one, other) else "begin"


def _revealed_by(figure: Figure, one: Entity, other: Entity) -> list[Doing]:
    """``the car ahead changes lanes and reveals a truck 60 m ahead``: as it has done so."""
    if not (one.still or other.still) or not (one.ego or other.ego):
        return []
    text = figure.text
    ahead = [
        a
        for a in text.acts(0, figure.end, {ActKind.CHANGE_LANE})
        if a.entity not in (one, other) and a.into is None
        if text.context.placed(a.entity, Approach.AHEAD)
    ]
    return ahead if len(ahead) == 1 and ahead[0].when is None else []
