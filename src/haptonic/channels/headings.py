"""Names and units of columns, from the headings that programs write above a table."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from haptonic.channels.cells import is_missing, number_of
from haptonic.units import TYPOGRAPHIC

LONGEST = 300  # characters of one name; longer ones have no unit
LONGEST_LINE = 8_000  # characters of a line whose names may have several words
COMMENT = re.compile(r"\s*(?:%|#|!|//)+\s?")
# the last pair of brackets, which may contain others: "Fz (mN)", "real ((m/s)/V)"; then COMSOL's parameter
_BRACKETED = re.compile(
    r"(?P<name>[^\[\]]*?[^\s\[\]]|)(?P<gap>\s*)"
    r"(?:\[(?P<square>[^\[\]]*)\]|\((?P<round>(?:[^()\[\]]|\([^()]*\))*)\))"
    r"\s*(?P<behind>@.*|,.*=.*|)"
)
_HERTZ = re.compile(r"(?P<name>.*?[^\s_])?[\s_]+(?P<unit>[kMGT]?Hz|k?hz|ghz|rad/s|rpm)")
_ATOM = (
    r"(?:[fpnuµmckMGT]?(?:m|s|Hz|N|V|W|Pa|g|rad)|[kKmMgG]?[hH][zZ]|sec|min|inch|in|ft|lbf|gf|kgf|deg|°|degrees?|"
    r"dB|%|1|rpm|°C|(?:2\s*\*?\s*)?(?:pi|π)|counts?|turns?)"
)
_FACTOR = rf"{_ATOM}(?:(?:\^|\*\*)?-?\d)?"
_UNIT = re.compile(rf"\(?{_FACTOR}\)?(?:\s*(?:[*/]|\s|per)\s*\(?(?:{_FACTOR}|a)\)?){{0,4}}")
_KEY = re.compile(r"[^:=()\[\]]{1,60}(?::(?:\s|$)|=\s*\S)")
_RULE = re.compile(r"[\s\-=_*+|#%.]*")


@dataclass(frozen=True)
class Heading:
    """Heading of a column.

    text : full text
    name : without the unit
    unit : as in the file, "" if missing
    """

    text: str
    name: str
    unit: str

    @classmethod
    def of(cls, cell: str) -> Heading:
        """Parse a cell: "Fz (mN)", "freq [Hz] @ k=0.1", "f / Hz", "Zeit in s", "f, kHz", "f_Hz"."""
        text = cell.strip().strip('"').strip()
        if len(text) > LONGEST:
            return cls(text, text, "")
        match = _BRACKETED.fullmatch(text)
        if match:
            unit = (match["square"] if match["square"] is not None else match["round"]).strip()
            # "max(w)" is a name; "max (w)" has an unknown unit, which is an error only where a unit is needed
            if is_unit(unit) or match["gap"] or match["square"] is not None or not match["name"]:
                return cls(text, " ".join(f"{match['name']} {match['behind']}".split()), plain_unit(unit))
        if is_unit(text):
            return cls(text, text, plain_unit(text) if re.search("hz|rad/s", text, re.IGNORECASE) else "")
        base, at, behind = text.partition(" @ ")
        for part in (" in ", "/", ","):
            name, _, unit = base.partition(part) if part != " in " else base.rpartition(part)
            if name.strip() and is_unit(unit.strip()) and not unit.strip().isdigit():
                return cls(text, f"{name.strip()}{at}{behind}", plain_unit(unit.strip()))
        match = _HERTZ.fullmatch(base)
        if match and match["name"]:
            return cls(text, f"{match['name']}{at}{behind}", plain_unit(match["unit"]))
        return cls(text, text, "")


def plain_unit(unit: str) -> str:
    """A unit with its usual capitals: "khz", "KHZ" and "kHz" are the same."""
    hertz = re.fullmatch(r"([kKMGT]?)hz", unit, re.IGNORECASE) if not unit.startswith("m") else None
    return f"{hertz[1].replace('K', 'k')}Hz" if hertz else unit


def is_unit(text: str) -> bool:
    """True for a unit as instruments write it: "Hz", "(m/s)/V", "rad s^-1"."""
    return len(text) <= LONGEST and bool(_UNIT.fullmatch(text.translate(TYPOGRAPHIC)))


def is_title(line: str) -> bool:
    """True for a line such as "Force Units: N" or "rate = 500 Hz", which does not name columns."""
    return bool(_KEY.match(line.lstrip(' "')))


def is_rule(line: str) -> bool:
    """True for an empty line and for one of dashes."""
    return len(line) <= LONGEST * 20 and bool(_RULE.fullmatch(line))


def units_in(cells: Sequence[str]) -> list[str] | None:
    """Units of a line that has only units, without their brackets; None for other lines."""
    units, has_unit = [], False
    for cell in cells:
        text = cell.strip().strip('"').strip()
        inner = text[1:-1].strip() if re.fullmatch(r"\[.*\]|\((?:[^()]|\([^()]*\))*\)", text) else None
        if inner is None and text not in ("", "-") and not is_unit(text):
            return None
        unit = plain_unit(text if inner is None else inner)
        has_unit |= unit not in ("", "-", "1")
        units.append("" if unit == "-" else unit)
    return units if has_unit else None


def could_be_names(cells: Sequence[str], decimal: str = ".") -> bool:
    """False if a cell is a number that cannot be a name: names are words, or whole numbers after a word."""
    filled = [cell.strip() for cell in cells if not is_missing(cell)]
    numbers = [cell for cell in filled if number_of(cell, decimal) is not None]
    return (
        bool(filled)
        and number_of(filled[0], decimal) is None
        and all(re.fullmatch(r"\d{1,4}", cell) for cell in numbers)
    )


def names_by_blanks(
    line: str, count: int, starts: Sequence[int] | None = None, ends: Sequence[int] | None = None
) -> list[str] | None:
    """As many names as columns from a line of words separated by blanks, or None.

    Parameters
    ----------
    starts, ends : positions of the first character of the cells below, and after their last one; given if all
        rows have the same ones
    """
    mark = COMMENT.match(line)
    plain = " " * mark.end() + line[mark.end() :] if mark else line
    text = plain.strip()
    if len(text) > LONGEST_LINE:
        return names if len(names := text.split()) == count else None
    for part in ("\t", ";", "|", ","):
        cells = [cell.strip() for cell in text.split(part)]
        if len(cells) == count > 1 and all(cells):
            return cells
    # two blanks separate names of two words, and so does the bracket at the end of a unit
    wide = re.split(r"\s{2,}(?![\[(@])|(?<=[\])])\s+(?![\[(@])", text)
    if len(wide) == count and not any(_has_wavevector(cell) for cell in wide):
        return wide
    ended = _ENDED.findall(text)
    if len(ended) == count and "".join(ended).replace(" ", "") == text.replace(" ", ""):
        return [cell.strip() for cell in ended]
    bound = re.findall(r"\S+(?:\s+[\[(][^)\]]*[\])])?(?:\s+@\s*\S+)?", text)
    if len(bound) == count:
        return bound
    for cuts, beside in (((starts or ())[1:], -1), ((ends or ())[:-1], 0)):
        if cuts and (aligned := _cut(plain, cuts, beside)):
            return aligned
    words, lacking = wide[0].split(), count - len(wide)
    if (
        not 0 < lacking < len(words)
        or words[lacking] == "in"
        or words[lacking][0] in "/[(@"
        or wide[0][-1] not in ")]"
    ):
        return None
    if all(_WAVEVECTOR.fullmatch(word) for word in words[:lacking]):
        return [*words[:lacking], " ".join(words[lacking:]), *wide[1:]]
    return None


# names that end with a unit in brackets, and COMSOL's parameter after it
_ENDED = re.compile(r"\S[^()\[\]]*[\[(][^()\[\]]*[\])](?:\s*@\s*[^\s,]+(?:,\s*[^\s,]+=[^\s,]+)*)?(?:\s+|$)")
_WAVEVECTOR = re.compile(r"[kqβκ](?:_?[xyz12])?|kappa|beta|wavevector|wavenumber|segment|path", re.IGNORECASE)


def _has_wavevector(cell: str) -> bool:
    """True if the name of a wavevector and the next name may have been read as one name."""
    words = cell.split()
    return (
        len(words) > 1
        and bool(_WAVEVECTOR.fullmatch(words[0]))
        and words[1][:1] not in "[(@/"
        and words[1] != "in"
    )


def _cut(line: str, cuts: Sequence[int], beside: int) -> list[str] | None:
    """Pieces of a line between positions that cut no word in two; None if there are no such positions.

    A name that is longer than its column shifts the following ones, and a blank within it may lie at a cut by
    chance. Therefore two blanks have to separate a name of several words from its neighbours.

    Parameters
    ----------
    beside : offset of the blank at each cut: -1 where pieces begin there, 0 where they end
    """
    texts = [line[a:b] for a, b in zip([0, *cuts], [*cuts, len(line)], strict=True)]
    pieces = [" ".join(text.split()) for text in texts]
    if not all(pieces) or not all(line[cut + beside : cut + beside + 1].isspace() for cut in cuts):
        return None
    for (before, after), (name, other) in zip(pairwise(texts), pairwise(pieces), strict=True):
        blanks = len(before) - len(before.rstrip()) + len(after) - len(after.lstrip())
        if blanks < 2 and (" " in name or " " in other):
            return None
    return pieces
