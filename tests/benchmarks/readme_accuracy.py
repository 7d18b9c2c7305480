"""Writes the README's table of speed against error, and the diagram beside it, as measured here and now.

python tests/benchmarks/readme_accuracy.py
"""

import platform
from pathlib import Path

from dynamics_cli import run
from dynamics_cli.accuracy.pictures import work_precision
from dynamics_cli.accuracy.report import accuracy
from dynamics_cli.core.plot.pages import draw

ROOT = Path(__file__).resolve().parents[2]
START, END = "<!-- accuracy -->", "<!-- /accuracy -->"
DIAGRAM = ROOT / "examples" / "accuracy.svg"


def processor() -> str:
    """What the machine calls its processor."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.machine()


def table() -> list[str]:
    """The questions with rivals, a row for each method."""
    document = run("accuracy")
    rows = document["results"]["methods"]  # type: ignore[index]
    several = {row["question"] for row in rows if "(chosen)" not in row["method"]}
    head = "| question | method | time, chosen = 1 | worst relative error | no answer |"
    lines = [head, "|---|---|---:|---:|---:|"]
    for row in rows:
        if row["question"] not in several:
            continue
        slower = f"{row['slower']['value']:.2g}" if "slower" in row else ""
        refused = row["refused"]["value"] or ""
        lines.append(f"| {row['question']} | {row['method']} | {slower} | {row['worst']['value']:.1e} | {refused} |")
    held = [row for row in rows if row["bound"].endswith("held") and "(chosen)" in row["method"]]
    stated = [row for row in rows if row["bound"] and "(chosen)" in row["method"]]
    lines += [
        "",
        f"The bounds that the program states held in {len(held)} of {len(stated)} questions that have one. Measured on "
        f"{processor()}, Python {platform.python_version()}; `no answer` counts cases that a method refused or "
        "answered with infinity.",
        "",
        f"![Work–precision diagram](examples/{DIAGRAM.name})",
    ]
    return lines


def main() -> None:
    """Rewrite the part of the README between the marks."""
    readme = ROOT / "README.md"
    text = readme.read_text(encoding="utf-8")
    before, _, rest = text.partition(START)
    after = rest.partition(END)[2] if END in rest else rest
    readme.write_text("\n".join([before + START, "", *table(), "", END]) + after, encoding="utf-8")
    DIAGRAM.write_bytes(draw(work_precision(accuracy()), "svg", "si"))


if __name__ == "__main__":
    main()
