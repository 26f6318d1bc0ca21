"""Views: each has a `root` to look at, a `reset` for a new run and an `update` for new rows."""
