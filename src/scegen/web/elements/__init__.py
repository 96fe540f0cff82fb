"""The page's own elements: each a small component that keeps what is typed in the browser."""

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import nicegui.elements.scene
from nicegui.element import Element
from nicegui.elements.mixins.text_element import TextElement
from nicegui.events import GenericEventArguments

_SCENE = Path(nicegui.elements.scene.__file__).parent / "dist"
"""three.js, as the framework brings it for its own scenes."""
Handler = Callable[[Any], object]


def node(tag: str, classes: str = "", text: str = "", **attributes: object) -> TextElement:
    """A plain element of the page; its text is shown as it is, never as markup.

    Attributes of Python's spelling (``aria_label``) become HTML's; those that are None are left
    out.
    """
    element = TextElement(tag=tag, text=text)
    if classes:
        element.classes(classes)
    for name, value in attributes.items():
        if value is not None:
            element.props[name.rstrip("_").replace("_", "-")] = value
    return element


def clickable(
    classes: str, done: Callable[[], object], text: str = "", **attributes: object
) -> TextElement:
    """Something to be clicked; ``done`` is called every time."""
    made = node("button", classes, text, type="button", **attributes)
    made.on("click", lambda _: done(), [])
    return made


def button(
    text: str, done: Callable[[], object], classes: str = "", **attributes: object
) -> TextElement:
    """A button that looks like one."""
    return clickable(f"button {classes}", done, text, **attributes)


def dotted(state: str, text: str) -> None:
    """Words behind a dot whose colour tells a state or a standing."""
    node("span", f"dot {state}")
    node("span", "", text)


def tell(element: TextElement, text: str | None) -> None:
    """Show words in an element, or hide it where there are none."""
    element.set_visibility(text is not None)
    element.text = text or ""


def mark(element: Element, name: str, *, on: bool) -> Element:
    """Give an element this class, or take it away."""
    return element.classes(add=name if on else "", remove="" if on else name)


def drawn(svg: str, classes: str = "", tag: str = "div") -> Element:
    """A picture of the project's own making, which escapes what comes from outside itself."""
    element = Element(tag).classes(classes)
    element.props["innerHTML"] = svg
    return element


class Component(Element):
    """An element drawn in the browser from its properties, which tells of what is done there."""

    def __init__(self, **properties: object) -> None:
        super().__init__()
        self.show(**{name: value for name, value in properties.items() if value is not None})

    def show(self, **properties: object) -> None:
        """Give it these properties, all at once."""
        self.props.update(properties)

    def when(self, **handlers: Handler) -> None:
        """Call each of these with what is told under its name."""
        for name, handler in handlers.items():
            self.on(name, partial(_hear, handler))


def _hear(handler: Handler, event: GenericEventArguments) -> None:
    handler(event.args)


class Description(Component, component="description.js"):
    """The text box with the standing of its words.

    It tells the text: as a ``draft`` while it is typed, and to ``submit`` it.
    """


class Entry(Component, component="entry.js"):
    """One labelled input."""

    def __init__(self, value: object, changed: Handler, **properties: object) -> None:
        super().__init__(value=value, **properties)
        self.when(value=changed)


def choice(options: Sequence[tuple[str, str]]) -> list[dict[str, str]]:
    """The options of an :class:`Entry`, from values and what is shown for them."""
    return [{"value": value, "label": label} for value, label in options]


class Form(Component, component="form.js"):
    """The functional scenario as a form; ``wrong`` says what keeps the form from being one.

    It tells of an ``edit`` with all data, of two names to ``rename``, of a name to ``forget``, and
    to ``confirm`` what was assumed of a field.
    """


class Gallery(Component, component="gallery.js"):
    """All logical scenarios as tiles, fetched from ``source`` as they come into sight.

    A new ``edition`` throws away the pictures of the old. It tells what to ``pick``, and the
    ``only`` one to be chosen.
    """


class Rules(Component, component="rules.js"):
    """A box for rules of one's own, with what they may ask for; it tells the rules to ``keep``."""


class Cinema(
    Component, component="cinema.js", esm={"nicegui-scene": str(_SCENE), "scegen-seat": "seat"}
):
    """The player (a ``script`` at an address) of what lies at ``source``, if that is not empty.

    Beside it is the view from the driver's seat.
    """
