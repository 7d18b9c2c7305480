"""Robot arms: pose, Jacobian, inverse kinematics, joint torques."""
