from .catalogue import (
    Case as Case,
    CaseQuantity as CaseQuantity,
    OmittedCase as OmittedCase,
    cases as cases,
    omitted_cases as omitted_cases,
)
from .comparison import (
    CaseComparison as CaseComparison,
    compare_case as compare_case,
    load_case_study as load_case_study,
)
from .page import page_text as page_text, write_page as write_page
from .tables import comparison_table as comparison_table, plain_comparison as plain_comparison
