// Foundations of the code: guards, baked-in state, verification.
function guardsSection(report) {
  const guards = report.kernel.guards || [], {guards: checks, samples} = report.verification || {};
  if (!guards.length) return [make("p", {class: "empty"}, "No guards: the code follows the one path that there is for all inputs.")];
  // Guards may be others in code that other passes made.
  const covered = checks && checks.length === guards.length, stopped = covered ? checks.map(check => check.failed) : [];
  // Samples within the premises; files of earlier versions do not say how many these are.
  const asked = covered ? checks.map((check, i) => check.evaluated ?? samples - stopped.slice(0, i).reduce((a, b) => a + b, 0)) : [];
  const left = covered ? asked.at(-1) - stopped.at(-1) : 0;
  const rows = guards.map((guard, i) => {
    const row = [i + 1, make("code", {}, guard.condition || "?"),
      guard.places.length ? lineLink(guard.places[0].file, guard.places[0].line) : ""];
    if (!covered) return row;
    const goesOn = asked[i] - stopped[i];
    return [...row, bar(asked[0] ? goesOn / asked[0] : 0, {title: "samples on which this one and those above hold"}), asked[i], goesOn, stopped[i]];
  });
  const heads = ["Guard", "Condition", "Source", ...(covered ? ["Coverage", "Asked", "Go on", "Stop here"] : [])];
  return [make("p", {}, "The generated function returns the number of the first guard that does not hold. " + (covered
    ? `All hold on ${number(left)} of ${plural(asked[0], "sample")} of the verification within the premises; a guard is asked where those above hold.` : "How often each holds is known after a verification: --verification FILE.")),
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
  return [table("State that was read and is not an input: its value is part of the code", ["Object", "Value", "Source"],
    frozen.map(state => [make("code", {}, state.name), make("code", {}, values(state.values)), link(state.place)]))];
}

const ulp = distance => distance > 2 ** 53 ? "NaN" : distance;

// Whether all is well, in a word and in a sentence.
function verdict(result) {
  const wrong = result.outputs.filter(output => output.different).length, left = result.left_behind || [];
  const faults = [
    [wrong, `${plural(wrong, "output")} of ${number(result.outputs.length)} differ from the original.`],
    [result.rewritten_different, `The rewritten program differs from the original in ${plural(result.rewritten_different, "output")}.`],
    [result.called_again_different, `Called again, the original differs in ${plural(result.called_again_different, "output")}.`],
    [left.length, `State is left behind: ${left.map(state => state.name).join(", ")}.`],
    [!result.inside, "No sample lies within the premises: nothing was compared."],
  ].filter(([is]) => is);
  if (faults.length) return {good: false, word: "failed", sentence: faults.map(([, words]) => words).join(" ")};
  const worst = result.outputs.reduce((most, output) => Math.max(most, output.worst_ulp), 0);
  const where = `on ${plural(result.inside, "sample")}, in mode ${result.mode}.`;
  return worst === 0 ? {good: true, word: "equal", sentence: `Every output is equal to the original's ${where}`}
    : {good: true, word: "in tolerance", sentence: `Every output is within the tolerance, at most ${number(ulp(worst))} ULP from the original's, ${where}`};
}

function verificationSection(report) {
  const result = report.verification;
  if (!result) return [make("p", {class: "empty"}, "Not given. symreal verify --json SOURCES CODE > FILE, then --verification FILE.")];
  const most = 200, {good, sentence} = verdict(result);
  const outside = [["not_finite", "with values that are not finite"], ["zero_sign", "in which the sign of a zero counts"],
    ["undefined", "in which the original is undefined"]].filter(([key]) => result[key]).map(([key, words]) => `${number(result[key])} ${words}`);
  const rows = [...result.outputs].sort((a, b) => (b.different > 0) - (a.different > 0)).slice(0, most).map(output =>
    [make("code", {}, `${output.label} · ${output.element}`), ulp(output.worst_ulp), output.different]);
  return [
    make("p", {class: good ? "verdict good" : "verdict bad"}, sentence),
    make("p", {}, `${plural(result.samples, "sample")} were drawn, ${number(result.inside)} lie within the premises.`
      + (outside.length ? ` Outside: ${outside.join(", ")}.` : "")),
    make("details", {open: !good}, make("summary", {}, "Each output"),
      table("The largest distance from the original", ["Output · element", "Worst ULP", "Samples that differ"], rows),
      result.outputs.length > most ? make("p", {class: "hint"}, `The first ${most} of ${number(result.outputs.length)}.`) : null)];
}
