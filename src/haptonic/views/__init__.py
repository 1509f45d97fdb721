"""Interactive views of results: one program for the sent page, the studio and the notebook.

The program is built from ``web/`` into ``bundle/``. It gets a `InteractiveView` as bytes and knows titles and units from
the attributes of its dataset.
"""

from haptonic.views.packed import InteractiveView, packed
from haptonic.views.sent import sent_page

__all__ = ["InteractiveView", "packed", "sent_page"]
