"""Things on the road and beside it: what lies in the way, what hides somebody."""

from __future__ import annotations

from scegen.scenario.things import ThingKind
from scegen.scenario.vocabulary import HazardKind, Side
from scegen.understanding.amounts.sentences import Sentences
from scegen.understanding.chunks import Mention, Place, Prep, Thing
from scegen.understanding.draft import Basis, Danger, Entity
from scegen.understanding.happenings import Item
from scegen.understanding.lexicon import word_list
from scegen.understanding.semantics.context import Clause, Context

_MOST = 5
_NEAR = 4
_SIDES = {"left": Side.LEFT, "right": Side.RIGHT}
_HIDING = frozenset({"behind", "between", "by", "from", "due"})
_VERBS = frozenset({"hide", "block", "cross", "walk", "appear", "move", "enter", "wait", "locate",
                    "pull_out", "stop", "dash", "encounter", "overlook"})  # fmt: skip


def items_in(text: Sentences, context: Context) -> list[Item]:
    """The things that take part in a danger, each in the danger that it causes.

    Args:
        text: the text with its clauses.
        context: the scenario in the making.
    """
    found: list[Item] = []
    for danger in context.draft.dangers:
        if danger.by or danger.items:
            continue
        if danger.kind is HazardKind.OBSTACLE:
            _lie_in_the_way(danger, text, context, found)
        elif danger.kind is HazardKind.OCCLUSION:
            _hide(danger, text, found)
    _also_hide(text, context, found)
    number_them(found)
    hiding = [d for d in context.draft.dangers if d.kind is HazardKind.OCCLUSION]
    placed = {item.basis.i for danger in hiding for item in danger.items}  # where it hides them
    context.draft.notes[:] = [n for n in context.draft.notes if n.i not in placed]
    return found


def number_them(found: list[Item]) -> None:
    """Gives each thing its name, by kind and number."""
    counts: dict[ThingKind, int] = {}
    for item in found:
        counts[item.kind] = counts.get(item.kind, 0) + 1
        item.name = f"{item.kind.value}_{counts[item.kind]}"


def _lie_in_the_way(danger: Danger, text: Sentences, context: Context, found: list[Item]) -> None:
    named = [t for t in _things(text) if t in context.draft.lying]
    listed = [t for t in named if _stands_for_others(t, text)]
    if listed and any(e.still for e in context.draft.entities):
        context.draft.dangers = [d for d in context.draft.dangers if d is not danger]
        return  # "two obstacles: a pedestrian and a bus"
    for thing in named:
        for _ in range(_count(thing)):
            item = item_of(thing, text)
            item.blocks, item.blocked = True, _who_reacts(thing, text)
            found.append(item)
            danger.items.append(item)


def _who_reacts(thing: Thing, text: Sentences) -> Entity | None:
    """``a van brakes for a fallen tree``: who does something about it."""
    for scene in text.within(*text.bounds(thing.i)):
        about = [scene.event.object, *(p.target for p in scene.event.pps)]
        if scene.event.object is thing and scene.event.lemma in word_list("shedding"):
            return None  # it lies in the way of who comes behind
        if scene.drivers and any(each is thing for each in about):
            return scene.drivers[0]
    return None


def _stands_for_others(thing: Thing, text: Sentences) -> bool:
    """``two obstacles …: a pedestrian …``: a word for those who are named."""
    _, end = text.bounds(thing.i)
    colon = any(t.low == ":" for t in text.tokens[thing.j : end])
    return colon and kind_of(thing) == ThingKind.OBSTACLE.value


def _hide(danger: Danger, text: Sentences, found: list[Item]) -> None:
    i, j = danger.basis.i or 0, danger.basis.j or 0
    start, end = text.bounds(i)
    things = [t for t in _things(text) if start <= t.i < end and t.kind in {"object", "obstacle"}]
    things += [t for t in _things(text) if t not in things and t.kind == "object"]
    # "a crate lies there and a hedge hides …": what lies in the way is named already.
    things.sort(key=lambda t: any(f.basis.i == t.i for f in found))
    for thing in things[:1]:
        item = _known(thing, found) or item_of(thing, text)
        item.hides += [e for e in _hidden(thing, text, i, j) if e not in item.hides]
        if item not in found:
            found.append(item)
        danger.items.append(item)


def _also_hide(text: Sentences, context: Context, found: list[Item]) -> None:
    """``behind a hedge and a parked van``: what hides somebody beside vehicles."""
    for danger in context.draft.dangers:
        if danger.kind is not HazardKind.OCCLUSION or not danger.by:
            continue
        i = danger.basis.i or 0
        start, end = text.bounds(i)
        for scene in text.within(start, end):
            for prep in scene.event.pps:
                target = prep.target
                if prep.value not in {"behind", "between", "by"} or not isinstance(target, Thing):
                    continue
                if target.kind == "object" and _known(target, found) is None:
                    item = item_of(target, text)
                    item.hides = list(scene.actors)
                    found.append(item)
                    danger.items.append(item)


def _things(text: Sentences) -> list[Thing]:
    return [
        c
        for c in text.chunks
        if isinstance(c, Thing) and c.head is not None and "thing" in c.head.data
    ]


def kind_of(thing: Thing) -> str:
    """The kind of a thing, as the lexicon has it."""
    return str(thing.head.data["thing"]) if thing.head is not None else "obstacle"


def _known(thing: Thing, found: list[Item]) -> Item | None:
    alike = [f for f in found if f.kind.value == kind_of(thing)]
    same = [f for f in alike if f.basis.i == thing.i]
    return same[0] if same else alike[-1] if alike else None


def _count(thing: Thing) -> int:
    number = thing.mod("num")
    return min(int(number.data["number"]), _MOST) if number is not None else 1


def item_of(thing: Thing, text: Sentences) -> Item:
    """A thing in the making: what it is called, and on which side it stands."""
    head = thing.head
    words = text.tokens[head.i : head.j] if head is not None else []
    called = " ".join([*(t.low for t in words[:-1]), *(t.forms[-1][0] for t in words[-1:])])
    item = Item(ThingKind(kind_of(thing)), called, Basis(thing.i, thing.j))
    own = [d for d in thing.dirs if d in _SIDES]
    after = [
        d
        for c in text.chunks
        if isinstance(c, Place) and 0 <= c.i - thing.j <= _NEAR and c.kind in {"side", "sidewalk"}
        for d in c.dirs
        if d in _SIDES
    ]
    side = next(iter((*own, *after)), None)
    item.side = _SIDES[side] if side is not None else None
    return item


def _hidden(thing: Thing, text: Sentences, i: int, j: int) -> list[Entity]:
    """Whom a thing hides: whom the verb names, or who is behind it."""
    start, end = text.bounds(i)
    here = [s for s in text.within(start, end) if s.event.name in _VERBS]
    for scene in here:
        if any(_behind(p, thing) for p in scene.event.pps):
            return [e for e in (scene.actors or scene.targets) if not e.ego]
    for scene in [s for s in here if i <= s.event.i <= j or s.event.name == "hide"]:
        who = _seen_in(scene)
        if who:
            return who
    return []


def _seen_in(scene: Clause) -> list[Entity]:
    direct = scene.event.object
    named = list(direct.entities) if isinstance(direct, Mention) else scene.targets
    return [e for e in (named or scene.actors) if not e.ego]


def _behind(prep: Prep, thing: Thing) -> bool:
    return prep.target is thing and (prep.value in _HIDING or prep.outer == "from")
