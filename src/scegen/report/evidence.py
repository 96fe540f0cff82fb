"""The description cut into spans, each with what was understood from it."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from itertools import pairwise

from scegen.report.words import hazard_words, plain
from scegen.scenario.evidence import Evidence
from scegen.scenario.functional import FunctionalScenario
from scegen.scenario.paths import NOWHERE, value_at
from scegen.scenario.proof import ClaimProof
from scegen.understanding import STANDINGS, Finding, Standing, passages, report_on
from scegen.understanding.report.parse_report import Disagreement
from scegen.units import parted

LONGEST_SHOWN = 20_000
"""Characters of a description that are shown."""
STANDS_FOR = {
    Standing.UNDERSTOOD: "said in the text",
    Standing.INFERRED: "concluded from the text",
    Standing.ASSUMED: "not said: a default",
    Standing.CONTRADICTED: "said or read in two ways",
    Standing.UNSUPPORTED: "understood, but not expressible",
}
"""What the standings of words and fields mean."""


@dataclass(frozen=True, slots=True)
class Span:
    """Consecutive characters; ``kind`` is the standing of what rests on them, or empty.

    ``claims`` are the statements that they became: those first that do not hold, then those that
    happen at a moment. ``ends``: no further words follow on which anything rests.
    """

    text: str
    kind: str = ""
    tooltip: str = ""
    claims: tuple[ClaimProof, ...] = ()
    ends: bool = True

    @property
    def verdict(self) -> str:
        """``held`` or ``failed``; empty where they became no statement."""
        if not self.claims:
            return ""
        return "held" if all(claim.holds for claim in self.claims) else "failed"


@dataclass(frozen=True, slots=True)
class FieldRow:
    """One understood field: its value, what it rests on, the words or the reason."""

    field: str
    value: str
    source: str
    ground: str


def spans(
    functional: FunctionalScenario,
    disagreements: Iterable[Disagreement] = (),
    claims: Iterable[ClaimProof] = (),
) -> list[Span]:
    """The description as spans; overlapping evidence is cut at every boundary."""
    report = report_on(functional, disagreements)
    claims = tuple(claims)
    end_s = max((claim.time_s or 0.0 for claim in claims), default=0.0)
    # What is so all the time, or judged when all is over, is no moment to look at.
    ranked = sorted(claims, key=lambda c: (c.holds, not 0.0 < (c.time_s or 0.0) < end_s))
    text = functional.description[:LONGEST_SHOWN]
    result = []
    for passage in passages(replace(report, text=text)):
        tips = dict.fromkeys(_claim(finding) for finding in passage.findings)
        became = tuple(c for c in ranked if any(_rests(c, f) for f in passage.findings))
        tips |= dict.fromkeys(f"{'✓' if c.holds else '✕'} {c.statement}" for c in became)
        shown = text[passage.start : passage.end]
        result.append(Span(shown, passage.standing or "", "\n".join(tips), became))
    for place, (span, after) in enumerate(pairwise(list(result))):
        result[place] = replace(span, ends=not after.kind)
    if len(functional.description) > LONGEST_SHOWN:
        hidden = len(functional.description) - LONGEST_SHOWN
        result.append(Span(f" … ({hidden:,} more characters)"))
    return result


def _rests(claim: ClaimProof, finding: Finding) -> bool:
    """Whether a statement rests on a finding's words: by its field, or by them and its subject."""
    if finding.field is None:
        return False
    if claim.field == finding.field:
        return True
    subject, other = (field.split(".")[:2] for field in (claim.field, finding.field))
    alike = subject == other or subject[0] == other[0] == "junction"
    return alike and claim.words is not None and claim.words == finding.words


def field_rows(functional: FunctionalScenario) -> list[FieldRow]:
    """The evidence as a table, one row for each field."""
    return [
        FieldRow(
            field_words(item.field),
            _value(functional, item.field),
            STANDINGS[item.source].value,
            _ground(item),
        )
        for item in functional.evidence
    ]


def left_out(functional: FunctionalScenario) -> list[Finding]:
    """Words that fill no field, with what was done instead."""
    return [finding for finding in report_on(functional).findings if finding.field is None]


def _ground(item: Evidence) -> str:
    quoted = f"“{item.text}”" if item.text else ""
    return " — ".join(part for part in (quoted, item.reason) if part)


def _claim(finding: Finding) -> str:
    said = [finding.standing.value, field_words(finding.field or ""), finding.reason or ""]
    return ": ".join(part for part in said if part)


def field_words(field: str) -> str:
    """The path of a field, such as ``participants.car_1.speed_mps``, in words."""
    group, *rest = field.split(".")
    if group == "participants" and rest:
        return " › ".join([rest[0], *map(_quantity_words, rest[1:])])
    return " › ".join(map(_quantity_words, (group, *rest)))


def _quantity_words(name: str) -> str:
    quantity, unit = parted(name)
    return f"{plain(quantity)} ({unit})" if unit else plain(quantity)


def _value(functional: FunctionalScenario, field: str) -> str:
    """The value at a path, in words; empty where the path leads nowhere."""
    if field.startswith("hazards."):
        kind, _, part = field.removeprefix("hazards.").partition(".")
        meant = [h for h in functional.hazards if h.kind == kind]
        if part == "to":
            return ", ".join(dict.fromkeys(name for h in meant for name in h.to))
        return "; ".join(hazard_words(h) for h in meant)
    found = value_at(functional.model_dump(mode="json"), field)
    return "" if found is NOWHERE else _in_words(found)


def _in_words(value: object) -> str:
    if value is None or value == "":
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:g}"
    if isinstance(value, list):
        return ", ".join(_in_words(item) for item in value)
    if isinstance(value, dict) and value.keys() == {"low", "high"}:
        low, high = value["low"], value["high"]
        return f"{low:.1f}" if low == high else f"{low:.1f} to {high:.1f}"
    if isinstance(value, dict) and value.get("type") == "after":
        delay = _in_words(value.get("delay_s"))
        later = {"": "some time", "0.0": "right"}.get(delay, f"{delay} s")
        over = "begins" if value["since"] == "begin" else "has ended"
        return f"{later} after {plain(value['act'])} {over}"
    if isinstance(value, dict):
        pairs = ((plain(str(k)), _in_words(v)) for k, v in value.items() if v not in (None, [], ""))
        return ", ".join(f"{k} {v}" for k, v in pairs if v)
    return plain(str(value))
