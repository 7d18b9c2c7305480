"""Recursions of a tree of links, against numbers of 25 digits and against each other.

The branched tree and the universal joint: mass matrix by partial velocities and accelerations by elimination, in mpmath
at 50 digits. The rods in a row: absolute angles, solved in fractions.
"""

import random

import numpy as np
import pytest

from dynamics_cli.errors import InadmissibleError
from dynamics_cli.numerics.orientation.rotations import axis_angle
from dynamics_cli.numerics.trees.articulated import forward
from dynamics_cli.numerics.trees.matrix import mass_matrix, partial
from dynamics_cli.numerics.trees.newton_euler import inverse, sweep
from dynamics_cli.numerics.trees.tree import BALL, FIXED, PRISMATIC, REVOLUTE, Link, Tree, placed, poses, rates
from dynamics_cli.numerics.vectors import times

UP = (0.0, 0.0, 9.81)
# A few dozen operations of numbers of one size.
ROUNDING = 4e-14


def diagonal(*moments):
    return tuple(tuple(moment if i == j else 0.0 for j in range(3)) for i, moment in enumerate(moments))


def branched():
    return Tree([
        Link("b1", -1, REVOLUTE, mass=4.0, centroid=(0.1, 0.0, 0.2),
             tensor=((0.3, 0.0, 0.02), (0.0, 0.25, 0.0), (0.02, 0.0, 0.2))),
        Link("b2", 0, REVOLUTE, axis=(0.0, 1.0, 0.0), position=(0.3, 0.0, 0.4), mass=2.0, centroid=(0.0, 0.0, -0.25),
             tensor=diagonal(0.05, 0.06, 0.02)),
        Link("b3", 0, PRISMATIC, axis=(1.0, 0.0, 0.0), position=(-0.2, 0.0, 0.1), mass=1.5, centroid=(0.1, 0.05, 0.0),
             tensor=diagonal(0.01, 0.02, 0.03)),
        Link("b4", 1, BALL, position=(0.0, 0.0, -0.5), mass=1.0, centroid=(0.02, 0.03, -0.2),
             tensor=diagonal(0.02, 0.015, 0.01)),
    ])  # fmt: skip


Q = [0.4, -0.7, 0.15, 0.8, 0.4, -0.2, 0.4]
Y = [1.2, -0.8, 0.5, 0.3, -1.1, 0.6]
EFFORTS = [2.0, 1.0, -3.0, 0.1, 0.2, -0.1]
ACCELERATIONS = [2.72889970260539115240963, 15.79237936850504168219447, -1.791555014869730442379518,
                 -33.73195163692259075341806, 18.43412360718901574027261, -1.420476560808999399127631]  # fmt: skip
BIAS = [1.015722295662536080634964, -5.709215800995440382598156, -0.108, 0.2676042173051239781937455,
        -1.862974205082702550261229, -0.2588286519516596087389308]  # fmt: skip


def test_a_branched_tree():
    tree = branched()
    frames = poses(tree, Q)
    assert forward(tree, frames, Y, EFFORTS, ground=UP) == pytest.approx(ACCELERATIONS, rel=ROUNDING)
    assert inverse(tree, frames, Y, ground=UP)[0] == pytest.approx(BIAS, rel=ROUNDING)
    efforts, wrenches = inverse(tree, frames, Y, ACCELERATIONS, ground=UP)
    assert efforts == pytest.approx(EFFORTS, abs=ROUNDING)
    matrix = mass_matrix(tree, frames)
    seen = matrix[0][0], matrix[0][1], matrix[1][1]
    assert seen == pytest.approx((1.237965494045464141903841, 0.08712577489955912608686118, 0.54950784), rel=ROUNDING)
    ground = placed(tree, frames)
    force, moment = wrenches[0]
    assert times(ground[0][0], force) == pytest.approx(
        (-15.17526492660475625332035, -0.7058947262624352704801435, 70.04766310758647592625884), rel=ROUNDING
    )
    assert times(ground[0][0], moment) == pytest.approx(
        (4.826530931575133939268374, -12.23035446276398790317594, 2.0), rel=ROUNDING
    )
    assert times(ground[3][0], wrenches[3][0]) == pytest.approx(
        (-2.476545883642976791440293, -2.110475201303610646596338, 1.314778664034712576076726), rel=ROUNDING
    )


def test_a_massless_link_inside_is_no_obstacle():
    tree = Tree([
        Link("cross", -1, REVOLUTE, axis=(1.0, 0.0, 0.0)),
        Link("bob", 0, REVOLUTE, axis=(0.0, 1.0, 0.0), mass=2.0, centroid=(0.0, 0.0, -0.5),
             tensor=diagonal(0.25, 0.25, 0.125)),
    ])  # fmt: skip
    found = forward(tree, poses(tree, [0.5, 0.25]), [1.0, -2.0], [0.0, 0.0], ground=UP)
    assert found == pytest.approx((-7.244504305700006635020966, -3.039656238113110074319215), rel=ROUNDING)


def rods(count):
    """Thin rods of 1 m and 1 kg along x, hinged in a row about y: without inertia about themselves."""
    return Tree([
        Link(f"rod{k}", k - 1, REVOLUTE, axis=(0.0, 1.0, 0.0), position=(1.0 if k else 0.0, 0.0, 0.0), mass=1.0,
             centroid=(0.5, 0.0, 0.0), tensor=diagonal(0.0, 1.0 / 12.0, 1.0 / 12.0))
        for k in range(count)
    ])  # fmt: skip


@pytest.mark.parametrize(
    ("count", "first", "last"),
    [(2, 9.0 / 7.0, -3.0 / 7.0), (3, 33.0 / 26.0, 3.0 / 26.0),
     (10, 332313.0 / 262087.0, -0.00001144658071556391579895226)],
)  # fmt: skip
def test_rods_in_a_row_let_go(count, first, last):
    tree = rods(count)
    rates_of = forward(tree, poses(tree, [0.0] * count), [0.0] * count, [0.0] * count, ground=(0.0, 0.0, 1.0))
    assert rates_of[0] == pytest.approx(first, rel=ROUNDING)
    # absolute angular accelerations are sums of large ones
    assert sum(rates_of) == pytest.approx(last, abs=ROUNDING)


def _random(rng, count):
    links = []
    for k in range(count):
        size = [rng.uniform(0.1, 1.0) for _ in range(3)]
        turn = axis_angle((rng.gauss(0, 1), rng.gauss(0, 1), rng.gauss(0, 1)), rng.uniform(-2, 2))
        moments = diagonal(size[0] + size[1], size[1] + size[2], size[2] + size[0])
        r = np.array(turn)
        links.append(
            Link(
                f"b{k}",
                rng.randrange(-1, k),
                rng.choice((REVOLUTE, PRISMATIC, BALL, FIXED)),
                axis=tuple(rng.gauss(0, 1) for _ in range(3)),
                position=tuple(rng.gauss(0, 1) for _ in range(3)),
                rotation=turn,
                mass=rng.uniform(0.5, 3.0),
                centroid=tuple(rng.gauss(0, 0.5) for _ in range(3)),
                tensor=tuple(tuple(map(float, row)) for row in r @ np.array(moments) @ r.T),
                rotor=rng.choice((0.0, 0.1)),
            )
        )
    return Tree(links)


@pytest.mark.parametrize("seed", range(8))
def test_three_ways_agree_on_random_trees(seed):
    rng = random.Random(seed)
    tree = _random(rng, 7)
    q = [rng.uniform(-1, 1) for _ in range(tree.coordinates)]
    y, efforts = ([rng.uniform(-2, 2) for _ in range(tree.speeds)] for _ in range(2))
    loads = [None if k % 2 else ((1.0, -2.0, 0.5), (0.3, 0.1, -0.7)) for k in range(len(tree.links))]
    frames = poses(tree, q)
    found = forward(tree, frames, y, efforts, ground=UP, loads=loads)
    again, _ = inverse(tree, frames, y, found, ground=UP, loads=loads)
    assert again == pytest.approx(efforts, abs=1e-11)
    matrix = np.array(mass_matrix(tree, frames))
    bias, _ = inverse(tree, frames, y, ground=UP, loads=loads)
    assert matrix @ found + bias == pytest.approx(efforts, abs=1e-11)
    # the matrix once more, from partial velocities
    ground = placed(tree, frames)
    total = np.diag([link.rotor for link in tree.links for _ in link.columns])
    for k, link in enumerate(tree.links):
        rotation, origin = (np.array(part) for part in ground[k])
        columns = partial(tree, ground, k, tuple(map(float, origin + rotation @ np.array(link.centroid))))
        turning, moving = (np.array([column[side] for column in columns]) for side in range(2))
        tensor = rotation @ np.array(link.tensor) @ rotation.T
        total = total + link.mass * moving @ moving.T + turning @ tensor @ turning.T
    assert matrix == pytest.approx(total, abs=1e-12)


def test_velocities_are_rates_of_places():
    tree = _random(random.Random(11), 6)
    rng = random.Random(12)
    q, y = ([rng.uniform(-1, 1) for _ in range(count)] for count in (tree.coordinates, tree.speeds))
    for link in tree.links:
        if link.joint == BALL:
            size = sum(x * x for x in q[link.place : link.place + 4]) ** 0.5
            q[link.place : link.place + 4] = [x / size for x in q[link.place : link.place + 4]]
    step, velocity = 1e-6, rates(tree, q, y)
    ends = [
        placed(tree, poses(tree, [x + sign * step * v for x, v in zip(q, velocity, strict=True)])) for sign in (1, -1)
    ]
    motions = sweep(tree, poses(tree, q), y)
    ground = placed(tree, poses(tree, q))
    for k in range(6):
        quotient = (np.array(ends[0][k][1]) - np.array(ends[1][k][1])) / (2.0 * step)
        assert times(ground[k][0], motions[k][2]) == pytest.approx(quotient, abs=1e-8)


def test_euler_parameter_rates():
    tree = Tree([Link("body", -1, BALL)])
    assert rates(tree, [0.8, 0.4, -0.2, 0.4], [0.3, -1.1, 0.6]) == pytest.approx((-0.29, 0.28, -0.5, 0.05), rel=1e-15)


def test_many_states_at_once():
    tree = branched()
    q, y, efforts = ([np.array([x, x + 0.1]) for x in numbers] for numbers in (Q, Y, EFFORTS))
    together = forward(tree, poses(tree, q), y, efforts, ground=UP)
    one = [x + 0.1 for x in Q], [x + 0.1 for x in Y], [x + 0.1 for x in EFFORTS]
    alone = forward(tree, poses(tree, one[0]), one[1], one[2], ground=UP)
    assert [x[0] for x in together] == pytest.approx(ACCELERATIONS, rel=ROUNDING)
    assert [x[1] for x in together] == pytest.approx(alone, rel=ROUNDING)


def test_a_chain_far_from_the_origin_loses_nothing():
    near, far = (Tree([
        Link(f"b{k}", k - 1, REVOLUTE, axis=(0.0, 1.0, 0.0), position=(1.0 if k else away, 0.0, 0.0), mass=1.0,
             centroid=(0.5, 0.0, 0.0), tensor=diagonal(0.0, 0.1, 0.1)) for k in range(3)
    ]) for away in (0.0, 1e8))  # fmt: skip
    args = [0.3, -0.5, 0.8], [1.0, 2.0, -1.0], [0.0] * 3
    here, there = (forward(t, poses(t, args[0]), args[1], args[2], ground=UP) for t in (near, far))
    assert here == there


def test_a_joint_that_nothing_resists_is_named():
    tree = Tree([Link("arm", -1, REVOLUTE, mass=1.0, centroid=(0.5, 0.0, 0.0)), Link("hand", 0, REVOLUTE)])
    with pytest.raises(InadmissibleError, match="joint of hand"):
        forward(tree, poses(tree, [0.0, 0.0]), [0.0, 0.0], [0.0, 0.0])


def test_axes_in_line_are_refused():
    axes = ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0))
    tensors = diagonal(0.0, 0.0, 0.0), diagonal(0.0, 0.0, 0.0), diagonal(1.0, 2.0, 3.0)
    tree = Tree([Link(f"ring{k}", k - 1, REVOLUTE, axis=axes[k], tensor=tensors[k]) for k in range(3)])
    good = poses(tree, [0.1, 0.5, 0.2])
    assert np.linalg.det(mass_matrix(tree, good)) == pytest.approx(4.62090691760441915220281, rel=1e-13)
    forward(tree, good, [1.0, 2.0, 3.0], [0.0] * 3)
    with pytest.raises(InadmissibleError, match="joint of ring0"):
        forward(tree, poses(tree, [0.1, 1.5707963, 0.2]), [1.0, 2.0, 3.0], [0.0] * 3)
