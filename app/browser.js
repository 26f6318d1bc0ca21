// The visitor's browser: frames shown, keys pressed, texts copied. It draws nothing.
const WRITING = "textarea, [contenteditable=true], input:not([type=range], [type=checkbox], [type=radio]), [role=dialog]"
const TYPING = "input, textarea, select, [contenteditable=true], [role=slider], [role=combobox], [role=listbox], [role=menu], [role=dialog]"
const PRESSING = "button, a, summary, [role=button], [role=tab], [role=switch], [role=radio], [role=menuitem]"

function focused(event) {
  // shadow roots hide what has the focus: the first of the path is what was really meant
  return event.composedPath().filter((node) => node instanceof Element)
}

function scrolls(node) {
  return node.matches("[tabindex='0']") && node.scrollWidth > node.clientWidth
}

function key_of(event) {
  const path = focused(event)
  // what a slider or a choice has just changed is taken back where the focus is
  if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z" && !path.some((node) => node.matches(WRITING))) {
    return event.shiftKey ? "Redo" : "Undo"
  }
  if (path.some((node) => node.matches(TYPING))) { return event.key === "Escape" ? "Escape" : null }
  if (event.ctrlKey || event.metaKey || event.altKey) { return null }
  if (event.key === " " && path.some((node) => node.matches(PRESSING))) { return null }
  if (path.some((node) => node.matches("[role=tab], [role=radio]")) && event.key.startsWith("Arrow")) { return null }
  if (/^(Arrow|Home|End)/.test(event.key) && path.some(scrolls)) { return null }
  const name = event.key === " " ? "Space" : event.key
  return event.shiftKey && name.startsWith("Arrow") ? `Shift+${name}` : name
}

const KEYS = new Set(["Space", "Escape", "ArrowLeft", "ArrowRight", "Shift+ArrowLeft", "Shift+ArrowRight", "Home", "End", ".", "p", "?", "Undo", "Redo"])

function fallback_copy(text) {
  const area = document.createElement("textarea")
  area.value = text
  document.body.append(area)
  area.select()
  const done = document.execCommand("copy")
  area.remove()
  return done
}

async function copy(text) {
  try {
    await navigator.clipboard.writeText(text)
    return true
  } catch {
    return fallback_copy(text)  // a page that is not served by https has no clipboard
  }
}

export function render({model, el}) {
  const listen = (event) => {
    const key = key_of(event)
    if (key === null || !KEYS.has(key)) { return }
    // an open dialog is closed by Escape, which is no wish to stop
    if (key === "Escape" && document.querySelector("[role=dialog]")) { return }
    if (key !== "Escape") { event.preventDefault() }
    if (!event.repeat || key.includes("Arrow")) { model.send_msg({key}) }
  }
  document.addEventListener("keydown", listen)
  model.on("remove", () => document.removeEventListener("keydown", listen))
  // a frame is on the screen when the browser has come to rest after drawing it
  const drawn = ({frame, answer}) => requestAnimationFrame(() => setTimeout(() => {
    if (answer) { model.send_msg({shown: frame}) }
    document.dispatchEvent(new CustomEvent("tyrecontact-frame", {detail: frame}))
  }, 0))
  model.on("msg:custom", async (message) => {
    if (message.frame !== undefined) { drawn(message) }
    if (message.copy !== undefined) { model.send_msg({copied: await copy(message.copy)}) }
    for (const [name, value] of Object.entries(message.style ?? {})) {
      document.documentElement.style.setProperty(name, value)
      // the type of buttons, tabs and choices follows that of the page
      if (name === "--scale") { document.documentElement.style.fontSize = `${100 * value}%` }
    }
  })
  model.send_msg({width: window.innerWidth, address: window.location.href.split(/[?#]/)[0]})
  el.style.display = "none"
}
