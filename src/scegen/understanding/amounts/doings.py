"""Numbers that say how an act is done: how hard, how fast at the end, how long, how far aside."""

from dataclasses import replace

from scegen.scenario.acts import ActKind
from scegen.scenario.model import Interval
from scegen.scenario.vocabulary import Side
from scegen.understanding.amounts.aside import SIDE_WORDS
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.amounts.timing import likewise
from scegen.understanding.entity import Basis
from scegen.understanding.frames import acts as frames
from scegen.understanding.happenings import STILL, Amount, Doing, Trigger
from scegen.understanding.lexicon import word_list

_PLAIN = frozenset({"duration", "distance", "lateral_speed", "lateral_move"})
_SIDE_REACH = 4
_IDLE = frozenset({"wait", "delay"})
_CHANGES = frozenset({ActKind.BRAKE, ActKind.ACCELERATE, ActKind.SET_OFF})


def fill(figure: Figure, field: str, kinds: frozenset[ActKind]) -> bool:
    """A field of an act of some kinds; whether there is one."""
    find = _lasting if figure.role == "duration" else _act
    doing = likewise(figure, kinds) or find(figure, field, kinds)
    return doing is not None and _give(doing, figure, field)


def made(figure: Figure, kind: ActKind, field: str) -> bool:
    """``lead car, deceleration 6 m/s²``: an act that only its amount tells of."""
    who, event = figure.subject, figure.verb
    if not who:
        return False
    told = [event.i] if event is not None and event.i < figure.i else []
    doing = Doing(kind, who[0], figure.amount.basis, figure.i, told=told)
    return _give(figure.text.add(doing), figure, field)


def comes_to(figure: Figure) -> bool:
    """``brakes and then holds 30 km/h``: what its own change of speed before that comes to.

    So does "sets off and drives 30 km/h": it stood before.
    """
    text = figure.text
    who = figure.actors or figure.subject
    before = [a for a in text.acts(0, figure.i) if a.entity in who and a.kind in _CHANGES]
    if len(who) != 1 or not before or before[-1].i < figure.start:
        return False
    last = before[-1]
    off = last.kind is ActKind.SET_OFF and last.always and figure.subject == [last.entity]
    held = off or figure.words_around.closes("holding_at")
    if not held or last.amounts.get("target_speed_mps") is not None:
        return False
    last.amounts["target_speed_mps"] = figure.amount
    return True


def rests(figure: Figure) -> bool:
    """``stops and stands there for 8 s``: how long one is at rest, not how it gets there."""
    event, text = figure.verb, figure.text
    who = figure.actors or figure.subject
    if event is None or not who:
        return False
    own = [a for a in text.acts(figure.start, event.i + 1) if a.entity is who[0]]
    doing = own[-1] if own else None
    stops = doing is not None and doing.kind is ActKind.STOP and not doing.amounts
    if doing is None or not stops:
        under_way = bool(own) or any(p.names("lane", "road", "middle") for p in event.pps)
        if not (who[0].is_vehicle or under_way):  # it waits at the kerb
            return False
        doing = text.add(Doing(ActKind.WAIT, who[0], Basis(event.i, event.j), event.i))
    else:
        doing.kind, doing.always = ActKind.WAIT, True
        doing.told.append(event.i)
    return _give(doing, figure, "duration_s")


def _give(doing: Doing, figure: Figure, name: str) -> bool:
    """Gives a number to a field of an act, and of those who do the same there."""
    role = figure.role
    ends = figure.words_around.before.endswith(" up to ")  # where it ends, no bound
    plain = ends or role in _PLAIN
    amount: Amount | None = figure.exactly if plain else figure.amount
    if role == "rate" and doing.kind is ActKind.STOP:
        doing.kind = ActKind.BRAKE
        doing.amounts.setdefault("target_speed_mps", Amount(STILL, doing.basis))
    if role == "speed_change":
        amount = _changed(doing, figure)
    if amount is None:
        return False
    if role == "lateral_move":
        doing = _further(doing, figure) if name in doing.amounts else doing
        _side(doing, figure)
        if both := figure.text.find("both_ways", doing.i, figure.j + _SIDE_REACH):
            _to_both_sides(doing, figure, amount, Basis(*both, "which side first is not said"))
    alike = figure.text.acts(doing.i, doing.i + 1, {doing.kind})  # "both brake with 6 m/s²"
    for same, own in zip(alike, figure.quantity.each(len(alike)), strict=True):
        several = own is not figure.quantity  # "brake with 6 and 4 m/s²"
        same.amounts.setdefault(name, replace(amount, value=own.value) if several else amount)
    return True


def _lasting(figure: Figure, field: str, kinds: frozenset[ActKind]) -> Doing | None:
    """The act that takes so long: that of its verb, that a noun names, or what one does there."""
    event = figure.verb
    if event is None:  # not "the driver is distracted for 2 s"
        return None if figure.words_around.preceded("for") else _act(figure, field, kinds)
    text, scenes = figure.text, figure.text.scenes
    near = {e.i for e in (event, *event.children, *([event.parent] if event.parent else []))}
    here = text.acts(figure.start, figure.end, kinds)
    own = [a for a in text.acts(0, figure.end, kinds) if near & a.places]
    noun = next((e for e in (event, event.parent) if e is not None and e.nominal), None)
    if not own and noun is not None:  # "the lane change takes 5 s", "lasts 5 s"
        own = text.acts(0, len(text.tokens), {*kinds} & {frames().get(noun.name)})
    if not own and event.name not in _IDLE:
        # "changes lanes, needing 5 s": what those do of whom the verb tells
        who = [e for c in scenes if c.event is event for e in c.actors]
        moves = [a for a in here if a.i < figure.i and a.kind is not ActKind.STOP]
        own = [a for a in moves if a.entity in who]
    return own[-1] if own else None


def _act(figure: Figure, name: str, kinds: frozenset[ActKind]) -> Doing | None:
    """The act of a number: the last before it in its sentence, else the next, else the last."""
    text = figure.text
    if _unread(figure, kinds):
        return None
    here = text.acts(figure.start, figure.end, kinds)
    before = [a for a in here if a.i < figure.i]
    after = [a for a in here if a.i > figure.i and name not in a.amounts]
    if before:
        free = [a for a in before if name not in a.amounts and a.i == before[-1].i]
        return before[-1] if figure.role == "lateral_move" else (free or before)[-1]
    if here:
        return after[0] if after else None
    spoken = bool(text.spoken_of(figure.start, figure.i))
    earlier = [a for a in text.acts(0, figure.start, kinds) if name not in a.amounts]
    same = [a for a in earlier if not spoken or a.entity in figure.subject]
    return same[-1] if same else None


def _unread(figure: Figure, kinds: frozenset[ActKind]) -> bool:
    """``pulls away at 1 m/s² and then stops``: said of a doing that is no act yet."""
    event = figure.verb
    if event is None or event.i >= figure.i or event.name == "move":
        return False
    if event.nominal or not event.subject:
        return False  # "Deceleration: 6 m/s²" names what has been told
    known = any(event.i in a.places for a in figure.text.found.acts)
    return not known and frames().get(event.name) in kinds


def _changed(doing: Doing, figure: Figure) -> Amount | None:
    """``slows by 20 km/h``: from the speed that it had."""
    speed, by = doing.entity.speed, figure.quantity.value
    if speed is None:
        return None
    sign = 1 if doing.kind is ActKind.ACCELERATE else -1
    low, high = sorted((speed.low + sign * by.low, speed.high + sign * by.high))
    basis = figure.amount.basis.because("its speed before, changed by so much")
    return Amount(Interval(low=low, high=high), basis)


def _further(doing: Doing, figure: Figure) -> Doing:
    """``1 m to the left and 1 m to the right``: one after the other."""
    second = Doing(doing.kind, doing.entity, doing.basis, doing.i + 1)
    second.when = Trigger("after", doing.basis, act=doing)
    acts = figure.text.found.acts
    acts.insert(acts.index(doing) + 1, second)
    return second


def _to_both_sides(doing: Doing, figure: Figure, amount: Amount, basis: Basis) -> None:
    """``weaves 0.5 m to either side``: to one and to the other."""
    second = _further(doing, figure)
    second.amounts["lateral_m"] = amount
    doing.side, second.side = Side.LEFT, Side.RIGHT
    doing.side_basis = second.side_basis = basis


def _side(doing: Doing, figure: Figure) -> None:
    """``0.5 m to the left``, ``to the left by 0.5 m``."""
    tokens, i, j = figure.text.tokens, figure.i, figure.j
    told = tokens[i - 1].low == "by" and tokens[i - 2].low in SIDE_WORDS
    for k in [i - 2] if told else range(j, min(j + _SIDE_REACH, len(tokens))):
        if tokens[k].low in SIDE_WORDS:
            doing.side, doing.side_basis = Side(SIDE_WORDS[tokens[k].low]), Basis(k, k + 1)
            return
    beside = doing.entity.beside if tokens[j].low in word_list("towards") else None
    if beside is not None and doing.side is None:  # "1 m towards the ego"
        doing.side = Side(beside[0]).opposite
        doing.side_basis = Basis(j, j + 1, "towards the lane beside its own")


def until_the_next(figure: Figure) -> bool:
    """``holds it for 5 s and then slows``: how long until the next act."""
    own = [a for a in figure.text.found.acts if a.entity in figure.subject]
    later = [a for a in own if a.i > figure.i]
    if not later or later[0].when is not None:
        return False
    before = [a for a in own if a.i < figure.i]
    kind = "after" if before else "start"
    later[0].when = figure.trigger(kind, act=before[-1] if before else None)
    return True
