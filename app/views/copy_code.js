// Copy the code of a block; args: block (the model of its pane), button, whose one tag is its label.
const code = Bokeh.index.find_one_by_id(block.id).shadow_el.querySelector("pre").textContent
const told = (text) => {
  button.data.label = text
  setTimeout(() => { button.data.label = button.tags[0] }, 2000)
}
const by_selection = () => {
  // where the page is not served by https, browsers have no clipboard
  const box = document.createElement("textarea")
  box.value = code
  box.style = "position: fixed; top: 0; opacity: 0"
  document.body.append(box)
  const before = document.activeElement
  box.select()
  const copied = document.execCommand("copy")
  box.remove()
  before?.focus()
  told(copied ? "Copied" : "Select it, and press Ctrl+C")
}
if (navigator.clipboard) {
  navigator.clipboard.writeText(code).then(() => told("Copied"), by_selection)
} else {
  by_selection()
}
