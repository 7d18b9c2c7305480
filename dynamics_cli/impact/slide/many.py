"""Slides of many cars side by side, for samples: forwards, and back from rest by Newton steps from one motion found.

Every car is one lane; what does not settle is solved alone.
"""

import numpy as np

from dynamics_cli.errors import DynamicsError
from dynamics_cli.impact.conventions import conventions
from dynamics_cli.impact.slide.back import COARSE, Root, Target, followed, gaps_of, newton, roots
from dynamics_cli.impact.slide.lanes import Lanes
from dynamics_cli.impact.slide.motion import Moment, Run
from dynamics_cli.impact.slide.records import AtRest, SlideResult
from dynamics_cli.impact.slide.task import car_of, moving, numbers_of, roots_of, shares_of, slide, target_of
from dynamics_cli.numerics.elementary import sqrt
from dynamics_cli.records import Numerics
from dynamics_cli.sampling import drawing, kept, missed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from numpy.typing import NDArray

    from dynamics_cli.impact.slide.wheels import Car, State

    Array = NDArray[Any]
    Given = dict[str, Any]

# Digits of the slides, and of large samples, whose spread drowns the rest: of these so many are solved in all digits,
# and may be off by so much of their deviation.
FINE = 1e-6
MANY, TRIED, DROWNED = 512, 64, 5e-3
# How far from the rest, in metres, the last step may begin and end.
CLOSE, SETTLED = 1e-4, 1e-4
# Fewer take longer side by side than one after another.
FEWEST = 5


class _Case:
    """A car, and its motion at the separation or its rest."""

    def __init__(self, parameters: "Given") -> None:
        self.given = given = {**(slide.__kwdefaults__ or {}), **parameters}
        self.car: Car = car_of(
            given["front_axle"], given["rear_axle"], given["track"], given["radius_of_gyration"], given["friction"],
            shares_of(given), given["grip_slope"], given["steer"], given["gravity"], given["grounds"], given["axes"],
        )  # fmt: skip
        self.pose = given["nose"], given["place"], given["axes"]
        self.back = isinstance(given["motion"], AtRest)
        self.state: Any = target_of(given["motion"], *self.pose) if self.back else moving(given["motion"], *self.pose)

    def lanes(self) -> Lanes:
        """Its lane."""
        state: Target | State = self.state
        return Lanes(self.car, state.begin if isinstance(state, Target) else (state.x, state.y), state.nose)

    def answer(self, unknowns: "list[float]", ended: "list[float]") -> SlideResult:
        """The numbers of its result."""
        (nose, place, axes), mass = self.pose, self.given["mass"]
        x, y, angle, time, path = ended
        start = Root((unknowns[0], unknowns[1], unknowns[2]), self.car, Run())
        found = roots_of([start] if self.back else [], axes)
        end = Moment(time, x, y, angle, (0.0, 0.0), 0.0, path, ())
        return SlideResult(
            **numbers_of(self.car, start, end, found, axes, place, nose, mass), turned_about=None, wheels=(), path=(),
            roots=(), conventions=conventions(axes, None), numerics=Numerics("lanes"),
        )  # fmt: skip


def slides(cases: "Sequence[Given]") -> "list[SlideResult | Exception]":
    """The numbers of each slide, or the error that refuses it."""
    if len(cases) < FEWEST:
        return [_alone(parameters) for parameters in cases]
    made: list[Any] = [None] * len(cases)
    posed: dict[int, _Case] = {}
    for row, parameters in enumerate(cases):
        try:
            posed[row] = _Case(parameters)
        except (DynamicsError, ArithmeticError) as error:
            made[row] = error
    for row, result in zip(posed, _side_by_side(list(posed.values())), strict=True):
        made[row] = result or _alone(cases[row])
    return made


def _alone(parameters: "Given") -> SlideResult | Exception:
    try:
        return slide(**parameters)
    except (DynamicsError, ArithmeticError) as error:
        return error


def _side_by_side(cases: "list[_Case]") -> "list[SlideResult | None]":
    """Results, and none of those that do not settle."""
    if not cases:
        return []
    lanes = Lanes.joined([case.lanes() for case in cases])
    if cases[0].back:
        found = _back(lanes, cases)
        if found is None:
            return [None] * len(cases)
        unknowns, wanted = found
        ends = lanes.ends(unknowns, FINE)
        settled = _lengths(np.array([*ends[:2], lanes.gyration * ends[2]]) - wanted) < SETTLED
    else:
        states = [case.state for case in cases]
        unknowns = np.array(
            [(one.vx, one.vy, case.car.gyration * one.spin) for one, case in zip(states, cases, strict=True)]
        ).T
        ends = _ends(lanes, unknowns)
        settled = np.array(np.isfinite(ends).all(axis=0))
    return [
        case.answer(motion, ended) if good else None
        for case, motion, ended, good in zip(cases, unknowns.T.tolist(), ends.T.tolist(), settled, strict=True)
    ]


def _ends(lanes: Lanes, unknowns: "Array") -> "Array":
    """Where slides end: of a large sample to fewer digits, as long as its spread drowns what they are off by."""
    count = unknowns.shape[1]
    if count >= MANY and drawing():
        ends = lanes.ends(unknowns, COARSE)
        some = np.arange(0, count, count // TRIED)
        apart = ends[:, some] - lanes.some(some).ends(unknowns[:, some], FINE)
        off = float((np.sqrt((apart * apart).mean(axis=1)) / ends.std(axis=1)).max())
        if off < DROWNED:
            missed(off)
            return ends
    return lanes.ends(unknowns, FINE)


def _back(lanes: Lanes, cases: "list[_Case]") -> "tuple[Array, Array] | None":
    """Motions that end at the rests, and these (3, n); none where no first one was found."""
    grips = np.array([sqrt(case.car.friction * case.car.gravity) for case in cases])
    # as friction grows, speeds grow by its root
    first = kept().get(slides)
    if first is None:
        first = _first(cases, grips)
    if first is None:
        return None
    kept()[slides] = first
    wanted = np.array([(*case.state.rest, case.car.gyration * case.state.rest_nose) for case in cases]).T
    at, _, slopes, _ = followed(lanes, wanted, first[:, None] * grips, _lengths, CLOSE, COARSE)
    at += newton(slopes, gaps_of(lanes, wanted, at, FINE))[0]
    return at, wanted


def _lengths(gaps: "Array") -> "Array":
    sizes: Array = np.sqrt((gaps * gaps).sum(axis=0))
    return np.where(np.isfinite(sizes), sizes, 1e9)


def _first(cases: "list[_Case]", grips: "Array") -> "Any":
    """A motion found alone, for a friction and gravity of one."""
    for case, grip in zip(cases, grips, strict=True):
        try:
            return np.array(roots(case.car, case.state)[0].unknowns) / grip
        except DynamicsError:
            continue
    return None
