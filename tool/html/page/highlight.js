// A line of C or C++ as elements: comments, literals, numbers, words of the language.
const tokens = new RegExp([
  "(?<comment>//.*|/\\*.*?(?:\\*/|$)|^\\s*#.*$)", "(?<text>\"(?:\\\\.|[^\"\\\\])*\"|'(?:\\\\.|[^'\\\\])+')",
  "(?<number>\\b(?:0x[\\da-fA-F.]+(?:p[+-]?\\d+)?|\\d[\\d.]*(?:e[+-]?\\d+)?)[fFlLuU]*)",
  "(?<word>\\b(?:auto|bool|break|case|class|const|constexpr|continue|default|do|double|else|enum|extern|float|for|if|inline|int|"
  + "long|namespace|operator|private|public|return|short|signed|sizeof|static|struct|switch|template|this|typedef|typename|"
  + "unsigned|using|void|while)\\b)"].join("|"), "g");

function highlighted(line) {
  const parts = [];
  let at = 0;
  for (const match of line.slice(0, 2000).matchAll(tokens)) {
    if (match.index > at) parts.push(line.slice(at, match.index));
    const kind = Object.keys(match.groups).find(name => match.groups[name] !== undefined);
    parts.push(make("span", {class: "c-" + kind}, match[0]));
    at = match.index + match[0].length;
  }
  parts.push(line.slice(at));
  return parts;
}
