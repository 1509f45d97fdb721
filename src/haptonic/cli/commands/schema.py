"""``haptonic schema``: for editors."""

from __future__ import annotations

import json
import sys

from haptonic.fields.json_schema import json_schema
from haptonic.study import Study


def run() -> None:
    """Print the JSON schema of the study file."""
    json.dump(json_schema(Study, "haptonic study"), sys.stdout, indent=2, ensure_ascii=False)
    sys.stdout.write("\n")
