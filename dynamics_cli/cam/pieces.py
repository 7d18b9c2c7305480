"""Pieces of a motion on which it is smooth: between joints of the program and of the laws themselves."""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def pieces(motion: "Any") -> "tuple[Any, Any]":
    """Starts and ends of the pieces of one turn, in radians and in order."""
    return motion.starts, motion.ends


def sample(motion: "Any", theta: "Any") -> "tuple[Any, Any, Any, Any]":
    """Lift and its three derivatives by cam angle at an array of angles of any shape."""
    return motion.at(theta)  # type: ignore[no-any-return]


def motion_of(program: "Any", geometry: "Any") -> "Any":
    """The motion of a program."""
    return program
