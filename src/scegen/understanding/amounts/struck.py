"""Where on the ego somebody touches it: which side, which half of its front, its middle."""

from collections.abc import Iterable

from scegen.scenario.model import Interval
from scegen.scenario.outcome import BodySide, OutcomeKind
from scegen.scenario.spacings import CONTACT, Measure
from scegen.scenario.vocabulary import HazardKind, Maneuver, ParticipantKind, Side
from scegen.understanding.amounts.contact_nouns import bare
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.chunks import NounPhrase, Place, Thing
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import Amount, Apart, Ending
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause
from scegen.understanding.semantics.lanes import SIDES
from scegen.understanding.semantics.met import from_the_rear

_WHOLE, _HALF, _LITTLE = 100.0, 50.0, 10.0
_SHARE = 2
_BODY = frozenset({"side", "front", "flank"})
_PARTS = {side.value: side for side in BodySide}
_ENDS = frozenset({BodySide.FRONT, BodySide.REAR})
_SIDES = frozenset({"left", "right"})
_ROADS = frozenset({"road", "lane", "highway"})


def fully_told(ending: Ending, endings: Iterable[Ending], text: Telling) -> Ending:
    """An ending, or another that tells the same of the same two, and where the ego is touched."""
    told = ending.kind, {*ending.between}
    alike = [each for each in endings if (each.kind, {*each.between}) == told]
    for each in alike:
        _struck(each, text)
    alike.sort(key=lambda each: each.half is None)  # "hits it. Only our left half caught it"
    return next((each for each in alike if each.struck or each.impact), ending)


def _struck(ending: Ending, text: Telling) -> None:
    """``the middle of the ego's front``, ``hits its rear``: which side, and where on it."""
    start, end = text.bounds(ending.basis.i or 0)
    places = [c for c in text.chunks if isinstance(c, Place)]
    roads = [c for c in places if c.kind in _ROADS]
    part_of = {id(p): _portion(p, text) for p in places}  # "the right corner of its front"
    # "… hits it; only the left half of our front is involved"
    places = [p for p in places if start <= p.i < end or (p.i >= end and part_of[id(p)])]
    portions = {id(portion) for p in places if (portion := part_of[id(p)]) is not p}
    driven_into: Basis | None = None
    for place in [p for p in places if p.kind in _BODY and id(p) not in portions]:
        if place.opening == "with" and place.i < (ending.basis.i or 0):
            continue  # "with his back to the ego he is hit"
        if place.opening == "from":
            continue  # "approaches from the rear and hits it": no part
        of_road = any(c.i == place.j + 1 for c in roads) and text.tokens[place.j].low == "of"
        if text.tokens[place.i - 2].low == "overlap" or of_road:
            continue
        part = _part(place, ending, text)
        portion = part_of[id(place)]
        whose = _owner(place, portion, ending, text)
        egos = whose is text.ego
        flank = part not in _ENDS
        if whose is None or (flank and not _hit(place, whose, ending, text)):
            continue
        basis = Basis(place.i, place.j)
        corner = part is BodySide.FRONT and not _SIDES.isdisjoint(place.dirs)
        half = portion or (place if corner else None)
        if half is not None and _is_middle(half) and egos and not (flank or ending.struck):
            words = Basis(min(half.i, place.i), max(half.j, place.j))
            ending.impact = Amount(Interval(low=_HALF, high=_HALF), words)
        elif half is not None and egos and part is BodySide.FRONT:
            ending.half = Side.LEFT if "left" in half.dirs else Side.RIGHT
            ending.half_basis = basis = Basis(min(half.i, place.i), max(half.j, place.j))
            ending.share = half.head.data.get("share") if half.head is not None else None
        if egos and part is not None and ending.struck is None:
            ending.struck, ending.struck_basis = part, basis
        elif not egos and (part is BodySide.REAR or _head_on_into(place, ending, text)):
            driven_into = driven_into or basis
    if ending.struck is None and driven_into is not None and text.ego in ending.between:
        backs = text.ego in text.draft.causing(HazardKind.REVERSING)
        ending.struck = BodySide.REAR if backs else BodySide.FRONT
        ending.struck_basis = driven_into
    _by_the_verb(ending, text)
    middle = text.find("at_its_middle", start, end)
    if middle is not None and text.ego in ending.between:  # "impact at mid-width"
        ending.impact = Amount(Interval(low=_HALF, high=_HALF), Basis(*middle))


def _part(place: Place, ending: Ending, text: Telling) -> BodySide | None:
    """Which part a place on a body is: of "the side" that from which the other comes."""
    if not place.dirs and place.kind != "front":
        end = text.tokens[place.j - 1].base in word_list("ends_of_bodies")  # "our bumper"
        return None if end else _side_faced(ending, text)
    corner = "front" in place.dirs and not _SIDES.isdisjoint(place.dirs)
    parts = (_PARTS[d] for d in place.dirs if d in _PARTS)
    return BodySide.FRONT if corner else next(parts, None)


def _by_the_verb(ending: Ending, text: Telling) -> None:
    """``rear-ends``, ``hits it from behind``: with its front, in the other's rear."""
    done = [s for s in text.scenes if s.event.i == ending.basis.i]
    if ending.struck is None and any(_backs_into(s, text) for s in done):
        ending.struck, ending.struck_basis = BodySide.REAR, ending.basis
    if ending.struck is not None or text.ego not in ending.between:
        return
    hit = next((s for s in done if from_the_rear(s.event, text.context)), None)
    along, into = word_list("along_the_side"), word_list("into_the_side")
    for scene in (s for s in done if s.event.lemma in along | into and hit is None):
        rams = text.ego in scene.actors and scene.event.lemma in into
        ending.struck_basis = ending.basis
        ending.struck = BodySide.FRONT if rams else _side_faced(ending, text)
    egos = hit is not None and (text.ego in hit.actors or ending.other in hit.targets)
    if hit is not None and (egos or text.ego in hit.targets or ending.other in hit.actors):
        ending.struck = BodySide.FRONT if egos else BodySide.REAR
        ends = [ending.basis.j or 0, *((p.place or p.word).j for p in hit.event.pps)]
        ending.struck_basis = Basis(ending.basis.i, max(ends))


def _side_faced(ending: Ending, text: Telling) -> BodySide | None:
    """The ego's side from which the other comes, as far as the ego goes straight."""
    turns = text.ego is None or text.ego.maneuvers - {Maneuver.STRAIGHT}
    of = ending.other
    sides = [a for a in SIDES if of and (a in of.sides or text.context.placed(of, SIDES[a]))]
    return None if turns or len(sides) != 1 else _PARTS[sides[0]]


def _backs_into(scene: Clause, text: Telling) -> bool:
    """``the ego backs up and bumps into it``: with its rear, unless along its side."""
    backs = text.ego in text.draft.causing(HazardKind.REVERSING) and text.ego in scene.actors
    into = any(p.value == "into" for p in scene.event.pps)
    return backs and (into or scene.event.lemma not in word_list("along_the_side"))


def _head_on_into(place: Place, ending: Ending, text: Telling) -> bool:
    """``the ego hits the side of a van``: with its front, unless along that side."""
    done = [s for s in text.scenes if s.event.i == ending.basis.i and text.ego in s.actors]
    across = any(s.event.lemma not in word_list("along_the_side") for s in done)
    return across and (not place.dirs or bool(_SIDES & set(place.dirs)))


def _hit(place: Place, whose: Entity, ending: Ending, text: Telling) -> bool:
    """Whether a part is what is touched: "by its left side"; the ego "is hit in the side"."""
    i, prep = ending.basis.i or 0, place.opening
    here = [s for s in text.scenes if s.event.i == i]
    is_hit = any(text.ego in s.targets and text.ego not in s.actors for s in here)
    told = place.owner is not None or place.has("possessive")
    direct = any(s.event.object is place or s.event.i == place.j for s in here)
    noun = all(s.event.nominal or bare(s.event, text) for s in here)  # "contact: our left side"
    after = prep in {"in", "into", "against"} and place.i > i  # no "on my right a van hits it"
    met = direct or (told and (noun or after))
    return met or (whose.ego and (prep in {"by", "with"} or (prep == "in" and is_hit)))


def _portion(place: Place, text: Telling) -> NounPhrase | None:
    """``the left half`` of its front, the bonnet ``in the middle``, ``on the left``."""
    of = min([place.i, *([place.owner.i] if place.owner is not None else [])]) - 1
    for part in text.chunks:
        if not (isinstance(part, Place | Thing) and (_SIDES & set(part.dirs) or _is_middle(part))):
            continue
        before = text.tokens[of].low == "of" and 0 <= of - part.j <= _SHARE  # "right 50 % of it"
        of_more = part.j < len(text.tokens) and text.tokens[part.j].low == "of"
        after = 0 <= part.i - place.j <= 1 and part.opening in {"", "in"}
        if before or (after and not (of_more or part.has("possessive"))):
            return part
    return None


def _is_middle(part: NounPhrase) -> bool:
    return isinstance(part, Place) and part.kind == "middle"


def settle(text: Telling) -> None:
    """What half of the front is touched, by the numbers if any: by whom it is narrow, where.

    Of whom the ego nears with an overlap, and no end is told, it is that they touch.
    """
    overlaps = [s for s in text.found.spacings if s.measure is Measure.OVERLAP_PERCENT]
    for two in overlaps if text.found.ending is None else []:
        near, own = two.entity, text.ego.speed
        if not isinstance(near, Entity):
            continue
        slower = own is not None and near.speed is not None and own.low > near.speed.high
        if slower or near.still or text.context.oncoming(near):
            basis = two.amount.basis.because("bodies overlap where they touch")
            text.found.ending = Ending(OutcomeKind.COLLISION, basis, [text.ego, near])
    ending = text.found.ending
    if ending is None or ending.half is None or ending.impact is not None:
        return
    basis, left = ending.half_basis or ending.basis, ending.half is Side.LEFT
    for overlap in overlaps:
        known = overlap.amount.basis
        begins, ends = min(known.i or 0, basis.i or 0), max(known.j or 0, basis.j or 0)
        overlap.amount = Amount(overlap.amount.value, Basis(begins, ends, known.reason))
        overlap.side = overlap.side or ending.half
    if overlaps:
        return
    other = ending.other
    across = other is not None and text.context.from_the_side(other)
    in_file = other is not None and other.is_vehicle and other.kind is not ParticipantKind.BICYCLE
    if other is not None and in_file and not across:
        high = ending.share or _HALF
        low = _LITTLE if ending.share is None else high - _LITTLE
        amount = Amount(Interval(low=low, high=high), basis)
        apart = Apart(Measure.OVERLAP_PERCENT, other, text.ego, amount, CONTACT, ending.half)
        text.found.spacings.append(apart)
    else:
        share = ending.share or _HALF
        value = Interval(low=0.0 if left else _WHOLE - share, high=share if left else _WHOLE)
        ending.impact = Amount(value, basis)


def _owner(
    place: Place, portion: NounPhrase | None, ending: Ending, text: Telling
) -> Entity | None:
    """Whose part it is: "the ego's front", "the rear of the car", "its rear"."""
    i = ending.basis.i or 0
    if place.owner is not None and place.owner.entities:
        owner: Entity = place.owner.entities[0]
        does = any(owner in s.actors for s in text.scenes if s.event.i == i)
        others = [e for e in ending.between if e is not owner]
        # "it crashes into the back of it" is into another's.
        return others[0] if does and place.owner.pronoun and len(others) == 1 else owner
    if place.has("possessive", "first_person"):
        return text.ego
    own = any((m.cat, m.value) == ("possessive", "its") for m in place.mods)
    head = portion if portion is not None and portion.i < place.i else place
    done = [s for s in text.scenes if s.event.object is head]
    scene = next((s for s in (*done, *text.scenes) if s in done or s.event.i == i), None)
    if scene is None:
        return None
    direct = scene.event.object is head
    prep = place.opening
    if prep == "in" and scene.event.name == "collide" and scene.targets and place.i > i:
        return scene.targets[0]  # "hits us in the side", "is hit on its right side"
    flank = bool(_SIDES & set(place.dirs))
    met = direct or (prep == "into" and (flank or not scene.event.passive))
    met = met or (prep == "with" and scene.event.lemma == "collide" and not scene.targets)
    doer = scene.actors[0] if scene.actors else None
    into = {"into", "against", *(["in"] if "front" in place.dirs else [])}
    if direct and own and into & {p.value for p in scene.event.pps}:
        return doer  # "puts its nose into the van"
    if met and (own or direct) and doer is not None:  # "a car behind hits its rear"
        return ending.other if doer.ego else text.ego
    if own or not direct:
        hit_by = scene.event.passive and prep == "by"
        return text.ego if hit_by or doer is None else doer
    return None
