"""What the search made of each scenario: before and after, what was said, the verdict."""

from scegen.report.contents import VERDICTS
from scegen.report.judgement import verdict_words
from scegen.scenario.proof import Proof
from scegen.scenario.wording import figure
from scegen.web.elements import dotted, drawn, node
from scegen.web.made import MadeScenario
from scegen.web.pictures import tile_picture
from scegen.web.work import Work


def outcome_cards(work: Work) -> None:
    """A card for each scenario that was made, and a line for each that was passed over."""
    if work.made is None:
        return
    if work.stale:
        node("p", "note", "Made before your last change; search again to make it anew.")
    for made in work.made.scenarios:
        with node("article", "card"):
            with node("h3", ""):
                dotted(made.state, made.name)
            with node("div", "card-body"):
                if work.made.functional is not None:
                    drawn(tile_picture(made.concrete.logical, work.made.functional), "paper")
                with node("div", ""):
                    _figures(made)
    for name, reason in work.made.skipped.items():
        with node("div", "remark"):
            dotted("open", f"{name}: {reason}")


def _figures(made: MadeScenario) -> None:
    """Whether a scenario is what was asked for."""
    if made.proof is not None:
        _proof(made.proof)
    if made.verdict is not None:
        node("p", "verdict", verdict_words(made.verdict))
    with node("ul", "chips checks", aria_label="Checks"):
        for checker, status in made.summary.get("checks", {}).items():
            state = VERDICTS.get(status, "open")
            node("li", f"check {state}", f"{checker} {status.replace('_', ' ')}")


def _proof(proof: Proof) -> None:
    measure = proof.of(proof.measure)
    pair = " and ".join(proof.pair)
    with node("p", "headline"):
        state, words = ("held", "") if proof.in_band else ("failed", " not reached")
        node("span", f"check {state}", f"{proof.target}{words}")
        if pair:
            node("span", "", pair)
    if measure is not None:
        with node("div", "before-after"):
            node("span", "measure", measure.name.upper() if len(measure.name) < 5 else measure.name)
            before, after = figure(measure.before), figure(measure.after)
            if before != after:
                node("span", "figure", before)
                node("span", "arrow", "→", aria_label="becomes")
            node("span", "figure", after)
            node("span", "unit", measure.unit)
    if proof.blocked_by and not proof.in_band:
        node("p", "note", proof.blocked_by)
    if proof.hazards:
        with node("ul", "chips", aria_label="Dangers"):
            for hazard in proof.hazards:
                state, words = ("held", "") if hazard.happened else ("failed", " does not happen")
                if hazard.happened and hazard.time_s is not None:
                    words = f" at {hazard.time_s:.1f} s"
                node("li", f"check {state}", hazard.kind.replace("_", " ") + words)
    if proof.claims:
        node("p", "", proof.held)
    for claim in proof.missed:
        with node("div", "remark"):
            words = f" (“{claim.words}”)" if claim.words else ""
            dotted("failed", f"{claim.statement}{words}: {claim.found}")
