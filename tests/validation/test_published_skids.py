"""Published skid calculations, each with its source and the precision it was printed with.

learnexams.com, answer to an examination question: a car skids 11 m on a surface of friction 0.65 and leaves
it at 3.5 m/s; with g = 9.81 m/s² it entered at 12.35 m/s (27.63 mph at 1,609 m a mile).
"""

import pytest
from harness import answer

from dynamics_cli.skid.braking import Segment, speed

PRINTED = 5e-4


def test_examination_question_in_si() -> None:
    result = speed(segments=Segment(distance=11.0, friction=0.65), end_speed=3.5, gravity=9.81)
    assert result.speed == pytest.approx(12.35, rel=PRINTED)
    assert result.speed == pytest.approx(12.35042509389859, rel=1e-14)
    assert result.speed * 3600.0 / 1609.0 == pytest.approx(27.63, rel=PRINTED)


def test_examination_question_through_the_command() -> None:
    given = ("--distance", "11 m", "--friction", "0.65", "--end-speed", "3.5 m/s", "--gravity", "9.81 m/s^2")
    results = answer("skid", "speed", *given, "--units", "us")["results"]
    assert results["speed"] == {"value": pytest.approx(27.63, rel=PRINTED), "unit": "mph"}
