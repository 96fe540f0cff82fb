"""--where and --rules: every kind of term, mistakes named by column or line, honest counts."""

from __future__ import annotations

from itertools import product

import pytest

from scegen.enumeration import enumerate_scenarios, plain_crossing
from scegen.enumeration.choosing.where import where
from scegen.enumeration.ruled import MAX_LISTED
from scegen.errors import InputError, NoScenarioError
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.logical import ConflictKind
from scegen.scenario.rule_file import RuleFile
from scegen.scenario.vocabulary import ArmsMode, Maneuver, Reduction

CARS = plain_crossing((0, 1, 2), 4)
MIXED = FunctionalScenario.model_validate(
    {
        "description": "made for a test",
        "junction": {"kind": "four_way", "arms": 4, "control": "priority_to_right"},
        "participants": [
            {"id": "me", "role": "ego", "entries": [0]},
            {"id": "bus", "kind": "bus", "entries": [1]},
            {"id": "walker", "kind": "pedestrian"},
        ],
    }
)


def by(scenario, name):
    return scenario.assignment(name)


def always(_):
    return True


def never(_):
    return False


def kinds(scenario):
    return [c.kind for c in scenario.conflicts]


@pytest.mark.parametrize(
    ("expression", "test"),
    [
        ("car_2.exit == 2", lambda s: by(s, "car_2").exit == 2),
        ("ego.turn in (left, right)", lambda s: by(s, "car_1").turn in ("left", "right")),
        ("ego.turn not in [left]", lambda s: by(s, "car_1").turn != "left"),
        ("left == ego.turn", lambda s: by(s, "car_1").turn == "left"),
        ("car_1.exit == car_2.exit", lambda s: by(s, "car_1").exit == by(s, "car_2").exit),
        ("conflicts(crossing) >= 2", lambda s: kinds(s).count("crossing") >= 2),
        (
            "conflict(car_3, ego) == merging",
            lambda s: any(
                (c.first, c.second, c.kind) == ("car_1", "car_3", "merging") for c in s.conflicts
            ),
        ),
        ("count(turn == left) > 1", lambda s: sum(d.turn == "left" for d in s.drives) > 1),
        ("yields(car_2, car_3)", lambda s: any(
            c.yields == "car_2" and c.second == "car_3" for c in s.conflicts)),
        ("not yields(ego) or index < 5", lambda s: s.index < 5 or not any(
            c.yields == "car_1" for c in s.conflicts)),
        ("ego.beside == none and deadlock", lambda s: bool(s.deadlock)),
    ],
)  # fmt: skip
def test_expressions_hold_where_they_say(expression, test):
    every = enumerate_scenarios(CARS).scenarios
    wanted = [s for s in every if test(s)]
    assert 0 < len(wanted) < len(every)
    listed = enumerate_scenarios(CARS, where=expression)
    assert list(listed.scenarios) == wanted
    assert listed.certificate.matching == len(wanted)
    assert (listed.certificate.count, listed.certificate.total) == (27, 27)
    assert listed.certificate.complete


def test_those_who_do_not_drive():
    listed = enumerate_scenarios(MIXED).scenarios
    for expression, test in {
        "walker.arm == 0 and walker.start == left": lambda s: (
            by(s, "walker").arm == 0 and by(s, "walker").start == "left"
        ),
        "walker.exit > 0": never,
        "walker.exit == none": always,
        "ego.arm != none": never,
        "count(kind == bus) == 1 and bus.role == other": always,
        "walker.maneuver == cross and ego.entry == 0": always,
    }.items():
        keep = where(MIXED, expression)
        assert [keep(s) for s in listed] == [test(s) for s in listed], expression


@pytest.mark.parametrize(
    ("expression", "column", "names"),
    [
        ("ego.turn == lefft", 13, "left"),
        ("ego.manuever == left", 5, "maneuver"),
        ("car_9.exit == 1", 1, "car_1"),
        ("conflicts(crosing) > 1", 11, "crossing"),
        ("confict(ego, car_2) == none", 1, "conflict"),
        ("ego.exit = 1", 10, "=="),
        ("ego.turn > 3", 1, "=="),
        ("ego.turn", 1, "compare"),
        ("1 < ego.exit < 3", 1, "and"),
        ("turn == left", 1, "deadlock"),
        ("ego.exit == left", 13, "index"),
    ],
)
def test_mistakes_are_named_by_column(expression, column, names):
    with pytest.raises(InputError) as caught:
        enumerate_scenarios(CARS, where=expression)
    assert f"column {column} of" in caught.value.where
    assert names in (caught.value.hint or "")


@pytest.mark.parametrize(
    "expression",
    [
        "", "(", "()", "ego", "1", "True", "ego.__class__ == 1", "__import__('os').system('ls')",
        "(lambda: 1)()", "[x for x in (1,)]", "ego.turn == 'left'", "count(exit)", "yields()",
        "conflicts(crossing, ego, 1) > 1", "f'{1}' == 1", "not" * 400, "(" * 900, "1" * 5000,
        "ego.exit is none", "count(turn == left, 1) > 0", "**", "a\x00b", "ego.exit + 1 == 2",
    ],
)  # fmt: skip
def test_what_is_no_expression_is_refused(expression):
    with pytest.raises(InputError):
        where(CARS, expression)


def test_a_limit_counts_the_matching_ones():
    full = enumerate_scenarios(CARS, where="ego.turn == left")
    cut = enumerate_scenarios(CARS, where="ego.turn == left", limit=2)
    assert cut.scenarios == full.scenarios[:2]
    assert not cut.certificate.complete
    assert cut.certificate.matching is None


@pytest.fixture
def rules():
    return lambda text: RuleFile(text, "mine.lp")


@pytest.mark.parametrize("reduction", Reduction)
@pytest.mark.parametrize("arms", ArmsMode)
def test_rules_that_tell_vehicles_and_arms_apart_keep_counts_honest(rules, reduction, arms):
    """Against plain loops: classes are those of the reduction, sizes count the allowed alone."""
    functional = plain_crossing((0, 1, 2, 3), 4)
    path = rules(":- turns(car_1,left).\n:- enters(V,0), leaves(V,X), enters(W,1), leaves(W,X).\n")
    moves = [m for m in product((1, 2, 3), repeat=4) if m[0] != 3 and m[0] % 4 != (1 + m[1]) % 4]
    turns = range(4) if arms is ArmsMode.EQUAL else [0]

    def classed(m):
        if reduction is Reduction.PATTERN:
            return tuple(sorted(m))
        if reduction is Reduction.NONE:
            return m
        return min(tuple(m[(i - t) % 4] for i in range(4)) for t in turns)

    sizes = {}
    for m in moves:
        sizes[classed(m)] = sizes.get(classed(m), 0) + 1
    found = enumerate_scenarios(functional, reduction=reduction, arms=arms, rules=path)
    assert {
        classed(tuple(d.move for d in s.drives)): s.class_size for s in found.scenarios
    } == sizes
    assert found.certificate.total == len(moves)
    assert found.certificate.count == len(sizes) == len(found.scenarios)
    assert any("tell apart" in note for note in found.notes) is (
        reduction is Reduction.PATTERN or (reduction is Reduction.EXACT and arms is ArmsMode.EQUAL)
    )


def test_every_word_of_the_vocabulary_says_what_the_scenario_says(rules):
    for text, test in {
        ":- not ego(me).": always,
        ":- conflict(me,bus,crossing).": lambda s: (
            not any(
                {c.first, c.second} == {"me", "bus"} and c.kind is ConflictKind.CROSSING
                for c in s.conflicts
            )
        ),
        ":- not comes_from(bus,me,right), does(me,left).": always,
        ":- comes_from(bus,me,right), does(me,left).": lambda s: (
            by(s, "me").turn is not Maneuver.LEFT
        ),
        ":- crosses(walker,A,_), not leaves(me,A).": lambda s: (
            by(s, "walker").arm == by(s, "me").exit
        ),
        ":- kind(V,bus), enters(V,E), arms(N), leaves(V,(E+2)\\N), arm(E), vehicle(V).": lambda s: (
            by(s, "bus").move != 2
        ),
        ":- does(P,cross), crosser(P), crosses(P,_,left).": lambda s: (
            by(s, "walker").start != "left"
        ),
    }.items():
        every = enumerate_scenarios(MIXED, reduction=Reduction.NONE).scenarios
        wanted = [s.assignments for s in every if test(s)]
        kept = enumerate_scenarios(MIXED, reduction=Reduction.NONE, rules=rules(text))
        assert [s.assignments for s in kept.scenarios] == wanted, text
        assert wanted


def test_rules_with_several_answers_of_their_own_list_nothing_twice(rules):
    path = rules("odd(V) :- vehicle(V), not even(V).\neven(V) :- vehicle(V), not odd(V).\n")
    assert len(enumerate_scenarios(CARS, rules=path).scenarios) == 27


@pytest.mark.parametrize(
    ("text", "line", "names"),
    [
        (":- enterss(V,1).", 2, "enters"),
        (":- enters(V).", 2, "2 arguments"),
        ("enters(car_1,0).", 2, "given"),
        ("placed(V) :- vehicle(V).", 2, "taken"),
        ("{a}.", 2, "choices"),
        ("a ; b.", 2, "choices"),
        ("#script(python) print(1) #end.", 2, "only rules"),
        ("#minimize{1}.", 2, "only rules"),
        ('#include "/etc/passwd".', 2, "one file"),
        ("#show.", 2, "only rules"),
        ("p(X) :- q(X).", 2, "q/1"),
        (":- #count{V : entres(V,0)} > 1.", 2, "enters"),
    ],
)
def test_mistakes_are_named_by_line(rules, text, line, names):
    with pytest.raises(InputError) as caught:
        enumerate_scenarios(CARS, rules=rules("% a remark\n" + text + "\n"))
    assert f"mine.lp, line {line}" in caught.value.where
    assert names in caught.value.render()


@pytest.mark.parametrize("text", [":- turns(car_1,", ":- not turns(V,left), V != X."])
def test_what_clingo_refuses_keeps_its_place(rules, text):
    with pytest.raises(InputError, match=r"mine\.lp:[23]:"):
        enumerate_scenarios(CARS, rules=rules("% a remark\n" + text + "\n"))


def test_rules_that_leave_nothing_or_too_much(rules):
    with pytest.raises(NoScenarioError, match="leave no scenario"):
        enumerate_scenarios(CARS, rules=rules(":- vehicle(V)."))
    assert MAX_LISTED < 3**12
    with pytest.raises(InputError, match="too many to list"):
        enumerate_scenarios(plain_crossing((0, 1, 2, 3) * 3, 4), rules=rules("a."))
