"""Distances, headways, offsets and overlaps between two."""

from __future__ import annotations

from dataclasses import replace

from scegen.scenario.acts import ActKind
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Approach, Maneuver
from scegen.understanding.amounts import aside
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.amounts.moments import moment, since
from scegen.understanding.amounts.pairs import each_from, pair_of, row_of, tell_order
from scegen.understanding.chunks import Place
from scegen.understanding.entity import Entity
from scegen.understanding.happenings import Apart, Doing
from scegen.understanding.lexicon import word_list

_SOON = 14
_ARMS_LENGTH = 3
"""Nearer than so many metres, who drives by somebody parked is beside them."""
_TWO_LANES = 7
_PASSED = frozenset({"overtake", "pass", "bypass"})
_WHOLE = 100
_TOLD_OTHERWISE = "how far apart they are then is told otherwise before; left out"


def apart(figure: Figure) -> bool:
    """So far lies between two, or from one of a row to the next."""
    spacings, row = figure.text.found.spacings, row_of(figure)
    amounts = [figure.amount] * len(row)
    if not row:
        row, amounts = each_from(figure)
    pair = row[-1] if row else pair_of(figure)
    if pair is None or _ends_up(figure):
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
    """``stops 3 m behind the truck``: how far apart they are once it stands.

    Before a crosswalk: from who crosses there.
    """
    pair, text = pair_of(figure), figure.text
    if pair is not None and isinstance(figure.noun, Place) and figure.noun.kind == "crosswalk":
        people = text.draft.entities
        crossing = [e for e in people if Maneuver.CROSS in e.maneuvers or not e.is_vehicle]
        pair = (figure.actors[0], crossing[0]) if crossing else None
    stops = [a for a in text.acts(figure.start, figure.i) if a.entity in (pair or ())]
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
    moved = (one.maneuvers | other.maneuvers) & {Maneuver.LANE_CHANGE, Maneuver.OVERTAKE}
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
        if one.ego and not (figure.adjacent or figure.verb):  # "ego 60 km/h, offset 0.5 m"
            entity, reference = other, one
        aside.abreast(figure, *((one, other, 1) if other.ego else (other, one, -1)))
    elif measure in {Measure.HEADWAY_S, Measure.TTC_S}:
        entity, reference = text.in_file(one, other)
    elif measure is Measure.OVERLAP_PERCENT:
        side = aside.toward(figure)[0] if amount.value.high < _WHOLE else None
        entity, reference = (other, one) if one.ego else (one, other)
        text.found.spacings[:] = [
            s for s in text.found.spacings if s.measure is not measure or s.entity is not entity
        ]  # "with full overlap (100 %)"
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
