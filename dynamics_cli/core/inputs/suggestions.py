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
    "slope": "grade",
    "incline": "grade",
    "efficiency": "braking isolation",
    "brake-efficiency": "braking",
    "skid-length": "distance",
    "length": "distance",
    "surface": "segment",
    "skid": "distance segment test-skid",
    "skid-marks": "distance segment",
    "mark": "distance radius",
    "speed-limit": "limit",
    "test": "test-skid",
    "speed": "velocity first-velocity",
    "v": "speed first-speed first-velocity",
    "velocity": "speed first-velocity approach-speed exit-speed",
    "initial-speed": "speed end-speed",
    "final-speed": "end-speed first-exit-speed",
    "delay": "reaction-time",
    "perception-time": "reaction-time",
    "limit-speed": "speed-limit",
    "visibility": "sight-distance",
    "throw": "throw-distance",
    "launch": "launch-angle take-off",
    "take-off-angle": "take-off",
    "angle": "take-off launch-angle pull-angle exit-heading",
    "exit-angle": "exit-heading",
    "approach-angle": "approach-heading",
    "departure-angle": "exit-heading",
    "entry-speed": "approach-speed",
    "impact-speed": "approach-speed speed",
    "post-impact-speed": "exit-speed",
    "drop": "rise height",
    "bank": "superelevation",
    "camber": "superelevation",
    "track": "track-width",
    "sagitta": "middle-ordinate",
    "force": "pull load",
    "m": "mass module",
    "e": "restitution",
    "cor": "restitution",
    "m1": "first-mass",
    "m2": "second-mass",
    "v1": "first-velocity first-speed first-approach-speed",
    "v2": "second-velocity second-speed second-approach-speed",
    "heading": "first-heading first-approach-heading",
    "ratio": "target",
    "held": "fixed",
    "input": "driver",
    "output": "driven",
    "z": "teeth first-teeth",
    "z1": "first-teeth",
    "z2": "second-teeth",
    "x1": "first-profile-shift",
    "x2": "second-profile-shift",
    "mn": "module",
    "pitch": "module diametral-pitch circular-pitch",
    "dp": "diametral-pitch",
    "alpha": "pressure-angle",
    "beta": "helix-angle",
    "a": "centre-distance",
    "center-distance": "centre-distance",
    "shift": "profile-shift first-profile-shift",
    "width": "face-width thickness",
    "bore": "thickness",
    "inner-radius": "thickness ring-radius",
    "inner-diameter": "thickness",
    "wall": "thickness",
    "wall-thickness": "thickness",
    "outer-radius": "radius",
    "diameter": "radius first-diameter base-radius worm-diameter tip-diameter",
    "radius": "base-radius first-radius wheel-radius",
    "pin-diameter": "pin over",
    "ball-diameter": "pin over",
    "max-pressure-angle": "rise-limit return-limit",
    "tolerance": "distance-tolerance points",
    "rpm": "speed shaft-speed",
    "stroke": "lift",
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
    "c": "damping",
    "zeta": "damping-ratio",
    "r": "radius",
    "l": "length",
    "h": "height",
    "theta": "angle crank-angle",
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
    "moi": "inertia first-inertia",
    "moment-of-inertia": "inertia first-inertia",
    "omega": "angular-velocity shaft-speed speed",
    "alpha-acceleration": "angular-acceleration",
    "shape": "part",
    "json-file": "input",
    "file": "input output",
    "csv": "rows format",
    "run": "initial first second",
    "reading": "initial first second",
    "trial-weight": "first-trial-mass",
    "peak": "base-acceleration",
    "peak-acceleration": "base-acceleration",
    "trial-mass": "first-trial-mass",
    "trial-angle": "first-trial-angle",
    "trial-radius": "trial-radius first-trial-radius",
    "unit": "units to",
    "precision": "digits",
    "verbose": "all explain",
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
    """What to add to a suggestion of radii where a diameter was typed."""
    return ", half of it, as in 60/2 mm" if "diameter" in typed and all("radius" in name for name in near) else ""
