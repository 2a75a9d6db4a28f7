// The page from its data: a heading for each section, an entry in the navigation, the content.
const sections = [
  ["summary", "Summary", summarySection],
  ["parallelism", "Parallelism", plotsSection],
  ["passes", "Passes", passesSection],
  ["lines", "Source lines", linesSection],
  ["code", "Source and code", codeSection],
  ["graph", "Graph", graphSection],
  ["timetable", "Timetable", timetableSection],
  ["guards", "Guards", guardsSection],
  ["frozen", "Baked-in state", frozenSection],
  ["verification", "Verification", verificationSection],
];

const report = JSON.parse(document.getElementById("data").textContent);
const main = document.querySelector("main"), nav = document.querySelector("nav");
for (const [id, title, content] of sections) {
  const section = make("section", {id, "aria-labelledby": id + "-title"}, make("h2", {id: id + "-title"}, title));
  main.append(section);
  nav.append(make("a", {href: "#" + id}, title));
  section.append(...content(report).filter(Boolean));
}
document.querySelector("footer").append(`Written by Symreal ${report.tool}. Mode ${report.mode}. Charts by uPlot, whose licence (MIT) is in this page.`);
// On paper also what is folded away on the screen.
const folded = () => document.querySelectorAll("details:not([open])");
addEventListener("beforeprint", () => { for (const each of folded()) each.dataset.folded = each.open = true; });
addEventListener("afterprint", () => { for (const each of document.querySelectorAll("[data-folded]")) { each.open = false; delete each.dataset.folded; } });
document.documentElement.dataset.ready = Math.round(performance.now());
