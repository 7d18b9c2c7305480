"""Validity of contours: no crossing sides, holes within material. All predicates are exact."""

from dynamics_cli.errors import require

TYPE_CHECKING = False
if TYPE_CHECKING:
    from dynamics_cli.inertia.section.contours import Contour, Point


def require_sound(shapes: "list[Contour]") -> None:
    """Refuse contours that cross themselves or one another, and holes outside the material or within one another.

    Contours may touch, and pieces may share sides.

    Raises InadmissibleError naming the contours and sides at fault.
    """
    _require_no_crossing(shapes)
    for contour in shapes:
        around = [other for other in shapes if other is not contour and _holds(other, contour)]
        depth = sum(other.sign for other in around)
        if contour.sign < 0 or depth < 0:
            holes = [contour] if contour.sign < 0 else [other for other in around if other.sign < 0]
            require(
                contour.sign < 0 < depth,
                "{hole} does not lie within material",
                code="hole-outside",
                hint="a hole lies within one piece, and not within another hole",
                hole=holes[0].name,
            )
        require(
            depth == (contour.sign < 0),
            "{contour} lies within {others}: its material would count twice",
            code="pieces-overlap",
            hint="draw the overlapping contours as one polygon",
            contour=contour.name,
            others=" and ".join(other.name for other in around),
        )


def _require_no_crossing(shapes: "list[Contour]") -> None:
    """Sides by their least x, each against those that begin before it ends."""
    sides = []
    for number, contour in enumerate(shapes):
        for place, (a, b) in enumerate(contour.sides(), 1):
            sides.append((min(a[0], b[0]), max(a[0], b[0]), number, place, a, b))
    sides.sort(key=lambda side: (side[0], side[1]))
    open_: list[tuple[int, int, int, int, Point, Point]] = []
    for side in sides:
        low, _, number, place, a, b = side
        open_ = [other for other in open_ if other[1] >= low]
        for _, _, other, side_name, c, d in open_:
            require(
                not (_apart(a, b, c, d) and _apart(c, d, a, b)),
                "side {side} of {other} crosses side {crossed} of {contour}",
                code="polygon",
                hint="give corners in order along the contour",
                side=side_name,
                other=shapes[other].name,
                crossed=place,
                contour=shapes[number].name,
            )
        open_.append(side)
    for outer in shapes:
        for inner in shapes:
            if outer is not inner and not (outer.diameter or inner.diameter):
                places = _all_places(outer, inner)
                require(
                    min(places) >= 0 or max(places) <= 0,
                    "{inner} crosses {outer}",
                    code="polygon",
                    hint="draw both as one polygon",
                    inner=inner.name,
                    outer=outer.name,
                )
    _require_circles_clear(shapes)


def _require_circles_clear(shapes: "list[Contour]") -> None:
    """Circles against sides and against circles."""
    circles = [contour for contour in shapes if contour.diameter]
    for index, circle in enumerate(circles):
        (x, y), d = circle.corners[0], circle.diameter
        for other in shapes:
            inside = [4 * _square(corner, (x, y)) < d * d for corner in other.corners] if not other.diameter else []
            crossed = any(inside) and not all(inside)
            crossed = crossed or any(_cuts(a, b, (x, y), d) for a, b in other.sides())
            _require_clear(crossed, circle, other)
        for other in circles[index + 1 :]:
            gap = 4 * _square(other.corners[0], (x, y))
            _require_clear((d - other.diameter) ** 2 < gap < (d + other.diameter) ** 2, circle, other)


def _require_clear(crossed: bool, circle: "Contour", other: "Contour") -> None:
    require(
        not crossed,
        "{circle} crosses {other}",
        code="polygon",
        hint="move one, or draw both as one polygon",
        circle=circle.name,
        other=other.name,
    )


def _holds(outer: "Contour", inner: "Contour") -> bool:
    """Whether the inner contour, which crosses nothing, lies within the outer one (or on it)."""
    if outer.diameter:
        (x, y), d = outer.corners[0], outer.diameter
        if inner.diameter:
            clearance = d - inner.diameter
            return clearance >= 0 and 4 * _square(inner.corners[0], (x, y)) <= clearance * clearance
        return all(4 * _square(corner, (x, y)) <= d * d for corner in inner.corners)
    if inner.diameter:
        return _places(outer, inner.corners[0]) > 0 and _bigger(outer, inner)
    return min(_all_places(outer, inner)) >= 0


def _all_places(outer: "Contour", inner: "Contour") -> "list[int]":
    """Where the corners of one polygon, and the middles of its sides, are to another."""
    twice = type(outer)(outer.name, outer.sign, [(2 * x, 2 * y) for x, y in outer.corners])
    points = [(2 * x, 2 * y) for x, y in inner.corners]
    points += [(a[0] + b[0], a[1] + b[1]) for a, b in inner.sides()]
    return [_places(twice, point) for point in points]


def _bigger(outer: "Contour", circle: "Contour") -> bool:
    """Whether a polygon around a circle's centre has every side outside the circle."""
    (x, y), d = circle.corners[0], circle.diameter
    return any(4 * _square(corner, (x, y)) >= d * d for corner in outer.corners)


def _places(outer: "Contour", point: "Point") -> int:
    """1 inside, 0 on the outline, −1 outside."""
    x, y = point
    inside = False
    for a, b in outer.sides():
        turn = _turn(a, b, point)
        if turn == 0 and min(a[0], b[0]) <= x <= max(a[0], b[0]) and min(a[1], b[1]) <= y <= max(a[1], b[1]):
            return 0
        if (a[1] > y) != (b[1] > y) and (turn > 0) == (b[1] > a[1]):
            inside = not inside
    return 1 if inside else -1


def _cuts(a: "Point", b: "Point", centre: "Point", d: int) -> bool:
    """Whether a side passes through a circle with both its ends outside."""
    if 4 * _square(a, centre) < d * d or 4 * _square(b, centre) < d * d:
        return False
    ux, uy = b[0] - a[0], b[1] - a[1]
    along = (centre[0] - a[0]) * ux + (centre[1] - a[1]) * uy
    square = ux * ux + uy * uy
    if not 0 < along < square:
        return False
    turn = ux * (centre[1] - a[1]) - uy * (centre[0] - a[0])
    return 4 * turn * turn < d * d * square


def _square(a: "Point", b: "Point") -> int:
    return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2


def _apart(a: "Point", b: "Point", c: "Point", d: "Point") -> bool:
    """Whether c and d lie strictly on either side of the line through a and b."""
    p, q = _turn(a, b, c), _turn(a, b, d)
    return (p > 0 > q) or (p < 0 < q)


def _turn(a: "Point", b: "Point", c: "Point") -> int:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
