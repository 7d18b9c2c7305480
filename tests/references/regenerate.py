"""Makes files of references again, all or those named, and then the manifest: two minutes of processor time in all.

Run: python tests/references/regenerate.py [NAME …], a name without its ending: convert, cam_motion, …. What has changed
is told; the same generators give the same bytes every time.
"""

import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import generate_manifest
import made_from
from manifest_sources import FILES

HERE = Path(__file__).resolve().parent


def main(names: list[str]) -> None:
    """Run the generators, then write the manifest."""
    for name in names or list(FILES):
        path = generate_manifest.DATA / f"{name}.json"
        before = path.read_bytes() if path.exists() else b""
        generator = HERE / f"generate_{name}_references.py"
        subprocess.run([sys.executable, str(generator)], check=True, stdout=subprocess.DEVNULL)
        print(name, "as before" if path.read_bytes() == before else "changed", flush=True)
    made_from.renew(names or list(FILES))
    target = generate_manifest.ACCURACY / "manifest.json"
    target.write_text(generate_manifest.text(), encoding="utf-8")


if __name__ == "__main__":
    unknown = set(sys.argv[1:]) - set(FILES)
    if unknown:
        sys.exit(f"no such file of references: {', '.join(sorted(unknown))}; there are {', '.join(FILES)}")
    main(sys.argv[1:])
