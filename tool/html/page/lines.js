// Origins of the operations: source lines, those with the most generated operations first.
function linesSection(report) {
  const lines = report.kernel.lines || [], most = 15;
  if (!lines.length) return [make("p", {class: "empty"}, "The graph names no places in sources.")];
  const texts = new Map(report.sources.map(file => [file.name, file.text === null ? null : file.text.split("\n")]));
  const heaviest = Math.max(1, ...lines.map(line => line.generated));
  const row = line => {
    const text = texts.get(line.file);
    return [lineLink(line.file, line.line), line.recorded, line.generated, bar(line.generated / heaviest),
      text ? make("code", {class: "source"}, highlighted((text[line.line - 1] || "").trim())) : make("span", {class: "gone"}, "the source is gone")];
  };
  const place = make("div"), show = count => place.replaceChildren(
    table("Operations by source line", ["Line", "Recorded", "Generated", "Share", "Source"], lines.slice(0, count).map(row)),
    count < lines.length ? button(`Show all ${number(lines.length)} lines`, () => show(lines.length)) : "");
  show(most);
  return [place];
}
