"""Combined mass properties and their uncertainties of two parts, as published.

R. L. Zimmerman, J. H. Nakai, Are You Sure? Uncertainty in Mass Properties Engineering, SAWE paper 3360, 64th Annual
International Conference on Mass Properties Engineering, 2005, 123-160: the "Widget" and the "2nd Part". The printed
results were computed with rounded intermediates and are good to about 0.2 % only, as users of the example have found;
a separate test holds our own to far more digits. Products are printed as +∫ x y dm. Units do not matter here.
"""

import math

import pytest

from dynamics_cli.inertia.assembly.assembly import Assembly, body
from dynamics_cli.inertia.assembly.parts import Part
from dynamics_cli.inertia.bodies.amount import OfMass
from dynamics_cli.inertia.bodies.properties import MassProperties, ProductSign
from dynamics_cli.numerics.number import over_plain

PRINTED = 2.5e-3
# mass; mass centre; xx, yy, zz; xy, xz, yz; and the standard uncertainties of all these in the same order
Row = tuple[float, tuple[float, ...], tuple[float, ...], tuple[float, ...]]
WIDGET: tuple[Row, Row] = (
    (57.83, (121.20, 0.04, -0.16), (7258.90, 8607.02, 10453.40), (834.44, -1198.38, -1066.58)),
    (1.2416, (0.2764, 0.2085, 0.0669), (386.9233, 171.4792, 414.5547), (1440.5402, 344.6237, 124.6860)),
)
SECOND: tuple[Row, Row] = (
    (16.80, (70.90, -0.95, 0.46), (65.07, 1124.65, 1078.82), (76.01, 202.83, 13.62)),
    (1.7308, (0.6234, 0.5173, 0.1405), (12.4687, 109.1324, 108.5481), (55.8879, 212.1241, 11.5408)),
)
COMBINED: tuple[Row, Row] = (
    (74.63, (109.8657, -0.1829, -0.0204), (7341.73, 42739.26, 44547.27), (1559.36, -1401.94, -1060.95)),
    (2.1301, (0.9591, 0.2000, 0.0618), (387.4017, 2794.5468, 2820.5125), (1488.1857, 418.6320, 125.3175)),
)


def part(rows: tuple[Row, Row]) -> Part:
    (mass, centroid, moments, (xy, xz, yz)), (mass_std, centroid_std, spread, (sxy, sxz, syz)) = rows
    xx, yy, zz = moments
    a, b, c = spread
    return Part(
        amount=OfMass(mass),
        centroid=centroid,  # type: ignore[arg-type]
        tensor=((xx, -xy, -xz), (-xy, yy, -yz), (-xz, -yz, zz)),
        mass_std=mass_std,
        centroid_std=centroid_std,  # type: ignore[arg-type]
        tensor_std=((a, sxy, sxz), (sxy, b, syz), (sxz, syz, c)),
    )


@pytest.fixture(scope="module")
def combined() -> MassProperties:
    scene = Assembly(parts=(part(WIDGET), part(SECOND)))
    return over_plain(body(scene, product_sign=ProductSign("positive")))  # type: ignore[no-any-return]


def test_the_combined_mass_properties(combined: MassProperties) -> None:
    mass, centroid, moments, (xy, xz, yz) = COMBINED[0]
    assert combined.mass == pytest.approx(mass, abs=0.005)
    assert combined.centroid == pytest.approx(centroid, rel=PRINTED)
    found = combined.moments
    assert (found.xx, found.yy, found.zz) == pytest.approx(moments, rel=PRINTED)
    products = combined.products
    assert (products.xy, products.zx, products.yz) == pytest.approx((xy, xz, yz), rel=PRINTED)


def test_the_combined_uncertainties(combined: MassProperties) -> None:
    mass, centroid, moments, (xy, xz, yz) = COMBINED[1]
    found = combined.standard_uncertainty
    assert found is not None
    assert found.mass == pytest.approx(mass, abs=0.5e-4)
    assert found.centroid == pytest.approx(centroid, rel=PRINTED)
    assert found.moments == pytest.approx(moments, rel=PRINTED)
    assert (found.products[0], found.products[2], found.products[1]) == pytest.approx((xy, xz, yz), rel=PRINTED)


def test_our_own_by_the_theorem(combined: MassProperties) -> None:
    """The parallel axes by hand, to twelve digits, where the printed numbers have three."""
    (m1, c1, i1, _), (m2, c2, i2, _) = WIDGET[0], SECOND[0]
    d = [a - b for a, b in zip(c1, c2, strict=True)]
    reduced = m1 * m2 / (m1 + m2)
    want = i1[1] + i2[1] + reduced * (d[0] ** 2 + d[2] ** 2)
    assert combined.moments.yy == pytest.approx(want, rel=1e-12)
    assert combined.standard_uncertainty is not None
    assert combined.standard_uncertainty.mass == pytest.approx(math.hypot(1.2416, 1.7308), rel=1e-15)
