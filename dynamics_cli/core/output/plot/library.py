"""Matplotlib, which the modules of this package alone import: how to get it, its settings, and an empty figure."""

import os

from dynamics_cli.errors import UsageError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_SETTINGS = {
    "svg.hashsalt": "dynamics",
    "svg.fonttype": "path",
    "pdf.compression": 6,
    "font.family": "DejaVu Sans",
    "font.size": 9.0,
    "axes.titlesize": 9.5,
    "axes.grid": True,
    "grid.linewidth": 0.4,
    "grid.color": "#cccccc",
    "axes.axisbelow": True,
    "legend.frameon": False,
    "legend.fontsize": 8.0,
    "legend.handlelength": 3.2,
    "axes.spines.top": False,
    "axes.spines.right": False,
    # An axis with an offset in small print at its end is misread.
    "axes.formatter.useoffset": False,
}
# No dates and no version of a library, so that a file depends on its numbers alone.
ABOUT: "dict[str, dict[str, Any]]" = {
    "svg": {"Date": None, "Creator": "dynamics"},
    "png": {"Software": "dynamics"},
    "pdf": {"CreationDate": None, "Creator": "dynamics", "Producer": "dynamics"},
}


def need() -> "Any":
    """The library, or how to get it."""
    # No window is opened: a backend that the environment names is not used, and need not exist.
    named = os.environ.pop("MPLBACKEND", None)
    try:
        import matplotlib
    except ImportError:
        raise UsageError(
            "pictures in files need a part that is not installed",
            code="not-installed",
            parameter="plot",
            hint="pip install 'dynamics-cli[plot]'; --plot - needs nothing",
        ) from None
    except Exception as error:
        raise UsageError(
            f"matplotlib does not start: {error}", parameter="plot", hint="its own settings file may be at fault"
        ) from None
    finally:
        if named is not None:
            os.environ["MPLBACKEND"] = named
    return matplotlib


def part(name: str) -> "Any":
    """A module of the library."""
    from importlib import import_module

    return import_module(f"matplotlib.{name}")


def settle(matplotlib: "Any") -> None:
    """The settings of every picture, independent of the user's matplotlib settings."""
    matplotlib.rcdefaults()
    matplotlib.rcParams.update(_SETTINGS)


def blank(width: float, height: float, **more: "Any") -> "Any":
    """A figure of that size in inches."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), **more)
    FigureCanvasAgg(figure)
    return figure
