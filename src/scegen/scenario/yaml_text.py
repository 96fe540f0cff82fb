"""Plain data as YAML text, as ``yaml.dump`` writes it.

That takes five times as long: it makes a node of every value before it makes an event of it, and
works out each time whether a word would be read as something else.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import yaml
from yaml import events
from yaml.representer import SafeRepresenter
from yaml.resolver import Resolver

_Dumper: type = getattr(yaml, "CSafeDumper", yaml.SafeDumper)
_MAPPING = events.MappingStartEvent(None, None, implicit=True, flow_style=False)
_SEQUENCE = events.SequenceStartEvent(None, None, implicit=True, flow_style=False)
_AS_VALUE, _AS_TEXT = (True, False), (False, True)
_FLOATS = SafeRepresenter()


def yaml_text(data: object) -> str:
    """Dictionaries in their order, lists, text, numbers, truths and None, as a document."""
    told = [events.StreamStartEvent(), events.DocumentStartEvent(explicit=False)]
    _tell(data, told)
    told += (events.DocumentEndEvent(explicit=False), events.StreamEndEvent())
    text: str = yaml.emit(told, Dumper=_Dumper, allow_unicode=True, width=100)
    return text


def _tell(data: object, told: list[Any]) -> None:
    if isinstance(data, dict):
        told.append(_MAPPING)
        for name, value in data.items():
            told.append(_word(name))
            _tell(value, told)
        told.append(events.MappingEndEvent())
    elif isinstance(data, list):
        told.append(_SEQUENCE)
        for value in data:
            _tell(value, told)
        told.append(events.SequenceEndEvent())
    elif isinstance(data, float):  # too many to remember, and all are plain
        node = _FLOATS.represent_float(data)
        told.append(events.ScalarEvent(None, node.tag, _AS_VALUE, node.value))
    else:
        told.append(_word(data))


@lru_cache(maxsize=4096, typed=True)
def _word(value: object) -> events.ScalarEvent:
    """Text, a whole number, a truth or None; in quotes where it would be read as another."""
    node = SafeRepresenter().represent_data(value)
    resolver: Any = Resolver()  # its stubs have no types
    plain = tuple(
        resolver.resolve(yaml.ScalarNode, node.value, how) == node.tag
        for how in (_AS_VALUE, _AS_TEXT)
    )
    return events.ScalarEvent(None, node.tag, plain, node.value)
