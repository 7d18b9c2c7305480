"""The cases of uncertainty.json: what is calculated from which inputs, why it is hard, and its law in mathematics."""

from collections.abc import Callable, Sequence

from uncertainty_laws import (
    Input,
    Law,
    Lognormal,
    Normal,
    Readings,
    Triangular,
    Truncated,
    Uniform,
    lognormal,
    rising,
    sum_of_uniforms,
)
from uncertainty_models import (
    apart,
    difference_of_normals,
    folded,
    identity,
    largest,
    largest_of_normals,
    positive_part,
    product_about_zero,
    product_of_two,
    product_of_uniforms,
    products,
    quotient,
    quotient_of_uniforms,
    radius,
    readings,
    rice,
    root_where_it_is,
    sine_of_half_turn,
    skid,
    skid_of_lognormals,
    skid_of_normals,
    smallest,
    square,
    square_of_readings,
    squares,
    sum_of_normals,
    sum_of_two,
)
from uncertainty_numbers import number, real

KINDS: dict[str, Callable[..., Input]] = {
    "normal": Normal, "uniform": Uniform, "triangular": Triangular, "lognormal": Lognormal, "truncated": Truncated,
    "readings": Readings,
}  # fmt: skip
Spelled = tuple[str, ...]


class Wanted:
    """A model on inputs, and the law of its result as a function of the inputs in multiple precision."""

    def __init__(
        self, name: str, why: str, model: str, inputs: Sequence[Spelled], law: Callable[..., Law],
        correlation: Sequence[tuple[int, int, str]] = (),
    ) -> None:  # fmt: skip
        self.name = name
        self.why = why
        self.model = model
        self.inputs = [list(one) for one in inputs]
        self.correlation = [list(one) for one in correlation]
        self._law = law

    def law(self) -> Law:
        """The law, at the precision that is set."""
        made = [KINDS[kind](*rest) for kind, *rest in self.inputs]
        return self._law(*made, *(number(float(rho)) for _, _, rho in self.correlation))


def _alike(count: int, *spelled: str) -> list[Spelled]:
    return [spelled] * count


def _pairs(count: int, rho: str) -> list[tuple[int, int, str]]:
    """Every pair alike; the law is told once."""
    return [(i, j, rho) for j in range(count) for i in range(j)]


N, U, T, L, TR, R = "normal", "uniform", "triangular", "lognormal", "truncated", "readings"
N01, U01 = (N, "0", "1"), (U, "0", "1")
_SKID = [
    ("an ordinary skid", "", ("0.7", "0.05", "18", "0.5")),
    (
        "friction known badly",
        "friction nine deviations from none: the root's bend gives a skew that a straight line misses",
        ("0.45", "0.05", "30", "1"),
    ),
    (
        "one input decides",
        "the length hardly matters: the gradient lies along one axis, and the other must not cost points",
        ("0.6", "0.05", "25", "0.001"),
    ),
    (
        "both matter alike",
        "both matter alike: the gradient lies between the axes, and neither is the right one to integrate along",
        ("0.5", "0.05", "10", "1"),
    ),
]
_MORE = [
    Wanted(
        f"{name} by {rho}", why, "skid", [(N, *values[:2]), (N, *values[2:])],
        lambda mu, d, rho: skid_of_normals(mu, d, rho), [(0, 1, rho)],
    )
    for name, rho, why, values in (
        ("friction and length correlated", "0.9",
            "correlated by 0.9: scores are sheared, and the deviation is a "
            "third more than that of independent inputs", ("0.7", "0.05", "18", "1")),
        ("friction and length correlated", "-0.9",
            "correlated by −0.9: what one adds the other takes "
            "away, two thirds of the deviation cancel", ("0.7", "0.05", "18", "1")),
    )
]  # fmt: skip

CASES: list[Wanted] = [
    *(
        Wanted(name, why, "skid", [(N, *values[:2]), (N, *values[2:])], skid_of_normals)
        for name, why, values in _SKID
    ),
    Wanted("lognormal inputs", "", "skid", [(L, "0.7", "0.05"), (L, "18", "0.5")], skid_of_lognormals),
    Wanted("wide lognormal inputs",
        "deviations of half the mean: the quantiles lie at half and at twice the median", "skid",
           [(L, "0.5", "0.25"), (L, "20", "10")], skid_of_lognormals),
    *_MORE,
    Wanted("nearly one input",
        "correlated by 0.999999: the matrix is next to singular, its "
        "factor's last row a small difference", "skid", [(L, "0.7", "0.1"), (L, "18", "3")],
           lambda mu, d, rho: skid_of_lognormals(mu, d, rho), [(0, 1, "0.999999")]),
    Wanted("nearly no variation", "correlated by −0.9999: what one adds the other takes away", "skid",
           [(L, "0.7", "0.07"), (L, "18", "1.8")], lambda mu, d, rho: skid_of_lognormals(mu, d, rho),
           [(0, 1, "-0.9999")]),
    Wanted("friction and length anywhere between bounds",
        "two bounds each: the distribution has corners where one input leaves its interval", "skid",
           [(U, "0.6", "0.8"), (U, "15", "20")], skid),
    Wanted("friction uniform, length normal",
        "bounded in one input only: a flat-topped density with soft sides, kinked in scores", "skid",
           [(U, "0.4", "0.9"), (N, "20", "1")], skid),
    Wanted("friction cut off, length uniform",
        "one tail cut at a deviation, the other far away: the score of the cut end grows without bound", "skid",
           [(TR, "0.7", "0.1", "0.6", "1.1"), (U, "18", "19")], skid),
    Wanted("friction triangular, length lognormal",
        "a triangle's corner in the density: the second derivative jumps within the interval", "skid",
           [(T, "0.5", "0.7", "0.75"), (L, "20", "3")], skid),
    # one input: what its own transformation does
    Wanted("e to a normal number",
        "a wide lognormal tail: mean and deviation "
        "are 1.6 and 2.2 times the median", "exp", [N01], lambda x: rising(x, real.exp)),
    Wanted("e to two deviations",
        "the mean lies at the 84th percentile, the deviation at the 97th: rare cases make both", "exp", [(N, "0", "2")],
           lambda x: lognormal(x.mean, x.std**2)),
    Wanted("lognormal three times as wide as its mean",
        "heavy tail: the deviation is ruled by cases about three deviations out in the logarithm", "same",
           [(L, "1", "3")], lambda x: rising(x, identity)),
    Wanted("reciprocal of a lognormal",
        "a falling function of a wide input: quantiles change "
        "places, and slopes at them differ six hundredfold", "reciprocal", [(L, "1", "1")],
           lambda x: rising(x, lambda v: 1 / v, sign=-1)),
    Wanted("square two deviations from zero",
        "two branches that meet two deviations from the centre: a "
        "fortieth of the inputs comes from the other", "square",
           [(N, "1", "0.5")], square),
    Wanted("square about zero",
        "the gradient is zero at the centre, so that a first-order deviation is zero", "square", [N01], square),
    Wanted("cube about zero", "a point of inflection at the centre: gradient and curvature are zero", "cube", [N01],
           lambda x: rising(x, lambda v: v**3)),
    Wanted("absolute value",
        "a kink a third of a deviation from the centre, where the density is greatest", "absolute", [(N, "0.3", "1")],
           lambda x: folded(x.mean, x.std)),
    Wanted("positive part",
        "an atom: three cases of ten are exactly zero, and "
        "the low quantile is within it", "positive", [(N, "0.5", "1")],
           positive_part),
    Wanted("positive part, rarely at zero", "an atom of one in forty at the very end of the interval", "positive",
           [(N, "1.95996398454", "1")], positive_part),
    Wanted("square root down to zero",
        "infinite slope at the bound: the density vanishes there, and a derivative does not exist", "root", [U01],
           lambda x: rising(x, real.sqrt)),
    Wanted("square root of what may be negative",
           "one case of 44 is inadmissible: quantiles are of the others, the lowest next to an infinite slope", "root",
           [(N, "1", "0.5")], root_where_it_is),
    Wanted("reciprocal near its pole", "the steep end is a thousandth of the interval from the pole", "reciprocal",
           [(U, "0.001", "1")], lambda x: rising(x, lambda v: 1 / v, sign=-1)),
    Wanted("sine over half a turn",
        "rises and falls: the greatest value lies inside, where the density has no bound", "sine",
           [(U, "0", "3.141592653589793")], sine_of_half_turn),
    Wanted("tangent near its poles",
        "slopes of one and of 200 in one interval: the "
        "deviation is made at its very ends", "tangent", [(U, "-1.5", "1.5")],
           lambda x: rising(x, real.tan)),
    Wanted("logarithm near zero",
        "the triangle's corner is next to the logarithm's pole: slopes from one to a thousand", "logarithm",
           [(T, "0.001", "0.002", "1")], lambda x: rising(x, real.log)),
    Wanted("nearly a step",
        "all of the rise within a thousandth of a deviation: "
        "between any points of a scan", "step", [(N, "0.0001", "1")],
           lambda x: rising(x, lambda v: real.atan(1000 * v), [number(-1) / 100, number(0), number(1) / 100])),
    Wanted("a tail alone",
        "normal beyond two deviations: nearly exponential, and the scores of its quantiles lie in a tail", "same",
           [(TR, "0", "1", "2", "5")], lambda x: rising(x, identity)),
    Wanted("a tail far out", "beyond seven deviations: probabilities of 1e-12 divided by one another", "same",
           [(TR, "0", "1", "7", "12")], lambda x: rising(x, identity)),
    Wanted("cut to next to uniform",
        "cut within half a deviation: nearly uniform, and the bounds are all that matters", "square",
           [(TR, "0.6", "1", "0.2", "0.8")], lambda x: rising(x, lambda v: v * v)),
    Wanted("five readings", "Student's t of four degrees of freedom: fourth moment infinite", "same",
           [(R, "9.7", "10.1", "10.4", "9.9", "10.2")], readings),
    Wanted("square of six readings about zero",
        "heavy tails of five degrees of freedom, folded at the centre: the fourth moment is barely finite", "square",
           [(R, "-1", "-0.5", "-0.25", "0.25", "0.5", "1")], square_of_readings),
    # two inputs
    Wanted("two uniform tolerances",
        "the sum's density is a triangle: corners where "
        "bounds meet, kinks in scores", "total", [U01, U01], sum_of_uniforms),
    Wanted("a wide and a narrow tolerance",
        "a trapezoid of sides a thousandth long: next to a jump at each end", "total",
           [U01, (U, "0", "0.001")], sum_of_uniforms),
    Wanted("product of uniforms",
        "the density is −ln w, without bound at zero, next to the low quantile", "product", [U01, U01],
           product_of_uniforms),
    Wanted("quotient of uniforms",
        "a density of three branches that meet with "
        "corners, one of them falling as 1/w²", "quotient", [(U, "1", "2"), (U, "0.5", "2")],
           quotient_of_uniforms),
    Wanted("a normal and a wide uniform",
        "steps of a uniform softened over a tenth of their width: narrow bends far from the centre", "total",
           [(N, "0", "0.1"), U01], sum_of_two),
    Wanted("a lognormal and a triangular", "three densities of different kinds, corners and a tail", "total",
           [(L, "1", "0.5"), (T, "0", "0.2", "2")], sum_of_two),
    Wanted("normal by lognormal",
        "a normal that comes within four deviations of zero, by a wide "
        "lognormal: neither logarithm nor line fits", "product", [(N, "2", "0.5"), (L, "1", "0.8")],
           product_of_two),
    Wanted("product about zero", "a saddle: gradient zero, density infinite at the median", "product", [N01, N01],
           product_about_zero),
    Wanted("quotient with a divisor cut off", "the divisor comes within a fifth of its mean to zero", "quotient",
           [(N, "1", "0.3"), (TR, "1", "0.5", "0.2", "3")], quotient),
    Wanted("difference of nearly the same", "correlated by 0.999999: all but a thousandth cancels", "difference",
           [(N, "5", "1"), (N, "4", "1")], difference_of_normals, [(0, 1, "0.999999")]),
    Wanted("distance of two numbers",
        "a kink a fifth of a deviation from the "
        "middle, across both axes", "apart", [(N, "0.2", "1"), (N, "0", "0.5")], apart),
    Wanted("larger of two alike",
        "a kink through the centre, along no axis: the "
        "gradient there does not exist", "largest", [N01, N01], largest),
    Wanted("larger of two correlated",
        "a kink along no axis of correlated scores, a "
        "third of a deviation off the centre", "largest", [N01, (N, "0.5", "2")],
           largest_of_normals, [(0, 1, "0.7")]),
    Wanted("smaller of two uniforms",
        "a kink that ends at bounds: the density jumps "
        "where the other's interval ends", "smallest", [U01, (U, "0.3", "0.9")], smallest),
    Wanted("length of a centred vector",
        "the gradient does not exist at the centre: the result is "
        "least there and rises in all directions", "radius", [N01, N01], radius),
    Wanted("length of a vector two deviations long",
        "level lines are circles about a point two deviations off: no line of integration follows them", "radius",
           [(N, "1", "0.5"), (N, "0", "0.5")], rice),
    # more inputs
    Wanted("four tolerances", "bounds in four inputs, smooth to the second derivative only", "total",
           _alike(4, *U01), sum_of_uniforms),
    Wanted("four tolerances, each half of the one before",
        "widths of a half, a quarter, an eighth: sixteen corners, none of which falls on another", "total",
           [U01, (U, "0", "0.5"), (U, "0", "0.25"), (U, "0", "0.125")], sum_of_uniforms),
    Wanted("eight tolerances",
        "256 corners of a piecewise polynomial of the eighth "
        "degree, whose terms cancel near the far end", "total", _alike(8, *U01), sum_of_uniforms),
    Wanted("length in space",
        "no gradient at the centre in three dimensions: the "
        "density vanishes there as the square", "radius", _alike(3, *N01), radius),
    Wanted("four squares",
        "the gradient is zero at the centre and the curvature the same "
        "in all four directions: none is the first", "squares", _alike(4, *N01), squares),
    Wanted("eight squares",
        "zero gradient and equal curvature in eight directions: a "
        "grid of points has as many dimensions", "squares", _alike(8, *N01), squares),
    Wanted("largest of four",
        "six kinks that meet at the centre of four dimensions, "
        "where the largest changes hands", "largest", _alike(4, *N01), largest),
    Wanted("largest of eight uniforms",
        "28 kinks, and the bound that all inputs share: the density "
        "rises as the seventh power and stops", "largest", _alike(8, *U01), largest),
    Wanted("product of six lognormals, correlated",
        "a correlation of a half in every pair: all "
        "fifteen of them widen the product", "product", _alike(6, L, "1", "0.4"),
           lambda *made: products(*made[:6], made[6]), _pairs(6, "0.5")),
    Wanted("product of ten uniforms",
        "five decades of range within the interval: the "
        "mean is fifteen times the median", "product", _alike(10, *U01), product_of_uniforms),
    Wanted("twenty inputs, correlated by 0.99",
        "correlated by 0.99 throughout: the matrix is next to singular in nineteen directions of twenty", "total",
           _alike(20, N, "1", "0.1"), lambda *made: sum_of_normals(*made[:20], made[20]), _pairs(20, "0.99")),
]  # fmt: skip
