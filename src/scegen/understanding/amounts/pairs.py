"""Between whom a distance or a time lies, and who of two is said to be in front."""

from dataclasses import replace
from itertools import pairwise

from scegen.scenario.spacings import LENGTHWISE, Measure
from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.chunks import Mention, Place
from scegen.understanding.entity import Entity
from scegen.understanding.happenings import Amount
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.terms import Term

_AHEAD = {Approach.AHEAD}
_ACROSS = {Approach.LEFT, Approach.RIGHT, Approach.OPPOSITE}
_PAIR = 2
_BRACKET = 3


def row_of(figure: Figure) -> list[tuple[Entity, Entity]]:
    """``two cars drive ahead of the ego with 20 m between each``: from one to the next."""
    scene = figure.scene
    column = scene is not None and scene.event.how("row") is not None  # "in a column, 2 s headway"
    each = figure.words_around.opens("in_a_row") or figure.words_around.opens("gaps")
    each |= figure.words_around.closes("one_to_the_next") and not figure.quantity.joined
    if not (column or each):
        return []
    text = figure.text
    own = {id(c.owner) for c in text.chunks if isinstance(c, Place)}  # "in the ego's lane"
    spoken = [m for m in text.mentions if figure.start <= m.i < figure.i and id(m) not in own]
    if not spoken:  # "three cars drive in a row. The gaps are 15 m"
        spoken = [m for m in text.mentions if m.i < figure.i and len(m.entities) > 1][-1:]
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
    """``they are 20 m and 45 m ahead``: each of two so far from a third, by a number of its own.

    In "the gaps are 20 m and 45 m" those in front are so far from one another.
    """
    text, quantity = figure.text, figure.quantity
    spoken = text.spoken_of(figure.start, figure.i)
    others = [e for e in spoken or text.draft.entities if not e.ego]
    named = (figure.subject, figure.actors, spoken, others)
    who = next((w for w in named if len(w) == len(quantity.parts)), [])
    other = next((e for e in (*text.named(figure.noun), text.ego) if e not in who), None)
    if other is None or not quantity.joined:
        return [], []
    ahead = [e for e in who if (e, _AHEAD) in text.stand(e, other)]
    following = list(pairwise(ahead if figure.words_around.closes("one_to_the_next") else []))
    for near, far in following:
        text.draft.place(far, near, _AHEAD, figure.amount.basis)
    nearer = {far: near for near, far in following}
    each = (replace(figure.amount, value=part.value) for part in quantity.each(len(who)))
    return [(entity, nearer.get(entity, other)) for entity in who], list(each)


def _in_one_file(members: list[Entity], text: Telling) -> bool:
    """``three cars stand in the ego's lane``: one behind the other, the first named in front."""
    ego = text.ego
    if not all((e, _AHEAD) in text.stand(e, ego) or e.stands for e in members):
        return False
    for leader, follower in pairwise(members):
        text.draft.place(leader, follower, {Approach.AHEAD}, leader.basis)
    return True


def pair_of(figure: Figure) -> tuple[Entity, Entity] | None:
    """Who lies how far from whom."""
    text, noun, subject = figure.text, figure.noun, figure.subject
    if figure.words_around.opens("from_each"):
        return None  # "each 3 m clear of the next", "with gaps of 20 m each"
    if (meeting := before_they_meet(figure)) is not None:
        return (meeting[0], meeting[1]) if len(meeting) > 1 else None
    named = text.named(noun) if noun is None or not noun.has("possessive") else []
    word = figure.after[0] if figure.after is not None else None
    located = word is not None and word.cat == "locus"
    before = [m for m in text.mentions if m.i < figure.i]
    holder = _placed_there(figure, word) if located else []
    if len(holder) == 1 and named:
        subject = holder  # "beside a van which is 60 m ahead of the ego": the van
    for scene in text.within(figure.start, figure.i) if located else []:
        out = any(p.outer == "from" or p.value == "between" for p in scene.event.pps)
        if out and any(p.word is word and p.on_mention is None for p in scene.event.pps):
            subject = scene.actors or subject  # "steps out from behind a van 20 m ahead of the ego"
    pronoun = isinstance(noun, Mention) and noun.pronoun is not None
    named = _by_a_pronoun(named, subject, figure) if pronoun else named
    pairs = [m.entities for m in before if len(m.entities) == _PAIR]
    between = two_between(figure) or (pairs[-1:] if figure.led_by == "apart" else [])
    between = between or ([] if named or located else _brought_in(figure))
    if between:
        return between[-1][0], between[-1][1]
    near = [m for m in before if m.j == figure.i - 1 and m.prep and m.prep.cat == "locus"]
    if near and subject and not located and subject != near[0].entities:
        return subject[0], near[0].entities[0]  # "the ego behind the van at 0.9 s hits it"
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
    leads = _leading(figure, word, first, named=bool(named)) if located and word else []
    other = next(iter(leads), None) or text.counterpart(first, text.spoken_of(0, figure.i))
    return (first, other) if other is not None and other is not first else None


def _placed_there(figure: Figure, word: Term | None) -> list[Entity]:
    """Who is said to be there by the phrase after a number: ``10 m ahead of it a bus``, too."""
    placed = [m for m in figure.text.mentions for p in m.pps if p.word is word and p.fronted]
    before = [m for m in figure.text.mentions if m.i < figure.i]
    before = [m for m in before if any(p.word is word for p in m.pps)]
    there = [*before[-1:], *placed]
    return list(there[0].entities) if there else []


def _leading(figure: Figure, word: Term, first: Entity, *, named: bool) -> list[Entity]:
    """Of whom one is behind: ``the second, 2 s behind``, ``a van brakes; we are 15 m behind``."""
    text = figure.text
    here = [p for p in text.draft.placements if p.basis.i == word.i]
    told = [e for s in text.within(0, figure.i) if first not in s.actors for e in s.actors]
    acting = [e for e in told if e.moving_vehicle and word.value == "behind" and not named]
    return [*(p.entity for p in here if p.reference is first), *acting[-1:]]


def _brought_in(figure: Figure) -> list[list[Entity]]:
    """``overtakes it with a van 150 m away``: who comes in right before the number.

    So is whom a clause is about, as in "while a van is 150 m away".
    """
    near = (m for m in figure.text.mentions if m.j == figure.i and m.stands_after("with"))
    ego, scene = figure.text.ego, figure.scene
    acting = [ego, *figure.actors, *(scene.targets if scene is not None else [])]
    aside = [e for e in figure.subject if e is figure.said_of and e not in acting]
    return [[e, ego] for m in near for e in m.entities[:1] if e is not ego] or [
        [e, ego] for e in aside
    ]


def two_between(figure: Figure) -> list[list[Entity]]:
    """``45 m remain between the van and the car``, ``the gap between them is 45 m``: the pair.

    So it is in "the distance of the van to the bus is 35 m".
    """
    tokens, extents = figure.text.tokens, word_list("lies_between")
    mentions = [m for m in figure.text.mentions if figure.start <= m.i < figure.end]
    opened = [(m, m.prep.i) for m in mentions if m.prep and tokens[m.prep.i].low == "between"]
    told = [m for m, k in opened if k == figure.j or tokens[k - 1].low in extents]
    first = next(iter([m for m in told if m.i < figure.i][-1:] or told), None)
    who = [e for m in mentions if first in (m, m.joined) for e in m.entities] if first else []
    named = [m for m in mentions if m.i < figure.i][-_PAIR:]
    if not who and len(named) == _PAIR and named[1].stands_after("to", "from"):
        way = figure.text.low(named[0].i - _PAIR, named[1].i - 1).split()
        inside = figure.text.low(named[0].j, named[1].i - 1).split()
        apart = extents.intersection(way) and extents.issuperset(w for w in inside if w != "'s")
        who = [e for m in named for e in m.entities] if apart else []
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


def _by_a_pronoun(named: list[Entity], subject: list[Entity], figure: Figure) -> list[Entity]:
    """``and the ego, 15 m behind it``: not behind itself.

    In "the van ahead changes lanes, the ego stops 2 m behind it" it is behind the one that stands.
    """
    text, placed = figure.text, figure.text.context.placed
    left = all(Maneuver.LANE_CHANGE in e.maneuvers and placed(e, Approach.AHEAD) for e in named)
    if not left or text.ego not in subject or figure.does not in {"stop", "brake"}:
        return named
    still = [e for e in text.draft.entities if e.stands and not (e.parked or e.ego or e in named)]
    return still if len(still) == 1 else named


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
        its = other.ego and draft.only(other, said)  # "the lane of the ego, which is 15 m behind"
        draft.place(*((other, one) if its else (one, other)), {said}, basis)
    two = [e for e in (one, other) if not e.ego]
    if measure not in LENGTHWISE or len(two) != 1 or not two[0].is_vehicle:
        return
    entity = two[0]
    placed = any(entity in (p.entity, p.reference) or p.entity.ego for p in draft.placements)
    beside = bool(entity.maneuvers & {Maneuver.LANE_CHANGE, Maneuver.CROSS})
    if not (placed or figure.text.context.meeting or beside or entity.parked or entity.heading):
        reason = "a gap along the road is one to who is ahead"
        draft.place(entity, None, {Approach.AHEAD}, basis.because(reason))


def on_two_roads(text: Telling, one: Entity, other: Entity) -> bool:
    """Whether two only come together where their roads meet."""
    sides = set().union(*(at for _, at in text.stand(one, other)))
    context, implied = text.context, text.draft.implied
    meet = context.meeting or context.junction.control is not None or "access" in implied
    return meet and sides <= _ACROSS
