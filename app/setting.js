// One setting: label with unit, slider and exact entry or a choice, its meaning, and the way back.
const PAUSE = 60  // ms between two values of a drag

function add(parent, tag, values = {}) {
  const node = document.createElement(tag)
  Object.assign(node, values)
  parent.append(node)
  return node
}

function number_entry(model, row, id, send) {
  const slider = model.step === null ? null : add(row, "input", {type: "range"})
  const entry = add(row, "input", {type: "number", id, step: "any", min: model.low, max: model.high})
  if (slider === null) { entry.className = "alone" } else {
    slider.setAttribute("aria-label", `${model.label}, slider`)
    // the first value of a drag at once, the others not faster than they can be run
    let timer = null, wanted = null
    const next = () => {
      timer = wanted === null ? null : setTimeout(next, PAUSE)
      if (wanted !== null) { send(wanted) }
      wanted = null
    }
    slider.addEventListener("input", () => {
      entry.value = slider.value
      wanted = Number(slider.value)
      if (timer === null) { next() }
    })
  }
  entry.addEventListener("change", () => send(entry.value === "" ? null : Number(entry.value)))
  const show = () => {
    if (slider !== null) {
      Object.assign(slider, {min: model.start, max: Math.max(model.end, model.value ?? 0), step: model.step})
      slider.value = model.value
    }
    entry.value = model.value
  }
  if (slider !== null) { model.on(["start", "end", "step"], show) }
  return show
}

function choice(model, row, id, send) {
  const select = add(row, "select", {id})
  for (const option of model.options) { add(select, "option", {value: String(option), textContent: String(option)}) }
  select.addEventListener("change", () => send(model.options[select.selectedIndex]))
  return () => { select.value = String(model.value) }
}

export function render({model, el}) {
  const root = add(el, "div"), head = add(root, "div", {className: "head"})
  add(head, "span", {className: "mark", textContent: "●", title: "Another value than the preset's"})
  const id = "entry"
  add(head, "label", {htmlFor: id, textContent: model.label})
  const about = add(head, "button", {className: "info", textContent: "i", title: model.description})
  about.setAttribute("aria-label", `About ${model.label}`)
  about.setAttribute("aria-expanded", "false")
  const back = add(head, "button", {className: "back", textContent: "⟲", title: "Back to the preset's value"})
  back.setAttribute("aria-label", `Reset ${model.label}`)
  const row = add(root, "div", {className: "row"})
  const text = add(root, "div", {className: "about", textContent: model.description})
  const send = (value) => {
    // a value that was refused before may be sent again
    model.value = value
  }
  const show = model.options.length ? choice(model, row, id, send) : number_entry(model, row, id, send)
  about.addEventListener("click", () => {
    const open = text.classList.toggle("open")
    about.setAttribute("aria-expanded", String(open))
  })
  back.addEventListener("click", () => model.send_msg({restore: true}))
  const mark = () => root.classList.toggle("differs", model.differs)
  model.on("value", show)
  model.on("differs", mark)
  show()
  mark()
}
