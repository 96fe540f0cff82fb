"""Reads the shape, the arms and the control of the junction."""

from dataclasses import dataclass
from itertools import pairwise

from scegen.errors import InfeasibleError
from scegen.scenario.junction import ARM_COUNTS, MAX_ARMS
from scegen.scenario.vocabulary import Control, JunctionKind
from scegen.understanding.entity import Basis
from scegen.understanding.lexicon import word_list
from scegen.understanding.road import absent
from scegen.understanding.road.absent import flashing, named_by_letter, only_counted, out_of_order
from scegen.understanding.words.numbers import POSITIONS
from scegen.understanding.words.terms import Term
from scegen.understanding.words.tokens import Token

_ARM_NOUNS = frozenset({"exit", "road", "leg"})
_ARMS = frozenset({"side", "leg", "approach", "road", "access", "direction"})
_ASSUMED_EXITS = 4
_WINDOW = 6
_FEWEST_ARMS = 3


@dataclass(slots=True)
class JunctionReading:
    """What the text says about the junction; None where it says nothing.

    With ``_basis``: the words for it, or the reason.

    Attributes:
        kind: its shape.
        arms: number of arms.
        control: who regulates priority.
        dark: the words that say that lights do not work.
        named: some word for a junction occurs, even if not its shape.
        straight: the words for a straight road.
        road: the first word for a road.
        highway: that word is one for a road with several lanes each way.
    """

    kind: JunctionKind | None = None
    kind_basis: Basis | None = None
    arms: int | None = None
    arms_basis: Basis | None = None
    control: Control | None = None
    control_basis: Basis | None = None
    dark: Basis | None = None
    named: Basis | None = None
    road: Basis | None = None
    straight: Basis | None = None
    highway: bool = False

    @property
    def crossing(self) -> bool:
        """Whether roads meet as far as the words say."""
        return self.kind not in {None, JunctionKind.STRAIGHT} or self.named is not None


def read_junction(terms: list[Term], tokens: list[Token]) -> JunctionReading:
    """What the text says about its junction.

    Raises:
        InfeasibleError: if the words contradict geometry ("a T-intersection with five arms").
    """
    reading, said = JunctionReading(), dict[Control, Basis]()
    for k, term in enumerate(terms):
        if term.cat == "place":
            _place(reading, terms, k, tokens)
            _place_control(said, terms, k, tokens)
        elif term.cat in {"actor", "manner"} and "control" in term.data:
            said.setdefault(Control(term.data["control"]), Basis(term.i, term.j))
        elif term.cat == "shape":
            _shape(reading, terms, k, tokens)
        elif term.cat == "cue":
            _set_kind(reading, JunctionKind(term.value), Basis(term.i, term.j), override=True)
        elif term.cat == "control" and not absent.negated(terms, k):
            said.setdefault(Control(term.value), Basis(term.i, term.j))
        elif term.cat in {"num", "quant"}:
            _counted_arms(reading, terms, k)
    counted = [o for o, t in pairwise(terms) if t.value == "exit" and POSITIONS.get(o.value, 0) > 0]
    if counted and reading.named is None and not reading.highway:  # "takes the second exit"
        _set_kind(reading, JunctionKind.ROUNDABOUT, Basis(counted[0].i, counted[0].j + 1))
    lines = [
        t for k, t in enumerate(terms) if t.value == "stop_line" and not absent.negated(terms, k)
    ]
    if lines and reading.kind is None and all(t.value != "crosswalk" for t in terms):
        reading.named = reading.named or Basis(lines[0].i, lines[0].j)  # nothing else has one
    if lines and not said and reading.crossing and reading.kind is not JunctionKind.ROUNDABOUT:
        reason = "a stop line without lights is one of a stop sign"
        said[Control.STOP] = Basis(lines[0].i, lines[0].j, reason)
    _regulate(reading, said)
    _reconcile(reading, tokens)
    return reading


def _place(reading: JunctionReading, terms: list[Term], k: int, tokens: list[Token]) -> None:
    term = terms[k]
    basis = Basis(term.i, term.j)
    if term.value == "junction" and not absent.away_from(terms, k):
        reading.named = reading.named or basis
        if "kind" in term.data:
            _set_kind(reading, JunctionKind(term.data["kind"]), basis)
    elif term.value in {"road", "highway", "lane"}:
        reading.road = reading.road or basis
        lane = term.value == "lane" and tokens[term.i].low in word_list("of_several")
        reading.highway = reading.highway or term.value == "highway" or lane
        before = terms[k - 1] if k else None
        if before is not None and before.value == "straight":
            reading.straight = Basis(before.i, term.j)


def _place_control(
    said: dict[Control, Basis], terms: list[Term], k: int, tokens: list[Token]
) -> None:
    """What stands at a place: a sign or a light, or none."""
    term = terms[k]
    control = term.data.get("control")
    lights = control == Control.SIGNALS
    carried = term.value == "stop_sign" and absent.held(terms, k)
    if control is None or carried or (lights and _of_a_vehicle(terms, k, tokens)):
        return
    stop = flashing(term, tokens, frozenset({"red"})) if lights else None
    off = flashing(term, tokens, word_list("flashing_colours")) if lights else None
    off = off or (out_of_order(term, tokens) if lights else None)
    if stop is not None:
        said.setdefault(Control.ALL_WAY_STOP, stop)
    elif off is not None:
        said.setdefault(Control.SIGNALS_OFF, off)
    elif absent.negated(terms, k):
        said.setdefault(Control.UNCONTROLLED, Basis(terms[k - 1].i, term.j))
    elif term.value == "stop_sign" and (every := _on_every_arm(terms, k)) is not None:
        said.setdefault(Control.ALL_WAY_STOP, every)
    else:
        said.setdefault(Control(control), Basis(term.i, term.j))


def _on_every_arm(terms: list[Term], k: int) -> Basis | None:
    """``stop signs on all four sides``, ``each approach has its own stop sign``."""
    marks = (m for m in range(k, 0, -1) if terms[m - 1].cat in {"punct", "sub"})
    for m in range(next(marks, 0), min(k + 5, len(terms))):
        on = m > 0 and terms[m - 1].cat == "prep"  # not "from every side cars come to a stop sign"
        arm = next((t for t in terms[m + 1 : m + 4] if t.cat not in {"num", "prep", "det"}), None)
        every = (terms[m].cat, terms[m].value) == ("quant", "all") and on == (m > k)
        if every and arm is not None and arm.value in _ARMS:
            return Basis(min(terms[k].i, terms[m].i), max(terms[k].j, arm.j))
    return None


def _of_a_vehicle(terms: list[Term], k: int, tokens: list[Token]) -> bool:
    """``its lights``, ``a bicycle with lights off``: not beside the road."""
    term = terms[k]
    if term.form != "s" or not k:
        return False
    before = terms[max(0, k - 4) : k]
    has = any(who.cat == "actor" and what.value == "with" for who, what in pairwise(before))
    bare = tokens[term.j - 1].low == "lights" and tokens[term.i].low != "traffic"
    return terms[k - 1].cat == "possessive" or (has and bare)


def _shape(reading: JunctionReading, terms: list[Term], k: int, tokens: list[Token]) -> None:
    """A shape counts where a junction is named after it or said to be so."""
    term = terms[k]
    counted = only_counted(terms, k, tokens)
    if counted is not None:
        reading.arms, reading.arms_basis = counted, Basis(term.i, term.j)
        return
    following = next((t for t in terms[k + 1 : k + 4] if t.value == "junction"), None)
    letter = term.j - term.i == 1 and term.value in {"t", "y"}
    named = letter and tokens[term.i].text == "T" and named_by_letter(terms, k)
    titled = term.j < len(tokens) and tokens[term.j].low == ":" and not letter
    if following is None and (letter or term.value == "four_way") and not (named or titled):
        return
    end = following.j if following is not None else term.j
    kind = JunctionKind(term.value)
    if kind is JunctionKind.SKEWED and following is None and reading.named is None:
        return
    _set_kind(reading, kind, Basis(term.i, end), override=True)


def _set_kind(
    reading: JunctionReading, kind: JunctionKind, basis: Basis, *, override: bool = False
) -> None:
    if reading.kind is None or (override and reading.kind is JunctionKind.FOUR_WAY):
        reading.kind, reading.kind_basis = kind, basis
    reading.named = reading.named or basis


_STRENGTH = {
    Control.ALL_WAY_STOP: 4, Control.SIGNALS: 3, Control.STOP: 2, Control.YIELD: 2,
    Control.PRIORITY_TO_RIGHT: 2, Control.SIGNALS_OFF: 1, Control.UNCONTROLLED: 0,
}  # fmt: skip


def _regulate(reading: JunctionReading, said: dict[Control, Basis]) -> None:
    """The strongest of what is said holds; beside lights that do not work, signs do."""
    reading.dark = said.get(Control.SIGNALS_OFF)
    if reading.dark is not None:
        said.pop(Control.SIGNALS, None)
    if said:
        reading.control = max(said, key=_STRENGTH.__getitem__)
        reading.control_basis = said[reading.control]


def _counted_arms(reading: JunctionReading, terms: list[Term], k: int) -> None:
    """``five-way intersection``, ``with 5 exits``, ``where six roads meet``, ``joins 5 roads``."""
    number = terms[k]
    noun = terms[k + 1] if k + 1 < len(terms) else None
    if noun is None or noun.value not in _ARM_NOUNS or noun.cat not in {"leg", "place"}:
        return
    meets = any(t.value == "approach" for t in terms[k + 2 : k + 4])
    joined = any(t.value == "junction" for t in terms[max(0, k - _WINDOW) : k + _WINDOW])
    before = [t.value for t in terms[max(0, k - 1) : k]]
    few = number.data.get("number", _FEWEST_ARMS) < _FEWEST_ARMS
    if few and (noun.value == "road" or before != ["with"]):
        return  # "where the two branches meet", "down one branch": some of them
    if not joined and not meets:
        return
    basis = Basis(number.i, noun.j)
    if number.cat == "num":
        reading.arms, reading.arms_basis = int(min(number.data["number"], 999)), basis
    elif number.value == "vague":
        reason = f"several exits without a number are read as {_ASSUMED_EXITS}"
        reading.arms, reading.arms_basis = _ASSUMED_EXITS, basis.because(reason)
    reading.named = reading.named or basis


def shape_of(arms: int) -> JunctionKind:
    """What a junction is of which only the number of arms is known."""
    return {3: JunctionKind.T, 4: JunctionKind.FOUR_WAY}.get(arms, JunctionKind.MULTI_WAY)


def _reconcile(reading: JunctionReading, tokens: list[Token]) -> None:
    arms = reading.arms
    if arms is None:
        return
    kind = reading.kind
    if kind is None:
        kind = shape_of(arms)
        reading.kind, reading.kind_basis = kind, reading.arms_basis
    elif kind is JunctionKind.FOUR_WAY and arms != ARM_COUNTS[kind][0]:
        basis = reading.kind_basis  # a "crossroads" may have any number of roads
        at = basis.i if basis is not None else None
        bare = at is not None and tokens[at].low.startswith("cross")
        reading.kind = kind = JunctionKind.MULTI_WAY if bare else kind
    fewest, most = ARM_COUNTS[kind]
    if fewest <= arms <= most:
        return
    words = _written(reading, tokens)
    what = "exits" if kind is JunctionKind.ROUNDABOUT else "arms"
    wanted = f"exactly {fewest}" if fewest == most else f"{fewest} to {min(most, MAX_ARMS)}"
    msg = f"a {kind.replace('_', '-')} junction cannot have {arms} {what} ({words})"
    raise InfeasibleError(msg, where="junction", hint=f"It needs {wanted} {what}.")


def _written(reading: JunctionReading, tokens: list[Token]) -> str:
    spans = [reading.kind_basis, reading.arms_basis]
    parts = [
        " ".join(t.text for t in tokens[b.i : b.j])
        for b in dict.fromkeys(s for s in spans if s)
        if b.i is not None
    ]
    return " … ".join(f"'{p}'" for p in dict.fromkeys(parts))
