// The colours of the page, light or dark, as its style has them.
let styleNow = null;
const colour = name => (styleNow ||= getComputedStyle(document.documentElement)).getPropertyValue("--" + name).trim();

// Called whenever the page turns light or dark; a printed page is light.
const redraws = [];
function onColours(redraw) { redraws.push(redraw); }
function coloursChanged() {
  styleNow = null;
  for (const redraw of redraws) redraw();
}
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", coloursChanged);
addEventListener("beforeprint", () => { document.documentElement.dataset.theme = "light"; coloursChanged(); });
addEventListener("afterprint", () => { delete document.documentElement.dataset.theme; coloursChanged(); });

// Kind of work of an operation.
const symbols = {add: "+", sub: "−", mul: "×", div: "÷", neg: "−"};
function kindOf(name) {
  if (name === "input" || name === "parameter") return "leaf";
  if (name === "add" || name === "sub" || name === "neg") return "sum";
  if (name === "mul") return "product";
  if (name === "div" || name === "sqrt") return "quotient";
  return "function";
}
const kinds = {leaf: "inputs, parameters", sum: "+ −", product: "×", quotient: "÷ √", function: "other operations"};
const legend = () => make("ul", {class: "legend", "aria-label": "Colours"}, Object.entries(kinds).map(([kind, words]) =>
  make("li", {}, make("span", {class: "swatch", style: `background:var(--kind-${kind})`}), words)));
