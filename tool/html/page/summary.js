// The figures that one looks for first, and the objects of the kernel.
const share = (part, whole) => whole ? `${number(100 * part / whole)} % of ${number(whole)}` : "";

function tiles(report) {
  const {kernel, figures, verification} = report, operations = kernel.operations;
  const result = [
    ["Arithmetic operations", operations.compute.arithmetic, share(operations.compute.arithmetic, operations.executed.arithmetic) + " executed"],
    ["Work", figures.work, `${figures.time_unit}, costs: ${figures.costs}`],
    ["Span", figures.span, "length of the critical path"],
    ["Mean parallelism", figures.parallelism, `levelled peak ${number(figures.peak.levelled)}`],
  ];
  if (!operations.executed.arithmetic) result[0][2] = share(operations.compute.arithmetic, operations.recorded.arithmetic) + " recorded";
  result.push(["Guards", (kernel.guards || []).length, kernel.guards ? "conditions on the inputs" : "holds for all inputs"]);
  if (verification) result.push(["Verification", verdict(verification).word, plural(verification.inside, "sample")]);
  return result.map(([name, value, note]) => make("div", {class: "tile"}, make("dt", {}, name),
    make("dd", {}, make("strong", {}, typeof value === "number" ? number(value) : value), make("span", {}, note))));
}

function summarySection(report) {
  const kernel = report.kernel;
  const rows = [["input", kernel.inputs], ["parameter", kernel.parameters], ["output", kernel.outputs]].flatMap(
    ([role, objects]) => objects.map(object => [make("code", {}, object.label), role, object.count]));
  const most = 12, list = table("Inputs and outputs", ["Object", "Role", "Numbers"], rows);
  return [
    make("dl", {class: "tiles"}, tiles(report)),
    rows.length > most ? make("details", {}, make("summary", {}, plural(rows.length, "object")), list) : list,
  ];
}
