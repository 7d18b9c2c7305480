"""Size of the teeth: module, diametral pitch or circular pitch, and the series of ISO 54."""

from math import pi

from dynamics_cli.errors import require, worded
from dynamics_cli.numerics.elementary import absolute, cos, pi_beside
from dynamics_cli.numerics.number import is_array
from dynamics_cli.quantities import Angle, Annotated, DiametralPitch, Module, Size
from dynamics_cli.records import Advice, record

# Modules between these [m] keep every length of a gear within the range of doubles.
SMALLEST, LARGEST = 1e-12, 1e3
# ISO 54, in mm: the preferred series, and the second.
SERIES_I = (1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, 16, 20, 25, 32, 40, 50)
SERIES_II = (1.125, 1.375, 1.75, 2.25, 2.75, 3.5, 4.5, 5.5, 6.5, 7, 9, 11, 14, 18, 22, 28, 36, 45)


@record
class NormalModule:
    """Size of the teeth as the module."""

    module: Annotated[Module, "Normal module m_n [m]."]

    def normal(self, helix_cosine: float) -> float:
        """The normal module."""
        return self.module


@record
class NormalDiametralPitch:
    """Size of the teeth as the diametral pitch of AGMA."""

    diametral_pitch: Annotated[DiametralPitch, "Normal diametral pitch P_nd, teeth per length of pitch diameter [1/m]."]

    def normal(self, helix_cosine: float) -> float:
        """The normal module."""
        return 1.0 / self.diametral_pitch


@record
class NormalCircularPitch:
    """Size of the teeth as the pitch."""

    circular_pitch: Annotated[Size, "Normal pitch p_n on the reference cylinder, e.g. 9.425 mm [m]."]

    def normal(self, helix_cosine: float) -> float:
        """The normal module."""
        return self.circular_pitch / pi_beside(self.circular_pitch)


@record
class TransverseModule:
    """Size of the teeth as the module in the plane of rotation."""

    transverse_module: Annotated[Module, "Transverse module m_t [m]."]

    def normal(self, helix_cosine: float) -> float:
        """The normal module."""
        return self.transverse_module * helix_cosine


@record
class TransverseDiametralPitch:
    """Size of the teeth as the diametral pitch in the plane of rotation."""

    transverse_diametral_pitch: Annotated[DiametralPitch, "Transverse diametral pitch P_d [1/m]."]

    def normal(self, helix_cosine: float) -> float:
        """The normal module."""
        return helix_cosine / self.transverse_diametral_pitch


@record
class TransverseCircularPitch:
    """Size of the teeth as the pitch in the plane of rotation."""

    transverse_circular_pitch: Annotated[Size, "Transverse pitch p_t on the reference cylinder, e.g. 9.425 mm [m]."]

    def normal(self, helix_cosine: float) -> float:
        """The normal module."""
        pitch = self.transverse_circular_pitch
        return pitch * helix_cosine / pi_beside(pitch, helix_cosine)


SpurPitch = NormalModule | NormalDiametralPitch | NormalCircularPitch


Pitch = (
    NormalModule
    | NormalDiametralPitch
    | NormalCircularPitch
    | TransverseModule
    | TransverseDiametralPitch
    | TransverseCircularPitch
)


def module_of(pitch: "Pitch", helix_angle: float) -> float:
    """The normal module of the given size; refuses sizes for which doubles would leave their range."""
    lean = absolute(helix_angle)
    require(
        lean < 0.5 * pi,
        "the helix angle is {helix_angle:6}; it must be below 90 degrees",
        helix_angle=(helix_angle, Angle),
        code="helix-angle",
    )
    module = pitch.normal(cos(lean))
    require_module(module)
    return module


def require_module(module: float) -> None:
    """Refuse a size of teeth outside the range for gears."""
    require(
        (module > SMALLEST) & (module < LARGEST),
        "the module {module:6} is outside the range for gears",
        module=(module, Size),
        code="module",
        hint="modules may be from 1e-9 mm to 1e6 mm",
    )


def module_advice(pitch: object, module: float) -> tuple[Advice, ...]:
    """Advice with the standard module when the given one is not in the series of ISO 54."""
    if not isinstance(pitch, NormalModule):
        return ()
    size = getattr(module, "value", module)
    if is_array(size) or not 0.9e-3 < size < 60e-3:
        return ()
    millimetres = 1e3 * size
    if any(abs(millimetres - standard) <= 1e-9 * millimetres for standard in (*SERIES_I, *SERIES_II)):
        return ()
    first = min(SERIES_I, key=lambda standard: abs(standard - millimetres))
    second = min((*SERIES_I, *SERIES_II), key=lambda standard: abs(standard - millimetres))
    message = worded("a module of {module:6} is in neither series of ISO 54", module=(size, Module))
    remedy = worded(
        "the nearest, in millimetres: {first} (series I)" + ("" if first == second else ", {second} (series II)"),
        first=f"{first:g}",
        second=f"{second:g}",
    )
    return (Advice(code="off-series", message=message, severity="note", remedy=remedy),)
