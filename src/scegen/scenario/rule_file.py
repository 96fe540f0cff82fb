"""A user's own rules in ASP as they stand in a file; what they mean is up to the enumeration."""

from dataclasses import dataclass

RULES_FILE = "rules.lp"
"""The name of the copy in a folder that was made under them."""


@dataclass(frozen=True, slots=True)
class RuleFile:
    """The rules' text, and the name by which messages tell where in it something is wrong."""

    text: str
    name: str = RULES_FILE
