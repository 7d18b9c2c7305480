"""The tasks of `dynamics skid`."""

from dynamics_cli.core.task import Family, Model, Task

BOOK = "Josephs & Huston, Dynamics of Mechanical Systems, section 10.10"

FAMILIES = {
    "skid": Family(
        "skid",
        "Speeds and distances from skids, yaw marks, vaults and braking.",
        Task(
            "speed",
            "Speed at the start of a skid over one or several surfaces.",
            Model(
                "work–energy",
                "dynamics_cli.skid.braking:speed",
                source=BOOK,
                formula="{speed|v} = √({end_speed|vₑ}² + 2·{gravity|g}·Σ {surfaces.drag_factor|f}·{distance|d})",
                assumptions=(
                    "every braked wheel slides the whole way",
                    "friction is constant on each surface",
                    "air drag is neglected",
                ),
            ),
            examples=('dynamics skid speed --distance "60 ft" --friction 0.7',),
        ),
    )
}
