"""A name that somebody chose is data: what becomes of it where it is shown or filed, medium by medium.

HTML is escaped by its templates, JSON by its writer, formulas in pictures are switched off in
`haptonic.plots.style`, and markup in a terminal in `haptonic.cli.console`.
"""

from __future__ import annotations

import hashlib
import re
from collections import Counter
from collections.abc import Collection, Iterable, Mapping

LONGEST_PART = 40  # characters of a name in a file's name, far below every system's limit
LONGEST_SLUG = 24
DIGITS = 16  # hexadecimal, of the digest of a name that cannot be its file's

# Moves the cursor, hides or reorders text, or cannot be encoded: C0, C1, line and paragraph separators, the
# marks of Unicode's bidirectional algorithm, surrogates. Tabs and line ends are text in a message.
_HIDDEN = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff]")
_LINES = re.compile(r"[\t\n]")
_PLAIN = re.compile(rf"[A-Za-z0-9_][A-Za-z0-9_-]{{0,{LONGEST_PART - 1}}}")
_OTHERS = re.compile(r"[^A-Za-z0-9_-]+")
# devices of Windows, whatever follows a point
_RESERVED = re.compile(r"(?i)con|prn|aux|nul|com[0-9]|lpt[0-9]")
_FORMULA = re.compile(r"'*[=+\-@\t\r]")
_SIGNS = {
    "±": "pm", "\N{MULTIPLICATION SIGN}": "times", "°": "circ", "µ": "mu", "π": "pi", "κ": "kappa",
    "ω": "omega", "Γ": "Gamma", "Ω": "Omega", "≤": "le", "≥": "ge", "→": "to",
}  # fmt: skip
_POWERS = dict(zip("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789", strict=True))
_IN_LATEX = str.maketrans(
    {letter: f"\\{letter}" for letter in "&%$#_{}"}
    | {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "\u200b": ""}
    | {letter: f"${letter}$" for letter in "<>|"}
    | {"\N{MINUS SIGN}": "$-$"}
    | {letter: f"$\\{name}$" for letter, name in _SIGNS.items()}
    | {letter: f"$_{k}$" for k, letter in enumerate("₀₁₂₃₄₅₆₇₈₉")}
    | {letter: f"$^{power}$" for letter, power in _POWERS.items()}
)
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


def hidden_in(name: str) -> str | None:
    """The first character of a name that is a control character, or None."""
    found = _HIDDEN.search(name) or _LINES.search(name)
    return found[0] if found else None


def names_in(text: str, known: Collection[str]) -> tuple[str, ...]:
    """Names with commas between; a known name may hold commas itself, and the longest one is taken."""
    parts, found = text.split(","), list[str]()
    while parts:
        joined = {count: ",".join(parts[:count]) for count in range(len(parts), 0, -1)}
        count = next((k for k, name in joined.items() if name in known or name.strip() in known), 1)
        name = joined[count] if joined[count] in known else joined[count].strip()
        found += [name] if name else []
        parts = parts[count:]
    return tuple(found)


def visible(text: str) -> str:
    """A text for a terminal or a message: control characters are written out, as in ``\\\\x1b``."""
    return _HIDDEN.sub(lambda found: ascii(found[0])[1:-1], text)


def file_parts(names: Iterable[str]) -> Mapping[str, str]:
    """What names become in names of files: themselves where plain, else something readable and a digest.

    Letters, digits, "_", "-" and "+" of ASCII only, so that no name leaves its folder on any system;
    different names become different ones, also where a system takes capitals for small letters.
    """
    names = list(dict.fromkeys(names))
    alike = Counter(name.casefold() for name in names)
    kept = {name for name in names if alike[name.casefold()] == 1 and _is_plain(name)}
    return {name: name if name in kept else _digested(name) for name in names}


def _is_plain(name: str) -> bool:
    return bool(_PLAIN.fullmatch(name)) and not _RESERVED.fullmatch(name)


def _digested(name: str) -> str:
    # "+" is in no plain name, so this one cannot be that of another name
    digest = hashlib.sha256(name.encode("utf-8", "surrogatepass")).hexdigest()[:DIGITS]
    return f"{_OTHERS.sub('_', name)[:LONGEST_SLUG]}+{digest}"


def cell(value: object) -> object:
    """A value for a table in CSV: text that a spreadsheet would compute gets the "'" that makes it text."""
    if isinstance(value, str) and _FORMULA.match(value) and not _NUMBER.fullmatch(value.lstrip("'")):
        return f"'{value}"
    return value


def latex(text: str) -> str:
    """A text for LaTeX, which prints it as it is: no letter of it is a command, none needs a package."""
    return visible(text).translate(_IN_LATEX)


def from_cell(text: str) -> str:
    """The text that `cell` made safe; any other text as it is."""
    return text[1:] if text.startswith("'") and cell(text[1:]) == text else text


def variable(text: str) -> str:
    """A text as the name of a variable in NetCDF, where "/" parts groups."""
    return text.replace("%", "%25").replace("/", "%2F")
