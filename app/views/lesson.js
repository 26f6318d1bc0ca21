// The strip of a lesson: draws `state`, and sends what is pressed.
function element(tag, className, text) {
  const made = document.createElement(tag)
  made.className = className
  if (text) made.textContent = text
  return made
}

export function render({ model, el }) {
  const root = element("section", "lesson")
  root.setAttribute("aria-label", "Guided lesson")
  el.append(root)
  let lesson = ""

  function button(label, key, message, className) {
    const made = element("button", className, label)
    made.type = "button"
    made.dataset.key = key
    made.onclick = () => model.send_msg(message)
    return made
  }

  function heading(state) {
    const row = element("div", "row")
    const title = element("h2", "title", state.title)
    title.tabIndex = -1
    title.dataset.key = "title"
    const moves = element("div", "moves")
    const back = button("Back", "back", { do: "back" }, "plain")
    back.disabled = state.step === 1
    moves.append(
      back,
      button(state.step < state.steps ? "Next" : "Finish", "next", { do: "next" }, "main"),
      button("Leave", "leave", { do: "leave" }, "plain"),
    )
    row.append(title, element("span", "count", `step ${state.step} of ${state.steps}`), moves)
    return row
  }

  function told(state) {
    const said = element("div", "said")
    const answered = state.chosen >= 0
    const first = element("p", "text")
    if (answered) first.append(element("b", "", state.right ? "Right. " : "Not quite. "))
    first.append(answered ? state.feedback : state.text)
    said.append(first)
    if (answered) {
      const seen = element("p", "seen")
      seen.append(element("b", "", "In the thesis: "), state.seen)
      said.append(seen)
    }
    said.setAttribute("aria-live", "polite")
    return said
  }

  function asked(state) {
    const box = element("div", "asked")
    box.setAttribute("role", "group")
    box.setAttribute("aria-label", state.question)
    box.append(element("p", "question", state.question))
    const choices = element("div", "choices")
    state.choices.forEach((label, index) => {
      const choice = button(label, `choice${index}`, { do: "choose", index }, "choice")
      choice.setAttribute("aria-pressed", String(index === state.chosen))
      choices.append(choice)
    })
    box.append(choices)
    return box
  }

  function show() {
    const state = model.state
    if (!state.title) {
      root.replaceChildren()
      lesson = ""
      return
    }
    const focused = el.getRootNode().activeElement
    const key = focused ? focused.dataset.key : ""
    root.style.setProperty("--size", `${state.size}px`)
    const body = element("div", "body")
    const left = told(state)
    left.append(button(`Show ${state.look}`, "show", { do: "show" }, "link"))
    body.append(left, asked(state))
    root.replaceChildren(heading(state), body)
    // a lesson that begins is read from its title; otherwise the keyboard stays where it was
    const target = root.querySelector(`[data-key="${lesson === state.title ? key : "title"}"]`)
    if (target && (key || lesson !== state.title)) target.focus({ preventScroll: true })
    lesson = state.title
  }

  model.on("state", show)
  show()
}
