"""Concrete scenarios with one thing changed."""

from __future__ import annotations


def changed(concrete, name, motion=None, **fields):
    """The scenario with some of one participant's numbers changed."""

    def new(one):
        if one.id != name:
            return one
        moved = {"motion": one.motion.model_copy(update=motion)} if motion else {}
        return one.model_copy(update=fields | moved)

    people = tuple(new(one) for one in concrete.participants)
    return concrete.model_copy(update={"participants": people})


def start(concrete, name):
    return concrete.participant(name).motion.start_m


def phase(concrete, name, number=0, **fields):
    """The scenario with a phase of one participant's program changed."""
    program = list(concrete.participant(name).speed_program)
    program[number] = program[number].model_copy(update=fields)
    return changed(concrete, name, speed_program=tuple(program))


def later(concrete, name, metres, number=0):
    """The scenario with a phase that is set off so much later."""
    trigger = concrete.participant(name).speed_program[number].trigger
    moved = trigger.model_copy(update={"distance_m": trigger.distance_m + metres})
    return phase(concrete, name, number, trigger=moved)


def on_road(concrete, **fields):
    """The scenario with something of its road changed."""
    return concrete.model_copy(update={"road": concrete.road.model_copy(update=fields)})
