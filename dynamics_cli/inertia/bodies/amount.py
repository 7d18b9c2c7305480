"""The amount of a body: its mass, or a density for its dimension, or a material by name."""

from dynamics_cli.errors import require
from dynamics_cli.quantities import Annotated, ArealDensity, Density, LinearDensity, Mass, Text
from dynamics_cli.records import record

MEASURES = ("", "length", "area", "volume")


@record
class OfMass:
    """Its mass."""

    mass: Annotated[Mass, "Mass, e.g. 2.5 kg."]


@record
class OfDensity:
    """Mass per volume, of solids."""

    density: Annotated[Density, "Mass per volume [kg/m^3]."]


@record
class OfMaterial:
    """A material of the table, of solids."""

    material: Annotated[Text, "A material of the table `dynamics inertia materials`, e.g. steel."]


@record
class OfArealDensity:
    """Mass per area, of laminae and shells."""

    areal_density: Annotated[ArealDensity, "Mass per area, e.g. 7.85 kg/m^2."]


@record
class OfLinearDensity:
    """Mass per length, of rods."""

    linear_density: Annotated[LinearDensity, "Mass per length [kg/m]."]


Amount = OfMass | OfDensity | OfMaterial | OfArealDensity | OfLinearDensity


def mass_of(amount: Amount, measure: float, dimension: int, name: str = "the shape") -> float:
    """The mass of a length, an area or a volume.

    Raises InadmissibleError when the density is one of another dimension, the material unknown, or the mass zero.
    """
    if isinstance(amount, OfMass):
        require(amount.mass > 0.0, "the mass of {body} is zero", code="no-mass", body=name)
        return amount.mass
    density, of = _density(amount)
    require(
        of == dimension,
        "{body} has {extent}, but the density given is per {measure}",
        code="dimension",
        hint=f"give mass, or {('mass', 'linear-density', 'areal-density', 'density or material')[dimension]}"
        + ("; one with a thickness is a cylinder, block or prism" if (dimension, of) == (2, 3) else ""),
        body=name,
        extent=("no extent", "a length and no area", "an area and no volume", "a volume")[dimension],
        measure=MEASURES[of],
    )
    mass = density * measure
    require(mass > 0.0, "the mass of {body} is zero", code="no-mass", hint="check its sizes and its density", body=name)
    return mass


def _density(amount: Amount) -> tuple[float, int]:
    if isinstance(amount, OfDensity):
        return amount.density, 3
    if isinstance(amount, OfMaterial):
        from dynamics_cli.inertia.bodies.materials import density_of

        return density_of(amount.material), 3
    if isinstance(amount, OfArealDensity):
        return amount.areal_density, 2
    assert isinstance(amount, OfLinearDensity)
    return amount.linear_density, 1
