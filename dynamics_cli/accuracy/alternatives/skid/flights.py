"""Vaults and throws: the forms of the textbook, as differences of squares and of distances, and a search."""

import math

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def least_vault_by_book(
    *, distance: float, rise: float, gravity: float, take_off: "float | None" = None, m: "Any" = math
) -> "dict[str, float]":
    """V² = g·(h + √(d² + h²)), tan α = v²/(g·d): digits go as the drop grows beside the distance."""
    up = rise + m.sqrt(distance * distance + rise * rise)
    speed = m.sqrt(gravity * up)
    angle = m.atan(speed * speed / (gravity * distance))
    time = distance / (speed * m.cos(angle))
    return {
        "speed": speed,
        "launch_angle": angle,
        "flight_time": time,
        "landing_speed": m.sqrt(speed * speed - 2 * gravity * rise),
        "landing_angle": m.atan((gravity * time - speed * m.sin(angle)) / (speed * m.cos(angle))),
    }


def vault_by_book(
    *, distance: float, rise: float, take_off: float, gravity: float, m: "Any" = math
) -> "dict[str, float]":
    """V = d·√(g/(2·cos α·(d·sin α − h·cos α))); the landing by tan⁻¹ and squares."""
    sine, cosine = m.sin(take_off), m.cos(take_off)
    speed = distance * m.sqrt(gravity / (2 * cosine * (distance * sine - rise * cosine)))
    time = distance / (speed * cosine)
    return {
        "speed": speed,
        "launch_angle": take_off,
        "flight_time": time,
        "landing_speed": m.sqrt(speed * speed - 2 * gravity * rise),
        "landing_angle": m.atan((gravity * time - speed * sine) / (speed * cosine)),
    }


def throw_by_searle(
    *, throw_distance: float, friction: float, launch_height: float, gravity: float,
    launch_angle: "float | None" = None, m: "Any" = math,
) -> "dict[str, float]":  # fmt: skip
    """V = √(2·μ·g·(s − μ·h))/(cos α + μ·sin α), between its values for α = tan⁻¹ μ and for a level launch."""
    greatest = m.sqrt(2 * friction * gravity * (throw_distance - friction * launch_height))
    out = {
        "least_speed": greatest / m.sqrt(1 + friction * friction), "greatest_speed": greatest,
    }  # fmt: skip
    if launch_height == 0.0:
        out["greatest_angle"] = 2 * m.atan(friction)
    if launch_angle is not None:
        speed = greatest / (m.cos(launch_angle) + friction * m.sin(launch_angle))
        up = speed * m.sin(launch_angle)
        time = (up + m.sqrt(up * up + 2 * gravity * launch_height)) / gravity
        flight = speed * m.cos(launch_angle) * time
        slide = throw_distance - flight
        if not slide >= 0.0:
            raise ArithmeticError
        out |= {
            "speed": speed, "flight_time": time, "flight_distance": flight, "slide_distance": slide,
            "slide_time": m.sqrt(2 * slide / (friction * gravity)),
        }  # fmt: skip
    return out
