"""An animated linkage: an SVG without script (SMIL); a still print shows the first frame."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    Line = Sequence[complex]

SECONDS = 6
MILLIMETRES = 1e3
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00")
MARGIN = 0.08


def animated(
    title: str, frames: "Sequence[Sequence[Line]]", traces: "Sequence[Line]", pivots: "Sequence[complex]",
    pins: "Sequence[Sequence[complex]]" = (), seconds: float = SECONDS,
) -> str:  # fmt: skip
    """Links as lines that move through their frames and back to the first, with curves and fixed pivots.

    Parameters
    ----------
    title : str
        What it is.
    frames : sequence
        For each frame the lines of the links, always as many, each of as many points [m].
    traces : sequence
        Curves that stand still.
    pivots : sequence
        Fixed pivots.
    pins : sequence
        For each frame the moving pins.
    seconds : float
        How long the frames take.

    Returns
    -------
    str
        The file.
    """
    everything = [point for frame in frames for line in frame for point in line]
    everything += [point for line in traces for point in line] + list(pivots)
    left, right = min(p.real for p in everything), max(p.real for p in everything)
    low, high = min(p.imag for p in everything), max(p.imag for p in everything)
    size = max(right - left, high - low)
    edge = MARGIN * size
    width, height = (MILLIMETRES * (span + 2.0 * edge) for span in (right - left, high - low))
    stroke = 0.012 * size * MILLIMETRES
    loop = f'dur="{seconds:g}s" repeatCount="indefinite"'
    parts = [
        f'<path d="M {_points(line)}" fill="none" stroke="#555555" stroke-width="{0.35 * stroke:.4f}"/>'
        for line in traces
    ]
    for index in range(len(frames[0])):
        shapes = [f"M {_points(frame[index])}" for frame in (*frames, frames[0])]
        line = frames[0][index]
        closed = "0.15" if len(line) > 2 and line[0] == line[-1] else "0"
        parts.append(
            f'<path d="{shapes[0]}" fill="{COLOURS[index % len(COLOURS)]}" fill-opacity="{closed}" '
            f'stroke="{COLOURS[index % len(COLOURS)]}" stroke-width="{stroke:.4f}" stroke-linecap="round" '
            f'stroke-linejoin="round"><animate attributeName="d" values="{";".join(shapes)}" {loop}/></path>'
        )
    for index in range(len(pins[0]) if pins else 0):
        x = ";".join(f"{MILLIMETRES * pin[index].real:.3f}" for pin in (*pins, pins[0]))
        y = ";".join(f"{-MILLIMETRES * pin[index].imag:.3f}" for pin in (*pins, pins[0]))
        parts.append(
            f'<circle cx="{x.partition(";")[0]}" cy="{y.partition(";")[0]}" r="{0.8 * stroke:.4f}" fill="#ffffff" '
            f'stroke="#000000" stroke-width="{0.3 * stroke:.4f}"><animate attributeName="cx" values="{x}" {loop}/>'
            f'<animate attributeName="cy" values="{y}" {loop}/></circle>'
        )
    for pivot in pivots:
        x, y = f"{MILLIMETRES * pivot.real:.4f}", f"{-MILLIMETRES * pivot.imag:.4f}"
        parts.append(f'<circle cx="{x}" cy="{y}" r="{1.1 * stroke:.4f}"/>')
    corner = f"{MILLIMETRES * (left - edge):.4f} {-MILLIMETRES * (high + edge):.4f}"
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.4f}mm" height="{height:.4f}mm" '
        f'viewBox="{corner} {width:.4f} {height:.4f}">\n'
        f"<title>{title}</title>\n<desc>unit: mm; the y axis points down, as in every SVG</desc>\n"
        + "\n".join(parts)
        + "\n</svg>\n"
    )


def _points(line: "Line") -> str:
    return " L ".join(f"{MILLIMETRES * point.real + 0.0:.3f} {-MILLIMETRES * point.imag + 0.0:.3f}" for point in line)
