# The page as a service: `docker build -t tyrecontact . && docker run -p 5006:5006 tyrecontact`
FROM python:3.12-slim

ENV PYTHONUNBUFFERED=1 PIP_NO_CACHE_DIR=1 OPENBLAS_NUM_THREADS=1
WORKDIR /srv/tyrecontact

# what changes least comes first: an edit of the package does not install its dependencies again
COPY tests/constraints.txt pyproject.toml README.md ./
RUN mkdir -p tyrecontact && touch tyrecontact/__init__.py && pip install -c constraints.txt ".[app,fast]"

COPY tyrecontact tyrecontact
COPY app app
RUN pip install --no-deps --force-reinstall .

RUN useradd --create-home --uid 10001 tyrecontact
USER tyrecontact
# the kernels of the presets and the compiled loops are ready before the first visitor comes
RUN tyrecontact run default --json && tyrecontact run thesis-instability --json && tyrecontact run quasi-static --json

EXPOSE 5006
# an address other than localhost has to be named: -e BOKEH_ALLOW_WS_ORIGIN=contact.example.org
ENV BOKEH_ALLOW_WS_ORIGIN=localhost:5006
# what one visitor may take of a public server; each can be set anew with -e, and left out with ""
ENV TYRECONTACT_MAX_SESSIONS=40 TYRECONTACT_MAX_RUNS=2 TYRECONTACT_MAX_STEPS=100000 TYRECONTACT_MAX_ELEMENTS=64 TYRECONTACT_MAX_SECONDS=600 TYRECONTACT_MAX_UPLOAD=100
HEALTHCHECK --interval=30s --timeout=5s --start-period=20s \
  CMD ["python", "-c", "import urllib.request as u; u.urlopen('http://localhost:5006/liveness', timeout=4)"]
CMD ["panel", "serve", "app", "--address", "0.0.0.0", "--port", "5006", "--liveness"]
