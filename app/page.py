"""The page of one visitor: layout, wiring, and the only clock."""

from __future__ import annotations

from typing import Any

import panel as pn
import panel_material_ui as pmui

from tyrecontact import presets

from .controls import Controls
from .runner import Run
from .views.contact_map import ContactMapView
from .views.force import ForceView
from .views.headline import HeadlineView
from .views.iterations import IterationsView
from .views.style import horizontal

#: milliseconds between two looks at what the solver has left
FRAME = 50
#: milliseconds from a change of what a plot shows until a long run is drawn in full there
_LOOK = 200
#: label -> least duration of a run [s]
PACES = {"as fast as it can": 0.0, "in about 6 s": 6.0, "in about 20 s": 20.0}

_BAR = {"MuiAppBar": {"styleOverrides": {"root": {"backgroundColor": "#0B3F5E", "color": "#fff"}}}}
_THEME = {
    "light": {"palette": {"primary": {"main": "#0B5C8A"}}, "components": _BAR},
    "dark": {"palette": {"primary": {"main": "#6CB8E6"}}, "components": _BAR},
}


def build() -> pmui.Page:
    """The page, wired; it starts no thread until Run is pressed."""
    return Session().root


class Session:
    """What one visitor sees and does.

    Attributes
    ----------
    controls, headline, force, iterations, contact_map : the form and the views.
    run : the run on show, or None before the first.
    root : the page.
    """

    def __init__(self) -> None:
        self.run: Run | None = None
        self._drawn = 0
        self._prepared = False
        self.headline = HeadlineView()
        self.force, self.iterations = ForceView(), IterationsView()
        self.contact_map = ContactMapView()
        self.controls = Controls(self.headline.refuse, self.headline.accept)
        self._make_header()
        self.root = self._layout()
        self._document = pn.state.curdoc  # None where there is no browser, as in tests
        self._clock: Any = None
        self._looking = False
        for view in (self.force, self.iterations):
            view.root.x_range.on_change("start", self._look_soon)
            view.root.x_range.on_change("end", self._look_soon)
        pn.state.on_session_destroyed(lambda _: self.close())

    def start(self) -> None:
        """Run the scenario of the form; it supersedes a run that is under way."""
        self.run = Run(self.controls.scenario, PACES[self.pace.value], after=self.run)
        self._drawn, self._prepared = 0, False
        self._clear_views()
        self.progress.value = 0
        self.stop_button.disabled = False
        self.run.start()
        self.headline.accept()
        self.headline.update(self.run)
        self._start_clock()

    def stop(self) -> None:
        """End the run before its next step; what was computed stays."""
        if self.run is not None:
            self.run.stop()

    def close(self) -> None:
        """The visitor has left."""
        self.stop()
        self.run = None
        self.controls.road_file.close()

    def frame(self) -> None:
        """Show what the solver has left since the last frame."""
        try:
            self._show()
        except Exception:
            self._stop_clock()
            self.stop()
            self.headline.refuse("this run could not be drawn to its end")
            raise

    def _show(self) -> None:
        run = self.run
        if run is None:
            return
        ended = run.phase.ended  # read before the rows: then no row comes after it
        if run.simulation is not None and not self._prepared:
            self._prepare_views(run)
        if self._prepared:
            self._draw(run, ended)
        self.headline.update(run)
        if ended:
            self._stop_clock()
            self.stop_button.disabled = True

    def _start_clock(self) -> None:
        # Bokeh's own: Panel's counts every tick as the page being busy, and tells the page
        if self._clock is None and self._document is not None:
            self._clock = self._document.add_periodic_callback(self.frame, FRAME)

    def _stop_clock(self) -> None:
        if self._clock is not None:
            self._document.remove_periodic_callback(self._clock)
            self._clock = None

    def _prepare_views(self, run: Run) -> None:
        assert run.simulation is not None
        assert run.baseline is not None
        road = run.scenario.road
        self.force.compare_with(run.baseline)
        self.contact_map.reset(road.size, road.elements, run.baseline.peak_element_force)
        self._prepared = True
        self._choose_axis()

    def _clear_views(self) -> None:
        assert self.run is not None
        self.force.reset()
        self.iterations.reset(self.run.scenario.numerics.max_iterations)
        self.contact_map.clear()

    def _draw(self, run: Run, ended: bool) -> None:
        assert run.simulation is not None
        assert run.record is not None
        low, high = self._drawn, run.record.count
        if high == 0 or (high == low and not ended):
            return
        self.force.update(run.record, low, high, ended)
        self.iterations.update(run.record, low, high, ended)
        self.contact_map.show(run.record, high - 1, run.simulation.kernel.spacing)
        self.progress.value = round(100 * high / len(run.simulation))
        self._drawn = high

    def _look_soon(self, _attribute: str, _old: Any, _new: Any) -> None:
        """A plot shows another range; not every pixel of a drag is worth an answer."""
        if self._document is not None and not self._looking:
            self._looking = True
            self._document.add_timeout_callback(self._look, _LOOK)

    def _look(self) -> None:
        self._looking = False
        for view in (self.force, self.iterations):
            view.look()

    def _darken(self, dark: bool) -> None:
        for view in (self.force, self.iterations):
            view.darken(dark)

    def _load_preset(self, name: str) -> None:
        scenario = presets.get(name)
        self.controls.load(scenario)
        # forth and back on one axis would lie on top of each other
        returns = scenario.loading.profile in ("load-hold-unload", "sinusoidal")
        self.axis.value = "time" if returns else "indentation"
        self.caption.object = presets.caption(name)

    def _choose_axis(self) -> None:
        """Put on the horizontal axis what is chosen, as far as the run on show goes."""
        if self.run is None or not self._prepared:
            return
        simulation, baseline = self.run.simulation, self.run.baseline
        assert simulation is not None
        assert baseline is not None
        axis = horizontal(self.axis.value, simulation.schedule.time, baseline.met)
        self.force.show_against(axis)
        self.iterations.show_against(axis)

    def _make_header(self) -> None:
        self.preset = pmui.Select(
            label="Preset", options=presets.names(), value="default", size="small",
            sizing_mode="stretch_width",
        )  # fmt: skip
        self.caption = pmui.Typography(
            presets.caption("default"), variant="caption", margin=(0, 10)
        )
        self.pace = pmui.Select(
            label="Pace", options=list(PACES), value="in about 6 s", size="small",
            sizing_mode="stretch_width",
        )  # fmt: skip
        self.run_button = pmui.Button(label="Run", color="success", variant="contained")
        self.stop_button = pmui.Button(
            label="Stop", color="error", variant="contained", disabled=True
        )
        self.axis = pmui.RadioButtonGroup(
            options=["indentation", "time"], value="indentation", size="small"
        )
        self.progress = pmui.LinearProgress(
            value=0, variant="determinate", sizing_mode="stretch_width", margin=(6, 10)
        )
        self.run_button.on_click(lambda _: self.start())
        self.stop_button.on_click(lambda _: self.stop())
        self.preset.param.watch(lambda event: self._load_preset(event.new), "value")
        self.axis.param.watch(lambda _: self._choose_axis(), "value")

    def _layout(self) -> pmui.Page:
        plots = pmui.Column(
            self.axis,
            pn.pane.Bokeh(self.force.root, sizing_mode="stretch_width"),
            pn.pane.Bokeh(self.iterations.root, sizing_mode="stretch_width"),
            sizing_mode="stretch_width",
        )
        touching = pn.pane.Bokeh(self.contact_map.root, sizing_mode="scale_width")
        grid = pmui.Grid(
            pmui.Grid(plots, size={"xs": 12, "md": 7}),
            pmui.Grid(touching, size={"xs": 12, "md": 5}),
            container=True, spacing=1, sizing_mode="stretch_width",
        )  # fmt: skip
        before = _busy_watchers()
        page = pmui.Page(
            title="tyrecontact",
            header=[pmui.Row(self.run_button, self.stop_button)],
            sidebar=[self.preset, self.caption, *self.controls.root, self.pace],
            main=[self.headline.root, self.progress, grid],
            sidebar_open=not _on_a_phone(),
            theme_config=_THEME,
            busy_indicator=None,
        )
        page.param.watch(lambda event: self._darken(event.new), "dark_theme")
        # the page would follow the server's being busy, at a redraw each, and never be freed
        for watcher in _busy_watchers():
            if watcher not in before:
                pn.state.param.unwatch(watcher)
        return page


def _busy_watchers() -> list[Any]:
    return list(pn.state.param.watchers.get("busy", {}).get("value", []))


def _on_a_phone() -> bool:
    """Whether the visitor's browser says that it is one: there the sidebar would cover the page."""
    headers = pn.state.headers or {}
    return "Mobi" in headers.get("User-Agent", "")
