// The text, contents that jump (an address cannot point into a component), equations that scroll.
export function render({ model, el }) {
  const page = document.createElement("article");
  const size = () => { page.style.fontSize = `${model.type_size}px`; };
  const fill = () => { page.innerHTML = model.text; };
  const reach = () => page.querySelectorAll("[data-scrolls]").forEach((part) => {
    const wide = part.scrollWidth > part.clientWidth;
    for (const [name, value] of [["tabindex", "0"], ["role", "group"], ["aria-label", part.dataset.scrolls]]) {
      if (wide) part.setAttribute(name, value); else part.removeAttribute(name);
    }
  });
  page.addEventListener("click", (event) => {
    const link = event.target.closest('a[href^="#"]');
    if (!link) return;
    event.preventDefault();
    const goal = page.querySelector(`[id="${link.getAttribute("href").slice(1)}"]`);
    goal.tabIndex = -1;
    goal.focus({ preventScroll: true });
    goal.scrollIntoView({ block: "start" });
  });
  model.on("text", fill);
  model.on("type_size", size);
  size();
  fill();
  new ResizeObserver(reach).observe(page);
  return page;
}
