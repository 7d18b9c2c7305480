"""The program's own methods whose references are in other words than their tasks' results."""

from typing import Any

from dynamics_cli.accuracy.cases import flat


class Stated(dict):  # type: ignore[type-arg]
    """Results by address, with the bounds that a task states for them."""

    numerics: "Any" = None


def pair(*, tips: str, **given: "Any") -> "dict[str, Any]":
    """A pair of gears, the results under the names of its references."""
    from dynamics_cli.gear.pair.pair import pair as own
    from dynamics_cli.gear.pair.shift_split import Tips

    answer = own(tips=Tips(tips), **given)
    results = flat(answer)
    results["nominal"] = answer.nominal_contact_ratio or answer.transverse_contact_ratio
    results["margin"] = answer.verdicts[0].margin
    if answer.nominal_contact_ratio is None:
        # where root form circles cut the path, its ends are not those of the tips
        results["first_sliding_at_start"] = answer.points[0].first_sliding
        results["second_sliding_at_end"] = answer.points[-1].second_sliding
    return results


def measure(*, module: float, internal: bool, helix_angle: float, **given: "Any") -> "Any":
    """Sizes over teeth and over pins; an internal helical gear has no span."""
    from dynamics_cli.gear.measure.measurement import measure as own
    from dynamics_cli.gear.pitch import NormalModule

    if internal and helix_angle:
        given.pop("over")
    return own(pitch=NormalModule(module), internal=internal, helix_angle=helix_angle, **given)


def mesh(**given: "Any") -> Stated:
    """The proof of a mesh; points of contact by their number in place of whole columns."""
    from dynamics_cli.gear.mesh.mesh import mesh as own
    from dynamics_cli.records import ErrorBound, Numerics

    answer = own(**given)
    assert answer.numerics is not None
    made = Stated({name: value for name, value in flat(answer).items() if name != "path"})
    bounds = []
    for bound in answer.numerics.bounds:
        _, _, column = bound.result.partition("path.")
        if not column:
            bounds.append(bound)
            continue
        for index, value in enumerate(answer.path.arrays[column]):
            address = f"{bound.result}[{index}]"
            made[address] = float(value)
            bounds.append(ErrorBound(address, bound.bound, bound.relative))
    made.numerics = Numerics("", tuple(bounds))
    return made


def data_block(**given: "Any") -> Stated:
    """The rows of a data block as numbers, by their symbols."""
    from dynamics_cli.gear.measure.data_block import data_block as own
    from dynamics_cli.records import ErrorBound, Numerics

    answer = own(**given)
    assert answer.numerics is not None
    bounds = {bound.result: bound for bound in answer.numerics.bounds}
    stated, kept = Stated(), []
    for index, row in enumerate(answer.rows):
        bound = bounds.get(f"rows[{index}].data")
        if bound is not None:
            stated[row.symbol] = float(row.data)
            kept.append(ErrorBound(row.symbol, bound.bound, bound.relative))
    stated.numerics = Numerics("", tuple(kept))
    return stated
