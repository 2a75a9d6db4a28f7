// The sources beside the generated code; a line leads to those of the other side.
const codePanes = {}; // once they are there: showLine(file, line)

class CodePanes {
  constructor(report) {
    this.report = report;
    this.code = report.code.text === undefined ? null : report.code;
    this.links();
    this.source = new LineList("Source", line => this.fromSource(line));
    this.target = new LineList("Generated code", line => this.fromTarget(line));
    this.choice = make("select", {"aria-label": "Source file", onchange: () => this.open(Number(this.choice.value))},
      report.sources.map((file, i) => make("option", {value: i}, file.name + (file.text === null ? " (gone)" : ""))));
    this.status = make("p", {class: "status", "aria-live": "polite"}, "Click a line, or move with the arrow keys, to see its counterpart.");
    if (this.code) this.target.show(this.code.text, new Map());
    const fullest = report.kernel.lines && report.kernel.lines[0];
    if (report.sources.length) this.open(Math.max(0, report.sources.findIndex(file => fullest && file.name === fullest.file)));
  }
  // Both ways: "file:line" to lines of code, lines of code to pairs of file and line.
  links() {
    this.toTarget = new Map();
    this.toSource = new Map();
    for (const [first, last, places] of this.code ? this.code.origins : [])
      for (let line = first - 1; line < last; line++)
        for (const [file, sourceLine] of places) {
          const key = file + ":" + (sourceLine - 1);
          if (!this.toTarget.has(key)) this.toTarget.set(key, []);
          this.toTarget.get(key).push(line);
          if (!this.toSource.has(line)) this.toSource.set(line, []);
          this.toSource.get(line).push([file, sourceLine - 1]);
        }
  }
  open(file) {
    if (this.file === file) return;
    this.file = file;
    this.choice.value = file;
    const {name, text} = this.report.sources[file], weights = new Map();
    for (const line of this.report.kernel.lines || [])
      if (line.file === name && line.generated) weights.set(line.line - 1, line.generated);
    this.source.show(text === null ? `The text of ${name} was not there when this report was made.` : text, text === null ? new Map() : weights);
  }
  fromSource(line) {
    const lines = this.toTarget.get(this.file + ":" + line) || [];
    this.source.mark([line], false);
    this.target.mark(lines);
    this.status.textContent = this.code ? `Line ${line + 1} of ${baseName(this.report.sources[this.file].name)}: ${plural(lines.length, "generated line")}.` : "";
  }
  fromTarget(line) {
    const places = this.toSource.get(line) || [];
    this.target.mark([line], false);
    if (places.length && !places.some(([file]) => file === this.file)) this.open(places[0][0]);
    this.source.mark(places.filter(([file]) => file === this.file).map(([, at]) => at));
    this.status.textContent = places.length ? `Line ${line + 1} comes from `
      + places.map(([file, at]) => `${baseName(this.report.sources[file].name)}:${at + 1}`).join(", ") + "." : `Line ${line + 1} comes from no source line.`;
  }
  showLine(name, line) {
    const file = this.report.sources.findIndex(each => each.name === name);
    if (file < 0) return;
    this.open(file);
    document.getElementById("code").scrollIntoView({block: "start"});
    this.source.element.focus({preventScroll: true});
    this.source.pick(line - 1);
  }
}

// "arm.cpp:12", which shows that line.
const lineLink = (file, line) => button(`${baseName(file)}:${line}`, () => codePanes.now.showLine(file, line),
  {class: "link", title: file});

function codeSection(report) {
  const panes = codePanes.now = new CodePanes(report);
  const target = panes.code ? panes.target.element : make("p", {class: "empty"},
    `The code of ${number(report.code.nodes)} nodes is left out. symreal opt GRAPH --lang=c -o FILE writes it.`);
  const source = report.sources.length ? panes.source.element : make("p", {class: "empty"},
    "The graph names no places in sources.");
  return [panes.status, make("div", {class: "panes"},
    make("div", {}, make("div", {class: "pane-head"}, make("h3", {}, "Source"), report.sources.length ? panes.choice : null), source),
    make("div", {}, make("div", {class: "pane-head"}, make("h3", {}, "Generated C"), panes.code ? make("code", {}, panes.code.name) : null), target))];
}
