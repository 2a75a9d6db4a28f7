// The nodes of open lanes and the lines between them. Too small to be seen, they are columns.
class NodeDrawing {
  constructor(view, base) {
    this.view = view;
    this.base = base; // LaneDrawing, which knows where things stand
    this.most = 1200; // nodes with lines to their operands
  }
  draw(context, width, height) {
    const {lanes, range, scroll} = this.view;
    this.context = context;
    this.cell = this.base.x(1) - this.base.x(0);
    this.seen = [];
    context.save();
    context.beginPath();
    context.rect(this.base.left, gutter.axis, width - this.base.left, height - gutter.axis);
    context.clip();
    for (let i = lanes.laneAt(scroll); i < lanes.list.length && lanes.list[i].y < scroll + height; i++)
      if (lanes.list[i].hasNodes) this.lane(lanes.list[i], height);
    if (this.seen.length <= this.most) {
      context.globalAlpha = 0.55;
      for (const node of this.seen)
        for (const operand of this.view.model.operands(node)) if (operand >= 0 && this.isShown(operand)) this.line(operand, node, "faint", 1);
      context.globalAlpha = 1;
    }
    const {selected} = this.view;
    if (selected >= 0) {
      for (const operand of this.view.model.operands(selected)) if (operand >= 0) this.line(operand, selected, "accent", 1.75);
      for (const user of this.view.model.users(selected).slice(0, 2000)) this.line(selected, user, "plot-2", 1.75);
    }
    for (const node of this.seen) this.node(node);
    if (selected >= 0 && !this.seen.includes(selected)) this.node(selected);
    context.restore();
    return this.seen.length;
  }
  lane(lane, height) {
    const {view: {lanes, range, model}, context, base} = this, {counts, firsts} = lanes.histogram(lane.group);
    const from = Math.max(0, Math.floor(range.from)), to = Math.min(counts.length, Math.ceil(range.to));
    const top = base.y(lane) + 6, pitch = lanes.pitch;
    const firstRow = Math.max(0, Math.floor((gutter.axis - top) / pitch)), rows = Math.ceil((height - top) / pitch);
    if (pitch < 4 || this.cell < 4) {
      context.fillStyle = colour("accent");
      const step = Math.max(1, Math.floor(1 / this.cell));
      for (let depth = from; depth < to; depth += step) {
        let most = 0;
        for (let i = depth; i < Math.min(depth + step, to); i++) most = Math.max(most, counts[i]);
        if (most) context.fillRect(base.x(depth), top, Math.max(1, this.cell * step - 0.5), Math.max(1, most * pitch));
      }
      return;
    }
    for (let depth = from; depth < to; depth++)
      for (let row = firstRow; row < Math.min(counts[depth], rows); row++)
        this.seen.push(model.order[model.groupFirst[lane.group] + firsts[depth] + row]);
  }
  // The middle of a node, or of the lane that hides it.
  at(node) {
    const {model, lanes} = this.view, lane = lanes.list[lanes.of[model.group[node]]];
    const x = this.base.x(model.depth[node] + 0.5), y = this.base.y(lane);
    return lane.hasNodes ? [x, y + 6 + (lanes.rowOf(node) + 0.5) * lanes.pitch] : [x, y + lane.height / 2];
  }
  isShown(node) { return this.view.lanes.list[this.view.lanes.of[this.view.model.group[node]]].hasNodes; }
  line(from, to, tint, thick) {
    const {context} = this, [x1, y1] = this.at(from), [x2, y2] = this.at(to), bend = Math.max(10, (x2 - x1) / 2);
    context.strokeStyle = colour(tint);
    context.lineWidth = thick;
    context.beginPath();
    context.moveTo(x1, y1);
    context.bezierCurveTo(x1 + bend, y1, x2 - bend, y2, x2, y2);
    context.stroke();
  }
  node(node) {
    const {context, view: {model, lanes, selected}} = this, [x, y] = this.at(node);
    const h = Math.max(3, Math.min(lanes.pitch - 2, 18)), w = Math.max(3, Math.min(this.cell - 3, h > 9 ? 64 : h * 2));
    context.fillStyle = colour("kind-" + model.kind(node));
    context.beginPath();
    context.roundRect(x - w / 2, y - h / 2, w, h, Math.min(4, h / 3));
    context.fill();
    if (node === selected || model.critical.has(node)) {
      context.strokeStyle = colour(node === selected ? "ink" : "critical");
      context.lineWidth = node === selected ? 2.5 : 1.5;
      context.stroke();
    }
    if (h < 11 || w < 14) return;
    context.fillStyle = colour("on-kind");
    context.font = `${Math.min(12, h - 1)}px system-ui, sans-serif`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    const symbol = model.symbol(node);
    if (context.measureText(symbol).width < w - 4) context.fillText(symbol, x, y + 0.5);
  }
}
