"""To which side, and how far: of who leaves its lane, and of distances from a line."""

from scegen.scenario.acts import ActKind
from scegen.scenario.bodies import BODIES
from scegen.scenario.model import Interval
from scegen.scenario.spacings import Measure
from scegen.scenario.vocabulary import Approach, HazardKind, Maneuver, Side
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.chunks import Place, Prep
from scegen.understanding.draft import Placement
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import Amount, Apart, Doing
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context
from scegen.understanding.semantics.lanes import owners
from scegen.understanding.semantics.patterns import people
from scegen.understanding.words.tokens import low_at

_REACH, _SIDE_REACH, _PAIR = 10, 14, 2
_WHOLE = 100.0
_BODY = frozenset({"front", "side", "portion"})
_ALONG, _BESIDE = frozenset({"ahead", "behind", "between"}), {Approach.ADJACENT}
_NEXT = {Approach.ADJACENT, Approach.LEFT, Approach.RIGHT}
SIDE_WORDS = {f"{s}{end}": s for s in ("left", "right") for end in ("", "ward", "wards")}


def off_its_lane(figure: Figure) -> bool:
    """``the ego stays 0.3 m left of its lane centre``: from where it should be itself."""
    text, who = figure.text, figure.subject
    around = f"{figure.words_around.before}{figure.words_around.after}"
    said = any(f" {p} " in around for p in word_list("lane_centre"))
    if not said or not any(e.ego or text.context.oncoming(e) for e in who):
        return False
    text.found.spacings.append(Apart(Measure.LATERAL_OFFSET_M, who[0], who[0], signed(figure)))
    return True


def signed(figure: Figure) -> Amount:
    """To the left is positive, to the right negative; the left where no side is said."""
    side, j = toward(figure)
    reason = "the side is not said; the left is taken" if side is None else None
    return turned(side is Side.RIGHT, figure.quantity.exact, Basis(figure.i, j, reason))


def of_a_width(figure: Figure) -> tuple[Amount, Side | None]:
    """``30 % of its front, on the left``: an overlap, on which side, and the words of both."""
    amount, text = figure.placed, figure.text
    if amount.value.high >= _WHOLE:
        return amount, None
    side, j = toward(figure)
    if any(not e.ego for e in text.spoken_of(figure.j, j)):
        j = figure.j
    body = [c for c in text.chunks if isinstance(c, Place) and c.kind in _BODY]
    near = [c.j for c in body if 0 <= c.i - figure.j <= 1 or c.i <= j < c.j]
    end = max([amount.basis.j or j, j, *near])
    return Amount(amount.value, Basis(figure.i, end, amount.basis.reason)), side


def abreast(figure: Figure, who: Entity, ego: Entity, sense: int) -> None:
    """``rides 2 m to the right of the ego's line``: beside it, if no place of the two is said."""
    amount = signed(figure)
    clear_m = (BODIES[who.kind].width_m + BODIES[ego.kind].width_m) / 2
    told = [a for _, a in figure.text.stand(who, ego) if not {Approach.AHEAD, Approach.BEHIND} <= a]
    unplaced = ego.ego and who.moving_vehicle and not told
    if unplaced and abs(amount.value.middle) >= clear_m:
        figure.text.draft.place(who, None, _BESIDE, amount.basis)
        side = "left" if sense * amount.value.middle > 0 else "right"
        who.beside = who.beside or (side, amount.basis)


def turned(right: bool, value: Interval, basis: Basis) -> Amount:
    """So far to the left, or to the right, which is negative."""
    return Amount(Interval(low=-value.high, high=-value.low) if right else value, basis)


def toward(figure: Figure) -> tuple[Side | None, int]:
    """The side that is named next to a number, and where the words for both end.

    ``the left 50 %``, ``the right half of its front (50 % overlap)``.
    """
    tokens, j = figure.text.tokens, figure.j
    for k in range(j, min(j + _REACH, figure.end)):
        if tokens[k].low in SIDE_WORDS:
            return Side(SIDE_WORDS[tokens[k].low]), k + 1
        first = k + 1 + (low_at(tokens, k + 1) in word_list("on_strips"))
        after = {low_at(tokens, first), low_at(tokens, first + (first > k + 1))}
        aside = tokens[k].low == "," and not after.isdisjoint(SIDE_WORDS)  # "50 %, on the left"
        if tokens[k].kind in {"number", "punct"} and not aside:
            break
    before = range(figure.i - 1, max(figure.start, figure.i - _SIDE_REACH) - 1, -1)
    said = (SIDE_WORDS[tokens[k].low] for k in before if tokens[k].low in SIDE_WORDS)
    return next(map(Side, said), None), j


_BACK = {"left": "right", "right": "left"}


def to_the_side(doing: Doing, scene: Clause, text: Telling) -> None:
    """Fill in to which side an act leads, and into whose lane."""
    context = text.context
    if doing.kind not in {ActKind.CHANGE_LANE, ActKind.SWERVE, ActKind.TURN, ActKind.OVERTAKE}:
        return
    event, entity = scene.event, doing.entity
    turns = doing.kind is ActKind.TURN
    for value, basis in _sides(doing.kind, scene, text):
        if value in _BACK and doing.side is None:
            doing.side, doing.side_basis = Side(value), basis
    if turns:
        return
    joins = entity.by_ramp or (entity.strip and entity.strip[1])
    if joins is not None and doing.kind is ActKind.CHANGE_LANE:
        doing.side = Side(context.draft.kerb).opposite  # "into the right lane", off the ramp
        words = joins.because("who joins comes from the side of the kerb")
        doing.side_basis = doing.side_basis or words
    _into(doing, scene, context)
    _homewards(doing, event.name == "return", context)
    if entity.ego and doing.side is None and doing.into is not None and doing.into.beside:
        side, words = doing.into.beside
        doing.side, doing.side_basis = Side(side), words.because("into the lane of who is there")
    homeward = doing.into is None or doing.into.ego
    beside = entity.beside or _comes_from(entity, context)
    towards = any(p.value in word_list("towards") for p in event.pps)
    over = doing.kind is ActKind.CHANGE_LANE or towards
    if homeward and over and doing.side is None and beside:
        side, words = beside
        doing.side = Side(_BACK[side])
        doing.side_basis = words.because("into the lane beside its own")


def _sides(kind: ActKind, scene: Clause, text: Telling) -> list[tuple[str, Basis]]:
    """The sides that words name to which a movement leads; the other of the lane that it leaves."""
    event = scene.event
    sides = [(d.value, Basis(d.i, d.j)) for d in event.dirs]
    lanes = [c for c in text.chunks if isinstance(c, Place) and c.kind == "lane"]
    # "merges out of the right lane", "pulls out of our lane"
    out = {"from", "out"}
    sources = [p.target for p in event.pps if out & {p.value, p.outer, text.tokens[p.word.i].low}]
    # "moves one lane to the left", "leaves the lane to the left"
    within = [c for c in lanes if not any(c is m for m in (event.object, *sources))]
    # "in the left lane, a car wanders towards ours": where it is, but "on the left, it overtakes"
    starts = [p.target for p in event.pps if p.fronted and kind is not ActKind.OVERTAKE]
    # "overtakes a van in the right lane": there is the van
    theirs = {e.start_lane[1].i for e in scene.targets if e.start_lane}
    goals = (g for g in event.nouns("into", "to", "for", "in") if isinstance(g, Place))
    for goal in (g for g in goals if all(g is not place for place in (*sources, *starts))):
        beside = any(c is not goal and c.i < goal.i <= c.j + 1 for c in within)
        if not beside and theirs.isdisjoint(range(goal.i - 1, goal.j)):
            # "from the lane to its right": from there
            sides += [(d, Basis(goal.i, goal.j)) for d in goal.dirs]
    # Who drifts out of the right lane may do so to either side.
    for place in sources if kind is not ActKind.TURN and event.name != "swerve" else []:
        if isinstance(place, Place):
            basis = Basis(place.i, place.j)
            sides += [(_BACK[d], basis) for d in place.dirs if d in _BACK]
    return sides


def _comes_from(entity: Entity, context: Context) -> tuple[str, Basis] | None:
    """``target from the left``: along a road, from the lane on that side."""
    for placement in context.draft.placements_of(entity) if not context.junction.crossing else []:
        side = next(iter(placement.approaches)).value
        if len(placement.approaches) == 1 and side in _BACK:
            return side, placement.basis
    return None


def _homewards(doing: Doing, returns: bool, context: Context) -> None:
    """Who comes from the front goes over the middle; who has overtaken comes back."""
    entity, words = doing.entity, doing.basis
    passes = Maneuver.OVERTAKE in entity.maneuvers
    back = passes and (returns or (doing.into is not None and doing.into.ego))
    across = Side(context.across)
    strays = entity in context.draft.causing(HazardKind.ONCOMING_LANE)
    strays &= context.oncoming(entity) and not (passes and returns)
    if strays and doing.kind is ActKind.CHANGE_LANE:
        doing.into, doing.into_basis = doing.into or context.draft.ego, doing.into_basis or words
        if doing.side is None:
            reason = "who comes from the front crosses the middle of the road"
            doing.side, doing.side_basis = across, words.because(reason)
    if back and doing.side is None and entity.beside is None:
        reason = "who has overtaken comes back to its lane"
        doing.side, doing.side_basis = across.opposite, words.because(reason)


def _into(doing: Doing, scene: Clause, context: Context) -> None:
    if doing.kind is not ActKind.CHANGE_LANE:
        return
    event = scene.event
    lanes = [g for g in event.nouns("into", "to", "for") if isinstance(g, Place)]
    lanes = [g for g in lanes if g.kind in {"lane", "path"}]
    own = [e for g in lanes for e in owners(g, scene, context) if g.owned_by or e.lane is not None]
    out = "out" in context.lows(event.i, event.j)  # "cuts out in front of"
    near = [p for p in event.pps if p.word.cat == "locus" and p.value in _ALONG and not out]
    # "boxed in behind a van, it …", "so does the car behind it": where one is at first
    near = [p for p in near if not p.fronted and all(m.j != p.word.i for m in event.subject)]
    near = [p for p in near if event.name == "cut_in" or not _is_there(doing.entity, p, context)]
    left = out and event.lemma == "cut"  # "cuts in, then cuts out"
    cuts = (d for d in context.draft.dangers if d.kind is HazardKind.CUT_IN and not left)
    egos = [e for e in context.draft.entities if e.ego]
    cut = [e for d in cuts if doing.entity in d.by for e in d.to or egos]
    named = [e for e in (*own, *scene.targets, *people(near), *cut) if e is not doing.entity]
    if named:
        doing.into, doing.into_basis = named[0], Basis(event.i, event.j)
    joins = doing.entity.by_ramp and all(p.value == "ahead" for p in near)  # till then beside it
    apart = context.junction.crossing or joins
    if near and named and not apart and named[0].moving_vehicle:
        _beside_whom(doing, named[0], near[0], context)
        if near[0].value == "between" and doing.entity.ego and len(named) == _PAIR:
            context.draft.place(named[1], named[0], {Approach.BEHIND}, named[1].basis)


def _is_there(entity: Entity, phrase: Prep, context: Context) -> bool:
    """``follows a truck and changes lanes 15 m behind it``: out of its lane, not into it.

    Into that of one whom only this phrase brings in ("in front of a car that is 20 m behind it").
    """
    ahead = phrase.value == "ahead"
    known = (e for e in people([phrase]) if e.ego or (e.basis.i or 0) < phrase.word.i or not ahead)
    for other in (e for e in known if entity.ego is not e.ego):
        front, told = entity if ahead else other, context.draft.placements
        told = [p for p in told if p.basis.i != phrase.word.i and not front.start_lane]
        leads = any(p.entity is front and _led(p, Approach.AHEAD) for p in told)
        if leads or any(p.reference is front and _led(p, Approach.BEHIND) for p in told):
            return True
    return False


def _led(told: Placement, place: Approach) -> bool:
    """Whether one is said to be there, and nowhere else, of the ego and another."""
    two = (told.entity, told.reference)
    return told.approaches == {place} and any(e is None or e.ego for e in two)


def _beside_whom(doing: Doing, other: Entity, phrase: Prep, context: Context) -> None:
    """``changes to the right lane in front of a truck``, ``behind it``: that one is there.

    Who comes in behind another is so from the start, unless it lets that one by.
    """
    draft, own = context.draft, doing.entity.ego
    behind = phrase.value == "behind" or (own and phrase.value == "between")
    who, seen = (other, Approach.AHEAD) if doing.entity.ego else (doing.entity, Approach.BEHIND)
    told = [p for p in draft.placements if other in (p.entity, p.reference) or who is p.entity]
    said = [p.approaches for p in told if p.basis.i != phrase.word.i]
    if doing.entity.ego and not behind:  # "in front of a van that comes up from behind"
        said = [approaches for approaches in said if approaches != {Approach.BEHIND}]
    if not (doing.entity.ego or (behind and other.ego)) or any(a - _NEXT for a in said):
        return
    basis = Basis(phrase.word.i, other.basis.j)
    if not said:
        draft.place(who, None, _BESIDE, basis)
        if doing.entity.ego and doing.side is not None:
            other.beside = other.beside or (doing.side.value, basis)
    if behind and doing.entity not in context.letting:
        draft.place(who, None, {seen}, basis)
