"""Speeds by those of others: as fast as somebody, so much faster, in front of who is faster."""

from scegen.scenario.acts import SLOWING, ActKind
from scegen.scenario.model import Interval
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.amounts.telling import CHANGING, Telling
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import STILL, Amount, Doing
from scegen.understanding.lexicon import word_list

_PAIR = 2


def as_fast(text: Telling) -> None:
    """Speeds that follow from those in numbers."""
    _until_alike(text)
    _alike(text)
    _followed(text)
    _in_one_lane(text)


def _give(whom: list[Entity], model: Entity, words: Basis, reason: str, times: float = 1.0) -> None:
    """Those of whom no speed is said, and who move, are so fast as another of their sort."""
    own = model.speed or STILL
    for entity in whom:
        alike = entity.is_vehicle == model.is_vehicle
        if entity.speed is None and alike and not entity.still:
            entity.speed = Interval(low=own.low * times, high=own.high * times)
            entity.speed_basis = words.because(reason)


def _share(pair: list[Entity], words: Basis, reason: str) -> None:
    """The one of two of whom no speed is said is as fast as the other."""
    known = [e for e in pair if e.speed is not None]
    if len(known) == 1:
        _give(pair, known[0], known[0].speed_basis or words, reason)


def _until_alike(text: Telling) -> None:
    """``slows down to the speed of the lorry``, ``brakes to match it``: as fast in the end."""
    for doing in text.acts(0, len(text.tokens), CHANGING):
        if "target_speed_mps" in doing.amounts:
            continue
        within = text.within(doing.i + 1, text.bounds(doing.i)[1])
        end = next((s.event.i for s in within if s.event.finite), text.bounds(doing.i)[1])
        span = text.find("to_their_speed", doing.i, end)
        others = [e for e in text.draft.entities if e is not doing.entity]
        if span is None:
            continue
        named = [e for e in text.spoken_of(span[0], end) if e is not doing.entity] or others
        model = next((e for e in named if e.speed is not None), None)
        if model is not None and model.speed is not None:
            basis = Basis(*span, "as fast as the other")
            doing.amounts["target_speed_mps"] = Amount(model.speed, basis)


def _alike(text: Telling) -> None:
    """``equally fast``, ``at the same speed``: as fast as the other, or as who is told of."""
    span = text.find("alike", 0, len(text.tokens))
    if span is not None:
        begin, end = text.bounds(span[0])
        near, after = text.spoken_of(begin, span[0])[::-1], text.spoken_of(span[1], end)
        last = text.tokens[span[1] - 1].low
        near = [] if last == "like" and not after else near  # "like a madman"
        named = after + near if last == "as" else near + after
        who = list(dict.fromkeys(e for e in named if not e.parked))
        before = reversed(text.spoken_of(0, span[0]))
        known = [e for e in (*who, *before) if e.speed is not None]
        word = text.tokens[span[0] - 1].low  # "half as fast as"
        times = 0.5 if word in word_list("half_as") else 1.0 + (word in word_list("twice_as"))
        acts = [e for s in text.within(begin, span[0])[-1:] for e in s.actors]
        for model in known[:1]:
            words = Basis(span[0] - (times != 1.0), span[1])
            _give(who, model, words, "as fast as the other", 1 / times if model in acts else times)


def _followed(text: Telling) -> None:
    """``the ego follows a car at 100 km/h``: one drives as fast as the other."""
    slow = text.draft.causing(HazardKind.SLOW_DRIVING)
    for scene in text.scenes:
        pair = [*scene.actors[:1], *scene.targets[:1]]
        follows = scene.event.name in {"follow", "tailgate"}
        if not follows or len(pair) != _PAIR or scene.event.negated:
            continue
        if not any(e in slow or e.still or not e.is_vehicle for e in pair):
            _share(pair, scene.words, "who follows drives as fast as the other")


def _in_one_lane(text: Telling) -> None:
    """``ego 50 km/h, target 20 km/h, same lane``: whom the faster one comes up to is ahead."""
    span, ego = text.find("same_lane", 0, len(text.tokens)), text.ego
    others = [e for e in text.draft.entities if e is not ego and e.is_vehicle]
    if span is None or ego.speed is None or len(others) != 1:
        return
    other = others[0]
    placed = any(other in (p.entity, p.reference) for p in text.draft.placements)
    if other.speed is None or other.maneuvers or placed:
        return
    where = Approach.AHEAD if other.speed.high < ego.speed.high else Approach.BEHIND
    basis = Basis(*span, "in one lane, the slower one is in front")
    text.draft.place(other, None, {where}, basis)


def kept_apart(text: Telling) -> None:
    """``3 s behind the lead at 120 km/h; the lead brakes``: until then one is as fast.

    So it is where a headway, or a distance that is kept, is told of from the start.
    """
    slow = text.draft.causing(HazardKind.SLOW_DRIVING)
    for apart in text.found.spacings:
        pair = [e for e in (apart.entity, apart.reference) if isinstance(e, Entity)]
        at = apart.amount.basis.i or 0
        start, end = text.bounds(at)
        told = text.find("keeping_apart", start, at) is not None or " kept " in text.low(at, end)
        kept = told or apart.measure is Measure.HEADWAY_S
        kept = kept and not any(e in slow or e.maneuvers - {Maneuver.STRAIGHT} for e in pair)
        if isinstance(apart.at, Doing):
            kept = apart.at.kind in {ActKind.BRAKE, ActKind.STOP} and apart.since == "begin"
        if apart.measure in {Measure.GAP_M, Measure.HEADWAY_S} and kept:
            _share(pair, apart.amount.basis, "as long as the distance is kept")


def relative(figure: Figure) -> bool:
    """``20 km/h slower than the ego``, ``closing speed 30 km/h``: from the speed of the other.

    Without "faster" or "slower", who is behind comes up so fast to who is in front.
    """
    text, by = figure.text, figure.quantity.exact
    compared = word_list("faster_than") | word_list("slower_than")
    before = text.low(figure.start, figure.i).split()  # "slower than the ego by 20 km/h"
    near = before[::-1] if before[-1:] == ["by"] else text.low(figure.j, figure.j + 1).split()
    word = next((w for w in near if w in compared), None)
    told = word is not None
    anybody = text.draft.entities if not told else []
    whose_ = [figure.said_of] if figure.said_of is not None else figure.actors
    named = [e for e in (*whose_, *figure.subject, *anybody) if e.moving_vehicle]
    who = next((e for e in named if e.speed is None), next(iter(named), None) if told else None)
    meets = figure.does == "collide" and bool(text.acts(0, len(text.tokens), SLOWING))
    if who is None or (meets and not told):  # "hits it at a closing speed of …": after braking
        return False
    than = [e for e in text.spoken_of(figure.j + 1, text.bounds(figure.j)[1]) if e is not who]
    other = than[0] if told and than else text.counterpart(who, text.spoken_of(0, figure.i))
    if other is None or (who.speed is None) == (other.speed is None):
        return False
    faster = word in word_list("faster_than") if told else text.in_file(who, other)[0] is who
    if other.speed is None:  # "the lead, at 50 km/h, is 25 km/h slower than the ego"
        who, other, faster = other, who, not faster
    sign, own = 1 if faster else -1, other.speed or STILL
    if not told and text.context.oncoming(who if other.ego else other):
        own, sign = Interval(low=-own.high, high=-own.low), 1  # both together come so near
    low, high = sorted((own.low + sign * by.low, own.high + sign * by.high))
    if low >= 0:
        who.speed = Interval(low=low, high=high)
        who.speed_basis = Basis(figure.i, figure.j + told, "measured from the speed of the other")
    return low >= 0
