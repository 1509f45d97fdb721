from .chapter import Absent, Chapter, Picture, Results, Table
from .page import write_report

__all__ = [
    "Absent",
    "Chapter",
    "Picture",
    "Results",
    "Table",
    "write_report",
]
