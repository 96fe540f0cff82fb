"""scenariogeneration's ``xodr`` and ``xosc``, loaded without scipy and xmlschema.

The library needs scipy for the length of one kind of curve only, parametric cubics, and xmlschema
to read files, neither of which is done here; but it would load both at once, a third of the time
that a whole run may take.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType

_SCIPY, _XMLSCHEMA = "scipy.integrate", "xmlschema"


def _quad(*args: object, **options: object) -> object:
    """``scipy.integrate.quad``, loaded when first called."""
    from scipy.integrate import quad  # noqa: PLC0415 - that is the point

    return quad(*args, **options)


def _stand_ins() -> dict[str, ModuleType]:
    scipy, xmlschema = ModuleType(_SCIPY), ModuleType(_XMLSCHEMA)
    scipy.quad = _quad  # type: ignore[attr-defined]
    xmlschema.__getattr__ = lambda name: getattr(import_module(_XMLSCHEMA), name)  # type: ignore[method-assign]
    return {scipy.__name__: scipy, xmlschema.__name__: xmlschema}


_mine = {name: made for name, made in _stand_ins().items() if name not in sys.modules}
sys.modules.update(_mine)
try:
    from scenariogeneration import xodr, xosc
    from scenariogeneration.xosc.enumerations import VersionBase
finally:
    for _name, _made in _mine.items():
        if sys.modules.get(_name) is _made:
            del sys.modules[_name]

__all__ = ["VersionBase", "xodr", "xosc"]
