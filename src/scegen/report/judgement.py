"""The careful driver's verdict and the reactivity of a scenario, in words and rows."""

from collections.abc import Iterator

from scegen.criticality.careful_driver import DELAY_S, RISK_EVALUATION_S, Outcome, Verdict
from scegen.criticality.reactivity.sensitivity import Sensitivity, Start
from scegen.report.tables import Row, Table

_MODEL = "careful and competent driver of UN R157; its use here, beyond motorways, is our extension"


def verdict_words(verdict: Verdict) -> str:
    """The verdict in a few sentences."""
    return " ".join([_outcome(verdict), _reaction(verdict), *_margin(verdict)])


def _outcome(verdict: Verdict) -> str:
    if verdict.outcome is Outcome.UNAVOIDABLE:
        others, at = " and ".join(verdict.contact), verdict.contact_speed_mps
        speed = "" if at is None else f" (ego at {at:.1f} m/s)"
        return f"A careful driver would touch {others} all the same{speed}."
    if driven := " and ".join(verdict.contact_as_driven):
        return f"A careful driver would not touch {driven}."
    return "Nobody is touched as it is, and nobody with a careful driver."


def _reaction(verdict: Verdict) -> str:
    if verdict.danger is None or verdict.perceived_s is None:
        return "No danger ahead is perceivable for long enough to react."
    said = f"{verdict.danger} is a perceivable danger from {verdict.perceived_s:.2f} s"
    if verdict.brakes_s is None:
        return f"{said}; braking for it would only bring about a contact."
    late = RISK_EVALUATION_S + DELAY_S
    return f"{said}, the brakes act {late:.2f} s later, at {verdict.brakes_s:.2f} s."


def _margin(verdict: Verdict) -> Iterator[str]:
    if verdict.outcome is Outcome.AVOIDABLE and verdict.distance_m != float("inf"):
        yield f"Remaining distance {verdict.distance_m:.2f} m."
    if verdict.spare_s is not None:
        amount, avoidable = f"{abs(verdict.spare_s):.1f} s", verdict.outcome is Outcome.AVOIDABLE
        how = f"could act {amount} later" if avoidable else f"would have to act {amount} earlier"
        yield f"The brakes {how}."
    if verdict.secondary:
        names = " and ".join(verdict.secondary)
        does = "does" if len(verdict.secondary) == 1 else "do"
        yield f"It stops and stays: {names}, who {does} not react, would run into it."


def judgement_tables(verdict: Verdict | None, sensitivity: Sensitivity | None) -> list[Table]:
    """The verdict and the reactivity as tables; none for what was not judged."""
    tables = []
    if verdict is not None:
        rows: tuple[Row, ...] = ((verdict.outcome.value, verdict_words(verdict), _MODEL),)
        tables.append(Table("Could it be avoided?", ("Verdict", "Why", "Driver"), rows))
    if sensitivity is not None:
        stays = "stays critical" if sensitivity.reactive else "does not always stay critical"
        starts = (sensitivity.slower, sensitivity.own, sensitivity.faster)
        tables.append(
            Table(
                f"If the ego starts slower or faster: with {sensitivity.partner}, it {stays}",
                ("Start", "Contact", "Smallest distance", "PET", "TTC", "Critical"),
                tuple(_start(start) for start in starts),
            )
        )
    return tables


def _start(start: Start) -> Row:
    percent = round(100 * (start.factor - 1))
    return (
        f"{percent:+d} %".replace("-", "−") if percent else "as it is",
        "yes" if start.contact else "no",
        f"{start.distance_m:.2f} m",
        "–" if start.pet_s is None else f"{start.pet_s:.2f} s",
        "–" if start.ttc_s is None else f"{start.ttc_s:.2f} s",
        "yes" if start.critical else "no",
    )
