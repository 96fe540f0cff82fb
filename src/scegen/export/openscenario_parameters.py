"""Scenarios with parameters: their declarations, and files of values to play them with."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from scegen.export.library import xosc
from scegen.export.openscenario_numbers import Numbers
from scegen.scenario.concrete import ConcreteScenario

VERSION = "1.2"
"""The first of which the ASAM checkers look at everything; parameters with bounds, and starts
along a path, are older (1.1)."""


@dataclass(frozen=True, slots=True)
class Declared:
    """A parameter of a file with its default and its bounds, in SI units."""

    name: str
    value: float
    low: float
    high: float


@dataclass(frozen=True, slots=True)
class Parameterisation:
    """What differs from the file of the scenario alone.

    ``fastest`` is the scenario with the highest of all speeds and rates, which vehicles must be
    capable of; ``note`` says what is no parameter.
    """

    declared: Sequence[Declared]
    numbers: Numbers
    fastest: ConcreteScenario
    note: str


def declarations(declared: Sequence[Declared]) -> xosc.ParameterDeclarations:
    """The declarations of a file, each with one group of constraints: within its bounds."""
    result = xosc.ParameterDeclarations()
    for item in declared:
        parameter = xosc.Parameter(item.name, xosc.ParameterType.double, in_file(item.value))
        bounds = xosc.ValueConstraintGroup()
        for rule, bound in (
            (xosc.Rule.greaterOrEqual, item.low),
            (xosc.Rule.lessOrEqual, item.high),
        ):
            bounds.add_value_constraint(xosc.ValueConstraint(rule, in_file(bound)))
        parameter.add_value_constraint_group(bounds)
        result.add_parameter(parameter)
    return result


def distribution(
    description: str, scenario_file: str, sets: Sequence[Mapping[str, float]], minor: int
) -> xosc.ParameterValueDistribution:
    """The sets of values that a scenario file is to be played with, one after the other."""
    several = xosc.DeterministicMultiParameterDistribution()
    for values in sets:
        one = xosc.ParameterValueSet()
        for name, value in values.items():
            one.add_parameter(name, in_file(value))
        several.add_value_set(one)
    deterministic = xosc.Deterministic().add_multi_distribution(several)
    return xosc.ParameterValueDistribution(
        description, "ML-SceGen", scenario_file, deterministic, osc_minor_version=minor
    )


def in_file(value: float) -> str:
    """A value as it stands in a file, without an exponent."""
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
