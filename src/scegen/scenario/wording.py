"""How people are told of what stands in files: counts, articles, changes."""


def counted(number: int, noun: str) -> str:
    """``1 scenario``, ``1,024 scenarios``."""
    return f"{number:,} {noun}" if number == 1 else f"{number:,} {noun}s"


def covering(number: int) -> str:
    """``2 scenarios cover every meeting``."""
    return f"{counted(number, 'scenario')} cover{'s' if number == 1 else ''} every meeting"


def with_article(noun: str) -> str:
    """``a car``, ``an animal``."""
    return f"an {noun}" if noun[:1].lower() in {*"aeiou"} else f"a {noun}"


def figure(value: float | None) -> str:
    """``0.83``; a dash where there is nothing to measure."""
    return "–" if value is None else f"{value:.2f}"


def change(before: str, after: str) -> str:
    """``0.83 → 0.78``; only the figure where it stays."""
    return after if before == after else f"{before} → {after}"
