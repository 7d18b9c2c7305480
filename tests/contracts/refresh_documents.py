"""Writes what the commands shown in README, docs/ and CONTRIBUTING print now, their pictures, and examples/*.out.

python tests/contracts/refresh_documents.py [PAGE|SCRIPT]...

Without arguments it does all of them. A command that ends in an error is shown with its error, as some are meant to be:
read the changes before they are committed. The table of docs/accuracy.md is written by
tests/benchmarks/accuracy_page.py.
"""

import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve()
sys.path[:0] = [str(HERE.parent), str(HERE.parents[1])]

from documents import (  # noqa: E402
    IMAGES,
    PAGES,
    ROOT,
    SCRIPTS,
    drawn,
    missing,
    outputs,
    with_fields,
    with_outputs,
    with_screens,
)
from shell import shell  # noqa: E402

REFUSED = "dynamics: "


def said(path: Path, before: bytes, after: bytes) -> None:
    """Write a file where it changes, and say so."""
    if before != after:
        path.write_bytes(after)
        print(f"{path.relative_to(ROOT)} changed")


def refresh_page(page: Path) -> None:
    """The outputs, tables of fields and pictures of one page."""
    text = page.read_text()
    with tempfile.TemporaryDirectory() as folder:
        printed = outputs(text, Path(folder))
    for session, output in printed:
        if output is None:
            print(f"{page.name}: not run, {', '.join(missing(session.command))} is not installed: {session.command}")
        elif output.startswith(REFUSED) and not session.output.startswith(REFUSED):
            print(f"{page.name}: refused now, look at it: {session.command}")
    said(page, text.encode(), with_screens(with_fields(with_outputs(text, printed))).encode())
    with tempfile.TemporaryDirectory() as folder:
        for name, data in drawn(text, Path(folder)).items():
            place = IMAGES / name
            said(place, place.read_bytes() if place.exists() else b"", data)


def refresh_script(script: Path) -> None:
    """The output beside one example script."""
    if missing(script.read_text()):
        print(f"{script.name}: not run, {', '.join(missing(script.read_text()))} is not installed")
        return
    place = script.with_suffix(".out")
    with tempfile.TemporaryDirectory() as folder:
        done = shell(f"sh {script.name}", script.parent, Path(folder))
    if done.returncode:
        print(f"{script.name}: status {done.returncode}: {done.stderr}")
        return
    said(place, place.read_bytes() if place.exists() else b"", done.stdout.encode())


def main() -> None:
    """Refresh everything, or what is named."""
    start = time.perf_counter()
    named = [Path(word).resolve() for word in sys.argv[1:]]
    failed = 0
    for path in named or [*PAGES, *SCRIPTS]:
        try:
            (refresh_script if path.suffix == ".sh" else refresh_page)(path)
        except Exception as error:  # the next page is refreshed all the same
            failed += 1
            print(f"{path.name}: {type(error).__name__}: {error}")
    print(f"{len(named or [*PAGES, *SCRIPTS])} files in {time.perf_counter() - start:.0f} s")
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
