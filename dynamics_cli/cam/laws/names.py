"""Names of rise laws, including those of VDI 2143 and of the trade."""

from dynamics_cli.records import Choice


class LawName(Choice):
    """A rise law."""

    names = (
        "linear",
        "parabolic",
        "cubic",
        "harmonic",
        "double-harmonic",
        "cycloidal",
        "modified-trapezoid",
        "modified-sine",
        "trapezoid",
        "3-4-5",
        "4-5-6-7",
        "5-6-7-8-9",
        "gutman-1-3",
        "freudenstein-1-3",
        "freudenstein-1-3-5",
        "modified-constant-velocity",
        "half-cycloid-start",
        "half-cycloid-end",
        "half-harmonic-start",
        "half-harmonic-end",
        "scca",
        "polynomial",
        "spline",
    )
    aliases = {  # noqa: RUF012
        "constant-velocity": "linear", "straight-line": "linear", "gerade": "linear",
        "uniform-velocity": "linear", "uniform-acceleration": "parabolic", "parabola": "parabolic",
        "quadratic-parabola": "parabolic", "constant-acceleration": "parabolic", "quadratische-parabel": "parabolic",
        "2-3": "cubic", "cubic-1": "cubic", "polynomial-2-3": "cubic", "poly3": "cubic",
        "simple-harmonic": "harmonic", "sinusoidal": "harmonic", "simple-sine": "harmonic", "shm": "harmonic",
        "sine": "harmonic", "sine-line": "harmonic", "einfache-sinuslinie": "harmonic",
        "cycloid": "cycloidal", "cyc": "cycloidal", "inclined-sine": "cycloidal", "inclined-sine-line": "cycloidal",
        "bestehorn": "cycloidal", "bestehorn-sinoid": "cycloidal", "geneigte-sinuslinie": "cycloidal",
        "modified-trapezoidal": "modified-trapezoid", "modified-acceleration-trapezoid": "modified-trapezoid",
        "modifiziertes-beschleunigungstrapez": "modified-trapezoid", "mt": "modified-trapezoid",
        "modified-sinusoidal": "modified-sine", "modifizierte-sinuslinie": "modified-sine", "ms": "modified-sine",
        "modsine": "modified-sine", "mod-sine": "modified-sine", "mod-trap": "modified-trapezoid",
        "trapezoidal": "trapezoid", "acceleration-trapezoid": "trapezoid",
        "beschleunigungstrapez": "trapezoid", "345": "3-4-5", "polynomial-3-4-5": "3-4-5", "poly345": "3-4-5",
        "poly5": "3-4-5", "5th-degree-polynomial": "3-4-5", "polynom-5.-grades": "3-4-5",
        "4567": "4-5-6-7", "polynomial-4-5-6-7": "4-5-6-7", "poly4567": "4-5-6-7", "poly7": "4-5-6-7",
        "polynom-7.-grades": "4-5-6-7", "56789": "5-6-7-8-9", "polynomial-5-6-7-8-9": "5-6-7-8-9", "poly9": "5-6-7-8-9",
        "gutman": "gutman-1-3", "freudenstein": "freudenstein-1-3", "mcv": "modified-constant-velocity",
        "mcv50": "modified-constant-velocity", "half-cycloid": "half-cycloid-start",
        "half-cycloidal": "half-cycloid-start", "half-harmonic": "half-harmonic-start", "poly": "polynomial",
    }  # fmt: skip
