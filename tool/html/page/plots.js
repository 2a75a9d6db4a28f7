// The three plots: how many operations are under way if all begin early, late, or levelled. One zoom for all.
const plotKinds = [
  ["from_inputs", "From the inputs", "each operation begins as early as it can", "plot-1"],
  ["from_outputs", "From the outputs", "each begins as late as the span allows", "plot-2"],
  ["levelled", "Levelled", "peaks are moved into valleys", "plot-3"],
];

function onePlot(place, report, [key, title, , tint], top, zoomed) {
  const {profiles, figures} = report, values = profiles[key];
  const times = values.map((_, i) => i * profiles.step / report.time_scale);
  // The last step is as long as the others.
  times.push(values.length * profiles.step / report.time_scale);
  const wholes = [1, 2, 5].flatMap(first => Array.from({length: 10}, (_, i) => first * 10 ** i)).sort((a, b) => a - b);
  const axis = more => ({...more, stroke: () => colour("muted"), font: "12px system-ui",
    labelFont: "12px system-ui", grid: {stroke: () => colour("line"), width: 1}, ticks: {stroke: () => colour("line"), width: 1}});
  return new uPlot({
    width: place.clientWidth, height: 220, cursor: {sync: {key: "profiles"}, drag: {x: true, y: false}},
    scales: {x: {time: false}, y: {range: [0, top]}},
    legend: {live: true},
    axes: [axis({label: `time in ${figures.time_unit}`, size: 30, labelSize: 20}), axis({size: 44, incrs: wholes})],
    series: [{label: "time"}, {label: title, stroke: () => colour(tint), fill: () => colour(tint) + "33", width: 1.5,
      paths: uPlot.paths.stepped({align: 1}), points: {show: false}}],
    hooks: {setScale: [(plot, scale) => { if (scale === "x") zoomed(plot); }]},
  }, [times, values.concat(values.length ? values[values.length - 1] : 0)], place);
}

function plotsSection(report) {
  const places = plotKinds.map(([, title]) => make("div", {class: "plot", role: "img", "aria-label": title}));
  const plots = [];
  const length = Math.max(...plotKinds.map(([key]) => report.profiles[key].length)) * report.profiles.step / report.time_scale;
  const top = 1.08 * Math.max(1, ...plotKinds.map(([key]) => report.profiles[key].reduce((a, b) => Math.max(a, b), 0)));
  let busy = true;
  const range = new ViewRange(length, () => {
    busy = true;
    for (const plot of plots) plot.setScale("x", {min: range.from, max: range.to});
    busy = false;
  });
  const zoomed = plot => {
    const {min, max} = plot.scales.x;
    if (!busy && min !== null && (Math.abs(min - range.from) > 1e-9 || Math.abs(max - range.to) > 1e-9)) range.set(min, max);
  };
  const build = () => {
    plots.push(...plotKinds.map((kind, i) => onePlot(places[i], report, kind, top, zoomed)));
    places[0].dataset.drawn = plots.length;
    range.fit();
  };
  requestAnimationFrame(build);
  addEventListener("resize", onceAFrame(() => plots.forEach((plot, i) => plot.setSize({width: places[i].clientWidth, height: 220}))));
  onColours(() => plots.forEach(plot => plot.redraw(false)));
  const peaks = report.figures.peak;
  return [
    make("p", {}, `How many operations run at once. ${plural(report.figures.least_units, "unit")} at least `
      + "are needed to be as fast as any number of units."),
    make("div", {class: "tools"}, rangeButtons(range, "the plots"),
      make("span", {class: "hint"}, "Drag across a plot to zoom; a double click shows all.")),
    make("div", {class: "plots"}, plotKinds.map(([key, title, words], i) => make("figure", {},
      make("figcaption", {}, make("strong", {}, title), ` peak ${number(peaks[key])}`, make("span", {}, words)), places[i]))),
    criticalPath(report),
  ];
}

function criticalPath(report) {
  const words = step => Object.entries(step.operations || {}).map(([name, count]) => count > 1 ? `${count} ${name}` : name).join(", ");
  const rows = report.figures.critical_path.map(step => [step.begins, words(step), step.name || "",
    step.file ? lineLink(step.file, step.line) : ""]);
  const path = table("The critical path, by source line", ["Begins at", "Operations", "Name", "Source"], rows.slice(0, 500));
  return make("details", {}, make("summary", {}, `The critical path: ${plural(rows.length, "step")}`), path);
}
