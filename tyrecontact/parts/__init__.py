"""The settings of a scenario, part by part; all values are SI.

`metadata["shown_in"]` is what a form shows instead.
"""
