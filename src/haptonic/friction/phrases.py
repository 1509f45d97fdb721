"""Text for a reduction of friction, and for two averages of it."""

from __future__ import annotations

import math

from haptonic.units import share_form, share_text

AVERAGES = {
    "reduction": "1 - (friction on) / (friction off), each first averaged over the participants: a person "
    "whose friction is high counts for more",
    "equivalence": "the mean over participants of 1 - on / off: all count the same, and a test over "
    "participants needs one number of each",
}


def averages() -> str:
    """Text that explains why a reduction and the mean of an idle waveguide's test differ."""
    return (
        "Two averages of the same trials, which differ a little: the reduction is "
        f"{AVERAGES['reduction']}; in the test of an idle waveguide it is {AVERAGES['equivalence']}."
    )


def change(value: float, low: float = math.nan, high: float = math.nan) -> str:
    """Text for a reduction (0.55 for 55 %) and its interval: friction "falls by ..." or "rises by ..."."""
    if float(format(100 * value, share_form(low, high))) >= 0:
        return f"friction falls by {share_text(value, low, high)}"
    return f"friction rises by {share_text(-value, -high, -low)}"
