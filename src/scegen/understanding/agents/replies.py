"""What each agent must answer: the scenario's own types, and the words that they rest on."""

from __future__ import annotations

from typing import Any

from pydantic import Field, model_validator

from scegen.scenario.acts import Act
from scegen.scenario.environment import Environment
from scegen.scenario.functional import FunctionalScenario, Hazard, Participant, Relation
from scegen.scenario.junction import Junction
from scegen.scenario.model import FrozenModel
from scegen.scenario.outcome import Outcome
from scegen.scenario.spacings import Spacing
from scegen.scenario.things import Thing
from scegen.scenario.vocabulary import Role
from scegen.understanding.agents.result import LONGEST_REMARK, Objection

_MOST_PARTICIPANTS = 60
_MOST_REMARKS = 400
_REMARKS = {"basis", "unsupported"}


class Basis(FrozenModel):
    """What one field rests on: words copied from the text, or a reason."""

    field: str = Field(max_length=100)
    words: str | None = Field(default=None, max_length=LONGEST_REMARK)
    reason: str | None = Field(default=None, max_length=LONGEST_REMARK)


class Passage(FrozenModel):
    """Words that matter but fit no field, and what was done instead."""

    words: str = Field(min_length=1, max_length=LONGEST_REMARK)
    instead: str = Field(min_length=1, max_length=LONGEST_REMARK)


class Reply(FrozenModel):
    """An agent's answer."""

    basis: tuple[Basis, ...] = Field(default=(), max_length=_MOST_REMARKS)
    unsupported: tuple[Passage, ...] = Field(default=(), max_length=_MOST_REMARKS)

    def parts(self) -> dict[str, Any]:
        """Its fields that are fields of the scenario, by name."""
        names = FunctionalScenario.model_fields.keys() & type(self).model_fields.keys()
        return {n: getattr(self, n) for n in type(self).model_fields if n in names - _REMARKS}


class RoadReply(Reply):
    """The road agent's answer: the junction and the conditions."""

    junction: Junction
    environment: Environment = Environment()


class ParticipantsReply(Reply):
    """The participants agent's answer; ``not_traffic`` says why there are none."""

    participants: tuple[Participant, ...] = Field(max_length=_MOST_PARTICIPANTS)
    relations: tuple[Relation, ...] = Field(default=(), max_length=_MOST_PARTICIPANTS)
    objects: tuple[Thing, ...] = Field(default=(), max_length=_MOST_PARTICIPANTS)
    not_traffic: str | None = Field(default=None, max_length=LONGEST_REMARK)

    @model_validator(mode="after")
    def _one_ego(self) -> ParticipantsReply:
        if self.not_traffic is not None:
            return self
        ids = [p.id for p in self.participants]
        egos = [p.id for p in self.participants if p.role is Role.EGO]
        if len(egos) != 1:
            msg = f"exactly one participant must have the role ego, found {egos or 'none'}"
            raise ValueError(msg)
        if len(set(ids)) != len(ids):
            msg = f"participant ids are not unique: {sorted(ids)}"
            raise ValueError(msg)
        for name in (n for r in self.relations for n in (r.participant, r.reference)):
            if name not in ids:
                msg = f"relations names the unknown participant {name!r}; there are {ids}"
                raise ValueError(msg)
        return self


class HazardsReply(Reply):
    """The hazards agent's answer."""

    hazards: tuple[Hazard, ...] = Field(max_length=_MOST_PARTICIPANTS)


class ActsReply(Reply):
    """The acts agent's answer: what happens, how far apart they are, how it ends."""

    acts: tuple[Act, ...] = Field(default=(), max_length=_MOST_PARTICIPANTS)
    spacings: tuple[Spacing, ...] = Field(default=(), max_length=_MOST_PARTICIPANTS)
    outcome: Outcome | None = None


class Review(FrozenModel):
    """The reviewer's answer."""

    objections: tuple[Objection, ...] = Field(max_length=20)
