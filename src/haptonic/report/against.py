"""Comparison of published values with ours: rows for the report and its JSON."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from haptonic.names import listed
from haptonic.plots.text import minus
from haptonic.results.references import References, Value, found_at
from haptonic.units import to_si, uncertain

NONE = "-"  # where there is nothing to show
ABSENT = "not computed in this run"
WITHOUT_PATH = {"experiment": "not computed: a fact of the experiment", "input": "input, as published"}
SAME = 1e-9  # relative difference of two inputs that are equal


@dataclass(frozen=True)
class ComparedValue:
    """A published value beside ours.

    quantity, published : name of the quantity, and its published value
    role : "computed", "input" or "experiment", as in the references
    ours, difference, remark : texts for a table; "-" where there is none
    agrees : whether ours agrees, within its error; None where that is not decided
    value, upper, error : ours in SI units, the upper end of two, and the bound of its error
    """

    quantity: str
    published: str
    role: str
    ours: str
    difference: str
    remark: str
    agrees: bool | None = None
    value: float | None = None
    upper: float | None = None
    error: float | None = None

    @property
    def cells(self) -> tuple[str, str, str, str, str]:
        """The row of a table."""
        return self.quantity, self.published, self.ours, self.difference, self.remark or NONE


def compared(references: References, answers: Mapping[str, Any]) -> list[ComparedValue]:
    """A row for every published value, in the order of the file.

    Parameters
    ----------
    answers : of the analyses by name, as JSON has them; "study" and "derived" among them
    """
    return [_compared(value, answers.get(value.analysis, {})) for value in references.value]


def _compared(value: Value, answer: Any) -> ComparedValue:
    bound = f"{value.relation} " if value.relation.startswith("at ") else ""
    head: dict[str, Any] = {
        "quantity": value.quantity,
        "published": f"{bound}{value.value}",
        "role": value.role,
    }
    if not value.path:
        return ComparedValue(**head, ours=WITHOUT_PATH[value.role], difference=NONE, remark=value.remark)
    ours = [found_at(answer, path) for path in (value.path, value.to) if path]
    if any(number is None for number in ours):
        return ComparedValue(**head, ours=ABSENT, difference=NONE, remark=value.remark)
    if not value.ends or not all(isinstance(number, int | float) for number in ours):
        return _words(value, head, ours)
    return _numbers(value, head, [float(number) for number in ours], answer)


def _words(value: Value, head: dict[str, Any], ours: list[Any]) -> ComparedValue:
    texts = [listed(list(map(str, part))) if isinstance(part, list) else str(part) for part in ours]
    text = listed(list(dict.fromkeys(texts)))
    agrees = all(text == value.value or text in value.means for text in texts)
    difference = "none" if agrees else "differs"
    return ComparedValue(
        **head, ours=_marked(value, text), difference=difference, remark=value.remark, agrees=agrees
    )


def _numbers(value: Value, head: dict[str, Any], ours: list[float], answer: Any) -> ComparedValue:
    divisor = found_at(answer, value.over) if value.over else 1.0
    taken = found_at(answer, value.less) if value.less else 0.0
    errors = [found_at(answer, path) for path in (value.error, value.less_error) if path]
    error = sum(errors) if errors and None not in errors else None
    if divisor is None or taken is None or not divisor:
        return ComparedValue(**head, ours=ABSENT, difference=NONE, remark=value.remark)
    ours = [(number - taken) / divisor * value.factor for number in ours]
    bound = None if error is None else abs(error / divisor * value.factor)
    scale, unit = _shown_unit(value)
    if bound:
        text = uncertain(ours[0] * scale, bound * scale)
    else:
        text = " to ".join(_number(number * scale, value) for number in ours)
    text = f"{text} {unit}".rstrip()
    known: dict[str, Any] = {"value": ours[0], "upper": ours[1] if len(ours) > 1 else None, "error": bound}
    agrees, difference = _difference(value, ours, bound or 0.0, scale, unit)
    rounded = agrees and difference != "none" and value.relation == "equal"
    remark = f"Agrees within {'our error and ' * bool(bound)}the rounding of the published value."
    remark = remark if rounded else value.remark
    return ComparedValue(
        **head,
        ours=_marked(value, minus(text)),
        difference=minus(difference),
        remark=remark,
        agrees=agrees,
        **known,
    )


def _difference(
    value: Value, ours: list[float], error: float, scale: float, unit: str
) -> tuple[bool | None, str]:
    """Agreement of our value, and its difference in words."""
    ends, low, high = value.ends, min(ours), max(ours)
    if value.relation != "equal":
        fulfilled = {
            "at least": low >= ends[0],
            "at most": high <= ends[0],
            "within": ends[0] <= low and high <= ends[-1],
        }[value.relation]
        return fulfilled, "none: fulfilled" if fulfilled else "not fulfilled"
    offs = [number - end for number, end in zip(ours, ends, strict=False)]
    room = error + value.rounding if value.role == "computed" else 0.0
    agrees = all(abs(off) <= max(room, SAME * abs(end)) for off, end in zip(offs, ends, strict=False))
    if agrees and not any(abs(off) > SAME * abs(end) for off, end in zip(offs, ends, strict=False)):
        return True, "none"
    texts = listed([_signed(off * scale) for off in offs])
    if unit == "%":
        return agrees, f"{texts} points"
    shares = "" if len(offs) > 1 or not ends[0] else f"({100 * offs[0] / ends[0]:+.2g} %)"
    return agrees, " ".join(filter(None, (texts, unit, shares)))


def _marked(value: Value, text: str) -> str:
    return f"{text} (input)" if value.role == "input" else text


def _signed(number: float) -> str:
    return f"{number:+.2f}" if abs(number) >= 0.1 or not number else f"{number:+.2g}"


def _number(number: float, value: Value) -> str:
    decimals = value.decimals + 1
    if value.role == "input" or not number or abs(number - round(number)) < SAME * abs(number):
        return f"{number:.4g}"
    return f"{number:.{decimals}f}" if abs(number) >= 10.0**-decimals else f"{number:.2g}"


def _shown_unit(value: Value) -> tuple[float, str]:
    """Factor from SI to the unit of the published text, and that unit."""
    unit = value.value.split(" to ")[-1].strip().partition(" ")[2]
    if value.unit == "1":
        return (100.0, "%") if unit == "%" else (1.0, "")
    return 1.0 / to_si(f"1 {unit}", value.unit, value.quantity), unit
