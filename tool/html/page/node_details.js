// Facts on the selected node, as text and as buttons that lead on.
function nodeDetails(view) {
  const {model, selected} = view, data = model.data;
  if (selected < 0) return [make("p", {class: "hint"}, "Select an operation to see what it is, what it takes and who uses it.")];
  const leadTo = node => button("%" + model.line[node], () => view.select(node, true), {class: "link", title: model.text(node)});
  const group = data.groups[model.group[selected]], name = model.name[selected] && data.names[model.name[selected] - 1];
  const row = (label, ...content) => [make("dt", {}, label), make("dd", {}, content)];
  const users = model.users(selected), most = 24, operands = [...model.operands(selected)];
  const file = group.line && view.report.sources[group.file].name;
  return [make("dl", {class: "details"},
    row("Operation", make("code", {}, model.text(selected))),
    name ? row("Called", make("code", {}, name)) : [],
    file ? row("From", lineLink(file, group.line), group.parent !== undefined ? " in " + data.groups[group.parent].label : "") : [],
    row("Takes", operands.length ? operands.map(code => [code >= 0 ? leadTo(code) : make("code", {}, model.operandText(code)), " "]) : "nothing: it goes in"),
    row("Used by", users.length ? users.slice(0, most).map(user => [leadTo(user), " "]) : "none",
      users.length > most ? ` and ${number(users.length - most)} more` : ""),
    model.results.has(selected) ? row("Output", model.results.get(selected).slice(0, 8).join(", ")) : [],
    row("Depth", plural(model.depth[selected], "step"), " from the inputs", model.critical.has(selected) ? " · on the critical path" : ""))];
}
