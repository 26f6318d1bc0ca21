"""Formats of files in which roads come; each reader gives what the file itself says."""
