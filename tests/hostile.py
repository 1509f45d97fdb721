"""Names that a study may give, as badly as it may."""

from hypothesis import strategies as st

from haptonic.names import hidden_in

NASTY = (
    "plate", "lattice", "supports", "finger", "region", "patch 1", "A bond", "a, b", "A1, V", "A1", "a1",
    "WG1", "x/../../../escaped",
    "../up", "/root", "C:\\boot", "..", ".", "~", "con", "nul.txt", "patch/1", "a%2Fb",
    "[/x]", "[red]y", "[bold", ":smile:",
    "$x_$", "$\\frac{$", "_hidden", "=2+5", "+1+1", "-x",
    "@SUM(A1)", "'=1",
    '"quoted"',
    "<b>&amp;", "<script>alert(1)</script>", "{{ 7 }}", "{0}", "%s", "a\\nb", " leading", "trailing ",
    "möbel", "名前", "🙂", "e\u0301", "\u00e9", "NA", "None", "nan", "1", "N" * 40,
)  # fmt: skip
RESERVED = ("rest", "the rest")  # names of all points outside of a region
any_text = st.text(st.characters(exclude_categories=["Cs", "Cc", "Zl", "Zp"]), min_size=1, max_size=40)
names = st.one_of(st.sampled_from(NASTY), any_text).filter(
    lambda name: bool(name.strip()) and hidden_in(name) is None and name not in RESERVED
)
