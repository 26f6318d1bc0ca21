// Presets as cards of plain buttons: a picture, a caption, and the other members of a figure.
const made = (tag, kind, text) => {
  const part = document.createElement(tag);
  part.className = kind;
  if (text !== undefined) part.textContent = text;
  return part;
};

export function render({ model }) {
  const root = made("div", "gallery");
  const search = made("input", "search");
  search.type = "search";
  search.placeholder = "avalanche, Fig. 27, road …";
  const label = made("label", "label", "Find a preset");
  label.append(search);
  const said = made("p", "said");
  said.setAttribute("role", "status");
  const groups = made("div", "groups");
  root.append(label, said, groups);

  const button = (kind, name, text) => {
    const part = made("button", kind, text);
    part.type = "button";
    part.dataset.name = name;
    part.addEventListener("click", () => { model.value = name; });
    return part;
  };
  const card = (preset) => {
    const part = made("article", "card");
    const main = button("main", preset.name);
    const picture = made("span", "picture");
    picture.innerHTML = preset.picture;
    picture.setAttribute("aria-hidden", "true");
    main.append(picture, made("span", "name", preset.name), made("span", "caption", preset.caption));
    if (preset.source) main.append(made("span", "source", preset.source));
    part.append(main);
    if (preset.members.length > 1) {
      const row = made("div", "members");
      row.setAttribute("role", "group");
      row.setAttribute("aria-label", `Members of ${preset.name}`);
      row.append(...preset.members.map((member) => button("member", member.name, member.label)));
      part.append(row);
    }
    const words = [preset.name, preset.caption, preset.source, ...preset.members.map((m) => m.label)];
    part.dataset.words = words.join(" ").toLowerCase();
    return part;
  };
  const fill = () => {
    groups.replaceChildren(...model.groups.map((group) => {
      const part = made("section", "group");
      const cards = made("div", "deck");
      cards.append(...group.presets.map(card));
      part.append(made("h3", "title", group.title), cards);
      return part;
    }));
    mark();
    sift();
  };
  const mark = () => groups.querySelectorAll("button").forEach((part) => {
    const { name } = part.dataset;
    const head = part.classList.contains("main") && model.current.startsWith(`${name}/`);
    if (name === model.current || head) part.setAttribute("aria-current", "true");
    else part.removeAttribute("aria-current");
  });
  const sift = () => {
    const wanted = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const cards = [...groups.querySelectorAll(".card")];
    cards.forEach((part) => {
      part.hidden = !wanted.every((word) => part.dataset.words.includes(word));
    });
    groups.querySelectorAll(".group").forEach((part) => {
      part.hidden = !part.querySelector(".card:not([hidden])");
    });
    const left = cards.filter((part) => !part.hidden).length;
    if (!wanted.length) said.textContent = `${cards.length} presets; the arrow keys lead from one to the next.`;
    else if (left) said.textContent = `${left} of ${cards.length} presets`;
    else said.textContent = "No preset has these words. Try fewer, or a figure's number.";
  };
  const move = (event) => {
    if (!["Escape", "Tab"].includes(event.key)) event.stopPropagation(); // the page's own keys rest
    const from = event.target.closest(".card")?.querySelector(".main");
    if (!from || !event.key.startsWith("Arrow")) return;
    event.preventDefault();
    const all = [...groups.querySelectorAll(".card:not([hidden]) .main")];
    const place = all.indexOf(from);
    const { left, top } = from.getBoundingClientRect();
    const column = all.filter((part) => Math.abs(part.getBoundingClientRect().left - left) < 2);
    const next = {
      ArrowRight: () => all[place + 1],
      ArrowLeft: () => all[place - 1],
      ArrowDown: () => column.find((part) => part.getBoundingClientRect().top > top + 2),
      ArrowUp: () => column.findLast((part) => part.getBoundingClientRect().top < top - 2),
    }[event.key]();
    next?.focus();
  };
  search.addEventListener("input", sift);
  root.addEventListener("keydown", move);
  model.on("groups", fill);
  model.on("current", mark);
  fill();
  return root;
}
