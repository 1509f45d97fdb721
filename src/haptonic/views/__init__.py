"""Interactive views of results, the same in the studio, on a page that can be sent, and in a notebook.

The programs are built from ``web/`` into ``bundle/``. They get an `InteractiveView` as bytes. Titles and
units are attributes of its dataset.
"""

from haptonic.views.notebook import widget_bundle, widgets_work
from haptonic.views.packed import InteractiveView, packed, program
from haptonic.views.sent import digest, embedded_data, packed_page, sent_page, write_page

__all__ = [
    "InteractiveView",
    "digest",
    "embedded_data",
    "packed",
    "packed_page",
    "program",
    "sent_page",
    "widget_bundle",
    "widgets_work",
    "write_page",
]
