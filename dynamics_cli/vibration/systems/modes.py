"""Natural frequencies, damping, shapes, modal and effective masses of a system of several masses."""

import math

from dynamics_cli.errors import require, worded
from dynamics_cli.quantities import (
    AngularRate,
    Annotated,
    Count,
    DampingRatio,
    Fraction,
    Frequency,
    Mass,
    Ratio,
    Text,
)
from dynamics_cli.records import Advice, Check, Choice, ErrorBound, Numerics, record
from dynamics_cli.vibration.single.oscillator import require_damping
from dynamics_cli.vibration.systems.inputs import Bodies, Line, Matrices, MatrixFiles, System

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# Frequencies of one group, relatively: any combination of their shapes serves.
SAME = 1e-9
# A frequency with fewer digits than this is none.
LOST = 0.01
ORTHOGONAL = 1e-9
# Parts of a shape below this are of rounding.
NOISE = 1e-15
# What turning radians into hertz adds to a bound.
ROUNDED = 4.5e-16


class Scale(Choice):
    """How shapes are scaled."""

    names = ("largest", "first", "mass")


LARGEST = Scale("largest")


@record
class Mode:
    """One mode."""

    number: Annotated[Count, "From the lowest [-]."]
    frequency: Annotated[Frequency | None, "Undamped natural frequency; of damped modes |λ|/2π [Hz]."]
    angular_frequency: Annotated[AngularRate | None, "That in radians [rad/s]."]
    damping_ratio: Annotated[DampingRatio | None, "Damping over critical damping ζ [-]."]
    damped_frequency: Annotated[Frequency | None, "Frequency of the damped vibration [Hz]."]
    shape: Annotated[tuple[Ratio, ...], "Displacements of the coordinates in their order [-]."]
    phases: Annotated[tuple[Ratio, ...] | None, "Of complex modes: lead of each coordinate in degrees [-]."]
    modal_mass: Annotated[Mass | None, "Σmφ² with the shape as scaled [kg]."]
    participation: Annotated[Ratio | None, "Participation factor for a common motion of the base, shape as scaled [-]."]
    effective_share: Annotated[Fraction | None, "Effective mass over the whole mass [-]."]


@record
class Modes:
    """The modes of a system."""

    coordinates: Annotated[Text, "The coordinates in the order of the shapes."]
    rigid_modes: Annotated[Count | None, "Modes of frequency zero, counted from the connections [-]."]
    kind: Annotated[Text, "undamped, proportionally damped, or complex."]
    total_mass: Annotated[Mass | None, "All masses [kg]."]
    modes: Annotated[tuple[Mode, ...], "The modes from the lowest."]
    numerics: Numerics | None = None
    checks: tuple[Check, ...] = ()
    advice: tuple[Advice, ...] = ()


def modes(
    *,
    system: Annotated[Line | Bodies | Matrices | MatrixFiles, "The system."],
    damping_ratio: Annotated[DampingRatio | None, "Damping ratio of every mode, instead of dampers, e.g. 0.02."] = None,
    scale: Annotated[Scale, "Shapes scaled to their largest part, their first part, or unit modal mass."] = LARGEST,
) -> Modes:
    """Natural frequencies and shapes of masses on springs, or of given matrices, with damping.

    Equation
    --------
    (K − ω²M)φ = 0; ω are the singular values of √k·A·m^{−½}, A the incidence of the springs; with dampers that couple
    modes: (λ²M + λC + K)ψ = 0, ζ = −Re λ/|λ|.

    Returns
    -------
    Modes
        Frequencies, damping, shapes, modal and effective masses; rigid modes exactly.

    Raises
    ------
    InadmissibleError
        When a mass matrix is singular, a stiffness matrix has a negative eigenvalue (divergence), damping is negative,
        or counts of masses and springs do not go together.

    References
    ----------
    Josephs & Huston, Dynamics of Mechanical Systems, CRC Press 2002, sections 13.7 and 13.8; Drmač & Veselić, SIAM J.
    Matrix Anal. Appl. 29 (2008) 1322 (one-sided Jacobi).

    Examples
    --------
    >>> made = modes(system=Line((1.0, 1.0), (1.0, 1.0)))
    >>> [round(one.angular_frequency, 9) for one in made.modes]
    [0.618033989, 1.618033989]
    """
    those = System(system)
    if damping_ratio is not None:
        require_damping(damping_ratio, DampingRatio)
    mass, stiffness, damping = those.matrices()
    if damping is not None:
        require(damping_ratio is None, "dampers and a damping ratio of all modes are both given", code="both",
                hint="leave out --damping-ratio, or the dampers")  # fmt: skip
        from dynamics_cli.vibration.systems.matrices import proportional

        if not proportional(mass, damping, stiffness):
            return _complex(those, mass, damping, stiffness, scale)
    omega, shapes, errors, numerics = undamped(those)
    rows = []
    whole = None if those.elements is None else math.fsum(those.elements.masses)
    for nth, (value, shape) in enumerate(zip(omega, shapes, strict=True)):
        zeta = damping_ratio
        if damping is not None and value:
            column = _array(shape)
            zeta = float(column @ damping @ column) / (2.0 * value)
        rows.append(_mode(those, nth, value, shape, zeta, scale, whole, errors[nth]))
    zetas = damping is not None or damping_ratio is not None
    return Modes(
        coordinates=", ".join(those.names),
        rigid_modes=None if those.elements is None else sum(value == 0.0 for value in omega),
        kind="proportionally damped" if zetas else "undamped",
        total_mass=whole,
        modes=tuple(rows),
        numerics=numerics,
        checks=_checks(those, mass, omega, shapes, rows, whole),
        advice=(*those.advice, *_advice(omega, errors)),
    )


def _array(shape: "Sequence[float]") -> "Any":
    import numpy as np

    return np.array(shape)


def undamped(those: System) -> "tuple[list[float], list[list[float]], list[float], Numerics]":
    """Angular frequencies, shapes of unit modal mass, relative errors, and how they are known."""
    if those.elements is not None:
        omega, shapes = those.elements.modes()
        width = those.elements.proved(omega)
        if width is None:
            method = "one-sided Jacobi on the factor of springs and masses; checked by element Rayleigh quotients"
            return omega, shapes, [0.0] * len(omega), Numerics(method)
        bounds = tuple(
            ErrorBound(f"modes[{nth}].{name}", width + ROUNDED)
            for nth, value in enumerate(omega) if value for name in ("frequency", "angular_frequency")
        )  # fmt: skip
        method = "one-sided Jacobi on the factor; every frequency proved by exact counts below and above it"
        return omega, shapes, [width] * len(omega), Numerics(method, bounds)
    from dynamics_cli.vibration.systems.matrices import symmetric_modes

    values, vectors, errors = symmetric_modes(those.mass, those.stiffness)
    bounds = tuple(
        ErrorBound(f"modes[{nth}].{name}", float(error))
        for nth, error in enumerate(errors) if error <= LOST for name in ("frequency", "angular_frequency")
    )  # fmt: skip
    text = "symmetric eigenvalues of the scaled matrices; bound 4nε‖K‖/ω², as the matrices were rounded"
    columns = [[float(x) for x in vectors[:, nth]] for nth in range(len(values))]
    return [float(x) for x in values], columns, [float(x) for x in errors], Numerics(text, bounds)


def scaled(shape: "Sequence[float]", scale: str) -> "list[float]":
    """A shape with its largest or first part one, or as it is (unit modal mass), its largest part positive."""
    largest = max(shape, key=abs)
    shape = [0.0 if abs(x) <= NOISE * abs(largest) else x for x in shape]
    if scale == "first" and abs(shape[0]) > 1e-12 * abs(largest):
        return [x / shape[0] for x in shape]
    if scale == "mass":
        return [x if largest > 0.0 else -x for x in shape]
    return [x / largest for x in shape]


def _mode(
    those: System, nth: int, value: float, shape: "list[float]", zeta: "float | None", scale: str,
    whole: "float | None", error: float,
) -> Mode:  # fmt: skip
    """A mode's row."""
    full = those.whole_shape(shape)
    drawn = scaled(full, scale)
    place = max(range(len(full)), key=lambda i: abs(full[i]))
    factor = drawn[place] / full[place]
    turn = None if whole is None else math.fsum(m * x for m, x in zip(those.elements.masses, shape, strict=True))  # type: ignore[union-attr]
    lost = error > LOST
    swings = zeta is not None and zeta < 1.0 and value > 0.0
    return Mode(
        number=nth + 1,
        frequency=None if lost else value / (2.0 * math.pi),
        angular_frequency=None if lost else value,
        damping_ratio=zeta if value else None,
        damped_frequency=value * math.sqrt((1.0 - zeta) * (1.0 + zeta)) / (2.0 * math.pi)  # type: ignore[operator]
        if swings and not lost else None,
        shape=tuple(drawn),
        phases=None,
        modal_mass=factor * factor,
        participation=None if turn is None else turn / factor,
        effective_share=None if turn is None or whole is None else turn * turn / whole,
    )  # fmt: skip


def _complex(those: System, mass: "Any", damping: "Any", stiffness: "Any", scale: str) -> Modes:
    """Modes that dampers couple."""
    from dynamics_cli.vibration.systems.matrices import complex_modes

    values, shapes, _, real = complex_modes(mass, damping, stiffness)
    rows = []
    for nth, value in enumerate(values):
        full = _whole_complex(those, shapes[:, nth])
        largest = max(full, key=abs)
        turned = [x / (full[0] if scale == "first" and abs(full[0]) > 1e-9 * abs(largest) else largest) for x in full]
        size = float(abs(value))
        rows.append(
            Mode(
                number=nth + 1, frequency=size / (2.0 * math.pi), angular_frequency=size,
                damping_ratio=-float(value.real) / size, damped_frequency=float(value.imag) / (2.0 * math.pi),
                shape=tuple(abs(x) for x in turned),
                phases=tuple(math.degrees(math.atan2(x.imag, x.real)) if abs(x) > 1e-12 else 0.0 for x in turned),
                modal_mass=None, participation=None, effective_share=None,
            )
        )  # fmt: skip
    notes = list(those.advice)
    if len(real):
        rates = ", ".join(
            f"{-x:.4g}" for x in sorted(real, reverse=True) if abs(x) > 1e-9 * abs(values).max(initial=0.0)
        )
        if rates:
            notes.append(Advice("overdamped", f"motions that do not swing decay at {rates} 1/s", severity="note"))
    rigid = None if those.elements is None else sum(not held for _, held in those.elements.groups())
    off = max((_residual(mass, damping, stiffness, v, shapes[:, i]) for i, v in enumerate(values)), default=0.0)
    return Modes(
        coordinates=", ".join(those.names), rigid_modes=rigid, kind="complex",
        total_mass=None if those.elements is None else math.fsum(those.elements.masses), modes=tuple(rows),
        numerics=Numerics("eigenvalues of the state matrix; the residual of each mode is checked"),
        checks=(Check("residual of each mode", off <= ORTHOGONAL, off, ORTHOGONAL),), advice=tuple(notes),
    )  # fmt: skip


def _whole_complex(those: System, shape: "Any") -> "list[complex]":
    real, imaginary = those.whole_shape(shape.real.tolist()), those.whole_shape(shape.imag.tolist())
    return [complex(a, b) for a, b in zip(real, imaginary, strict=True)]


def _residual(mass: "Any", damping: "Any", stiffness: "Any", value: complex, shape: "Any") -> float:
    """‖(λ²M + λC + K)ψ‖ over the sizes of its terms."""
    parts = (value * value * (mass @ shape), value * (damping @ shape), stiffness @ shape)
    return float(abs(parts[0] + parts[1] + parts[2]).max() / sum(abs(part).max() for part in parts))


def _checks(
    those: System, mass: "Any", omega: "list[float]", shapes: "list[list[float]]", rows: "list[Mode]",
    whole: "float | None",
) -> "tuple[Check, ...]":  # fmt: skip
    """Orthogonality; effective masses add up; a second computation of each frequency."""
    import numpy as np

    columns = np.array(shapes).T
    off = float(abs(columns.T @ mass @ columns - np.eye(len(omega))).max())
    made = [Check("shapes are orthogonal", off <= ORTHOGONAL, off, ORTHOGONAL)]
    if those.elements is not None:
        shares = abs(math.fsum(row.effective_share or 0.0 for row in rows) - 1.0)
        made.append(Check("effective masses add up to the whole", shares <= ORTHOGONAL, shares, ORTHOGONAL))
        worst = max(
            (abs(those.elements.rayleigh(s) / w - 1.0) for w, s in zip(omega, shapes, strict=True) if w), default=0.0
        )
        made.append(Check("element Rayleigh quotients", worst <= ORTHOGONAL, worst, ORTHOGONAL))
    return tuple(made)


def _advice(omega: "list[float]", errors: "list[float]") -> "tuple[Advice, ...]":
    notes = []
    for nth, error in enumerate(errors):
        if error > LOST:
            text = "mode {n} is lost in the rounding of the matrices: no digit of its frequency is known"
            remedy = "give masses and springs (--masses and --stiffnesses, or --body and --coupling)"
            place = f"modes[{nth}].frequency"
            notes.append(Advice("lost", worded(text, n=str(nth + 1)), "serious", remedy, result=place))
        elif error > 1e-6:
            text = "the frequency of mode {n} carries {digits} digits: the matrices hold no more"
            digits = str(max(int(-math.log10(error)), 1))
            notes.append(Advice("digits", worded(text, n=str(nth + 1), digits=digits)))
    for nth in range(len(omega) - 1):
        if omega[nth] and omega[nth + 1] - omega[nth] <= SAME * omega[nth + 1]:
            text = "modes {a} and {b} have one frequency: any combination of their shapes serves"
            notes.append(Advice("repeated", worded(text, a=str(nth + 1), b=str(nth + 2)), "note"))
    return tuple(notes)
