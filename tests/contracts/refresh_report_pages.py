"""Draws the first pages of three reports, as docs/ shows them, into docs/images: a crash, a gear pair, a cam.

python tests/contracts/refresh_report_pages.py

It takes the extra `report`: typst sets the pages, and writes them as PNG here instead of PDF.
"""

import io
import sys
import tempfile
from pathlib import Path
from typing import Any
from unittest.mock import patch

HERE = Path(__file__).resolve()
sys.path[:0] = [str(HERE.parent), str(HERE.parents[1])]

import typst  # noqa: E402
from documents import IMAGES  # noqa: E402
from harness import run  # noqa: E402
from shell import ROOT  # noqa: E402

# Dots to an inch and colours: what a page of a document shows, in a file that is not large.
DOTS, COLOURS = 110, 160
CRASH = ROOT / "examples" / "crash"
PAIR = ("gear", "pair", "--first-teeth", "17", "--second-teeth", "43", "--module", "3 mm", "--first-profile-shift",
        "0.3", "--backlash", "0.1 mm")  # fmt: skip
CAM = ("cam", "profile", "--program", "rise 10 mm in 90 deg ms; dwell 90 deg; return in 90 deg; dwell", "--follower",
       "roller", "--base-radius", "25 mm", "--roller-radius", "6 mm")  # fmt: skip


def crash(folder: Path) -> list[str]:
    """The documents of examples/crash."""
    names = [str(folder / f"{name}.json") for name in ("1_ford_after", "2_opel_after", "3_impact", "4_before")]
    calls = (
        ("skid", "speed", "--input", str(CRASH / "first_after.toml")),
        ("skid", "speed", "--input", str(CRASH / "second_after.toml")),
        ("impact", "momentum", "--axes", "compass", "--first-name", "Ford", "--second-name", "Opel",
         "--first-mass", "1500 ± 30 kg", "--first-approach-heading", "90 deg",
         "--first-exit-speed", f"@{names[0]}:speed", "--first-exit-heading", "48 ± 2 deg",
         "--second-mass", "1150 ± 30 kg", "--second-approach-heading", "0 deg",
         "--second-exit-speed", f"@{names[1]}:speed", "--second-exit-heading", "53 ± 2 deg"),
        ("skid", "speed", "--distance", "12.4 ± 0.3 m", "--friction", "0.72 ± 0.04",
         "--end-speed", f"@{names[2]}:first.approach_speed", "--limit", "70 km/h"),
    )  # fmt: skip
    for name, argv in zip(names, calls, strict=True):
        written(name, argv)
    return names


def written(name: str, argv: tuple[str, ...]) -> str:
    """The document of a call in a file."""
    outcome = run(*argv, "--json", "--output", name)
    assert outcome.status == 0, outcome.err
    return name


def first_page(folder: Path, *argv: str) -> bytes:
    """The first page of a report as a PNG file of few colours."""
    from PIL import Image

    compiled = typst.compile

    def as_png(name: str, **more: Any) -> bytes:
        pages = compiled(name, **{**more, "format": "png", "ppi": DOTS})
        first: bytes = pages[0] if isinstance(pages, list) else pages
        return first

    file = folder / "page.pdf"
    with patch.object(typst, "compile", as_png):
        outcome = run("report", *argv, "--date", "22 November 2026", "--output", str(file))
    assert outcome.status == 0, outcome.err
    page = io.BytesIO()
    Image.open(file).convert("RGB").quantize(COLOURS).save(page, "png", optimize=True)
    return page.getvalue()


def main() -> None:
    """Draw all three."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        pages = {
            "report_crash.png": (*crash(folder), "--title", "Two-car crash", "--case", "2026-17"),
            "report_gear_pair.png": (written(str(folder / "pair.json"), PAIR), "--author", "A. Designer"),
            "report_cam.png": (written(str(folder / "cam.json"), CAM), "--author", "A. Designer"),
        }
        for image, argv in pages.items():
            data = first_page(folder, *argv)
            (IMAGES / image).write_bytes(data)
            print(f"docs/images/{image}: {len(data) / 1000:.0f} kB")


if __name__ == "__main__":
    main()
