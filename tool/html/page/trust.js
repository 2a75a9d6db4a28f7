// What the code rests on: guards, baked-in state, verification.
function guardsSection(report) {
  const guards = report.kernel.guards || [], checks = (report.verification || {}).guards, samples = (report.verification || {}).samples;
  if (!guards.length) return [make("p", {class: "empty"}, "No guards: the code follows the one path that there is for all inputs.")];
  const rows = guards.map((guard, i) => [i + 1, make("code", {}, guard.condition || "?"),
    guard.places.length ? lineLink(guard.places[0].file, guard.places[0].line) : "",
    ...(checks && checks[i] ? [bar(1 - checks[i].failed / samples, {title: "samples on which it holds"}),
      `${number(samples - checks[i].failed)} of ${number(samples)}`] : [])]);
  const heads = ["Guard", "Condition", "Source", ...(checks ? ["Coverage", "Holds on samples"] : [])];
  return [make("p", {}, "The generated function returns the number of the first guard that does not hold."
    + (checks ? "" : " How often each holds is known after a verification: --verification FILE.")),
    table("Guards: what the recorded path rests on", heads, rows)];
}

function frozenSection(report) {
  const {frozen} = report.kernel;
  if (!frozen.length) return [make("p", {class: "empty"}, "Nothing: every number that the kernel read is an input, a parameter or a constant.")];
  const values = list => list.slice(0, 8).map(number).join(", ") + (list.length > 8 ? `, … ${number(list.length)} in all` : "");
  const link = place => {
    const parts = /^(.*?):(\d+)(?::\d+)?$/.exec(place);
    return parts ? lineLink(parts[1], Number(parts[2])) : place;
  };
  return [table("State that was read and is no input: its value is part of the code", ["Object", "Value", "Source"],
    frozen.map(state => [make("code", {}, state.name), make("code", {}, values(state.values)), link(state.place)]))];
}

function verificationSection(report) {
  const result = report.verification;
  if (!result) return [make("p", {class: "empty"}, "Not given. symreal verify --json SOURCES CODE > FILE, then --verification FILE.")];
  const wrong = result.outputs.filter(output => output.different), most = 200;
  const ulp = distance => distance > 2 ** 53 ? "NaN" : distance;
  const outside = [["not_finite", "with values that are not finite"], ["zero_sign", "in which the sign of a zero counts"],
    ["undefined", "in which the original is undefined"]].filter(([key]) => result[key]).map(([key, words]) => `${number(result[key])} ${words}`);
  const rows = [...wrong, ...result.outputs.filter(output => !output.different)].slice(0, most).map(output =>
    [make("code", {}, `${output.label} · ${output.element}`), ulp(output.worst_ulp), output.different]);
  return [
    make("p", {class: wrong.length ? "verdict bad" : "verdict good"}, wrong.length
      ? `${plural(wrong.length, "output")} of ${number(result.outputs.length)} differ from the original.`
      : `Every output is equal to the original's on ${plural(result.inside, "sample")}, in mode ${result.mode}.`),
    make("p", {}, `${plural(result.samples, "sample")} were drawn, ${number(result.inside)} lie within the premises.`
      + (outside.length ? ` Outside: ${outside.join(", ")}.` : "")),
    make("details", {open: wrong.length > 0}, make("summary", {}, "Each output"),
      table("The largest distance from the original", ["Output · element", "Worst ULP", "Samples that differ"], rows),
      result.outputs.length > most ? make("p", {class: "hint"}, `The first ${most} of ${number(result.outputs.length)}.`) : null)];
}
