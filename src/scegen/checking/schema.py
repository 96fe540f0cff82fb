"""XSD: OpenDRIVE and OpenSCENARIO by version, with the schema files of the ASAM checkers."""

from collections.abc import Iterable
from functools import lru_cache
from pathlib import Path
from typing import Any, cast

from lxml import etree

from scegen.checking.documents import BrokenXmlError, Document, parse_document
from scegen.checking.environment import ASAM_HINT, asam_python, site_packages
from scegen.checking.results import CheckResult, Finding, error, not_run, unchecked, verdict

CHECKER = "schema"
SCHEMAS: dict[tuple[str, str, str], str] = {
    ("OpenDRIVE", "1", "1"): "qc_opendrive/schema/1.1/OpenDRIVE_1.1.xsd",
    ("OpenDRIVE", "1", "2"): "qc_opendrive/schema/1.2/OpenDRIVE_1.2.xsd",
    ("OpenDRIVE", "1", "3"): "qc_opendrive/schema/1.3/OpenDRIVE_1.3.xsd",
    ("OpenDRIVE", "1", "4"): "qc_opendrive/schema/1.4/OpenDRIVE_1.4H.xsd",
    ("OpenDRIVE", "1", "5"): "qc_opendrive/schema/1.5/OpenDRIVE_1.5M.xsd",
    ("OpenDRIVE", "1", "6"): "qc_opendrive/schema/1.6.1/opendrive_16_core.xsd",
    ("OpenDRIVE", "1", "7"): "qc_opendrive/schema/1.7.0/opendrive_17_core.xsd",
    ("OpenSCENARIO", "1", "0"): "qc_openscenario/schema/1.0.0/OpenSCENARIO.xsd",
    ("OpenSCENARIO", "1", "1"): "qc_openscenario/schema/1.1.1/OpenSCENARIO.xsd",
    ("OpenSCENARIO", "1", "2"): "qc_openscenario/schema/1.2.0/OpenSCENARIO.xsd",
    ("OpenSCENARIO", "1", "3"): "qc_openscenario/schema/1.3.0/OpenSCENARIO.xsd",
}
"""Schema file by root element, revMajor and revMinor; that of OpenDRIVE 1.8 is no valid XSD 1.0."""
_KEPT = 4
"""Documents of which it is kept: many scenarios of a campaign share their road."""
SHOWN = 10
"""How many schema errors of one file are listed."""


def check_schema(contents: dict[str, bytes]) -> CheckResult:
    """Validate files, given by name; the suffix says what they are."""
    python = asam_python()
    folder = site_packages(python) if python else None
    if folder is None:
        return not_run(CHECKER, f"the schema files are not installed; {ASAM_HINT}")
    findings: list[Finding] = []
    used = []
    for name, content in contents.items():
        root_tag = "OpenDRIVE" if name.lower().endswith(".xodr") else "OpenSCENARIO"
        try:
            document = parse_document(name, content, root_tag)
        except BrokenXmlError as broken:
            findings.append(broken.finding)
            continue
        version = (root_tag, *document.version)
        if version not in SCHEMAS:
            message = f"there is no schema here for {root_tag} {'.'.join(version[1:])}"
            findings.append(unchecked("xsd.version", name, message))
            continue
        path = folder / SCHEMAS[version]
        if not path.is_file():
            return not_run(CHECKER, f"{path.name} is missing; {ASAM_HINT}", findings)
        used.append(" ".join((version[0], ".".join(version[1:]))))
        findings += _validate(document, path)
    return verdict(CHECKER, findings, ", ".join(used))


@lru_cache(maxsize=8)
def _schema(path: Path) -> etree.XMLSchema:
    return etree.XMLSchema(etree.parse(str(path)))


@lru_cache(maxsize=_KEPT)
def _validate(document: Document, path: Path) -> tuple[Finding, ...]:
    schema = _schema(path)
    if schema.validate(document.root):
        return ()
    log = list(cast("Iterable[Any]", schema.error_log))  # the stubs do not know that it is one
    found = [error("xsd.valid", f"{document.name}:{e.line}", e.message) for e in log[:SHOWN]]
    if len(log) > SHOWN:
        more = f"and {len(log) - SHOWN} more schema errors"
        found.append(error("xsd.valid", document.name, more))
    return tuple(found)
