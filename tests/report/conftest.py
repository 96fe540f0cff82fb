"""Pages in a browser."""

import pytest


@pytest.fixture
def open_page(browser, tmp_path):
    """Opens a document as a file; what goes wrong in it fails the test."""
    faults, pages = [], []

    def show(text, **options):
        options.setdefault("viewport", {"width": 1280, "height": 900})
        path = tmp_path / f"page-{len(pages)}.html"
        path.write_text(text, encoding="utf-8")
        page = browser.new_page(**options)
        page.set_default_timeout(10_000)
        pages.append(page)
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.on("console", lambda m: m.type == "error" and faults.append(m.text))
        page.on(
            "request",
            lambda r: r.url.startswith(("file:", "data:", "blob:")) or faults.append(r.url),
        )
        page.goto(path.as_uri())
        return page

    show.faults = faults
    yield show
    for page in pages:
        page.close()
    assert faults == []
