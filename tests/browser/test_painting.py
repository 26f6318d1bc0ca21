"""What is drawn while a run goes on lies on a canvas of its own, and stays within its plot."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tests.browser.conftest import Visit

#: view of the plot of the force
_VIEW = """() => {
  const source = Bokeh.documents[0].get_model_by_name("force")
  const draws = (figure) => figure.renderers.some((one) => one.data_source === source)
  return Bokeh.index.query(({model}) => model.type === "Figure" && draws(model)).next().value
}"""
#: left edge of its frame, after its vertical axis was changed
_EDGE = f"""async (end) => {{
  const view = ({_VIEW})()
  view.model.y_range.setv({{start: 0, end}})
  await new Promise((resolve) => setTimeout(resolve, 500))
  return view.frame.bbox.left
}}"""
#: whether what stands at the corner of its canvas is gone when it is painted again
_WIPED = f"""async () => {{
  const view = ({_VIEW})(), {{ctx}} = view.canvas_view.primary
  ctx.fillStyle = "#000"
  ctx.fillRect(0, 0, 9, 9)
  view.request_paint()
  await new Promise((resolve) => setTimeout(resolve, 500))
  return ctx.getImageData(0, 0, 9, 9).data.every((value, place) => place % 4 === 3 || value > 250)
}}"""
#: of the plot of the force: pixels drawn on the canvas of the run within the frame and outside it,
#: and paintings of its horizontal axis, after its axes were changed and so much was awaited
_PAINTED = """async ([end, rows]) => {
  const source = Bokeh.documents[0].get_model_by_name("force")
  const view = (VIEW)()
  view.model.y_range.setv({start: 0, end})
  const axis = view.renderer_views.get(view.model.below[0])
  let axes = 0
  const paint = axis._paint
  axis._paint = function(...all) { axes += 1; return paint.call(this, ...all) }
  const settled = source.data.force.length + rows
  await new Promise((resolve) => setTimeout(resolve, 300))
  axes = 0
  let turns = 0
  while (source.data.force.length < settled) {
    await new Promise((resolve) => setTimeout(resolve, 20))
    if (turns++ > 1500) { throw new Error("no more rows came") }
  }
  const {left, top, width, height} = view.frame.bbox
  const {ctx, canvas, pixel_ratio} = view.canvas_view.overlays
  const drawn = (x, y, w, h) => {
    const {data} = ctx.getImageData(...[x, y, w, h].map((value) => Math.round(value * pixel_ratio)))
    return data.filter((_, place) => place % 4 === 3).filter((alpha) => alpha > 0).length
  }
  const inside = drawn(left, top, width, height)
  // a line is antialiased over the edge
  const right = left + width + 2
  const outside = drawn(0, 0, canvas.width, top - 2) + drawn(right, 0, canvas.width, canvas.height)
  axis._paint = paint
  return [inside, outside, axes]
}""".replace("VIEW", _VIEW)


def test_a_run_leaves_neither_its_frame_nor_its_canvas(visit: Visit) -> None:
    """The axis is cut at a fifth of the force, which the run passes."""
    visit.choose_pace("in about 6 s")
    visit.press("Run")
    visit.wait_for_rows(20)
    inside, outside, axes = visit.tab.evaluate(_PAINTED, [2000, 30])
    assert inside > 20
    assert outside == 0
    assert axes == 0, "the axes were painted again"
    visit.wait_for_sentence("Complete", 90)
    visit.tab.wait_for_timeout(300)
    inside, outside, _ = visit.tab.evaluate(_PAINTED, [90, 0])
    assert inside > 20
    assert outside == 0
    assert visit.tab.evaluate(_WIPED)


def test_a_plot_whose_numbers_grow_wider_is_laid_out_anew_while_a_run_goes_on(visit: Visit) -> None:
    visit.choose_pace("in about 6 s")
    visit.press("Run")
    visit.wait_for_rows(20)
    narrow, wide, again = (visit.tab.evaluate(_EDGE, end) for end in (500, 123456789.5, 500))
    assert visit.sentence().startswith("Step ")
    assert wide > narrow
    assert again == narrow
    visit.press("Stop")
