"""Scenes of bodies as files."""

import json
from pathlib import Path
from typing import Any

import pytest


@pytest.fixture
def scene(tmp_path: Path) -> Any:
    def written(*bodies: dict[str, Any], **more: Any) -> str:
        path = tmp_path / "scene.json"
        path.write_text(json.dumps({"bodies": bodies, **more}))
        return str(path)

    return written
