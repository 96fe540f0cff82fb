"""Things made by hand."""

from __future__ import annotations

from scegen.scenario.objects import ObjectCategory, StaticObject


def thing(
    name: str = "crate_1", x_m: float = 60.0, y_m: float = 0.0, **more: object
) -> StaticObject:
    """A box of 1 m, or what ``more`` says."""
    usual: dict[str, object] = {
        "id": name,
        "category": ObjectCategory.OBSTACLE,
        "what": name.rsplit("_", 1)[0],
        "x_m": x_m,
        "y_m": y_m,
        "heading_deg": 0.0,
        "length_m": 1.0,
        "width_m": 1.0,
        "height_m": 1.0,
    }
    return StaticObject.model_validate(usual | more)
