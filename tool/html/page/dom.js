// Elements, and numbers as people read them.
function make(tag, properties, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties || {}))
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value !== undefined && value !== false) element.setAttribute(name, value === true ? "" : value);
  element.append(...children.flat(Infinity).filter(child => child !== undefined && child !== null).map(child =>
    child instanceof Node ? child : String(child)));
  return element;
}

const number = value => value === null ? "not finite" : typeof value === "number" ? value.toLocaleString("en", {maximumFractionDigits: 2}) : String(value);
const plural = (count, word) => `${number(count)} ${word}${count === 1 ? "" : "s"}`;
const baseName = path => path.slice(path.lastIndexOf("/") + 1);

// Rows of cells; a number stands right-aligned. A cell may be an element.
function table(caption, heads, rows) {
  const cell = (tag, content, extra) =>
    make(tag, {...extra, class: typeof content === "number" ? "number" : undefined},
         typeof content === "number" ? number(content) : content);
  const numeric = heads.map((_, column) => rows.length > 0 && rows.every(row => typeof row[column] === "number"));
  return make("div", {class: "scroll", tabindex: 0, role: "region", "aria-label": caption},
    make("table", {}, make("caption", {}, caption),
      make("thead", {}, make("tr", {}, heads.map((head, column) =>
        make("th", {scope: "col", class: numeric[column] ? "number" : undefined}, head)))),
      make("tbody", {}, rows.map(row => make("tr", {}, row.map((content, column) =>
        column === 0 ? cell("th", content, {scope: "row"}) : cell("td", content)))))));
}

const button = (label, action, properties) => make("button", {type: "button", onclick: action, ...properties}, label);

// A bar whose length is a share of the longest.
const bar = (share, properties) =>
  make("span", {class: "bar", ...properties}, make("span", {style: `width:${(100 * Math.min(share, 1)).toFixed(2)}%`}));

// A canvas as sharp as the screen, its context in CSS pixels.
function prepare(canvas, width, height) {
  const ratio = window.devicePixelRatio || 1;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    canvas.style.height = height + "px";
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}

// Draws once for all that happens before the next frame.
function onceAFrame(draw) {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => { waiting = false; draw(); });
  };
}
