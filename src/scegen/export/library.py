"""scenariogeneration's ``xodr`` and ``xosc``, loaded without scipy.

The library needs scipy for the length of one kind of curve only, parametric cubics, which are not
written here; but it would load scipy at once, half a second of the three that a whole run may take.
"""

from __future__ import annotations

import sys
from types import ModuleType

_NAME = "scipy.integrate"


def _quad(*args: object, **options: object) -> object:
    """``scipy.integrate.quad``, loaded when first called."""
    from scipy.integrate import quad  # noqa: PLC0415 - that is the point

    return quad(*args, **options)


def _stand_in() -> ModuleType:
    module = ModuleType(_NAME)
    module.quad = _quad  # type: ignore[attr-defined]
    return module


_mine = sys.modules.setdefault(_NAME, _stand_in())
try:
    from scenariogeneration import xodr, xosc
    from scenariogeneration.xosc.enumerations import VersionBase
finally:
    if getattr(_mine, "quad", None) is _quad:
        del sys.modules[_NAME]

__all__ = ["VersionBase", "xodr", "xosc"]
