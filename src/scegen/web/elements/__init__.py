"""The page's own elements: each a small component that keeps what is typed in the browser."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Protocol

import nicegui.elements.scene
from nicegui.element import Element
from nicegui.elements.mixins.text_element import TextElement

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


class Description(Element, component="description.js"):
    """The text box with the standing of its words."""

    def __init__(self, *, longest: int, placeholder: str) -> None:
        super().__init__()
        self.props["longest"] = longest
        self.props["placeholder"] = placeholder
        self.show("", [])

    def show(self, text: str, spans: list[dict[str, Any]]) -> None:
        """Put in a text and what became of its words."""
        self.props["spans"] = spans
        self.props["value"] = text

    def when(self, *, draft: Handler, submit: Handler) -> None:
        """Call these with the text: while it is typed, and when it is to be understood."""
        self.on("draft", lambda event: draft(event.args))
        self.on("submit", lambda event: submit(event.args))


class Entry(Element, component="entry.js"):
    """One labelled input."""

    def __init__(self, value: object, changed: Handler, **props: object) -> None:
        super().__init__()
        self.props["value"] = value
        for name, prop in props.items():
            if prop is not None:
                self.props[name] = prop
        self.on("value", lambda event: changed(event.args))


def choice(options: Sequence[tuple[str, str]]) -> list[dict[str, str]]:
    """The options of an :class:`Entry`, from values and what is shown for them."""
    return [{"value": value, "label": label} for value, label in options]


class Editor(Protocol):
    """Who hears what is changed in a form."""

    def edit(self, data: dict[str, Any]) -> None:
        """All data, changed."""

    def rename(self, old: str, new: str) -> None:
        """Somebody's name."""

    def forget(self, name: str) -> None:
        """Somebody is taken out."""

    def confirm(self, *paths: str) -> None:
        """What was assumed of a field is meant."""


class Form(Element, component="form.js"):
    """The functional scenario as a form."""

    def __init__(self, spec: list[dict[str, Any]], sections: Sequence[str]) -> None:
        super().__init__()
        self.props["spec"] = spec
        self.props["sections"] = list(sections)

    def show(
        self,
        scenario: dict[str, Any],
        standings: dict[str, Any],
        colours: dict[str, str],
        wrong: str | None,
    ) -> None:
        """Put in a scenario; ``wrong`` says what keeps the form from being one."""
        with self.props.suspend_updates():
            self.props["scenario"] = scenario
            self.props["standings"] = standings
            self.props["colours"] = colours
        self.props["wrong"] = wrong

    def when(self, editor: Editor) -> None:
        """Tell this of what is changed."""
        self.on("edit", lambda event: editor.edit(event.args))
        self.on("rename", lambda event: editor.rename(*event.args))
        self.on("forget", lambda event: editor.forget(event.args))
        self.on("confirm", lambda event: editor.confirm(event.args))


class Gallery(Element, component="gallery.js"):
    """All logical scenarios as tiles, fetched from ``source`` as they come into sight."""

    def __init__(self, source: str, ratio: float) -> None:
        super().__init__()
        self.props["source"] = source
        self.props["ratio"] = ratio
        self.show([], [], 0)

    def show(self, indices: list[int], picked: list[int], edition: int) -> None:
        """Show these scenarios; a new ``edition`` throws away the pictures of the old."""
        with self.props.suspend_updates():
            self.props["indices"] = indices
            self.props["picked"] = picked
        self.props["edition"] = edition

    def when(self, *, pick: Handler, only: Handler) -> None:
        """Call these when scenarios are picked, or one alone."""
        self.on("pick", lambda event: pick(event.args))
        self.on("only", lambda event: only(event.args))


class Rules(Element, component="rules.js"):
    """A box for rules of one's own, with what they may ask for."""

    def __init__(self, words: list[dict[str, str]], *, longest: int) -> None:
        super().__init__()
        self.props["words"] = words
        self.props["longest"] = longest
        self.show("")

    def show(self, text: str) -> None:
        """Put in the rules that are kept now."""
        if self.props.get("value") != text:
            self.props["value"] = text

    def when(self, *, keep: Handler) -> None:
        """Call this with the rules that are to be kept."""
        self.on("keep", lambda event: keep(event.args))


class Cinema(
    Element, component="cinema.js", esm={"nicegui-scene": str(_SCENE), "scegen-seat": "seat"}
):
    """The player (a module at an address), with the view from the driver's seat beside it."""

    def __init__(self, script: str) -> None:
        super().__init__()
        self.props["script"] = script
        self.show("")

    def show(self, source: str) -> None:
        """Play what lies at this address; nothing if it is empty."""
        self.props["source"] = source
