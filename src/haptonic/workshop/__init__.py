"""Files for a workshop: the solid (STEP, STL), its outlines (DXF) and a dimensioned drawing (PDF)."""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
