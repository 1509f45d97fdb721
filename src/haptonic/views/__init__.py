"""Interactive views of results: one program for the sent page, the studio and the notebook.

The program is built from ``web/`` into ``bundle/``. It gets an `InteractiveView` as bytes. Titles and units
are attributes of its dataset.
"""

from haptonic.views.packed import InteractiveView, packed
from haptonic.views.sent import packed_page, sent_page

__all__ = ["InteractiveView", "packed", "packed_page", "sent_page"]
