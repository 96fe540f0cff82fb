"""The proof of danger as tables: every hazard and every measure, before and after the search."""

from scegen.report.tables import Row, Table, change_row
from scegen.report.words import plain
from scegen.scenario.proof import Advice, HazardProof, Proof

_MEASURES = {
    "pet": "post-encroachment time",
    "distance": "smallest distance",
    "ttc": "smallest time to collision",
    "headway": "smallest time headway",
    "drac": "deceleration to avoid a crash",
    "contact_time": "first contact at",
    "impact_speed": "speed of impact",
}


def danger_tables(proof: Proof | None) -> list[Table]:
    """The tables; none where nothing was searched."""
    if proof is None:
        return []
    tables = [_target(proof), *_claims(proof)]
    rows = tuple(
        _hazard(after, before)
        for after, before in zip(proof.hazards, proof.hazards_before, strict=True)
    )
    if rows:
        heads = ("Danger", "By", "To", "Before", "Now", "Margin", "At", "Conditions")
        tables.append(Table("Does the danger happen?", heads, rows))
    if proof.advice is not None:
        tables.append(_advice(proof.advice))
    return tables


def target_words(proof: Proof) -> str:
    """The target, between whom, and whether it is reached, with the value that decides."""
    measure = proof.of(proof.measure)
    if not proof.pair and proof.in_band:
        return f"{proof.target}: nobody else is on the road"
    found = "" if measure is None else f" {_value(measure.after, measure.unit)}"
    name = _MEASURES.get(proof.measure or "", proof.measure)
    outcome = f"{name}{found}" if proof.in_band else f"not reached, {name}{found}"
    return f"{proof.target} of {' and '.join(proof.pair) or 'nobody'}: {outcome}"


def _target(proof: Proof) -> Table:
    outcome = "reached" if proof.in_band else "NOT reached"
    if proof.in_band_before and not proof.changed:
        outcome += ", as it was first made"
    if proof.blocked_by:
        outcome += f": {proof.blocked_by}"
    pair = " and ".join(proof.pair) or "nobody"
    band = f"{proof.band[0]:g} to {proof.band[1]:g}" if proof.band else "a contact"
    rows = [
        (
            _MEASURES.get(m.name, m.name) + (" (decides)" if m.name == proof.measure else ""),
            _value(m.before, m.unit),
            _value(m.after, m.unit),
            band if m.name == proof.measure else "",
        )
        for m in proof.measures
        if m.before is not None or m.after is not None
    ]
    title = f"Target {proof.target} between {pair}: {outcome}"
    return Table(title, ("Measure", "Before", "Now", "Band"), tuple(rows))


def _claims(proof: Proof) -> list[Table]:
    """Every statement, phrase by phrase of the text; those first that do not hold."""
    if not proof.claims:
        return []
    phrases = list(dict.fromkeys(claim.words for claim in proof.claims if claim.words))
    # What rests on no words comes last.
    order = {words: n for n, words in enumerate([*phrases, None])}
    rows = tuple(
        (
            f"“{claim.words}”" if claim.words else claim.field,
            claim.statement,
            "holds" if claim.holds else f"does NOT hold; what would help: {claim.helps}",
            _value(claim.measured, "" if claim.unit == "1" else claim.unit).rstrip(),
            _value(claim.time_s, "s"),
        )
        for claim in sorted(proof.claims, key=lambda c: (c.holds, order[c.words or None]))
    )
    title = f"What was said: {proof.held}"
    return [Table(title, ("Words", "Statement", "In what runs", "Measured", "At"), rows)]


def _advice(advice: Advice) -> Table:
    """What was proposed before the search, and what became of it."""
    if advice.led:
        fate = "the search went on from there"
    elif advice.changes:
        fate = "the search went its own way, since these led nowhere"
    else:
        fate = "none"
    rows = [change_row(change) for change in advice.changes]
    rows += [("–", "–", "–", "–", note, "") for note in advice.notes]
    rows = rows or [("–", "–", "–", advice.speaker, "no change proposed", "")]
    heads = ("Parameter", "Before", "Proposed", "By", "Why", "Rejected")
    return Table(f"Numbers proposed by {advice.speaker}: {fate}", heads, tuple(rows))


def _hazard(after: HazardProof, before: HazardProof) -> Row:
    return (
        plain(after.kind),
        " and ".join(after.by),
        " and ".join(after.to),
        "happened" if before.happened else "did not happen",
        ("happens" if after.happened else "does NOT happen")
        + (f": {after.note}" if after.note else ""),
        _value(after.margin, after.unit),
        _value(after.time_s, "s"),
        "; ".join(
            f"{part.name} {_value(part.value, part.unit)} (threshold {part.threshold:g})"
            for part in after.parts
        ),
    )


def _value(value: float | None, unit: str) -> str:
    return "–" if value is None else f"{value:.2f} {unit.replace('m/s2', 'm/s²')}"
