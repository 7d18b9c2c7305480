"""The first page: title block, picture, findings in sentences, their drivers, and the verdict of the checks."""

from dynamics_cli.core.output.plot.axes import words
from dynamics_cli.pictures import Axis, Panel, Picture, Ranges
from dynamics_cli.report.blocks import Beside, Heading, Image, Items, Paragraph, Title
from dynamics_cli.report.calculation import Calculation, node_at
from dynamics_cli.report.findings import finding, found, subject

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from dynamics_cli.report.blocks import Block

MOST_COMPARED = 2


def front(
    title: str,
    facts: "Sequence[str]",
    calculations: "Sequence[Calculation]",
    images: "Sequence[Image]",
    across: "Sequence[Image]" = (),
) -> "list[Block]":
    """Title block, a wide picture, the others beside findings, and whether the repeated calculations agree."""
    findings: list[Block] = [Heading(2, "Findings")]
    findings.append(Items([finding(case) for case in calculations], ordered=True))
    findings += [Paragraph(text, small=True) for text in _drivers(calculations)]
    findings.append(Paragraph(verdict(calculations), small=True))
    cautions = _cautions(calculations)
    if cautions:
        findings.append(Paragraph(cautions))
    return [Title(title, facts), *across, *([Beside(images, findings)] if images else findings)]


def _drivers(calculations: "Sequence[Calculation]") -> "list[str]":
    """The drivers of the findings with limits, or else of the last calculation."""
    for case in reversed(calculations):
        for address in sorted(found(case), key=lambda item: not case.limits(item)):
            drivers = case.drivers(address)
            if drivers:
                return [f"{case.name}: {subject(case, address)} is driven by {drivers} (shares of the variance)."]
    return []


def _cautions(calculations: "Sequence[Calculation]") -> str:
    """Which sections warn of something."""
    warned = [
        case.section
        for case in calculations
        if any(item["severity"] != "note" for item in (case.document or {}).get("warnings", ()))
    ]
    if not warned:
        return ""
    plural = "s" * (len(warned) > 1)
    return f"Warnings are in section{plural} {', '.join(map(str, warned))}."


def verdict(cases: "Sequence[Calculation]") -> str:
    """Whether the calculations gave the same results when repeated, and whether their checks passed."""
    same = sum(case.again.same for case in cases)
    documents = [case.document for case in cases if case.document is not None]
    failed = sum(not check["passed"] for document in documents for check in document["checks"])
    calculations = f"{len(cases)} calculation{'s' * (len(cases) > 1)}"
    text = f"{same} of {calculations} gave the same results when repeated from these inputs"
    different = [f"section {case.section}: {case.again.short}" for case in cases if not case.again.same]
    others = f"; {', '.join(different)}" if different else ""
    checks = f"{failed} internal check{'s' * (failed > 1)} failed" if failed else "All internal checks passed"
    return f"{text}{others}. {checks}."


def intervals(calculations: "Sequence[Calculation]", width: float) -> "Picture | None":
    """The findings of one unit with their intervals and limits on one axis; two at least."""
    grouped: dict[str, list[tuple[str, float, float, float]]] = {}
    limits: dict[str, list[tuple[float, str]]] = {}
    for case in calculations:
        labels = case.labels()
        for address in [address for address in found(case) if address in labels][:MOST_COMPARED]:
            node = node_at(case.results, address)
            if not isinstance(node, dict) or "interval" not in node or isinstance(node["value"], list):
                continue
            unit = node.get("unit", "")
            value = case.value(address)
            text = f"{case.name}: {labels[address]}\n{value.text} ({value.interval})"
            grouped.setdefault(unit, []).append((text, *node["interval"], node["value"]))
            for entry in case.limits(address):
                if entry["limit"].get("unit", "") == unit:
                    limits.setdefault(unit, []).append((entry["limit"]["value"], f"limit {entry['limit']['value']:g}"))
    unit, rows = max(grouped.items(), key=lambda item: len(item[1]), default=("", []))
    if len(rows) < 2:
        return None
    names, low, high, values = (tuple(column) for column in zip(*rows, strict=True))
    documents = [item.document for item in calculations if item.document]
    coverages = {document["results"] and _coverage(document["results"]) for document in documents}
    coverage = ", ".join(sorted(text for text in coverages if text))
    axis = Axis(f"[{unit}], {coverage} intervals" if unit else f"{coverage} intervals")
    items = (Ranges(names, low, high, values, tuple(dict.fromkeys(limits.get(unit, ())))),)
    return Picture((Panel(axis, Axis(""), items),), width=width)


def own_picture(case: Calculation) -> "Picture | None":
    """The picture of a calculation without the distributions of its results, if anything is left."""
    picture = case.again.picture
    if picture is None or len(picture.panels) == picture.distributions:
        return None
    panels = picture.panels[: len(picture.panels) - picture.distributions]
    return Picture(panels, picture.title, picture.columns, width=picture.width, scene=picture.scene)


def description(picture: Picture, system: str) -> str:
    """Description of a picture for readers who cannot see it."""
    parts = [words(picture.title, system)] if picture.title else []
    for panel in picture.panels:
        axes = [axis.title for axis in (panel.y, panel.x) if axis.title]
        subject = words(panel.title, system) or " over ".join(axes)
        labels = [words(getattr(item, "label", ""), system) for item in panel.items]
        labels += [name for item in panel.items for name in getattr(item, "names", ())]
        named = ", ".join(dict.fromkeys(label.replace("\n", " ") for label in labels if label))
        parts.append(f"{subject}: {named}" if named and subject else subject or named)
    return ". ".join(part for part in parts if part) or "picture"


def _coverage(node: "object") -> str:
    if isinstance(node, dict):
        if "interval" in node:
            return f"{100.0 * node['coverage']:.6g} %"
        return next(filter(None, map(_coverage, node.values())), "")
    return ""
