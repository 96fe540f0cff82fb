"""Speeds in numbers: of whom they are said, by the words around or who acts in the clause."""

from scegen.scenario.acts import ActKind
from scegen.scenario.bodies import BODIES
from scegen.scenario.model import Interval
from scegen.scenario.vocabulary import ON_FOOT, ParticipantKind
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.chunks import Event, Mention, Place
from scegen.understanding.clauses.dependents import chain
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import STILL, Amount, Doing
from scegen.understanding.lexicon import word_list
from scegen.understanding.words.quantities import Quantity
from scegen.understanding.words.terms import Term

_PAIR = 2
_RUNNING_MPS = 8.0
_BY_MUSCLE = ON_FOOT | {ParticipantKind.BICYCLE}


def held(figure: Figure) -> bool:
    """A speed that somebody holds: whose it is by its words or clause, else who acts there."""
    text, speed, words_ = figure.text, figure.quantity.value, Basis(figure.i, figure.j)
    change = _from_to(figure)
    outer = _past_a_clause(figure)
    taken = _taken(figure) if not outer else []
    if change is not None:
        for entity in taken or [change.entity]:
            entity.speed, entity.speed_basis = figure.quantity.parts[0], words_
        return True
    shared = text.low(figure.j, figure.j + 1).strip() in {"each", "both"}
    if taken and not shared:
        return True
    meant = [e for e in outer or _meant(figure) if e not in taken]
    able = _able(figure, meant)
    if not able and text.ego.speed is None:
        able = _able(figure, [text.ego]) or meant or [text.ego]
    others = [e for e in able if e.speed not in (None, speed)]
    again = [e for e in able if e.speed_basis and figure.start <= (e.speed_basis.i or 0)]
    if able and not _is_anew(figure, others) and all(e in others or e in again for e in able):
        named = reversed(text.spoken_of(figure.start, figure.i))  # "beside a truck, also 100 km/h"
        able = [e for e in named if e.speed is None and not e.still][:1] or able
    for entity in able:
        if entity.speed is not None and entity.speed != speed:
            _hand_on(entity, figure)
        if _free(entity, figure):
            entity.speed, entity.speed_basis = speed, figure.amount.basis
        elif entity.speed != speed:
            return False
        else:
            text.found.speeds_again.append((entity, words_))
    return bool(taken or able)


def _is_anew(figure: Figure, others: list[Entity]) -> bool:
    """``sits behind us at 80, then passes at 90``: a clause later; not ``passes a van at 90``."""
    verb = figure.verb
    if verb is None or verb.embedded or not verb.finite:
        return False
    noun = any(0 <= figure.i - m.j <= 2 and m.heads and not m.is_me for m in figure.text.mentions)
    return not noun and any(e.speed_basis and (e.speed_basis.i or 0) < verb.i for e in others)


def _taken(figure: Figure) -> list[Entity]:
    """Gives it to whose it is, by the words around or the clause, if they can be so fast."""
    near = figure.named_before(figure.i - 1)
    taken = []
    for entity, quantity in whose(figure):
        able = _can(entity, quantity.value, near) and not entity.parked
        if able and _free(entity, figure):
            basis = Basis(figure.i, figure.j, quantity.note)
            entity.speed, entity.speed_basis = quantity.value, basis
            taken.append(entity)
    return taken


def _free(entity: Entity, figure: Figure) -> bool:
    """Whether it may be so fast: "at 30 km/h …; nothing moves", "waits, then turns at 10 km/h"."""
    later = entity.speed_basis is not None and figure.i < (entity.speed_basis.i or 0)
    return entity.speed is None or (entity.speed == STILL and (later or entity.sets_off >= 0))


def _able(figure: Figure, meant: list[Entity]) -> list[Entity]:
    """Those who can be so fast."""
    speed = figure.quantity.value
    near = figure.named_before(figure.i - 1)  # "runs across in front of the ego at 50 km/h"
    for entity in meant:  # "a bike passes us at 140 km/h"
        bike = entity.kind is ParticipantKind.BICYCLE and entity.named_by == {"bike"}
        if bike and speed.low > BODIES[entity.kind].top_speed_mps:
            entity.kind = ParticipantKind.MOTORCYCLE
    return [e for e in meant if _can(e, speed, near)]


def _can(entity: Entity, speed: Interval, near: list[Entity]) -> bool:
    """Whether it can be so fast: not if it stands all the time.

    If somebody else stands nearer, what one does by muscle in traffic is the most.
    """
    stands = entity.still or "held" in entity.told
    stays = stands and not entity.ego and entity.sets_off < 0 and speed.high > 0
    own = not near or entity in near or entity.kind not in _BY_MUSCLE
    top = BODIES[entity.kind].top_speed_mps
    return not stays and speed.low <= (top if own else min(top, _RUNNING_MPS))


def _from_to(figure: Figure) -> Doing | None:
    """``brakes from 50 to 20 km/h``: what it drove before, and what it comes to."""
    text, parts, i = figure.text, figure.quantity.parts, figure.i
    if len(parts) != _PAIR or figure.words_around.closes("ranging"):
        return None  # "drives at anything from 60 to 70 km/h"
    # "brakes, 100 to 60 km/h": no range goes down
    joined = any(t.low in word_list("up_to") for t in text.tokens[i : figure.j])
    falls = joined and parts[0].low > parts[1].low
    arrow = any(t.low == "to" and not t.text.isalpha() for t in text.tokens[i : figure.j])
    if not falls and not arrow and not figure.words_around.preceded("from"):
        return None
    first, last = parts
    kind = ActKind.BRAKE if last.low < first.low else ActKind.ACCELERATE
    here = text.acts(figure.start, figure.end, {kind, ActKind.STOP})
    if not here and figure.subject:  # "slowing of the van from 90 to 36 km/h"
        told = [figure.verb.i] if figure.verb is not None else []
        made = Doing(kind, figure.subject[0], Basis(i, figure.j), i, told=told)
        here = [text.add(made)]  # "goes from 60 to 100 km/h"
    if not here:
        return None
    doing = next((a for a in reversed(here) if a.i < i), here[0])
    for each in (a for a in here if a.i == doing.i):  # "the traffic ahead slows from 100 to 40"
        each.amounts.setdefault("target_speed_mps", Amount(last, Basis(i, figure.j)))
    return doing


def _meant(figure: Figure) -> list[Entity]:
    """Who drives or walks so fast."""
    movers = [e for e in figure.actors if not e.parked]
    owned = figure.text.tokens[figure.start].low in word_list("its_own")
    return figure.subject if owned or not movers else movers


def _past_a_clause(figure: Figure) -> list[Entity]:
    """``steps out when the ego is 20 m away, at 4 km/h``: a comma ends the clause put in."""
    text, clause = figure.text, figure.clause
    if clause is None or clause[2] or text.low(figure.i - 2, figure.i - 1) != " , ":
        return []
    begin, told = clause[0], text.within(figure.start, clause[0])
    far = any(c.cat == "quantity" and begin < c.i < figure.i for c in text.chunks)
    inside = text.within(begin, figure.i)
    return told[-1].actors if told and far and not inside else []


def _hand_on(entity: Entity, figure: Figure) -> None:
    """``overtakes a tractor at 25 km/h; the ego drives 70 km/h``: the first was the tractor's.

    In "At 100 km/h, a truck cuts in at 80 km/h" it was the ego's.
    """
    basis, text = entity.speed_basis, figure.text
    if basis is None or basis.i is None:
        return  # nobody said it
    start, i = text.bounds(basis.i)[0], basis.i
    named = [m.entities for m in text.mentions if start <= m.i < i][-1:]
    alone = named[0] if named and len(named[0]) == 1 else []
    others = [e for e in alone if e is not entity] if named else [text.ego]
    for other in (e for e in others if e.speed is None and not e.still):
        other.speed, other.speed_basis = entity.speed, basis
        entity.speed = entity.speed_basis = None


_WAITS = frozenset({"wait", "yield", "cause", "hide"})
_FROM_REST = frozenset({"pull_out", "unpark", "reverse", "door", "leave"})
_BESIDES = frozenset({"prep", "locus", "manner", "aux"})


def whose(figure: Figure) -> list[tuple[Entity, Quantity]]:
    """Those whose speed it is, with what it is of each of them; none where nothing tells."""
    near = _for_whom(figure) or figure.named_before(_outside(figure))
    near = near or _of_the_noun(figure) or _opens_with(figure)
    return _one_each(near or _by_clause(figure), figure)


def _one_each(whom: list[Entity], figure: Figure) -> list[tuple[Entity, Quantity]]:
    """``ego and van at 50 and 70 km/h``: as many as participants, in order; one is that of all."""
    parts = figure.quantity.parts
    last = next((m for m in reversed(figure.text.mentions) if m.j <= figure.i), None)
    if last is not None and last.joined is not None and whom == last.entities:
        named = [entity for mention in chain(last) for entity in mention.entities]
        shared = _outside(figure) == figure.i  # not "a van and the ego (at 60 km/h)"
        shared = shared and any((m.i, m.j) == (figure.i, figure.j) for m in last.mods)
        own = len(parts) == len(named) or shared
        whom = named if own else whom
    return list(zip(whom, figure.quantity.each(len(whom)), strict=True))


def _for_whom(figure: Figure) -> list[Entity]:
    """``60 km/h for the ego and 20 km/h for the van``, ``60 km/h (ego), 20 km/h (van)``."""
    text = figure.text
    who = next((m for m in text.mentions if m.i >= figure.j), None)
    acts = text.within(figure.start, figure.i)
    if who is None or acts:
        return []
    within = text.low(figure.j, who.i) == " ( " and text.low(who.j, who.j + 1) == " ) "
    return list(who.entities) if within or text.low(figure.j, who.i) == " for " else []


def _outside(figure: Figure) -> int:
    """``a tractor (width 2.5 m, speed 30 km/h)``: where the brackets open around a number."""
    tokens = figure.text.tokens
    marks = [k for k in range(figure.start, figure.i) if tokens[k].low in {"(", ")"}]
    return marks[-1] if marks and tokens[marks[-1]].low == "(" else figure.i


def _of_the_noun(figure: Figure) -> list[Entity]:
    """``a car from the left at 50 km/h``, ``waits for a van at 50 km/h``, ``both at 50 km/h``.

    Who waits has no speed, and who sets off has none yet.
    """
    text, verb, end = figure.text, figure.verb, figure.i - 1
    who = next((m for m in reversed(text.mentions) if m.i <= figure.i), None)
    if who is None or who.possessor or who.i < figure.start or who.j >= figure.i:
        return []  # "a 60 km/h truck": its own
    if _before_any_verb(figure, who):
        return list(figure.placed_by(who).entities)
    passed = verb is not None and verb.object is who  # "overtakes both at 120 km/h"
    told = who.pronoun in {"both", "all"} and not (passed or text.within(who.j, figure.i))
    sides = [p for p in who.pps if p.value == "from" and p.names("side", "direction")]
    if any(p.place is not None and p.place.j == end for p in sides):
        told |= who.pronoun is None and not who.stands_after("of")
    elif verb is not None and who.j == end:
        ahead = any(p.value == "ahead" and p.target is who for p in verb.pps)
        awaited = verb.name in _WAITS and (who.prep is not None or verb.object is who)
        out = verb.name == "cut_in" and any(e.pulls_out for e in figure.actors)
        rests = (out or verb.name in _FROM_REST) and ahead
        met = figure.scene.targets if figure.scene is not None else []
        told |= who.stands_after("with") and not any(e in met for e in who.entities)
        # "turns left in front of a bus at 50 km/h", "… across the path of an oncoming bus …"
        comes = bool(who.ways) or (verb.name == "turn" and who.opened_by("indef"))
        told |= comes and who.prep is not None and not who.stands_after("with", "by")
        told |= awaited or (rests and not _has_another(figure, who))
    return list(who.entities) if told else []


def _before_any_verb(figure: Figure, who: Mention) -> bool:
    """``a coach at 60 km/h is overtaken by a taxi``, ``between me, at 50 km/h, and the van``."""
    if who.stands_after("of") or figure.text.within(figure.start, figure.i):
        return False
    between = [c for c in figure.text.chunks if who.j <= c.i < figure.i]
    return all((c.cat in _BESIDES or c.value == "," or isinstance(c, Place)) for c in between)


def _opens_with(figure: Figure) -> list[Entity]:
    """``At about 100 km/h, the ego is overtaken by a van``: of whom the sentence is about.

    So it is in "60 km/h is the speed of both".
    """
    text = figure.text  # behind a title, if there is one; "…, and at 80 km/h a van drives ahead"
    joints = (c for c in text.chunks if c.value == ":" or (c.cat == "conj" and c.j == figure.i - 1))
    start = max([figure.start, *(c.j for c in joints if c.i < figure.i)])
    before = [c for c in text.chunks if start <= c.i < figure.i]
    fronted = {id(p.target) for m in text.mentions for p in m.pps if p.fronted}  # "behind a bus"
    free = (m for m in text.mentions if id(m) not in fronted)
    who = next((m for m in free if start <= m.i < figure.end), None)
    if who is None or any(isinstance(c, Mention | Event) for c in before):
        return []
    if text.low(figure.j, figure.j + 1) == " : ":
        return [text.ego]  # "CPLA, 20 km/h: …": a title tells of who is tested
    named = text.low(figure.j, who.i).split()
    if named[:1] == ["is"] and named[-1:] == ["of"] and set(named) & word_list("rates"):
        return list(who.entities)
    acts = [c for c in text.within(start, who.i) if not c.event.embedded]
    told = before and who.prep is None and not who.possessor and not acts
    return list(who.entities) if told else []


def _by_clause(figure: Figure) -> list[Entity]:
    """The noun's, or of who acts.

    In "a van drives at 80 km/h, a bus in the right lane at 60 km/h" the bus does as the van, but
    at a speed of its own.
    """
    nouns, verbs = _of_nouns_and_verbs(figure)
    own = {e for speed, who in nouns if speed.i > figure.i for e in who}
    told = [*nouns, *((speed, [e for e in who if e not in own]) for speed, who in verbs)]
    return [e for t, who in told if (t.i, t.j) == (figure.i, figure.j) for e in who]


def _has_another(figure: Figure, who: Mention) -> bool:
    """Whether a speed is told of somebody elsewhere ("… in front of us at 30; we do 70")."""
    nouns, verbs = _of_nouns_and_verbs(figure)
    told = {e for speed, of in (*nouns, *verbs) if speed.i != figure.i for e in of}
    return any(e in told for e in who.entities)


def _of_nouns_and_verbs(figure: Figure) -> list[list[tuple[Term, list[Entity]]]]:
    """The speeds that stand with a noun, and those with a verb; with whose they are."""
    nouns = [(m.mods, m.entities) for m in figure.text.mentions]
    verbs = [(s.event.mods, s.actors) for s in figure.text.scenes]
    return [
        [(t, who) for mods, who in told for t in mods if (t.cat, t.value) == ("quantity", "speed")]
        for told in (nouns, verbs)
    ]
