"""Pictures of trains, profiles and meshes: finite numbers that show what was calculated."""

import math

import pytest

from dynamics_cli.gear.mesh.mesh import mesh
from dynamics_cli.gear.mesh.pictures import mesh_picture
from dynamics_cli.gear.pitch import NormalModule
from dynamics_cli.gear.single.pictures import profile_picture
from dynamics_cli.gear.single.profile import profile
from dynamics_cli.gear.trains.pictures import train_picture
from dynamics_cli.gear.trains.scene import Mesh, Network, Planetary, Shaft, Stages
from dynamics_cli.gear.trains.train import train
from dynamics_cli.pictures import Bars, Curve, Picture

MM = 1e-3


def curves(picture: Picture) -> list[Curve]:
    found = [item for panel in picture.panels for item in panel.items if isinstance(item, Curve)]
    for curve in found:
        assert len(curve.x) == len(curve.y) > 1
        assert all(map(math.isfinite, (*curve.x, *curve.y)))
    return found


@pytest.mark.parametrize("arrangement", [Stages("20:60, 18:-54"), Stages("20:35:60"), Stages("20:-80:30")])
def test_pitch_circles_in_mesh_touch(arrangement: Stages) -> None:
    found = curves(train_picture(train(arrangement=arrangement), arrangement=arrangement))
    for index, one in enumerate(arrangement.meshes()):
        circles = [curve for curve in found if curve.role == index and curve.style == "centre"]
        centres = [0.5 * (max(curve.x) + min(curve.x)) for curve in circles]
        radii = [0.5 * (max(curve.x) - min(curve.x)) for curve in circles]
        assert sorted(2 * radius for radius in radii) == pytest.approx(sorted((one.first_teeth, one.second_teeth)))
        apart = abs(centres[0] - centres[1])
        touching = abs(radii[0] - radii[1]) if one.internal else sum(radii)
        assert apart == pytest.approx(touching, rel=1e-12)


def test_planets_touch_sun_and_ring() -> None:
    arrangement = Planetary(sun=24, ring=72, planets=5)
    picture = train_picture(train(arrangement=arrangement), arrangement=arrangement)
    planets = [curve for curve in curves(picture) if curve.role == 1 and curve.style == "centre"]
    assert len(planets) == 5
    for planet in planets:
        away = [math.hypot(x, y) for x, y in zip(planet.x, planet.y, strict=True)]
        assert min(away) == pytest.approx(12.0, abs=0.02)
        assert max(away) == pytest.approx(36.0, abs=0.02)
    bars = next(item for item in picture.panels[1].items if isinstance(item, Bars))
    assert dict(zip(bars.names, bars.high, strict=True))["carrier"] == 0.25


def test_networks_and_differentials_show_their_speeds() -> None:
    network = Network((Mesh("a", 20, "b", 40),))
    assert len(train_picture(train(arrangement=network, driver="a", driven="b"), arrangement=network).panels) == 1
    planetary = Planetary(sun=24, ring=72)
    answer = train(arrangement=planetary, fixed="none", speed=10.0, shafts=(Shaft("ring", speed=2.0),))
    assert "speed" in train_picture(answer, arrangement=planetary).panels[-1].x.title


@pytest.mark.parametrize("options", [{}, {"internal": True}, {"rack": True}, {"only_teeth": 2}])
def test_profiles_stay_between_root_and_tips(options: dict) -> None:
    answer = profile(teeth=72, pitch=NormalModule(2 * MM), **options)
    found = curves(profile_picture(answer))
    if "rack" in options:
        return
    away = [math.hypot(x, y) for x, y in zip(found[0].x, found[0].y, strict=True)]
    low, high = sorted((answer.root_diameter / 2, answer.tip_diameter / 2))
    assert low * (1 - 1e-6) <= min(away)
    assert max(away) <= high * (1 + 1e-12)
    assert (len(found) == 5) == ("only_teeth" not in options)


@pytest.mark.parametrize("internal", [False, True])
def test_meshing_teeth_are_drawn_apart(internal: bool) -> None:
    given = {"first_teeth": 18, "second_teeth": 60, "pitch": NormalModule(2 * MM), "internal": internal}
    answer = mesh(**given, points=100)
    one, two = (curve for curve in curves(mesh_picture(answer, **given)) if curve.style in ("filled", "outline"))
    centre = -answer.centre_distance if internal else answer.centre_distance
    tip = max(math.hypot(x, y) for x, y in zip(one.x, one.y, strict=True))
    assert tip == pytest.approx(20 * MM, rel=1e-9)
    away = [math.hypot(x - centre, y) for x, y in zip(two.x, two.y, strict=True)]
    assert (min(away) if internal else max(away)) == pytest.approx((58 if internal else 62) * MM, rel=1e-9)
    # both flanks pass the pitch point, to what a line on paper shows
    pitch_point = 18 * MM
    for curve in (one, two):
        assert min(math.hypot(x - pitch_point, y) for x, y in zip(curve.x, curve.y, strict=True)) < 0.2 * MM
