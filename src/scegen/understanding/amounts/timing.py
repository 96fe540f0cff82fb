"""When acts happen by the clock: so long after the start, or after another act."""

from collections.abc import Collection

from scegen.scenario.acts import ActKind
from scegen.scenario.signals import AtLight
from scegen.scenario.spacings import Measure
from scegen.understanding.amounts.figures import Figure
from scegen.understanding.amounts.telling import ANY, CHANGING, Telling
from scegen.understanding.entity import Basis, Entity
from scegen.understanding.happenings import Doing, Since
from scegen.understanding.lexicon import word_list


def part_of(figure: Figure) -> tuple[int, list[Entity]]:
    """Where the part of a sentence begins in which it stands, and who it is about.

    A comma or conjunction begins a part if it has a subject of its own.
    """
    for k in range(figure.i - 1, figure.start - 1, -1):
        if k > figure.start and figure.text.tokens[k - 1].low not in word_list("joints"):
            continue
        named = (m for m in figure.text.mentions if k <= m.i < figure.i and m.prep is None)
        free = [m for m in named if m.entities]
        if free and not free[0].possessor:
            return k, list(free[0].entities)
    return figure.start, []


def likewise(figure: Figure, kinds: Collection[ActKind]) -> Doing | None:
    """``A brakes with 4 m/s², B 1 s later``: B does the same, without a verb."""
    begin, who = part_of(figure)
    text, (start, end) = figure.text, (figure.start, figure.end)
    joints = (k for k in range(figure.i, end) if text.tokens[k].low in word_list("joints"))
    elided = bool(who) and any(c.actors for c in text.within(start, begin))
    if not elided or text.within(begin, next(joints, end)):
        return None
    told = text.acts(start, begin, kinds)
    if not told or told[-1].entity in who:
        return None
    made = [text.same(told[-1], e, figure.i, figure.amount.basis) for e in who]
    return made[0]


_COMING = frozenset({"enter", "move", "pass", "cross", "turn", "approach", "appear", "merge"})
_SETTING_OUT = frozenset({"cross", "walk", "dash", "enter", "appear"})
_GREEN_REACH = 9
_ENDING = frozenset({"target_speed_mps", "duration_s", "distance_m"})


def delayed(figure: Figure) -> bool:
    """``after 3 s``, ``2 s later``, ``1 s after the van has cut in``."""
    since = _since(figure)
    doing = likewise(figure, ANY) or act_of(figure) or _comes_in(figure)
    if doing is None or doing.when is not None:
        return False
    base, at = _base(figure, doing)
    if base is None and since == "after":
        return False  # "2 s after the car has passed the sign": since something that is no act
    doing.when = figure.trigger("after" if base else "start", act=base, since=at)
    return True


def _since(figure: Figure) -> str:
    """The word after a time: "after" only where it opens a clause ("after that" opens none)."""
    after = figure.text.low(figure.j, figure.j + 4)
    named = any(m.i == figure.j + 1 and m.j > figure.j + 2 for m in figure.text.mentions)
    those = tuple(f" after {that} " for that in word_list("after_those"))
    if after.startswith(those) and not named:
        return "later"
    if after.startswith(" after ") and figure.text.find("starts", figure.j, figure.j + 4):
        return "start"
    return next(iter(after.split()), "")


def _waiting(text: Telling) -> list[Entity]:
    """Those who wait for green."""
    return [e for e in text.draft.entities if e.light and e.light[0] is AtLight.WAITS]


def at_green(figure: Figure) -> bool:
    """``sets off 0.8 s after the light has turned green``: who waits for that."""
    text, j = figure.text, figure.j
    ends = [k for k in range(j, figure.end) if text.tokens[k].low in {",", "and"}]
    if " green " not in text.low(j, min([*ends[:1], j + _GREEN_REACH, figure.end])):
        return False
    doing = act_of(figure)
    who = [doing.entity] if doing is not None else figure.subject
    waits = _waiting(text)
    for entity in ([e for e in waits if e in who] if who else waits)[:1]:
        entity.green_delay = entity.green_delay or figure.exactly
        return True
    return False


def since_green(doing: Doing, text: Telling) -> None:
    """``the light turns green. The car ahead sets off 3 s later``: since the green."""
    when, entity = doing.when, doing.entity
    if when is None or when.kind != "start" or doing.kind is not ActKind.SET_OFF:
        return
    if entity in _waiting(text) and " green " in text.low(0, when.basis.i or 0):
        entity.green_delay, doing.when = entity.green_delay or when.amount, None


def earlier(figure: Figure) -> bool:
    """``the van enters 1.5 s before the ego gets there``: the other's act comes later."""
    text = figure.text
    told = text.acts(figure.start, figure.i)
    first = told[-1] if told else _comes_in(figure)
    if _steps_out(figure):
        return True
    if first is None:
        return False
    second = next(iter(text.acts(figure.j, figure.end)), None)
    if second is None:
        named = [m for m in text.mentions if figure.j <= m.i < figure.end and m.entities]
        who = [m.entities[0] for m in named if m.entities[0] is not first.entity]
        who = [e for e in who if "circulates" not in e.told]  # it is in the ring already
        if who and who[0].still:  # "cuts out 2 s before a standing van"
            pair = {"entity": first.entity, "reference": who[0]}
            first.when = figure.trigger("measure", measure=Measure.TTC_S, **pair)
            return True
        if not who or first.kind is not ActKind.ENTER:
            return False
        second = text.same(first, who[0], figure.j, first.basis)
    second.when = figure.trigger("after", act=first, since="begin")
    return True


def _steps_out(figure: Figure) -> bool:
    """``steps off the kerb 2 s before the ego gets there``: when that one is so near in time."""
    text = figure.text
    comes = next((e for e in text.spoken_of(figure.j, figure.end) if e.moving_vehicle), None)
    crossing = text.acts(figure.start, figure.end, {ActKind.CROSS})
    does = [a for a in crossing if a.when is None and a.entity is not comes]
    ends = figure.i > figure.start and figure.does not in _SETTING_OUT  # "has left the lane 1 s …"
    verb = figure.verb
    ends = ends or (verb is not None and verb.perfect and verb.lemma == "cross")
    if comes is None or not does or ends:
        return False
    pair = {"entity": comes, "reference": does[0].entity}
    does[0].when = figure.trigger("measure", measure=Measure.TTC_S, **pair)
    return True


def _comes_in(figure: Figure) -> Doing | None:
    """``a van from the right 2 s after the ego``: it comes into the junction."""
    text = figure.text
    told = [c for c in text.within(figure.i, figure.end) if c.event.name in _COMING]
    who = [e for c in told for e in c.drivers] or part_of(figure)[1]
    if not text.context.meeting or not who or not who[0].is_vehicle:
        return None
    return text.add(Doing(ActKind.ENTER, who[0], figure.amount.basis, figure.i))


def _counted_on(figure: Figure, before: list[Doing]) -> bool:
    """``after 3 s it changes lanes, after 6 s it brakes``: both since the start."""
    since = before[-1].when
    if since is None or since.kind != "start" or since.amount is None:
        return False
    words = [figure.text.tokens[i - 1].low for i in (figure.i, since.basis.i or 0)]
    return words[0] == words[1] and figure.exactly.value.low > since.amount.value.low


def _of_the_other(figure: Figure, doing: Doing) -> Doing | None:
    """``1 s after the van``, and no verb: after it has done the same."""
    text = figure.text
    named = next((m for m in text.mentions if m.i == figure.j + 1 and m.entities), None)
    if named is None or named.entities[0] is doing.entity:
        return None
    here = text.within(named.j, figure.end)  # not "1 s after a van that comes from the left"
    helped = any(c.cat == "aux" and named.j <= c.i < figure.end for c in text.chunks)
    told = (c for c in here if c.event.finite and not c.event.embedded)
    if helped or any(c.actors == named.entities for c in told):
        return None
    other = named.entities[0]
    kind = ActKind.ENTER if doing.kind is ActKind.TURN else doing.kind  # whichever way it goes
    alike = [a for a in text.found.acts if a.entity is other and a.kind is kind]
    made = Doing(kind, other, Basis(named.i, named.j), named.i, always=doing.always)
    return alike[0] if alike else text.add(made)


def endless(doing: Doing, text: Telling) -> bool:
    """``1 s after the lead car brakes``: nothing says when it has done so."""
    told = [c.event for c in text.scenes if c.event.i in doing.places]
    over = any(e.perfect for e in told if e.i == doing.i) or _ENDING & set(doing.amounts)
    if doing.kind is ActKind.CROSS:  # "has stepped off the kerb": there the crossing begins
        return all(e.lemma != "cross" for e in told)
    return doing.kind in CHANGING and not over


def act_of(figure: Figure) -> Doing | None:
    """The act that is delayed: the one before the time in its clause, else the next."""
    text, i = figure.text, figure.i
    here = told_in(text, figure.start, figure.end)
    joined = [k for k in (i - 2, i - 1) if text.tokens[max(k, 0)].low in {"and", "then"}]
    commas = [k for k in range(figure.start, i) if text.tokens[k].low == ","]
    opening = max([part_of(figure)[0], *(k + 1 for k in (*commas, *joined))])
    earlier = [a for k, a in here if k < i]
    before = [a for k, a in here if opening <= k < i]
    after = [(k, a) for k, a in here if k > i]
    if before:
        return before[-1]
    if _since(figure) == "after" and len(after) > 1:
        return after[1][1]
    if _since(figure) == "after" and after and earlier and not joined:
        return earlier[-1]  # "brakes with 4 m/s², 0.5 s after the van has braked"
    comma = next((k for k in range(figure.j, figure.end) if text.tokens[k].low == ","), -1)
    comma = comma if _since(figure) in word_list("of_what") else -1  # "after 3 s it turns, …"
    first = [a for k, a in after if k > comma] or [a for _, a in after]
    return first[0] if first else None


def told_in(text: Telling, start: int, end: int) -> list[tuple[int, Doing]]:
    """The acts that are told of in a part of the text, with where, also for another time."""
    found = [(i, a) for a in text.found.acts for i in a.places if start <= i < end]
    return sorted(found, key=lambda f: f[0])


def _base(figure: Figure, doing: Doing) -> tuple[Doing | None, Since]:
    """Since when a delay counts."""
    text, since = figure.text, _since(figure)
    if since == "after":
        clause = [a for _, a in told_in(text, figure.j, figure.end) if a is not doing]
        if not clause:
            other = _of_the_other(figure, doing)
            return other, "begin" if other is not None else "end"
        begins = text.low(figure.j, clause[0].i)
        begun = any(f" {w} " in begins for w in word_list("begun"))
        return clause[0], "begin" if begun or endless(clause[0], text) else "end"
    before = [a for a in text.found.acts if a.i < doing.i]
    if not before or figure.words_around.closes("by_the_clock") or _counted_on(figure, before):
        return None, "end"
    last = before[-1]
    own = last.entity is doing.entity
    later = any(t.low in word_list("later") for t in text.tokens[figure.j : figure.j + 2])
    # of braking without an end, or that another answers: "the ego reacts after 1 s"
    ends = last.kind not in CHANGING or (own and _ENDING & set(last.amounts))
    return last, "end" if ends and (own or later) else "begin"
