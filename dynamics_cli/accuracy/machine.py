"""The machine that times were measured on, and other people's libraries that are installed on it."""

from dynamics_cli.quantities import Annotated, Text
from dynamics_cli.records import record

# Peers are imported under these names; what their authors call the package, where that is another name.
PACKAGES = {"py_gearworks": "py-gearworks"}


@record
class Machine:
    """What times depend on."""

    processor: Annotated[Text, "Name of the processor."]
    system: Annotated[Text, "Operating system and architecture."]
    python: Annotated[Text, "The interpreter and its version."]
    numpy: Annotated[Text, "The version of numpy."]


@record
class Peer:
    """Another library that answers some of the questions asked."""

    name: Annotated[Text, "Import name of the library."]
    version: Annotated[
        Text,
        'Its version where it is installed, "" where it is not, and why not where it is there but cannot be imported.',
    ]
    installed: Annotated[bool, "Whether it was measured."]


def this_machine() -> Machine:
    """The machine that this process runs on."""
    import platform

    import numpy as np

    system = f"{platform.system()} {platform.machine()}".strip()
    python = f"{platform.python_implementation()} {platform.python_version()}"
    return Machine(_processor() or platform.processor() or platform.machine(), system, python, np.__version__)


def whole_call() -> float:
    """The time of one whole call of the program, as a shell starts it: the median of three."""
    import subprocess
    import sys
    from statistics import median
    from time import perf_counter

    times = []
    for _ in range(3):
        start = perf_counter()
        call = [sys.executable, "-m", "dynamics_cli", "skid", "speed", "--distance", "20 m", "--friction", "0.7"]
        subprocess.run(call, check=False, capture_output=True)
        times.append(perf_counter() - start)
    return median(times)


def _processor() -> str:
    """What Linux says of the processor; elsewhere Python knows."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8", errors="replace") as file:
            names = [line.partition(":")[2].strip() for line in file if line.startswith("model name")]
    except OSError:
        return ""
    return names[0] if names else ""


def peer(name: str) -> Peer:
    """A library looked for: one that is there but cannot be imported is as good as none."""
    from contextlib import redirect_stdout
    from importlib import import_module, metadata
    from io import StringIO

    try:
        # some print when they are imported
        with redirect_stdout(StringIO()):
            import_module(name)
    except ImportError as error:
        missing = isinstance(error, ModuleNotFoundError) and error.name == name
        return Peer(name, "" if missing else f"not importable: {error}", installed=False)
    except Exception as error:
        return Peer(name, f"not importable: {error}", installed=False)
    try:
        return Peer(name, metadata.version(PACKAGES.get(name, name)), installed=True)
    except metadata.PackageNotFoundError:
        return Peer(name, "unknown", installed=True)
