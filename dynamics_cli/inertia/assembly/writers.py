"""Mass properties as the files that simulators read: URDF, SDF and MJCF.

All of them take SI units, the mass centre, and the tensor about it with products that are its own elements (−∫ x y dm).
"""

from dynamics_cli.inertia.bodies.mass_moments import tensor_of
from dynamics_cli.numerics.number import over_plain

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.bodies.mass_moments import Matrix
    from dynamics_cli.inertia.bodies.properties import MassProperties


def urdf(answer: "MassProperties") -> str:
    """A URDF robot of one link with its inertia: it loads as it is, and the link can be copied from it."""
    body = over_plain(answer)
    return (
        '<?xml version="1.0"?>\n'
        '<robot name="body">\n'
        '  <link name="body">\n'
        "    <inertial>\n"
        f'      <origin xyz="{_words(body.centroid)}" rpy="0 0 0"/>\n'
        f'      <mass value="{body.mass!r}"/>\n'
        f"      <inertia {_six(_tensor(body), ' ')}/>\n"
        "    </inertial>\n"
        "  </link>\n"
        "</robot>\n"
    )


def sdf(answer: "MassProperties") -> str:
    """An SDF model of one link with its inertia."""
    body = over_plain(answer)
    inner = "".join(
        f"          <{name}>{value!r}</{name}>\n" for name, value in zip(NAMES, _elements(_tensor(body)), strict=True)
    )
    return (
        '<?xml version="1.0"?>\n'
        '<sdf version="1.7">\n'
        '  <model name="body">\n'
        '    <link name="body">\n'
        "      <inertial>\n"
        f"        <pose>{_words(body.centroid)} 0 0 0</pose>\n"
        f"        <mass>{body.mass!r}</mass>\n"
        f"        <inertia>\n{inner}        </inertia>\n"
        "      </inertial>\n"
        "    </link>\n"
        "  </model>\n"
        "</sdf>\n"
    )


def mjcf(answer: "MassProperties") -> str:
    """A MuJoCo model of one free body; its six numbers are xx yy zz xy xz yz."""
    body = over_plain(answer)
    xx, xy, xz, yy, yz, zz = _elements(_tensor(body))
    return (
        '<mujoco model="body">\n'
        "  <worldbody>\n"
        '    <body name="body">\n'
        "      <freejoint/>\n"
        f'      <inertial pos="{_words(body.centroid)}" mass="{body.mass!r}" '
        f'fullinertia="{_words((xx, yy, zz, xy, xz, yz))}"/>\n'
        "    </body>\n"
        "  </worldbody>\n"
        "</mujoco>\n"
    )


NAMES = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


def _tensor(body: "MassProperties") -> "Matrix":
    """The tensor about the mass centre in the input axes, which may differ from the axes of the answer."""
    if body.axes == "given":
        return tensor_of(body.second_moments)
    moments = (body.principal_moments.first, body.principal_moments.second, body.principal_moments.third)
    axes = body.principal_axes
    return tuple(tuple(sum(moments[k] * axes[k][i] * axes[k][j] for k in range(3)) for j in range(3)) for i in range(3))  # type: ignore[return-value]


def _elements(tensor: "Matrix") -> tuple[float, ...]:
    return tensor[0][0], tensor[0][1], tensor[0][2], tensor[1][1], tensor[1][2], tensor[2][2]


def _six(tensor: "Matrix", between: str) -> str:
    return between.join(f'{name}="{value!r}"' for name, value in zip(NAMES, _elements(tensor), strict=True))


def _words(values: "tuple[float, ...]") -> str:
    return " ".join(repr(value) for value in values)
