from .chapter import Absent as Absent
from .chapter import Chapter as Chapter
from .chapter import Finding as Finding
from .chapter import Picture as Picture
from .chapter import Results as Results
from .chapter import Table as Table
from .page import write_report as write_report
