// The timetable as a Gantt chart: a row for each unit. Tasks too short to be seen are drawn as one bar.
class TimetableView {
  constructor(report) {
    this.report = report;
    this.rowHeight = 28;
    this.units = report.timetable.units.map(unit => this.decode(unit));
    this.canvas = make("canvas", {class: "picture", tabindex: 0, role: "application", "aria-describedby": "timetable-status", "aria-label":
      "The timetable. Left and right move, plus and minus zoom, 0 shows all, n and p go from task to task, up and down from unit to unit."});
    this.status = make("p", {class: "status", id: "timetable-status", "aria-live": "polite"}, "Point at a bar, or press n, to read its task.");
    this.redraw = onceAFrame(() => this.draw());
    this.scroll = this.unit = 0;
    this.task = -1;
    this.range = new ViewRange(report.timetable.length, () => this.redraw());
    const shareAt = x => (x - this.left) / (this.width - this.left - 8);
    this.shareAt = shareAt;
    moveByPointer(this.canvas, this.range, shareAt, by => this.scrollBy(by));
    moveByKeys(this.canvas, this.range, {n: () => this.choose(this.unit, this.task + 1), p: () => this.choose(this.unit, this.task - 1),
      ArrowDown: () => this.choose(this.unit + 1, 0), ArrowUp: () => this.choose(this.unit - 1, 0),
      Enter: () => this.task >= 0 && graphView.now.select(this.units[this.unit].node[this.task], true)});
    this.canvas.addEventListener("pointermove", event => { if (!event.buttons) this.point(event, false); });
    this.canvas.addEventListener("click", event => { if (this.canvas.moved < 4) this.point(event, true); });
    new ResizeObserver(() => this.redraw()).observe(this.canvas);
    onColours(() => this.draw());
  }
  decode(unit) {
    const wait = new PackedReader(unit.wait).column(unit.tasks), duration = new PackedReader(unit.duration).column(unit.tasks);
    const begin = new Float64Array(unit.tasks);
    for (let i = 0, end = 0; i < unit.tasks; i++) end = (begin[i] = end + wait[i]) + duration[i];
    return {name: unit.name, busy: unit.busy, begin, duration, node: new PackedReader(unit.node).column(unit.tasks)};
  }
  get height() { return Math.min(gutter.axis + this.rowHeight * this.units.length + 6, 520); }
  x(time) { return this.left + this.range.share(time) * (this.width - this.left - 8); }
  scrollBy(by) {
    this.scroll = Math.max(0, Math.min(this.scroll + by, gutter.axis + this.rowHeight * this.units.length + 6 - this.height));
    this.redraw();
  }
  draw() {
    const width = this.width = this.canvas.clientWidth; // asked for once a picture: it costs a layout
    if (!width) return;
    this.left = Math.min(150, 0.3 * width);
    const context = this.context = prepare(this.canvas, width, this.height), scale = this.report.time_scale;
    context.font = "12px system-ui, sans-serif";
    context.textBaseline = "middle";
    context.textAlign = "center";
    for (const at of marks(this.range.from, this.range.to, 12)) {
      context.fillStyle = colour("muted");
      context.fillText(number(at / scale), this.x(at), 11);
      context.fillStyle = colour("line");
      context.fillRect(this.x(at), gutter.axis, 1, this.height);
    }
    context.save();
    context.beginPath();
    context.rect(0, gutter.axis, width, this.height);
    context.clip();
    let drawn = 0;
    const last = Math.min(this.units.length, Math.ceil((this.scroll + this.height) / this.rowHeight));
    for (let unit = Math.floor(this.scroll / this.rowHeight); unit < last; unit++) drawn += this.row(unit, width);
    context.restore();
    this.canvas.dataset.bars = drawn;
  }
  row(index, width) {
    const {context} = this, unit = this.units[index], y = gutter.axis + index * this.rowHeight - this.scroll, middle = y + this.rowHeight / 2;
    context.fillStyle = colour("ink");
    context.textAlign = "left";
    context.fillText(fitted(context, unit.name, this.left - 66), 12, middle);
    context.fillStyle = colour("muted");
    context.textAlign = "right";
    context.fillText(`${Math.round(100 * unit.busy / this.report.timetable.length)} %`, this.left - 10, middle);
    context.save();
    context.beginPath();
    context.rect(this.left, y, width - this.left - 8, this.rowHeight);
    context.clip();
    let drawn = 0, merged = null;
    const flush = () => {
      if (!merged) return;
      this.bar(merged.from, merged.to, y, colour("faint"));
      merged = null;
      drawn++;
    };
    for (let i = this.firstAfter(unit, this.range.from); i < unit.begin.length && unit.begin[i] <= this.range.to; i++) {
      const from = this.x(unit.begin[i]), to = this.x(unit.begin[i] + unit.duration[i]);
      if (to - from >= 3) {
        flush();
        this.taskBar(unit, i, from, to, y, index === this.unit && i === this.task);
        drawn++;
      } else if (merged && from - merged.to < 1) merged.to = to;
      else { flush(); merged = {from, to}; }
    }
    flush();
    context.restore();
    return drawn;
  }
  bar(from, to, y, tint) {
    this.context.fillStyle = tint;
    this.context.fillRect(from, y + 4, Math.max(1, to - from - (to - from > 4 ? 1 : 0)), this.rowHeight - 8);
  }
  taskBar(unit, i, from, to, y, isCurrent) {
    const {context} = this, {model} = graphView.now, node = unit.node[i];
    this.bar(from, to, y, colour("kind-" + model.kind(node)));
    if (isCurrent) {
      context.strokeStyle = colour("ink");
      context.lineWidth = 2;
      context.strokeRect(from + 0.5, y + 4, to - from - 2, this.rowHeight - 8);
    }
    if (to - from < 16) return;
    context.fillStyle = colour("on-kind");
    context.textAlign = "center";
    const text = to - from > 70 ? `%${model.line[node]} ${model.symbol(node)}` : model.symbol(node);
    if (context.measureText(text).width < to - from - 4) context.fillText(text, (from + to) / 2, y + this.rowHeight / 2);
  }
  // The first task that ends after a time.
  firstAfter(unit, time) {
    let low = 0, high = unit.begin.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (unit.begin[middle] + unit.duration[middle] <= time) low = middle + 1; else high = middle;
    }
    return low;
  }
  point(event, isClick) {
    const index = Math.floor((event.offsetY - gutter.axis + this.scroll) / this.rowHeight), unit = this.units[index];
    if (!unit || event.offsetX < this.left) return;
    const time = this.range.from + this.shareAt(event.offsetX) * (this.range.to - this.range.from), task = this.firstAfter(unit, time);
    if (task >= unit.begin.length || unit.begin[task] > time) return;
    this.choose(index, task, false);
    if (isClick) graphView.now.select(unit.node[task], true);
  }
  choose(index, task, reveal = true) {
    this.unit = Math.max(0, Math.min(index, this.units.length - 1));
    const unit = this.units[this.unit], scale = this.report.time_scale;
    this.task = Math.max(0, Math.min(task, unit.begin.length - 1));
    if (!unit.begin.length) return;
    const end = unit.begin[this.task] + unit.duration[this.task];
    this.status.textContent = `${unit.name}, ${number(unit.begin[this.task] / scale)} to ${number(end / scale)}: ${graphView.now.model.text(unit.node[this.task])}`;
    if (reveal) {
      this.range.show(unit.begin[this.task]);
      const y = this.unit * this.rowHeight;
      if (y < this.scroll || y > this.scroll + this.height - 2 * this.rowHeight) this.scrollBy(y - this.scroll - this.height / 3);
    }
    this.redraw();
  }
}

function timetableSection(report) {
  const {timetable, figures, time_scale} = report, view = new TimetableView(report);
  const amount = time => `${number(time / time_scale)} ${figures.time_unit}`;
  const inARow = figures.time_unit === "nanoseconds" ? "" : " one after the other";
  const words = timetable.proven_optimal ? "No timetable is shorter." : `None is shorter than ${amount(timetable.bounds.best)}: the gap is at most ${number(timetable.gap_percent)} %.`;
  return [make("p", {}, `On ${plural(timetable.units.length, "unit")} it takes as long as ${amount(timetable.length)}${inARow}. ${words}`),
    make("div", {class: "tools"}, rangeButtons(view.range, "the timetable"),
      make("span", {class: "hint"}, "A click on a bar shows the operation in the graph above.")),
    legend(), view.canvas, view.status];
}
