"""The road: its heights, and the roughness springs that stand for its small scale."""
