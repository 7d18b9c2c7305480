"""Planar impacts followed from event to event in many bits, and the two laws that know no path.

From the present velocity it is asked which way the contact slips or whether friction can hold it, then the next event
is gone to (slip stops, compression ends, the law's end is reached), and it is asked again. The program has one closed
form for all phases.
"""

from typing import Any, NamedTuple

from precise import FUNCTIONS, Exact

Number = Any
sqrt = FUNCTIONS["sqrt"]


class Contact(NamedTuple):
    """K and the relative velocity in the frame of the contact; the normal points at body 1."""

    tangential: Number
    coupling: Number
    normal: Number
    slip: Number
    approach: Number


class Planar(NamedTuple):
    """Impulses at the end, the heat of friction, and the normal impulse while the first slip lasted."""

    normal: Number
    tangential: Number
    compression: Number = None
    heat: Number = None
    slip: Number = None


def follow(contact: Contact, mu: Number, e: Number, law: str) -> Planar:
    """The path of Routh and Keller to the end that Newton, Poisson or Stronge sets."""
    kt, kx, kn, ut, un = contact
    normal = tangential = work = back = heat = Exact(0)
    compression: Number = None
    slip: Number = normal if ut == 0 and mu else None
    for _ in range(12):
        held = ut == 0 and abs(kx) <= mu * kt
        way = _sign(ut) if ut else _sign(kx)
        ratio = -kx / kt if held else -mu * way
        rise, drift = kn + kx * ratio, Exact(0) if held else kt * ratio + kx
        stop = -ut / drift if ut * drift < 0 else None
        more = _to_the_end(un, rise, normal, compression, e * e * work - back, e, law, contact.approach)
        ends = more is not None and (stop is None or more <= stop)
        step = more if ends else stop
        if step is None:
            raise ArithmeticError("no event is ahead")
        done = step * (un + rise * step / 2)
        work, back = (work - done, back) if compression is None else (work, back + done)
        normal, tangential = normal + step, tangential + ratio * step
        heat -= ratio * step * (ut + drift * step / 2)
        un, ut = un + rise * step, Exact(0) if stop is not None and step == stop else ut + drift * step
        if not ends:
            slip = normal if slip is None else slip
            continue
        if compression is not None or e == 0:
            whole = normal if compression is None else compression
            return Planar(normal, tangential, whole, heat, normal if slip is None else slip)
        compression, un = normal, Exact(0)
    raise ArithmeticError("no end")


def _sign(x: Number) -> int:
    return (x > 0) - (x < 0)


def _to_the_end(
    un: Number, rise: Number, normal: Number, compression: Number, left: Number, e: Number, law: str, approach: Number
) -> Number | None:
    """Normal impulse to the end of compression, then to that of the law; nothing where this phase never gets there."""
    if compression is None:
        return -un / rise if rise > 0 else None
    if law == "poisson":
        return (1 + e) * compression - normal
    if rise <= 0 and un <= 0:
        return None
    if law == "newton":
        return (-e * approach - un) / rise if rise > 0 else None
    square = un * un + 2 * rise * left
    if square < 0:
        return None
    return 2 * left / (un + sqrt(square)) if left > 0 else Exact(0)


def _capped(contact: Contact, mu: Number, rise: Number) -> tuple[Number, Number]:
    """Impulse that stops the slip while u_n changes by `rise`, its ratio capped at friction."""
    kt, kx, kn, ut, _ = contact
    det = kt * kn - kx * kx
    along, across = (-kn * ut - kx * rise) / det, (kt * rise + kx * ut) / det
    if across > 0 and abs(along) <= mu * across:
        return across, along
    ratio = mu if (along >= 0) == (across >= 0) else -mu
    across = rise / (kn + kx * ratio)
    return across, ratio * across


def brach(contact: Contact, mu: Number, e: Number) -> Planar:
    """Newton's restitution with an impulse ratio up to μ."""
    return Planar(*_capped(contact, mu, -(1 + e) * contact.approach))


def kudlich_slibar(contact: Contact, mu: Number, e: Number) -> Planar:
    """(1 + e) times the impulse of compression, the sliding impact at the limit of friction."""
    across, along = _capped(contact, mu, -contact.approach)
    return Planar((1 + e) * across, (1 + e) * along, across)


def planar(contact: Contact, mu: Number, e: Number, law: str) -> Planar:
    """An impact by any of the laws."""
    if law == "brach":
        return brach(contact, mu, e)
    return kudlich_slibar(contact, mu, e) if law == "kudlich-slibar" else follow(contact, mu, e, law)
