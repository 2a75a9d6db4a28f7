// The nodes as columns. Node i has operands operand[first[i]] .. operand[first[i + 1] - 1]: a node, or -1 - k for
// constant k. Its depth is the number of steps from what goes in.
class GraphModel {
  constructor(data) {
    const count = this.count = data.count;
    this.data = data;
    this.ops = bytesOf(data.ops);
    this.kindOfOp = {};
    for (const [op, [name]] of Object.entries(data.table)) this.kindOfOp[op] = kindOf(name);
    this.group = new PackedReader(data.group).column(count);
    this.name = new PackedReader(data.name).column(count);
    this.line = new PackedReader(data.line).column(count);
    for (let i = 1; i < count; i++) this.line[i] += this.line[i - 1];
    this.readOperands(data);
    this.sort();
    this.leaves = new Map();
    for (let i = 0, leaf = 0; i < count; i++) if (this.isLeaf(i)) this.leaves.set(i, data.leaves[leaf++]);
    this.results = new Map();
    for (const [node, name] of data.results) this.results.set(node, [...(this.results.get(node) || []), name]);
    this.critical = new Set(data.critical_path);
  }
  readOperands(data) {
    const arity = new Uint8Array(256);
    for (const [op, [, operands]] of Object.entries(data.table)) arity[op] = operands;
    this.first = new Uint32Array(this.count + 1);
    for (let i = 0; i < this.count; i++) this.first[i + 1] = this.first[i] + arity[this.ops[i]];
    this.operand = new Int32Array(this.first[this.count]);
    this.depth = new Uint32Array(this.count);
    this.depths = 1;
    const reader = new PackedReader(data.operands);
    for (let i = 0; i < this.count; i++) {
      let depth = arity[this.ops[i]] ? 1 : 0;
      for (let at = this.first[i]; at < this.first[i + 1]; at++) {
        const code = reader.next(), node = code % 2 ? -1 - (code - 1) / 2 : i - code / 2;
        this.operand[at] = node;
        if (node >= 0) depth = Math.max(depth, this.depth[node] + 1);
      }
      this.depth[i] = depth;
      this.depths = Math.max(this.depths, depth + 1);
    }
  }
  // order: by group, then depth, then number. place: where a node stands in it.
  sort() {
    const groups = this.data.groups.length;
    const byDepth = counted(this.depth, this.depths, null), order = counted(this.group, groups, byDepth);
    this.order = order;
    this.place = new Uint32Array(this.count);
    for (let at = 0; at < this.count; at++) this.place[order[at]] = at;
    this.groupFirst = new Uint32Array(groups + 1);
    for (let i = 0; i < this.count; i++) this.groupFirst[this.group[i] + 1]++;
    for (let group = 0; group < groups; group++) this.groupFirst[group + 1] += this.groupFirst[group];
  }
  isLeaf(node) { return this.first[node] === this.first[node + 1]; }
  opName(node) { return this.data.table[this.ops[node]][0]; }
  kind(node) { return this.kindOfOp[this.ops[node]]; }
  symbol(node) { return this.leaves.get(node) || symbols[this.opName(node)] || this.opName(node); }
  operands(node) { return this.operand.subarray(this.first[node], this.first[node + 1]); }
  // Ascending; made when it is asked for first.
  users(node) {
    if (!this.userFirst) {
      this.userFirst = new Uint32Array(this.count + 1);
      for (const node of this.operand) if (node >= 0) this.userFirst[node + 1]++;
      for (let i = 0; i < this.count; i++) this.userFirst[i + 1] += this.userFirst[i];
      const next = this.userFirst.slice();
      this.user = new Uint32Array(this.userFirst[this.count]);
      for (let i = 0; i < this.count; i++)
        for (const node of this.operands(i)) if (node >= 0) this.user[next[node]++] = i;
    }
    return [...new Set(this.user.subarray(this.userFirst[node], this.userFirst[node + 1]))];
  }
  operandText(code) { return code >= 0 ? "%" + this.line[code] : this.data.constants[-1 - code]; }
  text(node) {
    return `%${this.line[node]} = ` + (this.leaves.has(node) ? `${this.opName(node)} ${this.leaves.get(node)}`
      : `${this.opName(node)} ${[...this.operands(node)].map(code => this.operandText(code)).join(" ")}`);
  }
  // The node with this number in the text of the graph, or -1.
  find(line) {
    let low = 0, high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.line[middle] < line) low = middle + 1; else high = middle;
    }
    return low < this.count && this.line[low] === line ? low : -1;
  }
}

// The numbers 0 .. keys.length - 1 by key, stable; `before`: the order that equal keys keep.
function counted(keys, limit, before) {
  const next = new Uint32Array(limit + 1), result = new Uint32Array(keys.length);
  for (let i = 0; i < keys.length; i++) next[keys[i] + 1]++;
  for (let key = 0; key < limit; key++) next[key + 1] += next[key];
  for (let at = 0; at < keys.length; at++) {
    const i = before ? before[at] : at;
    result[next[keys[i]]++] = i;
  }
  return result;
}
