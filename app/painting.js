// How Bokeh paints, on this page: many frames a second on a machine that is busy with the solver.
// Each change holds for all plots, and for what Bokeh does here alone; the pictures are the same.
const {InlineStyleSheet} = Bokeh.require("core/dom")
const {CanvasLayer} = Bokeh.require("core/util/canvas")
const {VisualProperties} = Bokeh.require("core/visuals/visual")
const {PlotView} = Bokeh.require("models/plots/plot_canvas")
const {GlyphRendererView} = Bokeh.require("models/renderers/glyph_renderer")

// The place of every part of a plot is written anew at every painting, and the page is styled anew
// for it, some thirty times a frame. What has not changed need not be written.
const write = InlineStyleSheet.prototype._update
InlineStyleSheet.prototype._update = function(css) {
  if (this.el.textContent !== css) { write.call(this, css) }
}

// That of a curve changes as it grows, and nothing stands there.
GlyphRendererView.prototype.update_position = () => {}

// For each colour, width and font the page's styles are asked, at every painting. None of this page
// says any (they would begin with `--bk-`).
VisualProperties.prototype._get_css_value = () => ""

// What is drawn while a run goes on lies on a canvas of its own, so that axes need not be painted
// again. Bokeh does not keep within the frame what lies there.
Object.defineProperty(GlyphRendererView.prototype, "needs_clip", {get: () => true})

// The text of every axis is measured at each painting, whether the plot is to be laid out anew. That
// of axes that are not painted has not changed.
const layOut = PlotView.prototype._invalidate_layout_if_needed
PlotView.prototype._invalidate_layout_if_needed = function() {
  const painters = [...this._invalidated_painters]
  const growing = painters.length > 0 && painters.every(({model}) => model.level === "overlay")
  if (this._needs_layout || this._invalidate_all || !growing) { layOut.call(this) }
}

// It clears from half a pixel inside: of what was drawn over the edge a shade would stay.
CanvasLayer.prototype.clear = function() {
  const {x, y, width, height} = this.bbox
  this.ctx.clearRect(x - 1, y - 1, width + 2, height + 2)
}

export function render({el}) { el.style.display = "none" }
