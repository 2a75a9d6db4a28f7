// Operations before and after each pass, and by kind.
function passesSection(report) {
  const {passes, operations} = report.kernel;
  const total = live => Object.entries(live).reduce((sum, [name, count]) => name === "arithmetic" ? sum : sum + count, 0);
  const most = Math.max(1, ...passes.map(pass => total(pass.live)));
  let before = null;
  const rows = passes.map(pass => {
    const all = total(pass.live), less = before === null || before === all ? "" : `${all > before ? "+" : "−"}${number(Math.abs(all - before))}`;
    before = all;
    return [make("code", {}, pass.after), pass.live.arithmetic, all, less, bar(all / most)];
  });
  const columns = Object.keys(operations), names = new Set(columns.flatMap(column => Object.keys(operations[column])));
  names.delete("arithmetic");
  const byKind = [...names].map(name => [make("code", {}, name), ...columns.map(column => operations[column][name] || 0)]);
  byKind.push(["+ − × ÷ together", ...columns.map(column => operations[column].arithmetic)]);
  return [
    table("Operations that something needs, after each pass", ["After", "+ − × ÷", "All", "Change", "Share"], rows),
    make("details", {}, make("summary", {}, "Each operation, from the program to the generated code"),
      table("Executed by the program, recorded, and generated", ["Operation", ...columns.map(column =>
        ({executed: "Executed", recorded: "Recorded", compute: "In compute", preprocess: "In preprocess"})[column] || column)], byKind)),
  ];
}
