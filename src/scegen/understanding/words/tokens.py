"""Splits text into tokens that keep their place in it; what its layout says is a mark, too."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from unicodedata import normalize

from scegen.understanding.lexicon import abbreviations, load
from scegen.understanding.words.lemmas import lemmas, meant

_ITEM = re.compile(
    r"(?:(?:^|(?<=\n))[ \t]*|(?<=[.;] )(?=\(?\d)|(?<=[:,] )(?=\(?\d+\)))"
    r"(?P<item>[-*•–][ \t]+|\(?(?:\d{1,2}|[a-z])(?:\.|\))[ \t]+(?=[^\W\d]))"
)
"""``- ego``, ``2. the car``, ``b) it``: what opens an item of a list."""
_BREAK = re.compile(r"[^\S\n]*\n\s*")
_ENTRY = re.compile(r"[^\n.,;:!?]{1,40}(?:[:|]|\.{3})")
_KEYS = re.compile(r"(?<=:)[^\n;:!?]*(,)\s*([^\n.,;:!?]{1,40})(?=:)")
_CELL = re.compile(r"(?P<name>(?<![^|\n])[^|\n\d:]*\|(?=\s*\d))|\|")
"""``ego 50 km/h | van brakes``: a bar ends an entry, but not a name in front of its number."""
_WORD = re.compile(r"[^\W\d_]+")
_LEADERS = re.compile(r"(?<=\s)\.{3,}(?=\s)|(?<=\S)\s*\.{4,}")
_BULLETS = frozenset("-*•–")
_ENDED = frozenset(".,;:!?")
_BETWEEN = re.compile(
    r"(?<=\s)[-–—]{1,2}(?=\s+[^\d\s])|—(?!\d)|(?<=\s)/(?=\s)(?!\s*(?:h|s|sec|hour)\b)"
)
_MARK = re.compile(r"[.,;:!?](?=\s)|[|&]|\s/\s|\d\s?(?:k?m|mph|kph|m?s|ft|%)")
_MAX_TITLE = 60
"""So many characters a title may have."""
_MAX_NAME = 3
"""So many words a heading may have that names somebody."""


def laid_out(text: str) -> dict[int, str]:
    """What stands at an offset of the text, by its layout: a mark, or nothing for bullets.

    A line that ends openly ends a sentence where a list, an entry ("Ego: 50 km/h") or a paragraph
    follows; a dash or slash between words is a comma, and the colon after a title.
    """
    found = {k: "" for m in _ITEM.finditer(text) for k in range(m.start("item"), m.end("item"))}
    between = list(_BETWEEN.finditer(text))
    for mark in between:
        if mark.start() not in found:
            titled = _titled(text, mark.start(), lonely=len(between) == 1)
            found[mark.start()] = ":" if titled else ","
    found |= {m.end() - 1: "" if m["name"] else "." for m in _CELL.finditer(text)}
    for dots in _LEADERS.finditer(text):  # "VUT ....... 70 km/h"
        found |= dict.fromkeys(range(dots.start(), dots.end()), "") | {dots.end() - 1: ":"}
    if ":" in text:
        for key in _KEYS.finditer(text):
            found |= {key.start(1): "."} if _somebody(key.group(2)) else {key.end(): ""}
    heading = ""
    for line in _BREAK.finditer(text):
        own = text.rfind("\n", 0, line.start()) + 1
        if own < line.start() and not _ITEM.match(text, own):
            heading = text[own : line.start()]
        at = line.start() + line.group().index("\n")
        found |= {k: "" for k in range(line.start(), line.end()) if text[k] == "\n"}
        item = _ITEM.match(text, text.rfind("\n", 0, line.end()) + 1)
        if item is not None and item["item"][0] in _BULLETS and _is_name(heading):
            found[at] = ","
        elif line.start() and text[line.start() - 1] not in _ENDED and _apart(text, line):
            found[at] = ":" if _titled(text, at, lonely=True) else "."
    return found


def _is_name(words: str) -> bool:
    """``Ego:`` above the items of a list, ``VUT`` before a dash: somebody, and nothing more."""
    return len(words.split()) <= _MAX_NAME and _somebody(words.strip(" \t:"))


def _somebody(name: str) -> bool:
    """Whether a few words end with somebody's name or place: ``lead car``, ``oncoming``."""
    word = _WORD.findall(name.lower())[-1:]
    node = load().root.following.get(lemmas(word[0])[0][0]) if word else None
    return node is not None and bool(node.cats & {"actor", "dir", "det"})


def _apart(text: str, line: re.Match[str]) -> bool:
    """Whether what follows a line is no continuation of it."""
    after = line.end()
    own = text.rfind("\n", 0, line.start()) + 1
    listed = _ITEM.match(text, after) is not None
    listed = listed or _ITEM.match(text, text.rfind("\n", 0, after) + 1) is not None
    entry = _ENTRY.match(text, after) is not None or _ENTRY.match(text, own) is not None
    short = line.start() - own <= _MAX_TITLE and text[after : after + 1].isupper()
    return listed or entry or short or line.group().count("\n") > 1


def _titled(text: str, start: int, *, lonely: bool) -> bool:
    """``Cut-in - ego 120 km/h, …``: whether a few words before a lonely mark are a title.

    So is somebody's name that opens an item: ``- VUT – left turn``.
    """
    item = _ITEM.match(text, text.rfind("\n", 0, start) + 1)
    if item is not None and item.end() <= start and _is_name(text[item.end() : start]):
        return True
    return lonely and start <= _MAX_TITLE and _MARK.search(text, 0, start) is None


_TOKEN = re.compile(
    r"(?P<plain>[A-Za-z]{3,}(?=[ ,.]))"
    r"|(?P<clock>(?<![\d:])\d{1,2}:\d{2}(?![\d:]))"
    r"|(?P<short>\b[wW]/[oO]?(?![^\s\d])|\b[xX]-(?:ing|walk)\b)"
    r"|(?P<bound>\b[NSEWnsew]/[Bb]\b)"
    r"|(?P<unit>(?:\b|(?<=\d))(?i:m|ft)\s?(?:/|(?i:per))\s?(?i:s(?:ec)?)\.?(?:\^|\*\*)?[2²]"
    r"|(?:\b|(?<=\d))m(?:\s?/\s?s\s?/\s?s\b|[·\s]?s\s?\^?(?:[⁻-]²|[-−]2\b))|%)"
    r"|(?P<label>[A-Za-z]{1,4}\d{1,2}(?!\w|\.\d))"
    r"|(?P<ordinal>\d{1,2}(?:st|nd|rd|th)(?!\w))"
    r"|(?P<number>(?:(?<=[ \t(=:])[-−])?\d{1,9}(?:[.,]\d{1,6})?)"
    r"|(?P<degrees>(?<=\d)\s?°(?!\s?[CF]\b))"
    r"|(?P<neg>n['’]t\b)"
    r"|(?P<clitic>['’](?:s|re|ll|m|ve|d)?\b|(?<=s)['’])"
    r"|(?P<word>[^\W\d_]+?(?=n['’]t\b)|[^\W\d_]+)"
    r"|(?P<at>(?<!\S)@(?!\w*@))"
    r"|(?P<arrow>(?:→|⇒|[-–=]{1,2}>)(?=\W*(?:\d|(?i:a |stand|stop|zero|rest|halt))))"
    r"|(?P<then>→|⇒|[-–=]{1,2}>)"
    r"|(?P<about>[~≈]\s?(?=\d))|(?P<over>>\s?(?=\d))|(?P<under><\s?(?=\d))"
    r"|(?P<tolerance>±|\+\s?/?\s?[-−–])"
    r"|(?P<mark>[-–—/|]|(?<=\d)\.\.(?=\d))"
    r"|(?P<punct>[.,;:!?()\[\]\n&])"
)
_ORDINALS = {"1st": "first", "2nd": "second", "3rd": "third", "4th": "fourth", "5th": "fifth",
             "6th": "sixth", "7th": "seventh", "8th": "eighth"}  # fmt: skip
_LETTERS = re.compile(
    r"(?<=\b[apieuAPIEU]\.[megsMEGS])\.(?=\s*[a-z0-9(,;]|\s[A-Z][-.]?\d)"
    r"|(?<=\b[apieuAPIEU])\.(?=[megsMEGS]\b)"
)
"""Full stops after single letters that shorten a word."""
_WITHIN = re.compile(r"\.(?=\s*[a-z0-9(,;]|\s[A-Z][-.]?\d|[MEGS]\b)")
"""What a full stop that only shortens a word has after it: no capital letter, as a sentence has."""
_LAYOUT = re.compile(r"\n|,[^,.;!?]{1,40}:|\s[-–—/|]|—|\.{3}|(?:^\W*|[.,:;] )\(?\w{1,2}[.)]\s")
"""What texts have whose layout says something."""
_MAX_WORD = 40
"""Longer runs of letters are no words; cutting them keeps look-ups cheap."""


_KINDS = ("number", "label", "clitic", "neg", "punct")
"""Groups that are a kind of their own; all others are words."""
_SIGNS = {"tolerance": "±", "at": "at", "arrow": "to", "degrees": "degrees"} | {
    word: word for word in ("about", "over", "under")
}
"""What a sign says: ``~50 km/h``, ``> 50 km/h``."""
_BARE = frozenset({"plain", "punct"})


@dataclass(slots=True, unsafe_hash=True)
class Token:
    """A word, number or mark with its span.

    Attributes:
        text: as written.
        low: lower case, curly apostrophes straightened, slips of the pen mended.
        start: first character offset.
        end: offset after the last character.
        kind: ``word``, ``number``, ``label``, ``clitic``, ``neg`` or ``punct``.
        forms: base forms of a word, see :func:`scegen.understanding.words.lemmas.lemmas`.
        slip: whether ``low`` is not what is written, but what seems to be meant.
    """

    text: str
    low: str
    start: int
    end: int
    kind: str
    forms: tuple[tuple[str, str], ...]
    slip: bool = False

    @property
    def base(self) -> str:
        """The base form, as the lexicon has it."""
        return self.forms[-1][0]


def tokenize(text: str) -> list[Token]:
    """Tokens in order; hyphens, slashes and other marks within words only separate.

    Returns:
        The tokens; ``token.text == text[token.start : token.end]`` holds for each.
    """
    found: list[Token] = []
    points = set[int]()
    if _WITHIN.search(text):
        points = {m.start() for m in _LETTERS.finditer(text)}
    shortened = abbreviations()
    layout = laid_out(text) if _LAYOUT.search(text) else {}
    for match in _TOKEN.finditer(text):
        start, end = match.span()
        group, written = match.lastgroup or "punct", match.group()
        mark = layout.get(start, {"mark": "", "then": ";"}.get(group))
        if start in points or mark == "":
            continue
        last = found[-1] if written == "." and found and found[-1].end == start else None
        short = last is not None and last.text.lower() in shortened and not last.text.isupper()
        if short and _WITHIN.match(text, start):
            continue  # "approx. 4 s", not "ahead of the AV. 4 s later"
        if mark is not None:
            found.append(Token(written, mark, start, end, "punct", ((mark, "base"),)))
            continue
        symbol = shortened.get(written.lower(), "").split()
        if len(symbol) > 1:  # "Ve0": the ego's speed
            found += [Token(written, low, start, end, "word", lemmas(low)) for low in symbol]
            continue
        low, kind, forms, slip = _read(written, group)
        found.append(Token(written, low, start, end, kind, forms, slip))
    return found


@lru_cache(maxsize=8192)
def _read(written: str, group: str) -> tuple[str, str, tuple[tuple[str, str], ...], bool]:
    """A word as it is meant, its kind, its base forms, and whether it is misspelt."""
    kind = group if group in _KINDS else "word"
    low = written.lower() if group in _BARE else _spelt(written, group)
    low = abbreviations().get(low, low)
    inflected = kind in {"word", "neg", "clitic"} and len(low) <= _MAX_WORD
    forms = lemmas(low) if inflected else ((low, "base"),)
    mended = None
    if kind == "word" and len(forms) == 1 and low not in load().words:
        mended = meant(low)  # no form of the word occurs in the lexicon
    return (low, kind, forms, False) if mended is None else (mended, kind, lemmas(mended), True)


def low_at(tokens: Sequence[Token], i: int) -> str:
    """The word at a place in the text, empty before its beginning and behind its end."""
    return tokens[i].low if 0 <= i < len(tokens) else ""


def base_words(tokens: list[Token], i: int, j: int) -> str:
    """The base forms of some tokens, with blanks between."""
    return " ".join(token.base for token in tokens[i:j])


def _spelt(written: str, group: str) -> str:
    """``2nd``, ``n/b``, ``don’t``: a word in lower case as the lexicon spells it."""
    low = _plain(written.lower().replace("’", "'"))
    if group == "bound":
        return low.replace("/", "")
    if group in _SIGNS:
        return _SIGNS[group]
    if group == "unit" and low != "%":  # "m/s^2", "m / s²", "m s⁻²", "ft/sec2"
        return "ft/s2" if low.startswith("f") else "m/s2"
    return _ORDINALS.get(low, low)


def _plain(low: str) -> str:
    """``coupé``: without accents, if it is a word of the lexicon so."""
    if low.isascii():
        return low
    plain = "".join(normalize("NFD", letter)[0] for letter in low)
    return plain if plain in load().words else low
