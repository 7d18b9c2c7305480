"""Cases of stability_roots.json: polynomials by factors, loops, delays and matrices, and why they are hard."""

# A polynomial by its coefficients from the highest power down, and how often it is a factor.
Factor = tuple[str, int]
Rows = list[list[str]]

PIECES = ("1, 0, 1", "1, 0, 3", "1, 1", "1, -2", "1, 2, 5", "1, -1, 4", "1, 0", "2, 3", "1, 0, 0, 0, 4", "1, 0.3, 7")
POLYNOMIALS: list[tuple[str, list[Factor], str]] = [
    ("zero pivot", [("1, 0, 1", 1), ("1, 1, 2, 2, 1", 1)], "a zero pivot beside roots ±i: what ε gives hangs on ε"),
    (
        "row of zeros",
        [("1, 0, 1", 1), ("1, 0, 2", 1), ("1, 1, 9, 19, 10", 1)],
        "Routh's array has a row of zeros",
    ),
    ("two pairs beside the axis", [("1, 3, 10, 24, 48, 96, 128, 192, 128", 1)], "Routh's array has a row of zeros"),
    ("three on each side", [("1, 1, -6, 0, 1, 1, -6", 1)], "Routh's array has a row of zeros"),
    ("two pairs on the axis", [("1, 7, 6, 42, 8, 56", 1)], "Routh's array has a row of zeros"),
    ("zero first column", [("1, 0, 2, 3", 1)], "the second row of Routh's array begins with zero"),
    ("square", [("1, 0, 0, 0, 4", 1)], "roots at ±1 ± i: an even polynomial, all rows but one vanish"),
    ("repeated on the axis", [("1, 0, 1", 2), ("1, 1", 1)], "a double pair on the axis, which splits when rounded"),
    ("triple at zero", [("1, 0", 3), ("1, 2, 5", 1)], "three roots at zero, which rounding throws to either side"),
    ("Wilkinson's twelve", [(f"1, {k}", 1) for k in range(1, 13)], "coefficients say little about the roots"),
    ("Wilkinson's twenty", [(f"1, {k}", 1) for k in range(1, 21)], "the last bit of a coefficient moves roots by ones"),
    ("eight times −1", [("1, 1", 8)], "a cluster: doubles spread it over a hundredth"),
    ("five times lightly damped", [("1, 0.02, 1", 5)], "a cluster beside the axis, which doubles spread across it"),
    ("four times and a stiff one", [("1, 0.001, 4", 4), ("1, 1000000", 1)], "a cluster beside the axis and a far root"),
    (
        "hardly damped",
        [("1, 0.000000000000001, 1", 1), ("1, 1", 1), ("1, 2", 1)],
        "a real part that is only 5e-16",
    ),
    ("hardly growing", [("1, -0.000000000001, 4", 1), ("1, 3", 3)], "a pair with a real part of 5e-13 on the right"),
    (
        "eighteen decades",
        [("1, 0.000000001", 1), ("1, 1", 1), ("1, 1000000000", 1)],
        "rates from 1e-9 to 1e9 side by side",
    ),
    ("all but double", [("1, 1", 1), ("1, 1.00000001", 1), ("1, 5", 1)], "two roots that are only 1e-8 apart"),
]


CIRCLES: list[tuple[str, list[Factor], str]] = [
    ("on the circle", [("1, -1.2, 1", 1), ("1, -0.5", 1)], "a pair on the circle, whose size is one exactly"),
    (
        "twice on the circle",
        [("1, -1.2, 1", 2), ("1, 0.3", 1)],
        "a double pair on the circle, which splits",
    ),
    ("at −1", [("1, 1", 1), ("1, -0.25", 2)], "z = −1 goes to infinity in the plane of s"),
    ("hardly inside", [("1, -1.6, 0.999999999999", 1), ("1, 0.5", 1)], "a pair whose size is 5e-13 below one"),
    ("hardly outside", [("1, -1.6, 1.0000000000001", 1), ("1, 0.5", 2)], "a pair whose size is 5e-14 above one"),
    ("six times inside", [("1, -0.99", 6)], "a cluster inside the circle, which doubles spread across it"),
    ("slow poles", [("1, -0.9999", 1), ("1, -0.9998", 1), ("1, -0.9997", 1)], "fast sampling puts all poles near one"),
]


GAINS: list[tuple[str, str, list[Factor], list[Factor], str]] = [
    ("three poles", "s(s+1)(s+2) + K", [("1, 3, 2, 0", 1)], [("1", 1)], ""),
    (
        "conditionally stable", "s(s+4)(s+6)(s^2+1.4s+1) + K(s^2+2s+4)",
        [("1, 0", 1), ("1, 4", 1), ("1, 6", 1), ("1, 1.4, 1", 1)], [("1, 2, 4", 1)], "",
    ),
    (
        "a servo", "s(s+1000)(s+20000) + 1000000000K", [("1, 0", 1), ("1, 1000", 1), ("1, 20000", 1)],
        [("1000000000", 1)], "",
    ),
    ("PI", "s^2(s+5)(s+12) + K(s+2)", [("1, 0", 2), ("1, 5", 1), ("1, 12", 1)], [("1, 2", 1)], ""),
    ("with zeros", "(s-1)(s+3)(s+4) + K(s^2+2s+3)", [("1, -1", 1), ("1, 3", 1), ("1, 4", 1)], [("1, 2, 3", 1)], ""),
    (
        "a window of 1e-9", "s^3 + s^2 + 0.000000001s + K - 1", [("1, 1, 0.000000001, -1", 1)], [("1", 1)],
        "stable from 1 to 1.000000001 only: a sweep steps over it",
    ),
    (
        "close to 6", "s(s+1)(s+2.000000001) + K", [("1, 0", 1), ("1, 1", 1), ("1, 2.000000001", 1)], [("1", 1)],
        "the gain differs from a round number in the tenth digit",
    ),
    (
        "a flexible mode", "s(s+2)(s^2+0.0002s+100) + 30K", [("1, 0", 1), ("1, 2", 1), ("1, 0.0002, 100", 1)],
        [("30", 1)], "a mode with hardly any damping: the limit is a small difference",
    ),
    (
        "five equal poles", "(s+1)^5 + K", [("1, 1", 5)], [("1", 1)],
        "roots start from a cluster, and cross by a steep angle",
    ),
]  # fmt: skip


DELAYS = [
    ("a spring behind time", "1, 0.4, 1", "0.5", ""), ("an integrator", "1, 0", "2", ""),
    ("two lags and an integrator", "1, 3, 2, 0", "1", ""), ("a damper behind time", "1, 0.1, 4", "0.5, 0", ""),
    ("chatter", "1, 0.2, 1.3", "0.9, 0.1", ""),
    ("hardly damped", "1, 0.000001, 1", "0.5", "the delay that is stood is 2e-6 s, a small angle over a frequency"),
    ("all but undamped", "1, 0.000000000001, 1", "0.5", "the delay that is stood is 2e-12 s, a smaller angle still"),
    ("all but touching", "1, 0.4, 1", "0.391918359", "|p| and |q| all but touch: two crossings close together"),
]  # fmt: skip


def as_rows(text: str) -> Rows:
    return [[cell.strip() for cell in row.split(",")] for row in text.split(";")]


def frank(size: int) -> Rows:
    return [
        [repr(float(-(size - max(i, j)) if j >= i - 1 else 0)) for j in range(size)] for i in range(size)
    ]  # fmt: skip


GYROSCOPIC = {"mass": "1, 0; 0, 1", "stiffness": "-1, 0; 0, -2"}
MATRICES: list[tuple[str, dict[str, Rows], str]] = [
    ("an oscillator", {"matrix": as_rows("0, 1; -4, -0.2")}, ""),
    ("Frank's matrix", {"matrix": frank(6)}, "eigenvalues far worse conditioned than those of a symmetric matrix"),
    ("all but defective", {"matrix": as_rows("-1, 1; -1e-14, -1")}, "a pair 1e-7 from where two roots meet"),
    (
        "three that meet", {"matrix": as_rows("-0.001, 1, 0; 0, -0.001, 1; 1e-12, 0, -0.001")},
        "a Jordan block of three, turned by 1e-12: roots 1e-4 from their middle",
    ),
    (
        "five that meet", {"matrix": as_rows(
            "-0.01, 1, 0, 0, 0; 0, -0.01, 1, 0, 0; 0, 0, -0.01, 1, 0; 0, 0, 0, -0.01, 1; -1e-16, 0, 0, 0, -0.01")},
        "a Jordan block of five: 1e-16 in one corner moves roots by 6e-4",
    ),
    ("far from normal", {"matrix": as_rows("-1, 1e6, 1e6; 0, -2, 1e6; 1e-14, 0, -3")}, "elements beside the diagonal "
     "of a million: rounding is as large as what it holds"),
    ("stiff", {"matrix": as_rows("0, 1, 0; -1e12, -1e6, 1; 1e-6, 0, -1e-6")}, "rates from 1e-6 to 1e6 in one matrix"),
    ("gyroscopic, below", {**{k: as_rows(v) for k, v in GYROSCOPIC.items()},
              "gyroscopic": as_rows("0, -2.4142135623; 2.4142135623, 0")}, "7e-11 below the place where flutter ends"),
    ("gyroscopic, above", {**{k: as_rows(v) for k, v in GYROSCOPIC.items()},
              "gyroscopic": as_rows("0, -2.4142135624; 2.4142135624, 0")}, "3e-11 above the place where flutter ends"),
    ("damped in one place", {"mass": as_rows("1, 0; 0, 1"), "damping": as_rows("1e-9, 0; 0, 0"),
                             "stiffness": as_rows("2, -1; -1, 2")}, "decay of 2.5e-10 beside frequencies of 1 rad/s"),
]  # fmt: skip
