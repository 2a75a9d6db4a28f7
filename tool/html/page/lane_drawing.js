// Lanes, their labels, the arcs of what uses what, the axis. Only what is in sight is drawn.
const gutter = {label: 210, arcs: 64, axis: 24};
const chartLeft = width => Math.min(gutter.label + gutter.arcs, 0.45 * width);

class LaneDrawing {
  constructor(view) { this.view = view; }
  draw(context, width, height) {
    const {lanes, scroll, range} = this.view;
    Object.assign(this, {context, width, height, left: chartLeft(width)});
    this.axis();
    context.save();
    context.beginPath();
    context.rect(0, gutter.axis, width, height - gutter.axis);
    context.clip();
    let drawn = 0;
    for (let i = lanes.laneAt(scroll); i < lanes.list.length && lanes.list[i].y < scroll + height; i++) {
      this.lane(lanes.list[i], i);
      drawn++;
    }
    if (this.left > gutter.label) this.arcs();
    context.restore();
    return drawn;
  }
  x(depth) { return this.left + this.view.range.share(depth) * (this.width - this.left - 8); }
  y(lane) { return lane.y - this.view.scroll + gutter.axis; }

  axis() {
    const {context, view: {range}} = this;
    context.font = "12px system-ui, sans-serif";
    context.fillStyle = colour("muted");
    context.strokeStyle = colour("line");
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.lineWidth = 1;
    for (const at of marks(range.from, Math.max(range.from + 1, range.to - 1), 12)) {
      const x = this.x(at + 0.5);
      context.fillText(number(at), x, 11);
      context.beginPath();
      context.moveTo(x, gutter.axis);
      context.lineTo(x, this.height);
      context.stroke();
    }
    context.textAlign = "left";
    context.fillText("steps from the inputs", 12, 11);
  }
  lane(lane, index) {
    const {context, view} = this, y = this.y(lane), group = view.lanes.groups[lane.group];
    if (index === view.current) {
      context.fillStyle = colour("current");
      context.fillRect(0, y, this.width, lane.height);
    }
    context.strokeStyle = colour("line");
    context.beginPath();
    context.moveTo(0, y + lane.height - 0.5);
    context.lineTo(this.width, y + lane.height - 0.5);
    context.stroke();
    const middle = Math.max(gutter.axis + 12, Math.min(y + Math.min(lane.height, 34) / 2, y + lane.height - 12));
    const indent = 12 + 14 * lane.level, count = number(view.lanes.histogram(lane.group).total);
    context.textBaseline = "middle";
    context.textAlign = "right";
    context.font = "12px system-ui, sans-serif";
    context.fillStyle = colour("muted");
    const right = Math.min(gutter.label, this.left) - 6, room = right - indent - 22 - context.measureText(count).width;
    context.fillText(count, right, middle);
    context.textAlign = "left";
    context.fillStyle = colour("accent");
    context.fillText(lane.isOpen ? "▾" : "▸", indent, middle);
    context.fillStyle = colour("ink");
    context.font = (lane.level || group.line ? "" : "600 ") + "13px system-ui, sans-serif";
    context.fillText(fitted(context, group.label, room), indent + 16, middle);
    if (lane.hasNodes) return;
    this.histogram(lane, y);
  }
  // A bar a step, or a pixel: the most of what is there.
  histogram(lane, y) {
    const {context, view: {range, lanes}} = this, {counts, most, least, last} = lanes.histogram(lane.group);
    const from = Math.max(Math.floor(range.from), least), to = Math.min(Math.ceil(range.to), last + 1);
    if (to <= from) return;
    const bottom = y + lane.height - 5, room = lane.height - (lane.isHead ? 14 : 10);
    context.fillStyle = colour("line");
    context.fillRect(this.x(from), bottom, this.x(to) - this.x(from), 1);
    context.fillStyle = colour(lane.isHead ? "faint" : "accent");
    const step = Math.max(1, Math.floor((range.to - range.from) / (this.width - this.left)));
    for (let depth = from - from % step; depth < to; depth += step) {
      let count = 0;
      for (let i = Math.max(depth, 0); i < Math.min(depth + step, to); i++) count = Math.max(count, counts[i]);
      if (!count) continue;
      const x = this.x(depth), w = this.x(depth + step) - x, h = Math.max(1.5, room * Math.sqrt(count / most));
      context.fillRect(x + (w > 4 ? 1 : 0), bottom - h, Math.max(1, w - (w > 4 ? 2 : 0)), h);
    }
  }
  // From a lane to those that use its numbers, on the right of the labels; a current lane's stand out.
  arcs() {
    const {context, view} = this, {lanes} = view, right = this.left - 8;
    const middle = lane => this.y(lane) + Math.min(lane.height, 34) / 2;
    for (const [from, to, count] of lanes.usage()) {
      const a = middle(lanes.list[from]), b = middle(lanes.list[to]);
      if (Math.max(a, b) < 0 || Math.min(a, b) > this.height) continue;
      const isCurrent = from === view.current || to === view.current;
      context.strokeStyle = colour(!isCurrent ? "faint" : from === view.current ? "plot-2" : "accent");
      context.globalAlpha = isCurrent ? 1 : 0.6;
      context.lineWidth = Math.min(4, 0.75 + Math.log10(count) * 0.8);
      const reach = Math.min(gutter.arcs - 14, 8 + Math.abs(b - a) * 0.2);
      context.beginPath();
      context.moveTo(right, a);
      context.bezierCurveTo(right - reach * 1.3, a, right - reach * 1.3, b, right, b);
      context.stroke();
      context.globalAlpha = 1;
    }
    context.lineWidth = 1;
  }
}

function fitted(context, text, room) {
  if (context.measureText(text).width <= room) return text;
  let length = text.length;
  while (length > 1 && context.measureText(text.slice(0, length) + "…").width > room) length--;
  return text.slice(0, length) + "…";
}
