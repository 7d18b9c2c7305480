"""Shapes by name: rods, laminae, shells and solids, each with its measure, mass centre and second moments."""

from dynamics_cli.inertia.shapes.hollow import (
    ClosedCylinder,
    HollowBlock,
    HollowCylinder,
    HollowFrustum,
    HollowHemisphere,
    HollowSphere,
    HollowTorus,
    RectangularTube,
)
from dynamics_cli.inertia.shapes.plates import (
    Annulus,
    Disk,
    Ellipse,
    HalfDisk,
    Polygon,
    QuarterDisk,
    Rectangle,
    Sector,
    Triangle,
)
from dynamics_cli.inertia.shapes.polyhedra import Block, Prism, Pyramid, RegularPrism, Tetrahedron, Wedge
from dynamics_cli.inertia.shapes.quadrics import Ellipsoid, EllipticCylinder, HalfEllipsoid, Paraboloid
from dynamics_cli.inertia.shapes.rods import ArcRod, QuarterCircleRod, RingRod, Rod, SemicircleRod
from dynamics_cli.inertia.shapes.shells import (
    BoxShell,
    ConicalShell,
    CylindricalShell,
    FrustumShell,
    HalfCylindricalShell,
    HemisphericalShell,
    SphericalShell,
    TorusShell,
)
from dynamics_cli.inertia.shapes.solids import (
    Capsule,
    Cone,
    Cylinder,
    Frustum,
    HalfCylinder,
    Hemisphere,
    QuarterCylinder,
    Sphere,
    Torus,
)

RODS = Rod | RingRod | ArcRod | SemicircleRod | QuarterCircleRod
PLATES = Triangle | Rectangle | Polygon | Disk | HalfDisk | QuarterDisk | Sector | Ellipse | Annulus
SHELLS = (
    CylindricalShell
    | HalfCylindricalShell
    | ConicalShell
    | FrustumShell
    | SphericalShell
    | HemisphericalShell
    | BoxShell
    | TorusShell
)
SOLIDS = (
    Sphere
    | Hemisphere
    | Cylinder
    | HalfCylinder
    | QuarterCylinder
    | EllipticCylinder
    | Cone
    | Frustum
    | Paraboloid
    | Capsule
    | Ellipsoid
    | HalfEllipsoid
    | Torus
    | Block
    | Wedge
    | Prism
    | RegularPrism
    | Pyramid
    | Tetrahedron
)
HOLLOW = (
    HollowSphere
    | HollowHemisphere
    | HollowCylinder
    | ClosedCylinder
    | HollowFrustum
    | HollowBlock
    | RectangularTube
    | HollowTorus
)
Shape = RODS | PLATES | SHELLS | SOLIDS | HOLLOW
