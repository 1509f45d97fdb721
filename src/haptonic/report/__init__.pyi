from .chapter import (
    Absent as Absent,
    Chapter as Chapter,
    Finding as Finding,
    Picture as Picture,
    Results as Results,
    Table as Table,
)
from .page import write_report as write_report
