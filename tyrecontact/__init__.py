"""Rubber tread blocks on rough roads: small-scale dynamic contact with adhesion.

>>> import tyrecontact as tc
>>> results = tc.Simulation(tc.presets.get("default")).run()
>>> results.to_xarray().to_netcdf("run.nc")
"""

from importlib.metadata import version

from tyrecontact import presets
from tyrecontact.results import Results
from tyrecontact.scenario import Scenario
from tyrecontact.simulation import Simulation

__all__ = ["Results", "Scenario", "Simulation", "presets"]
__version__ = version("tyrecontact")
