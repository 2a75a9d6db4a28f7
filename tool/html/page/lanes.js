// The picture's rows. A lane is a function, a source line below it, or, without a source, a kind of operation. Closed, it
// shows how many of its nodes there are by depth; open, its source lines, or its nodes.
class Lanes {
  constructor(model) {
    this.model = model;
    this.groups = model.data.groups;
    this.children = new Map();
    this.groups.forEach((group, i) => {
      if (group.parent === undefined) return;
      if (!this.children.has(group.parent)) this.children.set(group.parent, []);
      this.children.get(group.parent).push(i);
    });
    this.open = new Set();
    this.histograms = new Map();
    this.pitch = 14;
    this.arrange();
  }
  // Nodes by depth: counts[d] of them, from firsts[d] on among those of the group.
  histogram(group) {
    if (!this.histograms.has(group)) {
      const counts = new Uint32Array(this.model.depths), leaves = this.children.get(group) || [group];
      let total = 0;
      for (const leaf of leaves)
        for (let at = this.model.groupFirst[leaf]; at < this.model.groupFirst[leaf + 1]; at++, total++)
          counts[this.model.depth[this.model.order[at]]]++;
      const firsts = new Uint32Array(counts.length + 1);
      let most = 0, least = -1, last = 0;
      counts.forEach((count, depth) => {
        firsts[depth + 1] = firsts[depth] + count;
        most = Math.max(most, count);
        if (count) { last = depth; if (least < 0) least = depth; }
      });
      this.histograms.set(group, {counts, firsts, most, total, least, last});
    }
    return this.histograms.get(group);
  }
  // The lanes from top to bottom: y, height, how deep in the tree.
  arrange() {
    const tops = this.groups.map((_, i) => i).filter(i => this.groups[i].parent === undefined);
    const centre = group => { const h = this.histogram(group); return h.least + h.last / 1e6; };
    tops.sort((a, b) => centre(a) - centre(b) || a - b);
    this.list = [];
    this.of = new Int32Array(this.groups.length).fill(-1); // the lane that shows a group
    let y = 0;
    const add = (group, level) => {
      const children = this.children.get(group) || [], isOpen = this.open.has(group);
      const hasNodes = isOpen && !children.length;
      const height = hasNodes ? Math.max(34, this.histogram(group).most * this.pitch + 12) : isOpen ? 24 : 34;
      const index = this.list.length;
      this.list.push({group, level, y, height, isOpen, hasNodes, isHead: isOpen && children.length > 0});
      y += height;
      this.of[group] = index;
      for (const child of children)
        if (isOpen) add(child, level + 1); else this.of[child] = index;
    };
    tops.forEach(group => add(group, 0));
    this.height = y;
    this.links = null;
  }
  toggle(group) {
    const children = this.children.get(group) || [];
    if (this.open.has(group)) this.open.delete(group);
    else {
      this.open.add(group);
      if (children.length === 1) this.open.add(children[0]);
    }
    this.arrange();
  }
  // So that the node is there to be seen.
  openFor(node) {
    const group = this.model.group[node], parent = this.groups[group].parent;
    if (parent !== undefined) this.open.add(parent);
    this.open.add(group);
    this.arrange();
  }
  setPitch(pitch) { this.pitch = Math.min(Math.max(pitch, 0.02), 22); this.arrange(); }
  laneAt(y) {
    let low = 0, high = this.list.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.list[middle].y + this.list[middle].height <= y) low = middle + 1; else high = middle;
    }
    return low;
  }
  // The row of a node within its open lane.
  rowOf(node) {
    const group = this.model.group[node];
    return this.model.place[node] - this.model.groupFirst[group] - this.histogram(group).firsts[this.model.depth[node]];
  }
  // Which lanes use which: [from, to, how often], at most a few hundred, the strongest.
  usage() {
    if (this.links) return this.links;
    const {model} = this, counts = new Map(), size = this.list.length;
    for (let node = 0; node < model.count; node++) {
      const to = this.of[model.group[node]];
      for (let at = model.first[node]; at < model.first[node + 1]; at++) {
        const operand = model.operand[at];
        if (operand < 0) continue;
        const from = this.of[model.group[operand]];
        if (from !== to) counts.set(from * size + to, (counts.get(from * size + to) || 0) + 1);
      }
    }
    const all = [...counts].map(([key, count]) => [Math.floor(key / size), key % size, count]);
    return this.links = all.sort((a, b) => b[2] - a[2]).slice(0, 400);
  }
}
