"""How much of a body there is: its mass, or a density for its dimension, or a material by name."""

from dynamics_cli.errors import require
from dynamics_cli.quantities import ArealDensity, Density, LinearDensity, Mass, Text
from dynamics_cli.records import record

MEASURES = ("", "length", "area", "volume")


@record
class OfMass:
    """Its mass.

    Parameters
    ----------
    mass : Mass
        Mass [kg].
    """

    mass: Mass


@record
class OfDensity:
    """Mass per volume, of solids.

    Parameters
    ----------
    density : Density
        Mass per volume [kg/m^3].
    """

    density: Density


@record
class OfMaterial:
    """A material of the table, of solids.

    Parameters
    ----------
    material : Text
        Name of a material, as `dynamics inertia materials` lists them.
    """

    material: Text


@record
class OfArealDensity:
    """Mass per area, of laminae and shells.

    Parameters
    ----------
    areal_density : ArealDensity
        Mass per area [kg/m^2].
    """

    areal_density: ArealDensity


@record
class OfLinearDensity:
    """Mass per length, of rods.

    Parameters
    ----------
    linear_density : LinearDensity
        Mass per length [kg/m].
    """

    linear_density: LinearDensity


Amount = OfMass | OfDensity | OfMaterial | OfArealDensity | OfLinearDensity


def mass_of(amount: Amount, measure: float, dimension: int, what: str = "the shape") -> float:
    """The mass of a length, an area or a volume.

    Raises
    ------
    InadmissibleError
        When the density is one of another dimension, the material unknown, or the mass zero.
    """
    if isinstance(amount, OfMass):
        require(amount.mass > 0.0, "the mass of {0} is zero", what, code="no-mass")
        return amount.mass
    density, of = _density(amount)
    require(
        of == dimension,
        "{0} has {1}, and the density given is one per {2}",
        what,
        ("no extent", "a length and no area", "an area and no volume", "a volume")[dimension],
        MEASURES[of],
        code="dimension",
        hint=f"give mass, or {('mass', 'linear-density', 'areal-density', 'density or material')[dimension]}",
    )
    mass = density * measure
    require(mass > 0.0, "the mass of {0} is zero", what, code="no-mass", hint="check its sizes and its density")
    return mass


def _density(amount: Amount) -> tuple[float, int]:
    if isinstance(amount, OfDensity):
        return amount.density, 3
    if isinstance(amount, OfMaterial):
        from dynamics_cli.inertia.materials import density_of

        return density_of(amount.material), 3
    if isinstance(amount, OfArealDensity):
        return amount.areal_density, 2
    assert isinstance(amount, OfLinearDensity)
    return amount.linear_density, 1
