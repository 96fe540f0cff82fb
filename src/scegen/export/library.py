"""scenariogeneration's ``xodr`` and ``xosc``, loaded without scipy and xmlschema.

The library needs scipy for the length of one kind of curve only, parametric cubics, and xmlschema
to read files, neither of which is done here; but it would load both at once, a third of the time
that a whole run may take.
"""

from importlib import import_module
from types import ModuleType

from scegen.loading import stand_ins


def _quad(*args: object, **options: object) -> object:
    """``scipy.integrate.quad``, loaded when first called."""
    from scipy.integrate import quad  # noqa: PLC0415 - that is the point

    return quad(*args, **options)


_scipy, _xmlschema = ModuleType("scipy.integrate"), ModuleType("xmlschema")
_scipy.quad = _quad  # type: ignore[attr-defined]
_xmlschema.__getattr__ = lambda name: getattr(import_module("xmlschema"), name)  # type: ignore[method-assign]
with stand_ins({"scipy.integrate": _scipy, "xmlschema": _xmlschema}):
    from scenariogeneration import xodr, xosc
    from scenariogeneration.xosc.enumerations import VersionBase

__all__ = ["VersionBase", "xodr", "xosc"]
