// Text by lines, of which those in sight are elements. Keys move the current line; `picked` hears of each choice.
class LineList {
  constructor(label, picked) {
    this.rowHeight = 20;
    this.lines = [];
    this.marked = new Set();
    this.weights = new Map(); // by line, from 0: operations
    this.current = -1;
    this.rows = make("div", {class: "rows"});
    this.id = "lines-" + label.replace(/\W+/g, "-").toLowerCase();
    this.element = make("div", {class: "lines", id: this.id, tabindex: 0, role: "listbox", "aria-label": label,
      onscroll: onceAFrame(() => this.draw()), onkeydown: event => this.key(event), onclick: event => {
        const row = event.target.closest("[data-line]");
        if (row) this.pick(Number(row.dataset.line));
      }}, this.rows);
    this.picked = picked;
    new ResizeObserver(() => this.draw()).observe(this.element);
    addEventListener("beforeprint", () => this.print(true));
    addEventListener("afterprint", () => this.print(false));
  }
  show(text, weights) {
    this.lines = text.replace(/\n$/, "").split("\n");
    this.weights = weights;
    this.heaviest = Math.max(1, ...weights.values());
    this.marked = new Set();
    this.current = -1;
    this.rows.style.height = this.lines.length * this.rowHeight + "px";
    this.rows.style.setProperty("--digits", String(this.lines.length).length + "ch");
    this.element.scrollTop = 0;
    this.draw();
  }
  // On paper there are all lines, or, of very many, those in sight.
  print(begins) {
    this.all = begins && this.lines.length <= 3000;
    this.element.classList.toggle("whole", this.all);
    this.draw();
  }
  mark(lines, reveal = true) {
    this.marked = new Set(lines);
    const first = Math.min(...this.marked);
    if (reveal && this.marked.size) this.reveal(first);
    this.draw();
  }
  reveal(line) {
    const top = line * this.rowHeight, height = this.element.clientHeight;
    if (top < this.element.scrollTop || top + this.rowHeight > this.element.scrollTop + height)
      this.element.scrollTop = Math.max(0, top - height / 3);
  }
  pick(line) {
    this.current = Math.min(Math.max(line, 0), this.lines.length - 1);
    this.reveal(this.current);
    this.draw();
    this.picked(this.current);
  }
  key(event) {
    const page = Math.max(1, Math.floor(this.element.clientHeight / this.rowHeight) - 1);
    const to = {ArrowDown: this.current + 1, ArrowUp: this.current - 1, PageDown: this.current + page,
      PageUp: this.current - page, Home: 0, End: this.lines.length - 1, Enter: this.current, " ": this.current}[event.key];
    if (to === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    this.pick(to);
  }
  draw() {
    const first = this.all ? 0 : Math.max(0, Math.floor(this.element.scrollTop / this.rowHeight) - 4);
    const last = this.all ? this.lines.length : Math.min(this.lines.length, first + Math.ceil(this.element.clientHeight / this.rowHeight) + 8);
    const rows = [];
    for (let line = first; line < last; line++) rows.push(this.row(line));
    this.rows.replaceChildren(...rows);
    if (this.current >= first && this.current < last) this.element.setAttribute("aria-activedescendant", `${this.id}-${this.current}`);
    else this.element.removeAttribute("aria-activedescendant");
  }
  row(line) {
    const weight = this.weights.get(line), style = `top:${line * this.rowHeight}px`;
    const classes = ["line", this.marked.has(line) && "marked", line === this.current && "current"].filter(Boolean).join(" ");
    return make("div", {class: classes, style, role: "option", id: `${this.id}-${line}`, "data-line": line,
      "aria-selected": String(line === this.current), "aria-setsize": this.lines.length, "aria-posinset": line + 1},
    make("span", {class: "line-number"}, line + 1),
    make("span", {class: "weight", title: weight ? plural(weight, "operation") : undefined,
      style: weight ? `--share:${Math.max(0.06, Math.sqrt(weight / this.heaviest)).toFixed(3)}` : undefined}),
    make("code", {}, highlighted(this.lines[line])));
  }
}
