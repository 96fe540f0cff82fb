"""YAML and JSON text of unknown origin to plain data: bounded in depth and in size."""

import json
import re
from collections import Counter
from collections.abc import Callable, Hashable
from typing import Any

import yaml

from scegen.errors import VocabularyError

MOST_LEVELS = 100
"""So deep may data be nested; scenario files need a tenth of it."""
MOST_REPEATED = 100_000
"""So many values may aliases stand for, all together."""

_Base = yaml.CSafeLoader if yaml.__with_libyaml__ else yaml.SafeLoader
_CANNOT_BE_MADE = (ValueError, LookupError, ArithmeticError, AttributeError, TypeError)
"""What PyYAML and json let through: ``!!int x``, the date 2024-13-45, numbers of 5,000 digits,
half a character."""
_JSON = re.compile(r'\s*[{\[]\s*["{\[\]}]')
"""How JSON begins; ``{a: 1}`` and ``[a]`` are YAML."""


class _Loader(_Base):  # type: ignore[valid-type,misc]  # the base depends on the installation
    """A safe loader that refuses a key given twice, of which YAML would keep the last."""

    def construct_mapping(self, node: yaml.MappingNode, deep: bool = False) -> Any:  # noqa: ANN401 - as the base has it
        seen = set[Hashable]()
        for key, _ in node.value:
            if isinstance(key, yaml.ScalarNode) and key.tag != "tag:yaml.org,2002:merge":
                if key.value in seen:
                    problem = f"{key.value!r} is given twice"
                    raise yaml.constructor.ConstructorError(None, None, problem, key.start_mark)
                seen.add(key.value)
        return super().construct_mapping(node, deep=deep)


def parse(text: str, *, where: str) -> object:
    """YAML or JSON text (JSON is YAML) to plain data.

    Raises:
        VocabularyError: names the line and what is wrong there.
    """
    try:
        if _JSON.match(text):
            data = json.loads(text, object_pairs_hook=_object(where))
            if "\\u" in text:  # a half of a pair is no character
                json.dumps(data, ensure_ascii=False).encode()
            return data
        _require_bounded(text, where)
        return yaml.load(text, _Loader)  # noqa: S506 - a safe loader
    except yaml.YAMLError as error:
        raise _not_yaml(error, text, where) from error
    except json.JSONDecodeError as error:
        place = f"line {error.lineno}, column {error.colno}"
        raise VocabularyError(f"not valid JSON at {place}: {error.msg}", where=where) from error
    except RecursionError as error:
        raise _too_deep(where) from error
    except _CANNOT_BE_MADE as error:
        raise VocabularyError(
            "holds a value that cannot be read: a date or a number that does not exist, or a tag",
            where=where,
            hint="write text in quotes, and no tags (!!)",
        ) from error


def _object(where: str) -> Callable[[list[tuple[str, object]]], dict[str, object]]:
    """What makes a JSON object of its pairs, and refuses a key given twice as YAML's does."""

    def made(pairs: list[tuple[str, object]]) -> dict[str, object]:
        if len(whole := dict(pairs)) < len(pairs):
            twice = next(key for key, count in Counter(k for k, _ in pairs).items() if count > 1)
            raise VocabularyError(f"not valid JSON: {twice!r} is given twice", where=where)
        return whole

    return made


def _require_bounded(text: str, where: str) -> None:
    """Refuse what would overflow the stack, or memory: aliases of aliases of aliases."""
    sizes: dict[str, int] = {}
    under_way: list[tuple[str | None, int]] = [(None, 0)]
    repeated = 0
    for event in yaml.parse(text, _Base):
        anchor, size = getattr(event, "anchor", None), 1
        if isinstance(event, yaml.CollectionStartEvent):
            if len(under_way) > MOST_LEVELS:
                raise _too_deep(where)
            under_way.append((anchor, 1))
            continue
        if isinstance(event, yaml.AliasEvent):
            if anchor not in sizes:
                raise VocabularyError(
                    f"the alias *{anchor} stands in itself, or before what it stands for",
                    where=where,
                )
            size = sizes[anchor]
            repeated += size
            if repeated > MOST_REPEATED:
                raise VocabularyError(
                    f"aliases repeat more than {MOST_REPEATED:,} values", where=where
                )
        elif isinstance(event, yaml.CollectionEndEvent):
            anchor, size = under_way.pop()
        elif not isinstance(event, yaml.ScalarEvent):
            continue
        if anchor is not None:
            sizes[anchor] = size
        outer, so_far = under_way[-1]
        under_way[-1] = (outer, so_far + size)


def _too_deep(where: str) -> VocabularyError:
    return VocabularyError("nested too deeply for a scenario file", where=where)


def _not_yaml(error: yaml.YAMLError, text: str, where: str) -> VocabularyError:
    problem = str(getattr(error, "problem", None) or getattr(error, "reason", None) or error)
    mark = getattr(error, "problem_mark", None)
    place = f" at line {mark.line + 1}, column {mark.column + 1}" if mark is not None else ""
    line = text.splitlines()[mark.line : mark.line + 1] if mark is not None else []
    hint = None
    if "\t" in "".join(line):
        hint = "indent with blanks: YAML takes no tabs"
    return VocabularyError(f"not valid YAML{place}: {problem}", where=where, hint=hint)
