"""Distances, headways, offsets and overlaps between two, and when they are as said."""

from dataclasses import replace

from scegen.scenario.acts import ENTERING, ActKind
from scegen.scenario.spacings import CONTACT, LENGTHWISE, START, Measure
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver
from scegen.understanding.amounts import aside
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.amounts.pairs import each_from, on_two_roads, pair_of, row_of, tell_order
from scegen.understanding.amounts.telling import CHANGING, Telling
from scegen.understanding.entity import Entity
from scegen.understanding.happenings import Apart, Doing, Since
from scegen.understanding.lexicon import word_list

_SOON = 14
_ARMS_LENGTH = 3
"""Nearer than so many metres, who drives by somebody parked is beside them."""
_TWO_LANES = 7
_PASSED = frozenset({"overtake", "pass", "bypass"})
_ELSEWHERE = {Maneuver.LANE_CHANGE, Maneuver.OVERTAKE, Maneuver.LEFT, Maneuver.RIGHT}
_BREACHES = (HazardKind.FAILURE_TO_YIELD, HazardKind.RED_LIGHT_RUNNING)
_TOLD_OTHERWISE = "how far apart they are then is told otherwise before; left out"


def apart(figure: Figure) -> bool:
    """So far lies between two, or from one of a row to the next."""
    spacings, row = figure.text.found.spacings, row_of(figure)
    amounts = [figure.amount] * len(row)
    if not row:
        row, amounts = each_from(figure)
    pair = row[-1] if row else pair_of(figure)
    if pair is None or _ends_up(figure) or (figure.quantity.joined and not row):
        return False
    measure = _sideways(figure, *pair)
    at = moment(figure, measure, *pair)
    if row:
        found = zip(row, amounts, strict=True)
        spacings += [Apart(measure, a, b, amount, at) for (a, b), amount in found]
    else:
        told = _between(figure, measure, *pair, at)
        if any(_otherwise(told, other) for other in spacings):
            figure.text.draft.note_at(told.amount.basis, _TOLD_OTHERWISE)
        else:
            spacings += [told, *_past_all(told, figure)]
    return True


def _otherwise(told: Apart, other: Apart) -> bool:
    """Whether two cannot be so far apart at that moment, by what was told before."""
    same = told.measure is other.measure and told.at is other.at and told.since == other.since
    same = same and {told.entity, told.reference} == {other.entity, other.reference}
    one, two = told.amount.value, other.amount.value
    return same and (one.low > two.high or two.low > one.high)


def _past_all(told: Apart, figure: Figure) -> list[Apart]:
    """``overtakes two cyclists, leaving 1.5 m``: past each of them."""
    if told.measure is not Measure.LATERAL_GAP_M:
        return []
    pair = {told.entity, told.reference}
    return [
        replace(told, entity=by, reference=other)
        for scene in figure.text.scenes
        if scene.event.name in _PASSED and len(scene.targets) > 1
        for by in scene.actors[:1]
        if by in pair and pair - {by} <= {*scene.targets}
        for other in scene.targets
        if other not in pair
    ]


def _ends_up(figure: Figure) -> bool:
    """``drifts until only 0.3 m remain``: how far apart they end up."""
    if figure.clause is None or figure.clause[2] not in word_list("until"):
        return False
    return not figure.text.acts(figure.clause[1], figure.clause[1] + _SOON)


def at_rest(figure: Figure) -> bool:
    """``stops 3 m behind the truck``: how far apart they are once it stands."""
    pair, text = pair_of(figure), figure.text
    begin = figure.start if text.acts(figure.start, figure.i) else 0  # "…; 1 m is left"
    who = {pair[0], text.in_file(*pair)[0]} if pair is not None else {}  # "… between the two"
    stops = [a for a in text.acts(begin, figure.i) if a.entity in who]
    stops = [a for a in stops if a.always and a.ends_at_rest]  # "must stop 2 m before": it shall
    if pair is None or not stops:
        return False
    amount = figure.placed
    text.found.spacings.append(Apart(figure.measure, *pair, amount, stops[-1], since="end"))
    return True


def _sideways(figure: Figure, one: Entity, other: Entity) -> Measure:
    """``passes the parked van at 1 m``, ``drives beside it, 1 m away``: from side to side."""
    measure = figure.measure
    if measure is not Measure.GAP_M or figure.words_around.opens("lies_along"):
        return measure
    far = figure.quantity.exact.high
    by = {"pass", "bypass", *(["move"] if far <= _ARMS_LENGTH else [])}
    overtaking = [a.entity for a in figure.text.found.acts if a.kind is ActKind.OVERTAKE]
    for event, targets in ((s.event, s.targets) for s in figure.text.scenes):
        overtaking += targets if event.name in _PASSED else []
    past = figure.does in by and (one.parked or other.parked)
    past = past or (far <= _ARMS_LENGTH and (one in overtaking or other in overtaking))
    stand = [at for _, at in figure.text.stand(one, other)]
    beside = {Approach.ADJACENT} in stand
    past = past or ({Approach.OPPOSITE} in stand and far <= _ARMS_LENGTH)  # as they are level
    moved = (one.maneuvers | other.maneuvers) & _ELSEWHERE
    lateral = past or (beside and not moved and far <= _TWO_LANES)
    return Measure.LATERAL_GAP_M if lateral else measure


def _between(
    figure: Figure, measure: Measure, one: Entity, other: Entity, at: Doing | str
) -> Apart:
    """The spacing of two, the one whose it is first."""
    entity, reference, side, text = one, other, None, figure.text
    amount = figure.placed
    if measure is Measure.LATERAL_OFFSET_M:
        amount = aside.signed(figure)
        if one.ego and not (figure.named_before(figure.i) or figure.verb):
            entity, reference = other, one  # "ego 60 km/h, offset 0.5 m"
        aside.abreast(figure, *((one, other, 1) if other.ego else (other, one, -1)))
    elif measure in {Measure.HEADWAY_S, Measure.TTC_S}:
        entity, reference = text.in_file(one, other)
    elif measure is Measure.OVERLAP_PERCENT:
        amount, side = aside.of_a_width(figure)
        entity, reference = (other, one) if one.ego else (one, other)
        text.found.spacings[:] = [
            s for s in text.found.spacings if s.measure is not measure or s.entity is not entity
        ]  # "with full overlap (100 %)"
    if not (isinstance(at, Doing) and at.kind in ENTERING):
        tell_order(figure, measure, one, other)
    return Apart(measure, entity, reference, amount, at, side, since(text, at, one, other))


def to_a_thing(figure: Figure) -> bool:
    """``a mattress lies 60 m ahead``, ``60 m ahead of the ego lies a mattress``."""
    text = figure.text
    verb = figure.verb
    lies = verb is not None and verb.lemma in word_list("lying") and not verb.doers
    start = 0 if lies else figure.start  # "loses a pallet; it lies 60 m ahead"
    here = [x for x in text.found.items if start <= (x.basis.i or 0) < figure.end]
    if not here or not (lies or all(e.ego for e in text.spoken_of(figure.start, figure.i))):
        return False
    nearest = min(here, key=lambda x: x.basis.i or 0)
    if not all(e.ego for e in text.spoken_of(figure.j, nearest.basis.i or 0)):
        return False  # "20 m ahead of the ego a cyclist swerves around a pothole"
    text.found.spacings.append(Apart(Measure.GAP_M, nearest, text.ego, figure.placed))
    return True


_ANSWERING = frozenset({ActKind.BRAKE, ActKind.STOP, ActKind.CHANGE_LANE})
_INTO = ENTERING | {ActKind.CHANGE_LANE, ActKind.OVERTAKE, ActKind.SWERVE, ActKind.CROSS,
                     ActKind.OPEN_DOOR}  # fmt: skip
_BEGINNING = frozenset({"try", "light", "inert"})
"""``starts to brake``: what is begun is told after it."""


def moment(figure: Figure, measure: Measure, one: Entity, other: Entity) -> Doing | str:
    """An act, the contact or the start."""
    if measure is Measure.OVERLAP_PERCENT:
        return CONTACT
    text, start = figure.text, figure.start
    acts = [a for a in text.found.acts if a.entity in (one, other)]
    if measure is Measure.LATERAL_GAP_M:
        passing = [a for a in acts if a.kind is ActKind.OVERTAKE and a.i < figure.end]
        return passing[-1] if passing else START
    begun = _as_it_begins(figure, acts)
    starts = text.find("starts", start, figure.end) is not None and not begun
    # "5 m behind, it cuts in": it comes in ahead
    cuts_in = [e for e in text.draft.causing(HazardKind.CUT_IN) if e in (one, other)]
    cuts_in = [e for e in cuts_in if text.context.placed(e, Approach.BEHIND)]
    starts |= any(a.entity in cuts_in and a.i > figure.i for a in acts)
    if measure not in LENGTHWISE or starts:
        return START
    own = figure.verb
    told = {own.i} if own is not None and own.i < figure.i else set()
    comes = own is not None and own.lemma in word_list("nearing")
    comes = comes and any(map(figure.words_around.preceded, word_list("coming_to")))
    into = (
        begun[-1:]
        or [a for a in acts if comes and a.i > figure.i]  # "gets to within 20 m and brakes"
        or [a for a in acts if a.kind in _INTO and told & a.places]
        or [a for a in acts if _in_trigger(a, figure)]
        or _as_another(figure, one, other)
        or [a for a in _opens_with(figure, acts) if _goes_in(a)]
    )
    if into:
        return into[0]  # "when it has passed it moves in 15 m ahead of the ego"
    here = [a for a in acts if any(start <= i < figure.i for i in a.places)]
    here_into = [a for a in here if _goes_in(a)]
    if not here_into:  # "brakes at a TTC of 3 s", "brakes with 6 m/s² 20 m ahead of the ego"
        then = [a for a in here if told & a.places] or _opens_with(figure, acts)
        here_into = [a for a in then if measure is Measure.TTC_S or a.kind in CHANGING]
    if not here_into and on_two_roads(text, one, other):  # "a van pulls out. The gap is 20 m"
        here_into = [a for a in acts if _goes_in(a)] or _comes_in(figure, one, other)
    return here_into[-1] if here_into else _until_it_brakes(text, one, other, acts)


def _comes_in(figure: Figure, one: Entity, other: Entity) -> list[Doing]:
    """``does not yield, TTC 2 s``: as who breaks the rule there comes in."""
    who = [e for e in figure.text.draft.causing(*_BREACHES) if e in (one, other)][:1]
    added = (Doing(ActKind.ENTER, e, figure.amount.basis, figure.i) for e in who)
    return [figure.text.add(doing) for doing in added]


def _goes_in(doing: Doing) -> bool:
    """Whether one comes where the other drives: a gap is one as it begins to."""
    return doing.kind in _INTO or (doing.kind is ActKind.SET_OFF and doing.entity.pulls_out)


def _until_it_brakes(text: Telling, one: Entity, other: Entity, acts: list[Doing]) -> Doing | str:
    """Between two who are as fast: as far as when the one in front brakes."""
    unequal = one.speed is not None and other.speed is not None and one.speed != other.speed
    stay = not any(a.kind in _INTO for a in acts)  # "cuts into the 20 m gap between them"
    parted = stay and any(a.into in (one, other) for a in text.found.acts if a not in acts)
    if unequal or parted or any(e.still or not e.is_vehicle for e in (one, other)):
        return START
    leader = text.in_file(one, other)[1]
    told = [a for a in acts if a.kind in _ANSWERING and a.always]
    own = [a for a in told if a.entity is leader]
    # "brakes as the car ahead stops"
    first = own and (told[0] is own[0] or text.find("while_begun", told[0].i, own[0].i))
    return own[0] if first else START


def _opens_with(figure: Figure, acts: list[Doing]) -> list[Doing]:
    """``at a TTC of 2 s the lead car brakes``, ``10 m ahead of the ego a van swerves``: then.

    So it is in "a van, 40 m ahead and doing 100 km/h, moves over", "closes in and, its rear 40 m
    ahead of the ego, begins to change lanes": as who is told of before begins to do so.
    """
    text = figure.text
    commas = [k for k in range(figure.start, figure.i) if text.tokens[k].low == ","]
    begin = max(commas, default=figure.start)
    alike = text.tokens[begin].low == "with"  # "with the car 20 m ahead, the ego changes lanes"
    named = [m for m in text.mentions if begin <= m.i < figure.i and not m.possessor]
    before = [] if alike else named
    inside = begin > figure.start or bool(before)
    if text.within(begin, figure.i) or (inside and figure.after is None):
        return []
    told = [c.event for c in text.within(figure.j, figure.end) if not c.event.embedded]
    begun = [e.i for e in told if e.finite and e.name in _BEGINNING]
    # "of a van standing there the ego …", but "a van starts moving over"
    told = [e for e in told if e.finite or e.form != "ing" or (e.parent and e.parent.i in begun)]
    first = next((e for e in told if e.name not in _BEGINNING), None)
    if first is None or (inside and any(figure.j <= m.i for m in first.subject)):
        return []
    who = [e for m in before for e in m.entities][:1]
    over = [a for a in acts if first.i in a.places and (who or [a.entity]) == [a.entity]]
    return [a for a in over if not inside or (_goes_in(a) and not first.passive)]


def _as_it_begins(figure: Figure, acts: list[Doing]) -> list[Doing]:
    """``20 m at the start of its lane change``, ``the gap is 20 m then``: those told before."""
    text = figure.text
    if text.find("at_that_moment", figure.start, figure.end):
        return [a for a in acts if a.i < figure.start and not text.acts(figure.start, figure.end)]
    at, end = text.find("onsets", figure.start, figure.end) or (0, 0)
    named = text.within(end, end + 3) or text.find("manoeuvres", at, end + 3)
    return [a for a in acts if a.i < at] if named else []


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


def _as_another(figure: Figure, one: Entity, other: Entity) -> list[Doing]:
    """``steps out from behind a van 20 m ahead``, ``swerves to avoid a truck 30 m ahead``: then.

    So it is with ``the car ahead changes lanes and reveals a truck 60 m ahead``.
    """
    if not (one.still or other.still) or not (one.ego or other.ego):
        return []
    text = figure.text
    others = [a for a in text.acts(0, figure.i, _INTO) if a.entity not in (one, other)]
    left = [a for a in others if a.kind is ActKind.CHANGE_LANE and a.into is None and not a.when]
    left = [a for a in left if text.context.placed(a.entity, Approach.AHEAD)]
    return [a for a in others if a.i >= figure.start][-1:] or (left if len(left) == 1 else [])
