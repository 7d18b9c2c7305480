"""The skid tasks by name, and the records that their inputs are made of."""

from dynamics_cli.skid import avoid, braking, drag, friction, pedestrian, spin, stop, vault, yaw

TASKS = {
    "speed": braking.speed,
    "distance": braking.distance,
    "friction": friction.friction,
    "drag_factor": drag.drag_factor,
    "stop": stop.stop,
    "yaw": yaw.yaw,
    "vault_least_speed": vault.vault_least_speed,
    "vault_known_angle": vault.vault_known_angle,
    "pedestrian": pedestrian.pedestrian,
    "avoid": avoid.avoid,
    "spin": spin.spin,
}
GROUPS: dict[str, type] = {
    "segments": braking.Segment,
    "skids": friction.TestSkid,
    "Surface": drag.Surface,
    "Axles": drag.Axles,
    "Sled": drag.Sled,
    "Radius": yaw.Radius,
    "Chord": yaw.Chord,
    "Rotation": spin.Rotation,
    "Share": spin.Share,
}
