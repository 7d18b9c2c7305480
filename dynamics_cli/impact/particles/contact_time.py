"""Duration and peak force of a central impact whose contact has a stiffness."""

from dynamics_cli.errors import require
from dynamics_cli.impact.particles.hunt_crossley import HuntCrossley, shape
from dynamics_cli.impact.particles.springs import HALF_PI, HERTZ_QUARTER, Hertz, Spring
from dynamics_cli.numerics.elementary import exp, log, sqrt
from dynamics_cli.quantities import Annotated, Force, Size, Time
from dynamics_cli.records import record


@record
class Push:
    """The course of the contact."""

    duration: Annotated[Time, "Time from touch to release [s]."]
    peak_force: Annotated[Force, "Greatest force [N]."]
    mean_force: Annotated[Force, "Impulse over duration [N]."]
    compression: Annotated[Size, "Greatest approach of the bodies after touching [m]."]


def push(
    force: Spring | Hertz | HuntCrossley | None, reduced: float, closing: float, restitution: float
) -> Push | None:
    """Duration and forces of a spring, F = kδ, or of Hertz's law, F = ⁴⁄₃ E*√R δ^1.5, that unloads to e² of the work.

    Unloading falls from the peak by the same power of a deflection e² as large, which takes e times as long. Hunt and
    Crossley's loss acts throughout: F = k δ^1.5 (1 + c δ̇), with c chosen to give the restitution.
    """
    if force is None:
        return None
    if isinstance(force, Spring):
        stiffness = force.contact_stiffness
        require(stiffness > 0.0, "the stiffness of the contact must be above zero", code="no-stiffness")
        pace = sqrt(reduced / stiffness)
        depth, peak, quarter = closing * pace, closing * sqrt(reduced * stiffness), HALF_PI
    else:
        stiffness = (4.0 / 3.0) * force.contact_modulus * sqrt(force.contact_radius)
        require(stiffness > 0.0, "modulus and radius of the contact must be above zero", code="no-stiffness")
        if isinstance(force, HuntCrossley):
            return _lossy(force, stiffness, reduced, closing, restitution)
        work = 1.25 * reduced * closing * closing
        require(work > 1e-290, "the impact is too weak to be calculated in doubles", code="range")
        depth, quarter = exp(0.4 * log(work / stiffness)), HERTZ_QUARTER
        peak, pace = work / depth, depth / closing
    duration = (1.0 + restitution) * quarter * pace
    return Push(duration, peak, (1.0 + restitution) * reduced * closing / duration, depth)


def _lossy(force: HuntCrossley, stiffness: float, reduced: float, closing: float, restitution: float) -> Push:
    require(force.hunt_crossley, "--hunt-crossley is given or left out", code="flag")
    time, peak, depth = shape(restitution)
    work = reduced * closing * closing
    unit = exp(0.4 * log(work / stiffness))
    duration = time * (unit / closing)
    return Push(duration, peak * (work / unit), (1.0 + restitution) * reduced * closing / duration, depth * unit)
