"""Pages of one file that open offline: template, style and script, which are all our own."""

import json
from base64 import b64encode
from hashlib import sha256
from importlib.resources import files

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup


def page(package: str, template: str, style: str, script: str, content: dict[str, object]) -> str:
    """The page as an HTML document; what comes from outside is escaped by the template.

    Of ``script`` the page tells the digest: no other one runs.
    """
    environment = Environment(
        loader=PackageLoader(package),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    return environment.get_template(template).render(
        **content,
        style=Markup(style),  # noqa: S704 - our own, as is the script
        script=Markup(script),  # noqa: S704
        digest=b64encode(sha256(f"\n{script}".encode()).digest()).decode(),
    )


def asset(package: str, name: str) -> str:
    """The text of a file that lies in a package."""
    return files(package).joinpath(name).read_text(encoding="utf-8")


def as_json(value: object) -> Markup:
    """JSON that ends no element, whatever words it holds."""
    text = json.dumps(value, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    for sign in "<>&\u2028\u2029":
        text = text.replace(sign, f"\\u{ord(sign):04x}")
    return Markup(text)  # noqa: S704 - no markup is left in it
