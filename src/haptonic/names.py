"""Names that users choose, safe in terminals, files, tables, LaTeX and NetCDF; names and counts in sentences.

HTML is escaped by templates, JSON by its writer. `haptonic.plots.style` switches off formulas in pictures,
and `haptonic.cli.console` markup in a terminal.
"""

from __future__ import annotations

import hashlib
import re
from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence

LONGEST_PART = 40  # characters of a name in the name of a file, far below the limit of every system
LONGEST_SLUG = 24
DIGITS = 16  # hexadecimal digits of the digest of a name that cannot be the name of a file

# Characters that move the cursor, hide or reorder text, or cannot be encoded: C0, C1, line and paragraph
# separators, marks of Unicode's bidirectional algorithm, surrogates. Tabs and line ends are text in a
# message.
_HIDDEN = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff]")
_LINES = re.compile(r"[\t\n]")
_PLAIN = re.compile(rf"[A-Za-z0-9_][A-Za-z0-9_-]{{0,{LONGEST_PART - 1}}}")
_OTHERS = re.compile(r"[^A-Za-z0-9_-]+")
# names of devices in Windows, with any ending
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
    | {"\N{MINUS SIGN}": "$-$", "\N{EN DASH}": "--"}
    | {letter: f"$\\{name}$" for letter, name in _SIGNS.items()}
    | {letter: f"$_{k}$" for k, letter in enumerate("₀₁₂₃₄₅₆₇₈₉")}
    | {letter: f"$^{power}$" for letter, power in _POWERS.items()}
)
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


def hidden_in(name: str) -> str | None:
    """First control character of a name; None without one."""
    match = _HIDDEN.search(name) or _LINES.search(name)
    return match[0] if match else None


def names_in(text: str, known: Collection[str]) -> tuple[str, ...]:
    """Names separated by commas; a known name may contain commas, and the longest known name is taken."""
    parts, names = text.split(","), list[str]()
    while parts:
        joined = {count: ",".join(parts[:count]) for count in range(len(parts), 0, -1)}
        count = next((k for k, name in joined.items() if name in known or name.strip() in known), 1)
        name = joined[count] if joined[count] in known else joined[count].strip()
        names += [name] if name else []
        parts = parts[count:]
    return tuple(names)


def listed(names: Sequence[str], last: str = "and") -> str:
    """Names in a sentence: ``"a, b and c"``; ``last`` is the word before the last one."""
    return f" {last} ".join(filter(None, [", ".join(names[:-1]), *names[-1:]]))


def counted(number: int, noun: str) -> str:
    """Text of a count: ``"3 rows"``, ``"1 row"``, ``"no rows"``."""
    return f"{number or 'no'} {noun}{'' if number == 1 else 's'}"


def visible(text: str) -> str:
    """A text for a terminal or a message, with control characters escaped, as in ``\\\\x1b``."""
    return _HIDDEN.sub(lambda match: ascii(match[0])[1:-1], text)


def file_parts(names: Iterable[str]) -> Mapping[str, str]:
    """Forms of names in names of files: plain names unchanged, others as a readable part and a digest.

    Only ASCII letters, digits, "_", "-" and "+" occur, so that no name leaves its folder on any system.
    Different names get different forms, also on systems that ignore the case of letters.
    """
    names = list(dict.fromkeys(names))
    alike = Counter(name.casefold() for name in names)
    unchanged = {name for name in names if alike[name.casefold()] == 1 and _is_plain(name)}
    return {name: name if name in unchanged else _digested(name) for name in names}


def _is_plain(name: str) -> bool:
    return bool(_PLAIN.fullmatch(name)) and not _RESERVED.fullmatch(name)


def _digested(name: str) -> str:
    # no plain name contains "+", so this form cannot be another name
    digest = hashlib.sha256(name.encode("utf-8", "surrogatepass")).hexdigest()[:DIGITS]
    return f"{_OTHERS.sub('_', name)[:LONGEST_SLUG]}+{digest}"


def cell(value: object) -> object:
    """A value for a CSV table; a text that a spreadsheet would compute gets a leading "'"."""
    if isinstance(value, str) and _FORMULA.match(value) and not _NUMBER.fullmatch(value.lstrip("'")):
        return f"'{value}"
    return value


def latex(text: str) -> str:
    """A text for LaTeX that prints it literally: no letter is a command, and no package is needed."""
    return visible(text).translate(_IN_LATEX)


def from_cell(text: str) -> str:
    """The original of a text from `cell`; any other text is unchanged."""
    return text[1:] if text.startswith("'") and cell(text[1:]) == text else text


def variable(text: str) -> str:
    """A text as the name of a NetCDF variable, in which "/" separates groups."""
    return text.replace("%", "%25").replace("/", "%2F")
