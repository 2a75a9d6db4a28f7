// The graph: lanes by function and source line, open ones with their nodes.
const graphView = {}; // once it is there: select(node, reveal)

class GraphView {
  constructor(report) {
    this.report = report;
    this.model = new GraphModel(report.graph);
    this.lanes = new Lanes(this.model);
    this.scroll = 0;
    this.current = 0;
    this.selected = -1;
    this.canvas = make("canvas", {class: "picture", tabindex: 0, role: "application", "aria-label":
      "The graph. Up and down choose a group, Enter opens it, left and right move, plus and minus zoom, 0 shows all.",
      "aria-describedby": "graph-status"});
    this.status = make("p", {class: "status", id: "graph-status", "aria-live": "polite"});
    this.details = make("div", {class: "node", "aria-live": "polite"});
    this.redraw = onceAFrame(() => this.draw());
    this.range = new ViewRange(this.model.depths, () => this.redraw());
    this.laneDrawing = new LaneDrawing(this);
    this.nodeDrawing = new NodeDrawing(this, this.laneDrawing);
    this.listen();
    this.say();
    this.details.replaceChildren(...nodeDetails(this));
  }
  listen() {
    const shareAt = x => (x - chartLeft(this.canvas.clientWidth)) / (this.canvas.clientWidth - chartLeft(this.canvas.clientWidth) - 8);
    moveByPointer(this.canvas, this.range, shareAt, by => this.scrollBy(by));
    moveByKeys(this.canvas, this.range, {
      ArrowDown: () => this.choose(this.current + 1), ArrowUp: () => this.choose(this.current - 1),
      Enter: () => this.toggle(this.current), " ": () => this.toggle(this.current),
      PageDown: () => this.scrollBy(300), PageUp: () => this.scrollBy(-300),
      Home: () => this.choose(0), End: () => this.choose(this.lanes.list.length - 1),
      "[": () => this.taller(1 / 1.4), "]": () => this.taller(1.4),
      n: () => this.step(1), p: () => this.step(-1),
    });
    this.canvas.addEventListener("click", event => {
      if (this.canvas.moved < 4) this.click(event.offsetX, event.offsetY);
    });
    this.canvas.addEventListener("pointermove", event => {
      const node = this.nodeAt(event.offsetX, event.offsetY);
      this.canvas.title = node >= 0 ? this.model.text(node) : "";
    });
    new ResizeObserver(() => this.redraw()).observe(this.canvas);
    onColours(() => this.draw());
  }
  get height() { return Math.max(220, Math.min(560, this.lanes.height + gutter.axis + 6)); }
  draw() {
    const width = this.canvas.clientWidth;
    if (!width) return;
    const context = prepare(this.canvas, width, this.height);
    this.canvas.dataset.lanes = this.laneDrawing.draw(context, width, this.height);
    this.canvas.dataset.nodes = this.nodeDrawing.draw(context, width, this.height);
  }
  scrollBy(by) {
    this.scroll = Math.max(0, Math.min(this.scroll + by, this.lanes.height + gutter.axis + 6 - this.height));
    this.redraw();
  }
  taller(factor) {
    const lane = this.lanes.list[this.current], before = lane.y - this.scroll;
    this.lanes.setPitch(this.lanes.pitch * factor);
    this.scroll = this.lanes.list[this.current].y - before;
    this.scrollBy(0);
  }
  say() {
    const lane = this.lanes.list[this.current], group = this.lanes.groups[lane.group];
    this.status.textContent = `${group.label}: ${plural(this.lanes.histogram(lane.group).total, "node")}, ${lane.isOpen ? "open" : "closed"}.`;
  }
  choose(index) {
    this.current = Math.max(0, Math.min(index, this.lanes.list.length - 1));
    const lane = this.lanes.list[this.current], room = this.height - gutter.axis;
    if (lane.y < this.scroll) this.scroll = lane.y;
    else if (lane.y + Math.min(lane.height, room) > this.scroll + room) this.scroll = lane.y + Math.min(lane.height, room) - room;
    this.scrollBy(0);
    this.say();
  }
  toggle(index) {
    const {group} = this.lanes.list[index];
    this.lanes.toggle(group);
    this.choose(this.lanes.of[group]);
  }
  nodeAt(x, y) {
    const {lanes, model} = this, lane = lanes.list[lanes.laneAt(y - gutter.axis + this.scroll)];
    if (!lane || !lane.hasNodes || y < gutter.axis || x < this.laneDrawing.left) return -1;
    const depth = Math.floor(this.range.from + (x - this.laneDrawing.left) / this.nodeDrawing.cell);
    const row = Math.floor((y - this.laneDrawing.y(lane) - 6) / lanes.pitch), {counts, firsts} = lanes.histogram(lane.group);
    return row >= 0 && row < (counts[depth] || 0) ? model.order[model.groupFirst[lane.group] + firsts[depth] + row] : -1;
  }
  click(x, y) {
    const index = this.lanes.laneAt(y - gutter.axis + this.scroll), node = this.nodeAt(x, y);
    if (node >= 0) this.select(node, false);
    else if (index < this.lanes.list.length && y > gutter.axis) {
      this.current = index;
      if (x < this.laneDrawing.left || !this.lanes.list[index].hasNodes) this.toggle(index);
      else this.choose(index);
    }
  }
  // The next or the last node of the current group.
  step(by) {
    const {model} = this, {group} = this.lanes.list[this.current];
    if (this.lanes.children.has(group)) return;
    const first = model.groupFirst[group], count = model.groupFirst[group + 1] - first;
    const inside = this.selected >= 0 && model.group[this.selected] === group;
    this.select(model.order[first + (inside ? (model.place[this.selected] - first + by + count) % count : 0)], true);
  }
  select(node, reveal) {
    this.selected = node;
    this.details.replaceChildren(...nodeDetails(this));
    if (reveal) this.reveal(node);
    this.redraw();
  }
  reveal(node) {
    this.lanes.openFor(node);
    if (this.lanes.pitch < 6) this.lanes.setPitch(14);
    this.current = this.lanes.of[this.model.group[node]];
    const lane = this.lanes.list[this.current], y = lane.y + this.lanes.rowOf(node) * this.lanes.pitch;
    if (y < this.scroll || y > this.scroll + this.height - 60) this.scroll = y - this.height / 3;
    const steps = (this.canvas.clientWidth - this.laneDrawing.left) / 24, depth = this.model.depth[node];
    if (this.range.to - this.range.from > 2 * steps) this.range.set(depth + 0.5 - steps / 2, depth + 0.5 + steps / 2);
    this.range.show(depth);
    this.scrollBy(0);
    this.say();
  }
}

function graphSection(report) {
  const view = graphView.now = new GraphView(report);
  const field = make("input", {type: "text", inputmode: "numeric", size: 9, placeholder: "%12", "aria-label": "Number of a node in the graph's text"});
  const search = make("form", {class: "search", onsubmit: event => {
    event.preventDefault();
    const node = view.model.find(Number(field.value.replace("%", "")));
    if (node >= 0) view.select(node, true);
    else view.status.textContent = `Nothing needs a node ${field.value}.`;
  }}, field, make("button", {}, "Go to node"));
  return [
    make("p", {}, `${plural(view.model.count, "node")} of the optimised graph, by function and source line. A bar says how many stand at a depth; `
      + "arcs lead to the groups that use a group's numbers. Operations of the critical path are outlined."),
    make("div", {class: "tools"}, rangeButtons(view.range, "the graph"),
      button("Taller", () => view.taller(1.4), {"aria-label": "Taller rows"}), button("Flatter", () => view.taller(1 / 1.4), {"aria-label": "Flatter rows"}),
      button("Open / close", () => view.toggle(view.current), {"aria-label": "Open or close the current group"}), search),
    make("p", {class: "hint"}, "Click a group to open it. The wheel zooms once the picture has the focus; with Shift it scrolls."),
    legend(), view.canvas, view.status, view.details];
}
