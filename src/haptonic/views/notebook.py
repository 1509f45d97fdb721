"""A view as a widget of a notebook, by the package anywidget."""

from __future__ import annotations

from functools import cache
from importlib.util import find_spec
from typing import Any

from haptonic.progress import in_kernel
from haptonic.views.packed import InteractiveView, compressed, packed, program

WIDGET = "application/vnd.jupyter.widget-view+json"


def widgets_work() -> bool:
    """True in a notebook if the extra ``notebook`` is installed."""
    return in_kernel() and find_spec("anywidget") is not None


def widget_bundle(view: InteractiveView) -> dict[str, Any]:
    """Formats that a notebook shows a view from, by media type, without the text."""
    bundle, *_ = view_widget(view)._repr_mimebundle_()
    return {WIDGET: bundle[WIDGET]}


def view_widget(view: InteractiveView) -> Any:
    """The widget of a view."""
    return _widget_class()(data=compressed(packed(view)))


@cache
def _widget_class() -> Any:
    from anywidget import AnyWidget
    from traitlets import Bytes

    class ViewWidget(AnyWidget):
        """Widget with the program and the compressed data of a view."""

        _esm = program()
        data = Bytes().tag(sync=True)

    return ViewWidget
