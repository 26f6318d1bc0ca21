// A whole number, written or stepped by the arrow keys.
export function render({ model }) {
  const root = document.createElement("label");
  const entry = document.createElement("input");
  Object.assign(entry, { type: "number", min: 0, step: 1 });
  root.append(model.label, entry);
  const show = () => {
    entry.max = model.end;
    entry.value = model.value;
  };
  entry.addEventListener("change", () => {
    const wanted = Math.min(Math.max(Math.round(Number(entry.value)), 0), model.end);
    if (wanted === model.value) show();
    else model.value = wanted;
  });
  model.on(["value", "end"], show);
  show();
  return root;
}
