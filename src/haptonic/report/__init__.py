"""One page that shows what a study gave: self-contained, printable, with the paper beside it."""

from haptonic.report.chapter import Absent, Chapter, Picture, Results, Table
from haptonic.report.page import write_report
from haptonic.report.quality import write_quality
from haptonic.report.sheet import write_sheet

__all__ = [
    "Absent",
    "Chapter",
    "Picture",
    "Results",
    "Table",
    "write_quality",
    "write_report",
    "write_sheet",
]
