"""Entry of `panel serve app`: builds the page of one visitor."""

import sys

from .page import build

# the solver shares the interpreter with the page: let clicks be answered between its steps
sys.setswitchinterval(0.001)

build().servable()
