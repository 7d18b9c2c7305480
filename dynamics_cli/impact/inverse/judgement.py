"""Reliability of approach speeds from exit motion: verdicts, implied contact, contradictions."""

from dynamics_cli.errors import judge, require, worded
from dynamics_cli.impact.inverse.fit import Fit, Side
from dynamics_cli.numerics.distributions.normal import upper
from dynamics_cli.numerics.elementary import exp, sqrt
from dynamics_cli.quantities import Energy, Fraction, Ratio, RoadSpeed
from dynamics_cli.records import Advice

Pair = tuple[float, float]
GOOD, CAUTION, UNDETERMINED = "good", "caution", "not determined"
# Limits of a speed's relative standard deviation.
GOOD_SHARE, CAUTION_SHARE = 0.05, 0.15
UNLIKELY, CONTRADICTION, PRACTICALLY_NEVER = 0.05, 0.001, 1e-6
# Sine of the angle between the levers.
GOOD_SINE, SMALLEST_SINE = 0.5, 0.1
# Cotangent of half the angle between the approach paths, as for momentum.
GOOD_ANGLE, LARGEST_ANGLE = 4.0, 12.0
HIGHEST_RESTITUTION = 0.4
DEGREE = 0.017453292519943295
GOOD_TOLERANCE, HALF_TURN = 3.0 * DEGREE, 180.0 * DEGREE
ROOT_PI = 1.7724538509055161
SMALL_SHARE = 0.05


class Contact:
    """Restitution, ratio of impulses and energy lost that a fit implies."""

    def __init__(self, fit: Fit, sides: "tuple[Side, Side]", normal: Pair | None) -> None:
        self.restitution: float | None = None
        self.ratio: float | None = None
        self.energy_lost: float | None = None
        self.restitution_sigma: float | None = None
        self.ratio_sigma: float | None = None
        if sides[0].spins is None or sides[1].spins is None:
            return
        before = [float(fit.state[axis] - fit.state[2 + axis]) for axis in (0, 1)]
        gain = [[1.0 / sides[0].mass + 1.0 / sides[1].mass, 0.0], [0.0, 1.0 / sides[0].mass + 1.0 / sides[1].mass]]
        for side in sides:
            inertia, (x, y), spin, _ = side.spins  # type: ignore[misc]
            before[0] -= side.sense * spin * y
            before[1] += side.sense * spin * x
            for row, a in enumerate((-y, x)):
                for column, b in enumerate((-y, x)):
                    gain[row][column] += a * b / inertia
        p = [float(number) for number in fit.state[4:]]
        after = [before[row] + gain[row][0] * p[0] + gain[row][1] * p[1] for row in (0, 1)]
        lost = -0.5 * sum(p[axis] * (before[axis] + after[axis]) for axis in (0, 1))
        self.energy_lost = lost
        require(
            lost >= 0.0,
            "no approach motion gives these exits: the impact would have given {energy:3} to the vehicles",
            energy=(-lost, Energy),
            code="energy-gained",
            hint="check the signs of spins and levers, and the headings",
        )
        if normal is not None:
            self._along(fit, normal, before, after, gain, p)

    def _along(
        self,
        fit: Fit,
        normal: Pair,
        before: "list[float]",
        after: "list[float]",
        gain: "list[list[float]]",
        p: "list[float]",
    ) -> None:
        """Parts along the normal, from the second to the first, and across it."""
        across = -normal[1], normal[0]
        approach = before[0] * normal[0] + before[1] * normal[1]
        parting = after[0] * normal[0] + after[1] * normal[1]
        push, drag = p[0] * normal[0] + p[1] * normal[1], p[0] * across[0] + p[1] * across[1]
        require(
            push > 0.0 and approach < 0.0,
            "the impulse would pull along this normal: its component from the second to the first is {share:3} of it",
            share=(push / (push * push + drag * drag) ** 0.5 if push or drag else 0.0, Ratio),
            code="pull",
            hint="the normal points from the first vehicle to the second",
        )
        bounce, ratio = -parting / approach, drag / push
        self.restitution, self.ratio = bounce, ratio
        along = [gain[0][k] * normal[0] + gain[1][k] * normal[1] for k in (0, 1)]
        closing = [normal[0], normal[1], -normal[0], -normal[1], 0.0, 0.0]
        leaving = [*closing[:4], *along]
        slopes = [-(a + bounce * b) / approach for a, b in zip(leaving, closing, strict=True)]
        self.restitution_sigma = fit.sigma(slopes)
        turned = [(across[k] - ratio * normal[k]) / push for k in (0, 1)]
        self.ratio_sigma = fit.sigma([0.0, 0.0, 0.0, 0.0, *turned])

    def advice(self) -> "tuple[Advice, ...]":
        """Cautions about an implied contact that is unlike vehicles."""
        cautions: list[Advice] = []
        remedy = "check normal, contact point, spins and headings: the contact is elsewhere, or a measurement is wrong"
        if self.restitution is not None and not 0.0 <= self.restitution <= HIGHEST_RESTITUTION:
            word = "below 0" if self.restitution < 0.0 else "above 0.4"
            text = worded(
                "not this contact: the implied restitution is {e:3}, {word}", e=(self.restitution, Ratio), word=word
            )
            cautions.append(Advice(code="odd-restitution", message=text, severity="serious", remedy=remedy))
        if self.ratio is not None and abs(self.ratio) > 1.0:
            text = worded(
                "not this contact: the implied tangential impulse is {ratio:3} of the normal one",
                ratio=(self.ratio, Ratio),
            )
            cautions.append(Advice(code="odd-friction", message=text, severity="serious", remedy=remedy))
        return tuple(cautions)


def chance(chi_squared: float, freedom: int) -> float | None:
    """Probability of a sum of squares as large or larger, by its recurrence from one or two degrees of freedom."""
    if freedom <= 0:
        return None
    half = 0.5 * chi_squared
    freedom_so_far = 2 - freedom % 2
    total = 2.0 * upper(sqrt(chi_squared)) if freedom_so_far == 1 else exp(-half)
    # half^(ν/2) e^(-half)/Γ(ν/2 + 1)
    term = 2.0 * sqrt(half) * exp(-half) / ROOT_PI if freedom_so_far == 1 else half * exp(-half)
    while freedom_so_far < freedom:
        total += term
        freedom_so_far += 2
        term *= half / (0.5 * freedom_so_far)
    return total


def least_certain(fit: Fit, names: "tuple[str, str]") -> "tuple[str, float] | None":
    """The least certain combination of both speeds, in words, and its standard deviation."""
    import numpy as np

    directions = []
    for index in (0, 1):
        speed = fit.speed(index)
        if speed == 0.0:
            return None
        row = np.zeros(6)
        row[2 * index : 2 * index + 2] = fit.state[2 * index : 2 * index + 2] / speed
        directions.append(row)
    rows = np.array(directions)
    values, vectors = np.linalg.eigh(rows @ fit.covariance @ rows.T)
    x, y = (float(part) for part in vectors[:, 1])
    main, other = (0, 1) if abs(x) >= abs(y) else (1, 0)
    ratio = (y / x) if main == 0 else (x / y)
    sigma = float(max(values[1], 0.0) ** 0.5)
    if abs(ratio) < SMALL_SHARE:
        return f"{names[main]} faster, the other unchanged", sigma
    word = "faster" if ratio > 0.0 else "slower"
    return f"{names[main]} faster and {names[other]} {word} by {abs(ratio):.2f} of it", sigma


def agreement(probability: float | None, residuals: "list[tuple[str, float]]") -> "tuple[Advice, ...]":
    """A caution below 5 %, a refusal below 0.1 %, naming the measurement that fits worst."""
    if probability is None or probability >= UNLIKELY:
        return ()
    name, worst = residuals[0]
    judge(
        probability >= CONTRADICTION,
        "the measurements contradict each other: correct ones would disagree as much with a probability "
        "{below} {chance:2}; {name} is off by {worst:2} standard deviations",
        below="of" if probability >= PRACTICALLY_NEVER else "below",
        chance=(max(probability, PRACTICALLY_NEVER), Fraction),
        name=name,
        worst=(abs(worst), Ratio),
        code="contradiction",
        hint="check that measurement first, or state larger standard deviations",
        results=("first.approach_speed", "second.approach_speed"),
    )
    text = worded(
        "the measurements contradict each other: correct ones would disagree as much with a probability of {chance:2}",
        chance=(probability, Fraction),
    )
    return (Advice(code="contradiction", message=text, remedy=f"check the {name} first (see residuals)"),)


def share_verdict(speed: float, sigma: float | None) -> str | None:
    """The verdict of a speed by its standard deviation."""
    if sigma is None:
        return None
    if sigma > CAUTION_SHARE * speed:
        return UNDETERMINED
    return GOOD if sigma <= GOOD_SHARE * speed else CAUTION


def unreliable(sides: "tuple[tuple[str, str | None, float, float | None], ...]") -> "tuple[Advice, ...]":
    """Advice for each speed that is not good."""
    cautions: list[Advice] = []
    for name, verdict, speed, sigma in sides:
        if sigma is not None and verdict in (CAUTION, UNDETERMINED):
            severe = verdict == UNDETERMINED
            text = worded(
                (
                    "these measurements do not determine the speed of {name}"
                    if severe
                    else "the speed of {name} is rough"
                )
                + ": {speed:3} with a standard deviation of {sigma:2}",
                name=name,
                speed=(speed, RoadSpeed),
                sigma=(sigma, RoadSpeed),
            )
            remedy = "a spin, a recorder or the energy of deformation of the other vehicle determines it better"
            code = "undetermined-speed" if severe else "rough-speed"
            cautions.append(Advice(code=code, message=text, severity="serious" if severe else "caution", remedy=remedy))
    return tuple(cautions)


def judge_crossing(a: Pair, b: Pair) -> str:
    """The verdict of momentum alone by the angle between the approach paths; refused close to one line."""
    sine, cosine = a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]
    require(sine != 0.0, "the approach paths are on one line: momentum alone gives no speeds", code="undetermined")
    condition = (1.0 + abs(cosine)) / abs(sine)
    judge(
        condition <= LARGEST_ANGLE,
        "the approach paths are too close to one line for momentum alone: angle condition {kappa:3}, above 12",
        kappa=(condition, Ratio),
        hint="give exit spins with spins before, inertias, levers and standard deviations: they decide with momentum",
        results=("first.approach_speed", "second.approach_speed"),
    )
    return GOOD if condition <= GOOD_ANGLE else CAUTION


def by_heading(fit: Fit, sides: "tuple[Side, Side]", index: int) -> "tuple[str, float, str, float]":
    """By momentum alone, of one vehicle's speed: verdict, tolerance of the worst heading, its name, m/s a degree."""
    side, other = sides[index], sides[1 - index]
    assert side.way is not None
    assert other.way is not None
    names = ("first", "second")[index], ("second", "first")[index]
    (x, y), (a, b) = side.way, other.way
    sine, cosine = abs(x * b - y * a), x * a + y * b
    ratio = other.mass / side.mass
    speeds = fit.speed(index), fit.speed(1 - index)
    slopes = [
        (abs(speeds[0] * cosine), f"{names[0]}.approach_heading"),
        (ratio * speeds[1], f"{names[1]}.approach_heading"),
        (abs(a * side.velocity[0] + b * side.velocity[1]), f"{names[0]}.exit_heading"),
        (ratio * abs(a * other.velocity[0] + b * other.velocity[1]), f"{names[1]}.exit_heading"),
    ]
    steepest, worst = max(slopes)
    tolerance = min(0.1 * speeds[0] * sine / steepest, HALF_TURN) if steepest > 0.0 else HALF_TURN
    verdict = GOOD if tolerance >= GOOD_TOLERANCE else CAUTION if tolerance >= DEGREE else UNDETERMINED
    return verdict, tolerance, worst, DEGREE * steepest / sine


def judge_levers(a: Pair, b: Pair) -> "tuple[float, str]":
    """Sine between the levers and its verdict; refused where the contact is on the line of centres."""
    size = sqrt((a[0] * a[0] + a[1] * a[1]) * (b[0] * b[0] + b[1] * b[1]))
    require(size > 0.0, "a lever is zero: its spin says nothing about the impulse", code="no-lever")
    sine = abs(a[0] * b[1] - a[1] * b[0]) / size
    judge(
        sine >= SMALLEST_SINE,
        "the contact is almost on the line of the mass centres: the sine between the levers is {sine:3}, below 0.1, "
        "and spins do not give the impulse along that line",
        sine=(sine, Ratio),
        hint="give the approach headings",
        results=("first.approach_speed", "second.approach_speed"),
    )
    return sine, GOOD if sine >= GOOD_SINE else CAUTION
