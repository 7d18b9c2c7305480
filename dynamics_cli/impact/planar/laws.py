"""Laws of planar impact by name: ends of the Routh–Keller path, Brach's impulse ratio, Kudlich–Slibar.

Each gives an `Outcome` in the contact's frame (see `path`), or the reason why it has no answer. Sources: Keller (1986),
Stronge, Impact Mechanics (2000); Brach & Brach, Vehicle Accident Analysis and Reconstruction Methods (2011); Kudlich
(1966), Slibar.
"""

from dynamics_cli.impact.planar.path import Mobility, determinant, sign, travel
from dynamics_cli.numerics.elementary import absolute, multiply_add, where
from dynamics_cli.numerics.number import decides
from dynamics_cli.quantities import Annotated
from dynamics_cli.records import Choice, record

LAWS = ("stronge", "newton", "poisson", "brach", "kudlich-slibar")
ON_THE_PATH = ("stronge", "newton", "poisson")
# Limit of an energy gain by rounding, relative to the work of compression.
GAIN = 1e-12


class Law(Choice):
    """The law that ends an impact; the default is Stronge's energetic restitution, which never gains energy.

    stronge: the normal force returns e² of its work. newton: u_n' = −e u_n. poisson: p_n = (1 + e) p_c.
    brach: u_n' = −e u_n and an impulse ratio up to μ. kudlich-slibar: (1 + e) times the compression impulse. all: each.
    """

    names = (*LAWS, "all")
    aliases = {  # noqa: RUF012
        "energetic": "stronge",
        "kinematic": "newton",
        "kinetic": "poisson",
        "impulse-ratio": "brach",
        "pim": "brach",
        "kudlich": "kudlich-slibar",
        "slibar": "kudlich-slibar",
    }


LAW = Law("stronge")


@record
class Meeting:
    """Velocities and mobility at the contact, in its frame."""

    mobility: Annotated[Mobility, "K."]
    slip: Annotated[float, "u_t before [m/s]."]
    approach: Annotated[float, "u_n before, negative [m/s]."]
    friction: Annotated[float, "μ [-]."]
    restitution: Annotated[float, "e [-]."]
    turning: Annotated[float, "Relative spin before [rad/s]."]
    moment_restitution: Annotated[
        float, "Share of the moment impulse that is absent; 1 for a contact without moment [-]."
    ]
    compliance: Annotated[float, "1/J₁ + 1/J₂ [1/(kg·m²)]."]
    arms: Annotated[tuple[float, float], "Relative spin per tangential and per normal impulse [1/(kg·m)]."]


@record
class Outcome:
    """An impact by one law, in the contact's own frame."""

    normal: Annotated[float, "Impulse on body 1 [N·s]."]
    tangential: Annotated[float, "Impulse on body 1 [N·s]."]
    moment: Annotated[float | None, "Moment impulse at the contact on body 1; None without [N·m·s]."]
    normal_after: Annotated[float, "Relative velocity after [m/s]."]
    tangential_after: Annotated[float, "Relative velocity after [m/s]."]
    normal_lost: Annotated[float, "Energy lost to the normal and to the tangential impulse [J]."]
    tangential_lost: Annotated[float, "Energy lost to the normal and to the tangential impulse [J]."]
    moment_lost: Annotated[float | None, "Energy lost to the moment impulse [J]."]
    first_slip: Annotated[
        float | None, "Normal impulse until the first slip stopped; None where a law knows no path [N·s]."
    ]
    compression: Annotated[
        float | None, "Normal impulse at the greatest compression; None where a law knows none [N·s]."
    ]
    compression_work: Annotated[float | None, "Work of the normal force until then; None where a law knows none [J]."]
    scale: Annotated[float, "The energy that losses are compared with [J]."]
    history: Annotated[str, "Slip in words; empty for arrays."]
    feasible: Annotated[bool, "Whether the law gives a compressive impulse."]
    why: Annotated[str, "Why not."] = "the law does not push the bodies apart"

    @property
    def lost(self) -> float:
        """Energy lost in all."""
        total = self.normal_lost + self.tangential_lost
        return total if self.moment_lost is None else total + self.moment_lost

    @property
    def gains(self) -> bool:
        """Whether the law gains energy."""
        return self.lost < -GAIN * self.scale


def outcome(meeting: Meeting, law: str) -> Outcome:
    """The impact by one law."""
    if law in ON_THE_PATH:
        return _on_the_path(meeting, law)
    return _brach(meeting) if law == "brach" else _kudlich_slibar(meeting)


def critical_ratio(meeting: Meeting) -> tuple[float, float]:
    """Numerator and denominator of Brach's critical impulse ratio: p_t and p_n, times det K, that stop the slip.

    μ_c = [k_x (1 + e) u_n − k_n u_t]/[k_x u_t − k_t (1 + e) u_n].
    """
    k = meeting.mobility
    rise = -(1.0 + meeting.restitution) * meeting.approach
    return _pair(k, -meeting.slip, rise)


def _pair(k: Mobility, tangential: float, normal: float) -> tuple[float, float]:
    """Det K times the impulse that changes the relative velocity by (tangential, normal)."""
    along = multiply_add(k.normal, tangential, -(k.coupling * normal))
    across = multiply_add(k.tangential, normal, -(k.coupling * tangential))
    return along, across


def _on_the_path(m: Meeting, law: str) -> Outcome:
    path = travel(m.mobility, m.slip, m.approach, m.friction, m.restitution, law)
    history = ""
    if decides(path.normal):
        history = _history(m, bool(path.ended_first), bool(path.sticks))
    return Outcome(
        normal=path.normal,
        tangential=path.tangential,
        moment=None,
        normal_after=path.normal_after,
        tangential_after=path.tangential_after,
        normal_lost=_lost(path.normal_lost, m.restitution, path.compression_work, path.ended_first, law),
        tangential_lost=path.friction_work,
        moment_lost=None,
        first_slip=path.first_slip,
        compression=path.compression,
        compression_work=path.compression_work,
        scale=path.compression_work + path.friction_work,
        history=history,
        feasible=path.normal > 0.0,
    )


def _lost(difference: float, restitution: float, work: float, ended: bool, law: str) -> float:
    """(1 − e²)|W| where the path gives that, else the difference of work done and work returned."""
    lost = (1.0 - restitution) * (1.0 + restitution) * work
    return lost if law == "stronge" else where(ended, lost, difference)


def _history(m: Meeting, ended: bool, sticks: bool) -> str:
    if m.friction == 0.0:
        return "slip without friction"
    if m.slip == 0.0:
        return "stick" if sticks else "slip from rest"
    if ended:
        return "slip"
    return "slip, stick" if sticks else "slip, reversed slip"


def _capped(
    k: Mobility, det: float, tangential: float, normal: float, friction: float
) -> tuple[float, float, bool, bool]:
    """Impulse of a velocity change (tangential, normal), its ratio capped at μ with its sign kept; whether it stuck."""
    along, across = _pair(k, tangential, normal)
    holds = (absolute(along) <= friction * across) & (across > 0.0)
    ratio = friction * where(sign(along) == 0.0, 1.0, sign(along)) * where(across < 0.0, -1.0, 1.0)
    stiff = multiply_add(ratio, k.coupling, k.normal)
    pushes = holds | (stiff > 0.0)
    slid = normal / where(pushes & (stiff > 0.0), stiff, 1.0)
    return where(holds, along / det, ratio * slid), where(holds, across / det, slid), pushes, holds


def _brach(m: Meeting) -> Outcome:
    """Brach's planar impact mechanics, with his moment of restitution in the form (1 − e_m)·Δω' + e_m·(1/J)·M = 0."""
    k, det = m.mobility, m.mobility.determinant
    free = 1.0 - m.moment_restitution
    tangential, normal = -m.slip, -(1.0 + m.restitution) * m.approach
    with_moment = not decides(free) or bool(free != 0.0)
    if with_moment:
        drop = free / m.compliance
        bt, bn = m.arms
        k = Mobility(
            k.tangential - drop * bt * bt, k.coupling - drop * bt * bn, k.normal - drop * bn * bn, determinant=0.0
        )
        det = determinant(k.tangential, k.coupling, k.normal)
        tangential = tangential + drop * bt * m.turning
        normal = normal + drop * bn * m.turning
    along, across, pushes, holds = _capped(k, det, tangential, normal, m.friction)
    moment: float | None = None
    moment_lost: float | None = None
    drift = multiply_add(m.mobility.tangential, along, m.slip) + m.mobility.coupling * across
    if with_moment:
        kick = m.turning + (bt * along + bn * across)
        moment = -drop * kick
        drift = drift + bt * moment
        moment_lost = -0.5 * moment * (m.turning + kick + m.compliance * moment)
    drift = where(holds, 0.0, drift)
    half = 0.5 * across * -m.approach
    return Outcome(
        normal=across,
        tangential=along,
        moment=moment,
        normal_after=-m.restitution * m.approach,
        tangential_after=drift,
        normal_lost=(1.0 - m.restitution) * half,
        tangential_lost=-0.5 * along * (m.slip + drift),
        moment_lost=moment_lost,
        first_slip=None,
        compression=None,
        compression_work=None,
        scale=half + absolute(along * m.slip),
        history=_ratio_words(holds),
        feasible=pushes & (across > 0.0),
        why="the impulse ratio leaves no compressive impulse between the bodies",
    )


def _kudlich_slibar(m: Meeting) -> Outcome:
    """Full impact where friction can hold the contact at the end of compression, else sliding impact at its limit."""
    k = m.mobility
    along, across, pushes, holds = _capped(k, k.determinant, -m.slip, -m.approach, m.friction)
    grown = 1.0 + m.restitution
    normal, tangential = grown * across, grown * along
    after = where(holds, -m.restitution * m.slip, multiply_add(k.tangential, tangential, m.slip) + k.coupling * normal)
    risen = -m.restitution * m.approach
    return Outcome(
        normal=normal,
        tangential=tangential,
        moment=None,
        normal_after=risen,
        tangential_after=after,
        normal_lost=(1.0 - m.restitution) * 0.5 * normal * -m.approach,
        tangential_lost=-0.5 * tangential * (m.slip + after),
        moment_lost=None,
        first_slip=None,
        compression=across,
        compression_work=None,
        scale=0.5 * normal * -m.approach + absolute(tangential * m.slip),
        history=_ratio_words(holds),
        feasible=pushes & (across > 0.0),
        why="the compression impulse does not push the bodies apart",
    )


def _ratio_words(holds: bool) -> str:
    if not decides(holds):
        return ""
    return "common tangential velocity" if holds else "slip at the limit of friction"
