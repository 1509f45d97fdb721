from .chapter import Absent, Chapter, Picture, Results, Table
from .page import write_report
from .quality import write_quality
from .sheet import write_sheet

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
