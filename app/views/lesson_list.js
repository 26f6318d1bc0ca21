// The lessons to choose from: one button each.
export function render({ model, el }) {
  const root = document.createElement("div")
  root.className = "lessons"
  el.append(root)

  function line(className, text) {
    const made = document.createElement("span")
    made.className = className
    made.textContent = text
    return made
  }

  function show() {
    root.style.setProperty("--size", `${model.type_size}px`)
    root.replaceChildren(
      ...model.lessons.map((lesson) => {
        const card = document.createElement("button")
        card.type = "button"
        card.append(
          line("title", lesson.title),
          line("aim", lesson.aim),
          line("where", `${lesson.where} · about ${lesson.minutes} minutes`),
        )
        card.onclick = () => model.send_msg(lesson.name)
        return card
      }),
    )
  }

  model.on(["lessons", "type_size"], show)
  show()
}
