// The bar of the player: native controls, which are light, and which keyboards and readers know.
// It sends what the visitor asks for; what is on show comes back as parameters.

const SPEEDS = [0.25, 0.5, 1, 2, 4]
/** ms after which an answer is not waited for any longer */
const PATIENCE = 250

function make(tag, properties, ...children) {
  const element = Object.assign(document.createElement(tag), properties)
  element.append(...children)
  return element
}

/** Asks for one thing at a time; of what is wanted before the answer, the last. */
function patient(ask) {
  let wanted = null, timer = null
  const answered = () => {
    clearTimeout(timer)
    timer = null
    if (wanted !== null) send(wanted)
  }
  const send = (value) => {
    wanted = null
    timer = setTimeout(answered, PATIENCE)
    ask(value)
  }
  return {answered, want: (value) => { timer === null ? send(value) : wanted = value }}
}

export function render({model, el}) {
  const ask = (message) => model.send_msg(message)
  const play = make("button", {type: "button", className: "play"})
  const live = make("button", {type: "button", className: "live", textContent: "Newest",
    title: "Follow the newest step"})
  const slider = make("input", {type: "range", min: 0, step: 1, ariaLabel: "Step on show"})
  const speed = make("select", {ariaLabel: "Speed of the replay", title: "Speed of the replay"},
    ...SPEEDS.map((value) => make("option", {value, textContent: `× ${value}`})))
  const label = make("span", {className: "label"})

  const scrub = patient((step) => ask({do: "scrub", step}))
  play.onclick = () => ask({do: "play"})
  live.onclick = () => ask({do: "newest"})
  slider.oninput = () => scrub.want(Number(slider.value))
  speed.onchange = () => ask({do: "speed", speed: Number(speed.value)})
  slider.onkeydown = (event) => {
    const way = {ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1}[event.key]
    if (way === undefined || event.ctrlKey || event.altKey || event.metaKey) return
    event.preventDefault()
    event.stopPropagation() // the page has the same keys
    ask({do: "move", by: way * (event.shiftKey ? 10 : 1)})
  }

  let held = false
  slider.onpointerdown = () => { held = true }
  slider.onpointerup = slider.onpointercancel = slider.onchange = () => { held = false }
  let answered = null
  const show = ({count, step, label: words, playing, speed: times}) => {
    const last = Math.max(count - 1, 0)
    slider.max = last
    if (!held) slider.value = step < 0 ? last : step
    slider.ariaValueText = label.textContent = words
    for (const control of [slider, play, live, speed]) control.disabled = count < 2
    live.setAttribute("aria-pressed", step < 0)
    const sign = playing ? "❚❚" : "▶"
    if (play.textContent !== sign) {
      play.textContent = sign
      play.ariaLabel = play.title = playing ? "Pause the replay" : "Replay"
    }
    if (speed.value !== String(times)) speed.value = String(times)
    if (step !== answered) scrub.answered()
    answered = step
  }
  model.on("msg:custom", show)
  show(model.state)
  return make("div", {className: "bar", role: "group", ariaLabel: "Replay"},
    play, slider, speed, live, label)
}
