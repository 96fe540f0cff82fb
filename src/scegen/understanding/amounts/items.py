"""Things on the road and beside it, what they hide; how large they and those who drive are."""

from collections.abc import Sequence

from scegen.scenario.bodies import LENGTHS_M, WIDTHS_M
from scegen.scenario.things import SIZES_M, ThingKind
from scegen.scenario.vocabulary import Approach, HazardKind, Side
from scegen.understanding.amounts.figures import Figure, has_a_size
from scegen.understanding.amounts.telling import Telling
from scegen.understanding.chunks import Event, Mention, NounPhrase, Place, Thing
from scegen.understanding.draft import Danger
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import Item, name_them
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause

_ANY = ThingKind.OBSTACLE.value
_MOST = 5
_NEAR = 4
_SIDES = frozenset(Side)
_MOVES = frozenset({"move", "enter", "cross", "walk", "dash", "lose_control"})
_ALONG = {"ahead": False, "behind": True}
"""Where what lies there is in somebody's way -> whether of one who reverses."""
_HIDING = frozenset({"behind", "between", "by", "from", "due"})


def read_items(text: Telling) -> None:
    """The things that take part in a danger, each in the danger that it causes."""
    hiding = [d for d in text.draft.dangers if d.kind is HazardKind.OCCLUSION]
    for danger in [d for d in text.draft.dangers if not (d.by or d.items)]:
        if danger.kind is HazardKind.OBSTACLE:
            _lie_in_the_way(danger, text)
        elif danger in hiding:
            _hide(danger, text)
    name_them(text.found.items)
    placed = {item.basis.i for danger in hiding for item in danger.items}  # where it hides them
    text.draft.notes[:] = [n for n in text.draft.notes if n.i not in placed]


def _add(item: Item, danger: Danger, text: Telling) -> None:
    if item not in text.found.items:
        text.found.items.append(item)
    danger.items.append(item)


def _lie_in_the_way(danger: Danger, text: Telling) -> None:
    named = [t for t in _things(text) if t in text.draft.lying]
    general = [t for t in named if kind_of(t) == _ANY]  # "two obstacles: a pedestrian and a bus"
    listed = any(" : " in text.low(t.j, text.bounds(t.i)[1]) for t in general)
    if listed and any(e.still for e in text.draft.entities):
        text.draft.dangers = [d for d in text.draft.dangers if d is not danger]
        return
    named = [t for k, t in enumerate(named) if not _again(t, named[:k])]
    for thing in named:
        number = thing.mod("num")
        for _ in range(min(int(number.data["number"]), _MOST) if number is not None else 1):
            item = item_of(thing, text)
            item.blocks, item.blocked = True, _who_reacts(thing, text)
            _before_whom(item, thing, text)
            _add(item, danger, text)
        for scene in text.scenes:  # "a ball rolls onto the road"
            follows = 0 <= scene.event.i - thing.j <= 1 and not scene.actors
            if follows and scene.event.name in _MOVES and not scene.event.negated:
                text.draft.note(scene.event.i, scene.event.j, "things do not move: it lies there")


def _again(thing: Thing, before: list[Thing]) -> bool:
    """``a crate lies there; the ego hits the crate``, ``… the obstacle``: named already."""
    known = {kind_of(t) for t in before}
    definite = any(m.value == "def" for m in thing.mods) and thing.mod("num") is None
    return definite and (kind_of(thing) in known or (bool(known) and kind_of(thing) == _ANY))


def _who_reacts(thing: Thing, text: Telling) -> Entity | None:
    """``a van brakes for a fallen tree``: who does something about it."""
    for scene in text.within(*text.bounds(thing.i)):
        if scene.event.object is thing and scene.event.lemma in word_list("shedding"):
            return None  # it lies in the way of who comes behind
        if scene.drivers and any(each is thing for each in scene.event.nouns()):
            return scene.drivers[0]
    return None


def _before_whom(item: Item, thing: Thing, text: Telling) -> None:
    """``a box lies ahead of the van``, or behind it, if that reverses."""
    rest = [c for c in text.chunks if thing.j <= c.i < text.bounds(thing.i)[1]]
    rest = [c for c in rest if not isinstance(c, Event) and c.cat not in {"rel", "manner"}]
    where, whom = [*rest, None, None][:2]
    if where is None or where.value not in _ALONG or not isinstance(whom, Mention):
        return
    backing = [e for s in text.scenes if s.event.name == "reverse" for e in s.actors]
    for each in (whom.entities or backing)[:1]:
        if _ALONG[where.value] == (each in backing):
            item.blocked, item.blocked_basis = each, Basis(where.i, where.j)


def _hide(danger: Danger, text: Telling) -> None:
    start, end = text.bounds(danger.basis.i or 0)
    things = [t for t in _things(text) if start <= t.i < end and t.lies_there]
    things += [t for t in _things(text) if t not in things and t.kind == "object"]
    # "a crate lies there and a hedge hides …": what lies in the way is named already.
    lying = {item.basis.i for item in text.found.items}
    things.sort(key=lambda t: t.i in lying)
    for thing in things[:1]:
        item = _known(thing, text) or item_of(thing, text)
        item.hides += [e for e in _hidden(thing, danger.basis, text) if e not in item.hides]
        side = {Approach(item.side.value)} if item.side is not None else set()
        for who in item.hides:  # they are on its side
            if not text.draft.placements_of(who):
                text.draft.place(who, None, side, item.basis)
        _add(item, danger, text)


def _things(text: Telling) -> list[Thing]:
    return [c for c in text.chunks if isinstance(c, Thing) and has_a_size(c)]


def kind_of(thing: Thing) -> str:
    """The kind of a thing, as the lexicon has it."""
    return str(thing.head.data["thing"]) if thing.head is not None else "obstacle"


def _known(thing: Thing, text: Telling) -> Item | None:
    alike = [f for f in text.found.items if f.kind.value == kind_of(thing)]
    same = [f for f in alike if f.basis.i == thing.i]
    return same[0] if same else alike[-1] if alike else None


def item_of(thing: Thing, text: Telling) -> Item:
    """A thing in the making: what it is called, and on which side it stands."""
    head = thing.head
    words = text.tokens[head.i : head.j] if head is not None else []
    called = " ".join([*(t.low for t in words[:-1]), *(t.forms[-1][0] for t in words[-1:])])
    item = Item(ThingKind(kind_of(thing)), called, Basis(thing.i, thing.j))
    places = [c for c in text.chunks if isinstance(c, Place) and 0 <= c.i - thing.j <= _NEAR]
    beside = [thing, *(c for c in places if c.kind in {"side", "sidewalk"})]
    sides = ((Side(d), Basis(c.i, c.j)) for c in beside for d in c.dirs if d in _SIDES)
    item.side, item.side_basis = next(sides, (None, None))
    return item


def _hidden(thing: Thing, words: Basis, text: Telling) -> list[Entity]:
    """Whom a thing hides: whom the verb names, or who is behind it."""
    i, j = words.i or 0, words.j or 0
    here = [s for s in text.within(*text.bounds(i)) if s.event.name in word_list("beside_things")]
    for scene in here:
        hides = (p for p in scene.event.pps if p.value in _HIDING or p.outer == "from")
        if any(p.target is thing for p in hides):
            return [e for e in (scene.actors or scene.targets) if not e.ego]
    told = [s for s in here if i <= s.event.i <= j or s.event.name == "hide"]
    return next((who for s in told if (who := _seen_in(s))), [])


def _seen_in(scene: Clause) -> list[Entity]:
    direct = scene.event.object
    named = list(direct.entities) if isinstance(direct, Mention) else scene.targets
    return [e for e in (named or scene.actors) if not e.ego]


_LIMITS = {"length_m": LENGTHS_M, "width_m": WIDTHS_M}


def sized(figure: Figure, field: str) -> bool:
    """Gives a number to a field of the one whose size it is; whether there is one."""
    noun = _named_beside(figure)
    if noun is None:
        return False
    items = figure.text.found.items
    whose: Sequence[Entity | Item] = [i for i in items if i.basis.i == noun.i]
    limits = SIZES_M
    if isinstance(noun, Mention):
        whose, limits = noun.entities, _LIMITS[field]
    amount = figure.exactly
    if not limits[0] <= amount.value.low <= amount.value.high <= limits[1]:
        built = f"nothing less than {limits[0]:g} m or more than {limits[1]:g} m is built so"
        figure.note(f"{built} {figure.role}; left out")
        return True
    for each in whose:
        each.sizes.setdefault(field, amount)
    return bool(whose) and all(each.sizes[field].value == amount.value for each in whose)


def _named_beside(figure: Figure) -> NounPhrase | None:
    """The noun in whose phrase a number stands ("a 12 m bus"), else which it follows.

    Of a noun and the place where that is said to be ("the truck in the left lane, which is 12 m
    long") it is the noun; but the lane may be so wide.
    """
    within, text = figure.phrase_around(figure.i), figure.text
    if within is None and text.low(figure.j + 1, figure.j + 2) == " and ":
        within = figure.phrase_around(figure.j + 2)  # "a 2.5 m wide and 12 m long bus"
    if within is not None:
        return within
    before = [c for c in text.chunks if figure.start <= c.i and c.j <= figure.i]
    for chunk in reversed(before):
        if isinstance(chunk, Thing) and text.tokens[chunk.j - 1].low in word_list("extents"):
            continue  # "a van, length 6 m"
        if isinstance(chunk, Mention | Thing):
            return chunk if has_a_size(chunk) else None
        lane = isinstance(chunk, Place) and (chunk.prep is None or figure.role == "wide")
        if isinstance(chunk, Event) or lane:
            return None
    return None
