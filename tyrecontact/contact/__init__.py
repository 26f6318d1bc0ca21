"""What happens between road and tread: one time step, and the memory between steps."""
