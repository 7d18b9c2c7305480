"""Probable meaning of an unknown name: a name that it abbreviates, a synonym, or the nearest spelling."""

from dynamics_cli.core.units.near_names import nearest_words

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

# Other names of a parameter, and its names here; those that a task has are offered.
SYNONYMS = {
    "mu": "friction",
    "f": "friction",
    "coefficient-of-friction": "friction",
    "drag": "friction rolling-drag",
    "slope": "grade angle",
    "incline": "grade angle",
    "efficiency": "braking isolation",
    "brake-efficiency": "braking",
    "skid-length": "distance",
    "length": "distance",
    "surface": "segment",
    "skid": "distance segment test-skid",
    "skid-marks": "distance segment",
    "mark": "distance radius",
    "speed-limit": "limit",
    "speed": "velocity first-velocity rotation start-speed",
    "v": "speed first-speed first-velocity",
    "velocity": "speed first-velocity approach-speed exit-speed",
    "initial-speed": "speed end-speed start-speed",
    "final-speed": "end-speed first-exit-speed",
    "delay": "reaction-time",
    "prt": "reaction-time",
    "limit-speed": "speed-limit",
    "visibility": "sight-distance",
    "drag-factor": "friction rolling-drag",
    "launch": "launch-angle take-off",
    "angle": "take-off launch-angle pull-angle exit-heading elevation tilt lean",
    "exit-angle": "exit-heading",
    "approach-angle": "approach-heading",
    "departure-angle": "exit-heading",
    "entry-speed": "approach-speed",
    "impact-speed": "approach-speed speed end-speed",
    "post-impact-speed": "exit-speed",
    "drop": "rise height",
    "bank": "superelevation",
    "camber": "superelevation",
    "sagitta": "middle-ordinate",
    "force": "pull load load-force",
    "m": "mass module",
    "e": "restitution",
    "cor": "restitution",
    "v1": "first-velocity first-speed first-approach-speed",
    "v2": "second-velocity second-speed second-approach-speed",
    "heading": "first-heading first-approach-heading",
    "ratio": "target",
    "held": "fixed",
    "input": "driver crank",
    "output": "driven rocker",
    "ixx": "moments tensor",
    "iyy": "moments tensor",
    "izz": "moments tensor",
    "ixy": "products tensor",
    "ixz": "products tensor",
    "iyz": "products tensor",
    "iyx": "products tensor",
    "izx": "products tensor",
    "izy": "products tensor",
    "z": "teeth first-teeth",
    "x1": "first-profile-shift",
    "x2": "second-profile-shift",
    "mn": "module",
    "od": "diameter",
    "outside-diameter": "tip-diameter",
    "outer-diameter": "diameter",
    "starts": "threads",
    "q": "diameter-factor",
    "pd": "diametral-pitch",
    "pitch": "module diametral-pitch circular-pitch euler-angles",
    "dp": "diametral-pitch",
    "alpha": "pressure-angle",
    "beta": "helix-angle",
    "a": "centre-distance stiffness-a crank acceleration",
    "b": "stiffness-b coupler rod",
    "center-distance": "centre-distance",
    "shift": "profile-shift first-profile-shift",
    "width": "face-width thickness",
    "bore": "inner-diameter thickness",
    "id": "inner-diameter",
    "d": "diameter distance ground",
    "af": "across-flats",
    "inner-radius": "thickness ring-radius",
    "inner-diameter": "thickness",
    "wall": "thickness",
    "outer-radius": "radius",
    "diameter": "radius first-diameter base-radius worm-diameter tip-diameter",
    "radius": "base-radius first-radius wheel-radius",
    "pin-diameter": "pin over",
    "ball-diameter": "pin over",
    "max-pressure-angle": "rise-limit return-limit",
    "tolerance": "distance-tolerance points",
    "rpm": "speed shaft-speed",
    "stroke": "lift crank",
    "base-circle": "base-radius",
    "base-circle-radius": "base-radius",
    "base-diameter": "base-radius",
    "roller-diameter": "roller-radius",
    "law": "program",
    "dwell": "program",
    "beta-angle": "span",
    "rise": "lift program",
    "stiffness": "spring-rate contact-stiffness",
    "spring": "stiffness spring-rate",
    "spring-constant": "stiffness spring-rate",
    "k": "stiffness spring-rate",
    "c": "damping rocker",
    "zeta": "damping-ratio",
    "r": "radius",
    "l": "length",
    "h": "height",
    "theta": "angle crank-angle exit-heading",
    "phi": "exit-heading",
    "psi": "approach-heading",
    "u": "exit-speed start-speed",
    "w": "weight",
    "crush": "stations mean-crush",
    "friction": "drag-factor",
    "offset": "lateral-shift",
    "shift-distance": "lateral-shift",
    "noise": "sigma",
    "sd": "sigma",
    "std": "sigma",
    "standard-deviation": "sigma",
    "direction": "along from-direction",
    "plane": "normal",
    "connecting-rod": "rod coupler",
    "frame": "ground",
    "follower": "rocker",
    "phase": "angle",
    "moi": "inertia first-inertia axial",
    "moment-of-inertia": "inertia first-inertia",
    "omega": "angular-velocity shaft-speed speed",
    "alpha-acceleration": "angular-acceleration",
    "shape": "part form wheel",
    "json-file": "input",
    "file": "survey input output",
    "csv": "rows format",
    "run": "initial first second",
    "reading": "initial first second",
    "trial-weight": "first-trial-mass",
    "trial-mass": "first-trial-mass",
    "grade": "slope angle",
    "weight": "mass load",
    "range": "target distance",
    "rotation": "speed precession",
    "body": "wheel form",
    "tensor": "moments",
    "inertia": "axial first-inertia central-inertia",
    "displacement": "distance",
    "damping-ratio": "damping",
    "tilt": "lean angle",
    "lever": "at",
    "deflection": "length",
    "rolling": "rolling-resistance",
    "first-mass": "mass",
    "second-mass": "other-mass",
    "unit": "units to",
    "precision": "digits",
    "verbose": "all explain",
    "theta2": "crank-angle",
    "omega2": "speed",
    "alpha2": "angular-acceleration",
    "s": "distance",
    "r-dot": "radial-speed",
    "theta-dot": "angular-velocity",
    "r-ddot": "radial-speed-rate",
    "theta-ddot": "angular-acceleration",
    "rpy": "yaw pitch roll",
    "yaw": "euler-angles",
    "roll": "euler-angles",
    "yaw-rate": "angle-rates",
    "rotvec": "rotation-vector",
    "piston-force": "load-force",
    "driver": "crank",
    "driven": "rocker",
    "peak": "base-acceleration",
    "peak-acceleration": "base-acceleration",
    "trial-angle": "first-trial-angle",
    "trial-radius": "first-trial-radius",
}
MOST = 3
BODIES = {"first-": "1", "second-": "2"}


def _meant(word: str) -> "list[str]":
    """The synonyms of a word; of a body's parameter, `first-exit-angle` or `speed1`, the synonyms of the parameter."""
    synonyms = SYNONYMS.get(word, "").split()
    for body, digit in BODIES.items():
        if word.startswith(body) or word.endswith(digit):
            parameter = word.removeprefix(body).removesuffix(digit).rstrip("-")
            synonyms += [f"{body}{name}" for name in (parameter, *SYNONYMS.get(parameter, "").split())]
    return list(dict.fromkeys(synonyms))


def suggestions(typed: str, known: "Iterable[str]") -> "list[str]":
    """Up to three known names that a typed one may mean.

    In order: a prefix of a single name together with synonyms, synonyms alone, other prefixes,
    endings, the nearest spelling.
    """
    plain = {name.replace("_", "-"): name for name in known}
    word = typed.lower().replace("_", "-")
    begun = [name for name in plain if name.startswith(word)]
    meant = [name for name in _meant(word) if name in plain]
    if len(begun) == 1:
        return [plain[name] for name in dict.fromkeys([*meant, *begun])][:MOST]
    ended = [name for name in plain if name.endswith(f"-{word}")]
    near = meant or begun or ended or nearest_words(word, plain)
    return [plain[name] for name in near[:MOST]]


def halved(typed: str, near: "Iterable[str]") -> str:
    """What to add where a diameter was typed for a radius, or a stroke for a crank."""
    doubled = {"diameter": "radius", "stroke": "crank"}
    halves = any(word in typed and all(half in name for name in near) for word, half in doubled.items())
    return ", half of it, as in 60/2 mm" if halves else ""
