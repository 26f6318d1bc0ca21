// Save every plot on show as a file; args: kind ("png" or "svg"), button, whose one tag begins the
// names of the files.
// Drawn anew by BokehJS in the kind asked for, on the plot's own ground, so that what is light on
// a dark page is not lost on a white one.
const figures = new Set(Bokeh.index.query((view) => view.model.type.endsWith("Figure")))
const ground = (element) => {
  for (let at = element; at; at = at.parentNode ?? at.host) {
    const colour = at instanceof Element ? getComputedStyle(at).backgroundColor : ""
    if (colour && !/, 0\)$|transparent/.test(colour)) return colour
  }
  return "#ffffff"
}

const png = (layer, colour) => {
  const sheet = document.createElement("canvas")
  sheet.width = layer.canvas.width
  sheet.height = layer.canvas.height
  const pen = sheet.getContext("2d")
  pen.fillStyle = colour
  pen.fillRect(0, 0, sheet.width, sheet.height)
  pen.drawImage(layer.canvas, 0, 0)
  return new Promise((resolve) => sheet.toBlob(resolve, "image/png"))
}

const svg = async (layer, colour) => {
  const drawn = await (await layer.to_blob()).text()
  const sheet = new DOMParser().parseFromString(drawn, "image/svg+xml")
  const paper = sheet.createElementNS("http://www.w3.org/2000/svg", "rect")
  for (const [name, value] of [["width", "100%"], ["height", "100%"], ["fill", colour]]) {
    paper.setAttribute(name, value)
  }
  sheet.documentElement.prepend(paper)
  return new Blob([new XMLSerializer().serializeToString(sheet)], {type: "image/svg+xml"})
}

const when = new Date().toISOString().slice(0, 19).replace(/[-:]/g, "").replace("T", "-")
const taken = new Set()
const named = (view) => {
  const title = String(view.model.title?.text ?? "")
  const words = title.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "") || "plot"
  let name = words
  for (let number = 2; taken.has(name); number++) name = `${words}-${number}`
  taken.add(name)
  return `${button.tags[0]}-${name}-${when}.${kind}`
}

const save = async (view) => {
  const layer = view.export(kind)
  const colour = ground(view.el)
  const link = document.createElement("a")
  link.download = named(view)
  link.href = URL.createObjectURL(await (kind === "png" ? png(layer, colour) : svg(layer, colour)))
  link.click()
  setTimeout(() => URL.revokeObjectURL(link.href), 10000)
}

const run = async () => {
  for (const view of figures) {
    if (view.el.isConnected && view.el.getClientRects().length && view.bbox.width) {
      await save(view)
      await new Promise((resolve) => setTimeout(resolve, 150)) // a browser drops what comes at once
    }
  }
}
run()
