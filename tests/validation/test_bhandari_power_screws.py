"""Power screws of Bhandari, Design of Machine Elements, chapter 6, as printed in its Scilab Textbook Companion.

FOSSEE, IIT Bombay, Scilab-TBC-Uploads, book 764, examples 6.1, 6.2 and 6.6: data6_N.sci and result6_N.txt.
"""

from math import pi

import pytest

from dynamics_cli.force.laws.screw import Form, Nominal, Standard, screw

# Six decimals are printed, of N mm, N m, kW and per cent.
PRINTED = 0.5e-6


def test_example_6_1_a_triple_start_square_thread_with_a_collar() -> None:
    jack = screw(
        load=15e3, form=Standard(Form("square")), size=Nominal(0.050), pitch=0.008, starts=3, friction=0.15,
        collar_diameter=(0.100 + 0.065) / 2,
    )  # fmt: skip
    assert 1e3 * jack.raising_torque == pytest.approx(204644.140833, abs=PRINTED, rel=0)
    assert 1e3 * jack.lowering_torque == pytest.approx(87401.514671, abs=PRINTED, rel=0)


def test_example_6_2_a_double_start_trapezoidal_thread() -> None:
    lift = screw(
        load=300e3, form=Standard(Form("trapezoidal")), size=Nominal(0.100), pitch=0.012, starts=2, friction=0.15
    )
    assert lift.raising_torque == pytest.approx(3378.159205, abs=PRINTED, rel=0)
    assert lift.lowering_torque == pytest.approx(1030.685630, abs=PRINTED, rel=0)
    assert 100.0 * lift.efficiency == pytest.approx(33.921302, abs=PRINTED, rel=0)


def test_example_6_6_the_lead_screw_of_a_lathe() -> None:
    lead_screw = screw(
        load=2e3, form=Standard(Form("trapezoidal")), size=Nominal(0.052), pitch=0.008, friction=0.15,
        collar_diameter=(0.100 + 0.060) / 2, collar_friction=0.12,
    )  # fmt: skip
    assert 1e-3 * lead_screw.raising_torque * 2.0 * pi * 30.0 / 60.0 == pytest.approx(0.061838, abs=PRINTED, rel=0)
    assert 100.0 * lead_screw.efficiency == pytest.approx(12.937099, abs=PRINTED, rel=0)
