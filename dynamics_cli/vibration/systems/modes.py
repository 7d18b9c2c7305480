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
    MatrixOfNumbers,
    Ratio,
    Text,
)
from dynamics_cli.records import Advice, Check, Choice, ErrorBound, Numerics, record
from dynamics_cli.sampling import cost, drawing
from dynamics_cli.vibration.single.oscillator import require_damping
from dynamics_cli.vibration.systems.inputs import Bodies, Line, Matrices, MatrixFiles, System

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

# Frequencies nearer than this share are one: any combination of their shapes is a shape too.
SAME = 1e-9
# A frequency whose relative error may be larger is not given.
LOST = 0.01
ORTHOGONAL = 1e-9
# Parts of a shape below the first share of its largest are rounding; a first part below the second sets no scale.
NOISE, ABSENT = 1e-15, 1e-12
# Frequencies that stand by themselves; seconds of a sample of uncertain inputs, at least, and a pair of coordinates.
LISTED, ONCE, EACH = 3, 2e-4, 1e-6
# Matrices of more coordinates are not listed.
MOST_LISTED = 12


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

    first_frequency: Annotated[Frequency | None, "Lowest natural frequency above zero [Hz]."]
    second_frequency: Annotated[Frequency | None, "The next one [Hz]."]
    third_frequency: Annotated[Frequency | None, "The one after [Hz]."]
    first_damping_ratio: Annotated[DampingRatio | None, "Damping ratio of the first of them [-]."]
    coordinates: Annotated[Text, "The coordinates in the order of the shapes."]
    rigid_modes: Annotated[Count | None, "Modes of frequency zero, counted from the connections [-]."]
    kind: Annotated[Text, "undamped, proportionally damped, or complex."]
    total_mass: Annotated[Mass | None, "All masses [kg]."]
    modes: Annotated[tuple[Mode, ...], "The modes from the lowest."]
    mass_matrix: Annotated[MatrixOfNumbers | None, "Mass matrix, of twelve coordinates at most, in kg."]
    damping_matrix: Annotated[MatrixOfNumbers | None, "Damping matrix, in N·s/m."]
    stiffness_matrix: Annotated[MatrixOfNumbers | None, "Stiffness matrix, in N/m."]
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
    model = System(system)
    if damping_ratio is not None:
        require_damping(damping_ratio, DampingRatio)
    mass, stiffness, damping = model.matrices()
    if damping is not None:
        require(damping_ratio is None, "dampers and a damping ratio of all modes are both given", code="both",
                hint="leave out --damping-ratio, or the dampers")  # fmt: skip
        from dynamics_cli.vibration.systems.matrices import proportional

        if not proportional(mass, damping, stiffness):
            return _complex(model, mass, damping, stiffness, scale)
    omega, shapes, errors, numerics = undamped(model)
    if drawing():
        cost(0.0, ONCE + EACH * len(omega) ** 2, 1)
        few = int((omega == 0.0).sum()) + LISTED
        omega, shapes, errors = omega[:few], shapes[:few], errors[:few]
    zetas = None if damping_ratio is None else [damping_ratio] * len(omega)
    if damping is not None:
        zetas = (((shapes @ damping) * shapes).sum(axis=1) / (2.0 * (omega + (omega == 0.0)))).tolist()
    elif damping_ratio is not None:
        momenta = shapes @ mass
        damping = momenta.T * (2.0 * damping_ratio * omega) @ momenta
    total = None if model.elements is None else math.fsum(model.elements.masses)
    rows = _rows(model, (omega, shapes, errors), zetas, scale, total)
    return Modes(
        coordinates=", ".join(model.names),
        rigid_modes=None if model.elements is None else int((omega == 0.0).sum()),
        kind="undamped" if zetas is None else "proportionally damped",
        **_lowest(rows),
        total_mass=total,
        modes=rows,
        **_matrices(mass, damping, stiffness),
        numerics=numerics,
        checks=() if drawing() else _checks(model, mass, omega, shapes, rows),
        advice=(*model.advice, *_advice(omega.tolist(), errors.tolist())),
    )


def _lowest(rows: "Sequence[Mode]") -> "dict[str, Any]":
    """The lowest frequencies above zero by themselves, for limits, sweeps and uncertain inputs."""
    moving = [row for row in rows if row.frequency != 0.0]
    names = ("first_frequency", "second_frequency", "third_frequency")
    lowest: dict[str, Any] = dict(zip(names, [*(row.frequency for row in moving), None, None, None], strict=False))
    return lowest | {"first_damping_ratio": moving[0].damping_ratio if moving else None}


def _matrices(mass: "Any", damping: "Any", stiffness: "Any") -> "dict[str, Any]":
    """The matrices as rows of numbers, where they are small enough to be read."""
    matrices = {"mass_matrix": mass, "damping_matrix": damping, "stiffness_matrix": stiffness}
    listed = len(mass) <= MOST_LISTED
    return {name: tuple(map(tuple, rows.tolist())) if listed and rows is not None else None
            for name, rows in matrices.items()}  # fmt: skip


def undamped(model: System) -> "tuple[Any, Any, Any, Numerics]":
    """Angular frequencies, shapes of unit modal mass in rows, relative errors, and how they are known."""
    if model.elements is None:
        from dynamics_cli.vibration.systems.matrices import symmetric_modes

        omega, shapes, errors = symmetric_modes(model.mass, model.stiffness)
        method = "symmetric eigenvalues of the scaled matrices; bound 4nε‖K‖/ω², as the matrices were rounded"
        known = errors <= LOST
    else:
        omega, shapes, errors, method = model.elements.modes()
        known = (omega > 0.0) & (errors > 0.0)
    bounds = tuple(
        ErrorBound(f"modes[{nth}].{name}", error)
        for nth, (error, stated) in enumerate(zip(errors.tolist(), known.tolist(), strict=True)) if stated
        for name in ("frequency", "angular_frequency")
    )  # fmt: skip
    return omega, shapes, errors, Numerics(method, bounds)


def scaled(shapes: "Any", scale: str) -> "Any":
    """Shapes in rows with their largest or first part one, or as they are (unit modal mass), the largest positive."""
    import numpy as np

    largest = np.take_along_axis(shapes, abs(shapes).argmax(axis=1)[:, None], axis=1)
    shapes = np.where(abs(shapes) <= NOISE * abs(largest), 0.0, shapes)
    if scale == "mass":
        return shapes * np.where(largest > 0.0, 1.0, -1.0)
    if scale == "first":
        largest = np.where(abs(shapes[:, :1]) > ABSENT * abs(largest), shapes[:, :1], largest)
    return shapes / largest


def _rows(
    model: System, modes: "tuple[Any, Any, Any]", zetas: "list[float] | None", scale: str, total: "float | None"
) -> "tuple[Mode, ...]":
    """A row for each mode."""
    import numpy as np

    omega, shapes, errors = modes
    full = model.whole(shapes)
    drawn, each, place = scaled(full, scale), np.arange(len(full)), abs(full).argmax(axis=1)
    factors = (drawn[each, place] / full[each, place]).tolist()
    turns: Any = [None] * len(factors)
    if model.elements is not None:
        turns = model.elements.participations(omega, shapes).tolist()
    entries = []
    for nth, value, shape, factor, turn, error in zip(
        each.tolist(), omega.tolist(), drawn.tolist(), factors, turns, errors.tolist(), strict=True
    ):
        lost, zeta = error > LOST, zetas[nth] if zetas is not None and value else None
        hertz = value / (2.0 * math.pi)
        oscillates = zeta is not None and zeta < 1.0 and not lost
        entries.append(
            Mode(
                number=nth + 1,
                frequency=None if lost else hertz,
                angular_frequency=None if lost else value,
                damping_ratio=zeta,
                damped_frequency=hertz * math.sqrt((1.0 - zeta) * (1.0 + zeta)) if oscillates else None,  # type: ignore[operator]
                shape=tuple(shape),
                phases=None,
                modal_mass=factor * factor,
                participation=None if turn is None else turn / factor,
                effective_share=None if turn is None or total is None else turn * turn / total,
            )
        )
    return tuple(entries)


def _complex(model: System, mass: "Any", damping: "Any", stiffness: "Any", scale: str) -> Modes:
    """Complex modes, which dampers couple."""
    from dynamics_cli.vibration.systems.matrices import complex_modes

    values, shapes, real = complex_modes(mass, damping, stiffness)
    rows = []
    for nth, (value, full) in enumerate(zip(values.tolist(), model.whole(shapes).tolist(), strict=True), 1):
        largest = max(full, key=abs)
        turned = [x / (full[0] if scale == "first" and abs(full[0]) > 1e-9 * abs(largest) else largest) for x in full]
        size = abs(value)
        rows.append(
            Mode(
                number=nth, frequency=size / (2.0 * math.pi), angular_frequency=size,
                damping_ratio=-value.real / size, damped_frequency=value.imag / (2.0 * math.pi),
                shape=tuple(abs(x) for x in turned),
                phases=tuple(math.degrees(math.atan2(x.imag, x.real)) if abs(x) > ABSENT else 0.0 for x in turned),
                modal_mass=None, participation=None, effective_share=None,
            )
        )  # fmt: skip
    notes = list(model.advice)
    rates = [x for x in sorted(real.tolist(), reverse=True) if abs(x) > 1e-9 * abs(values).max(initial=0.0)]
    if rates:
        listed = ", ".join(f"{-x:.4g}" for x in rates)
        notes.append(Advice("overdamped", f"overdamped motions decay at {listed} 1/s", severity="note"))
    rigid = None if model.elements is None else sum(not held for _, held in model.elements.groups())
    off = max((_residual(mass, damping, stiffness, *pair) for pair in zip(values, shapes, strict=True)), default=0.0)
    return Modes(
        coordinates=", ".join(model.names), rigid_modes=rigid, kind="complex", **_lowest(rows),
        total_mass=None if model.elements is None else math.fsum(model.elements.masses), modes=tuple(rows),
        **_matrices(mass, damping, stiffness),
        numerics=Numerics("eigenvalues of the state matrix; the residual of each mode is checked"),
        checks=(Check("residual of each mode", off <= ORTHOGONAL, off, ORTHOGONAL),), advice=tuple(notes),
    )  # fmt: skip


def _residual(mass: "Any", damping: "Any", stiffness: "Any", value: complex, shape: "Any") -> float:
    """‖(λ²M + λC + K)ψ‖ over the sizes of its terms."""
    parts = (value * value * (mass @ shape), value * (damping @ shape), stiffness @ shape)
    return float(abs(parts[0] + parts[1] + parts[2]).max() / sum(abs(part).max() for part in parts))


def _checks(model: System, mass: "Any", omega: "Any", shapes: "Any", rows: "tuple[Mode, ...]") -> "tuple[Check, ...]":
    """Orthogonality; effective masses add up; a second computation of each frequency."""
    import numpy as np

    weighted = shapes @ mass if model.elements is None else shapes * np.diag(mass)
    product = weighted @ shapes.T
    product.flat[:: len(omega) + 1] -= 1.0
    off = float(max(product.max(), -product.min()))
    entries = [Check("shapes are orthogonal", off <= ORTHOGONAL, off, ORTHOGONAL)]
    if model.elements is not None:
        shares = abs(math.fsum(row.effective_share or 0.0 for row in rows) - 1.0)
        entries.append(Check("effective masses add up to the whole", shares <= ORTHOGONAL, shares, ORTHOGONAL))
        moving = omega > 0.0
        worst = float(abs(model.elements.rayleigh(shapes[moving]) / omega[moving] - 1.0).max(initial=0.0))
        entries.append(Check("element Rayleigh quotients", worst <= ORTHOGONAL, worst, ORTHOGONAL))
    return tuple(entries)


def _advice(omega: "list[float]", errors: "list[float]") -> "tuple[Advice, ...]":
    notes = []
    for nth, error in enumerate(errors):
        if error > LOST:
            text = "mode {n} is lost in the rounding of the matrices: no digit of its frequency is known"
            remedy = "give masses and springs (--masses and --stiffnesses, or --body and --coupling)"
            place = f"modes[{nth}].frequency"
            notes.append(Advice("lost", worded(text, n=str(nth + 1)), "serious", remedy, result=place))
        elif error > 1e-6:
            text = "the frequency of mode {n} has {digits} correct digits: the matrices hold no more"
            digits = str(max(int(-math.log10(error)), 1))
            notes.append(Advice("digits", worded(text, n=str(nth + 1), digits=digits)))
    for nth in range(len(omega) - 1):
        if omega[nth] and omega[nth + 1] - omega[nth] <= SAME * omega[nth + 1]:
            text = "modes {a} and {b} have the same frequency: any combination of their shapes is a shape too"
            notes.append(Advice("repeated", worded(text, a=str(nth + 1), b=str(nth + 2)), "note"))
    return tuple(notes)
