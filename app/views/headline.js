// Figures, progress and the sentence on the state: made once, then only what has changed is written.
function make(parent, kind, text = "") {
  const node = document.createElement("div")
  node.className = kind
  node.textContent = text
  parent.append(node)
  return node
}

function write(node, text) {
  if (node.textContent !== text) { node.textContent = text }
}

export function render({model, el}) {
  const root = make(el, "headline")
  const grid = make(root, "figures"), bar = make(root, "bar"), done = make(bar, "done")
  const state = make(root, "state"), words = make(state, "sentence"), left = make(state, "left")
  const notice = make(words, "notice"), sentence = make(words, "words")
  const aloud = make(root, "unseen")
  notice.setAttribute("role", "alert")
  // every step read aloud would be too much: it is there to be looked up, and ends are announced
  words.setAttribute("role", "status")
  words.setAttribute("aria-live", "off")
  aloud.setAttribute("aria-live", "polite")
  bar.setAttribute("role", "progressbar")
  bar.setAttribute("aria-label", "Progress of the run")
  const cells = new Map()
  const cell = (name) => {
    if (!cells.has(name)) {
      const box = make(grid, "figure")
      make(box, "label", name).title = name
      const value = make(box, "value"), number = document.createElement("span"), unit = document.createElement("span")
      unit.className = "unit"
      value.append(number, unit)
      cells.set(name, [number, unit])
    }
    return cells.get(name)
  }
  const show = (shown) => {
    for (const [name, value, unit] of shown.figures ?? []) {
      const [number, unit_node] = cell(name)
      write(number, value)
      write(unit_node, unit)
    }
    done.style.transform = `scaleX(${shown.progress ?? 0})`
    bar.setAttribute("aria-valuenow", Math.round(100 * (shown.progress ?? 0)))
    write(left, shown.left ?? "")
    write(notice, shown.notice ?? "")
    notice.style.display = shown.notice ? "" : "none"
    write(sentence, shown.sentence ?? "")
    sentence.className = shown.bad ? "words bad" : "words"
    if (shown.ended) { write(aloud, shown.sentence) }
  }
  model.on("msg:custom", show)
  show(model.state)
}
