"""XML files of unknown origin, read safely: no entities, no network, no huge trees."""

from dataclasses import dataclass, field
from functools import lru_cache

from lxml import etree

from scegen.checking.results import Finding, error

LARGEST = 1e9
"""Larger numbers are no metres, radians, seconds or shares: computing with them could overflow."""
_KEPT = 4
"""Documents that are kept: several checkers look at one after the other."""


@dataclass(frozen=True)
class Document:
    """A parsed XML file. ``name`` is the file name that findings show; nobody changes it."""

    name: str
    content: bytes
    root: etree._Element = field(compare=False)

    @property
    def version(self) -> tuple[str, str]:
        """The revision of its standard, major and minor; ``?`` for what is not said."""
        header = self.root.find("header" if self.root.tag == "OpenDRIVE" else "FileHeader")
        if header is None:
            return "?", "?"
        return header.get("revMajor", "?"), header.get("revMinor", "?")

    def declared(self) -> dict[str, str]:
        """The values of an OpenSCENARIO file's parameters by ``$name``."""
        found = self.root.iterfind(".//ParameterDeclaration")
        return {"$" + e.get("name", "").removeprefix("$"): e.get("value", "") for e in found}


def usable(text: str | None) -> float | None:
    """A number as it stands in a file; None if it is none, or larger than metres, radians get."""
    try:
        value = float(text or "")
    except ValueError:
        return None
    return value if abs(value) <= LARGEST else None


class BrokenXmlError(Exception):
    """The file is not XML that can be trusted; carries the finding. Never leaves the package."""

    def __init__(self, finding: Finding) -> None:
        self.finding = finding
        super().__init__(finding.message)


@lru_cache(maxsize=_KEPT)
def parse_document(name: str, content: bytes, root_tag: str) -> Document:
    """Parse XML whose root must be ``root_tag``; BrokenXmlError names the line."""
    parser = etree.XMLParser(
        resolve_entities=False,
        no_network=True,
        huge_tree=False,
        load_dtd=False,
        dtd_validation=False,
    )
    try:
        root = etree.fromstring(content, parser)
    except (etree.XMLSyntaxError, ValueError) as failure:
        line = getattr(failure, "lineno", None)
        place = f"{name}:{line}" if line else name
        why = str(failure).partition(" (<string>")[0]
        raise BrokenXmlError(error("xml.well_formed", place, f"not XML: {why}")) from failure
    if root.getroottree().docinfo.internalDTD is not None:
        message = "declares a document type; such files are not read (entities could expand)"
        raise BrokenXmlError(error("xml.no_doctype", name, message))
    if root.tag != root_tag:
        message = f"the root element is {root.tag!r}, not {root_tag!r}"
        raise BrokenXmlError(error("xml.root", name, message))
    return Document(name, content, root)
