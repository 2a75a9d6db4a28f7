#include "tool/configuration/yaml.h"

#include "engine/support/files.h"
#include "engine/support/text.h"

#include <set>
#include <sstream>

namespace symreal::tool {
namespace {

// Does the item need quotes, since YAML takes it for a list, an alias, an anchor or a comment?
bool wants_quotes(std::string const &item) {
  if (item.empty() || item.front() == '"' || item.front() == '\'') return false;
  return item.front() == '*' || item.front() == '&' || item.front() == '%' || item.front() == '@' ||
         item.find_first_of("[]{}#") != item.npos;
}

// Quotes a value, or the values of a bracketed list.
std::string value_with_quotes(std::string const &value) {
  if (!value.starts_with("[")) return wants_quotes(value) ? in_quotes(value) : value;
  bool const is_closed = value.ends_with("]");
  std::string text = "[", before;
  for (std::string const &item : items_of(value.substr(1, value.size() - (is_closed ? 2 : 1)))) {
    text += before + (wants_quotes(item) ? in_quotes(item) : item);
    before = ", ";
  }
  return text + "]";
}

// `inputs: ["q[0:6]", "v"]` for `inputs: [q[0:6], v]`; `exclude: "*.cpp"` for `exclude: *.cpp`. Empty if the line needs
// no quotes.
std::string with_quotes(std::string const &line) {
  std::size_t const key = line.find(": ");
  std::size_t const dash = line.find_first_not_of(' ');
  std::size_t begin = key != line.npos ? key + 2 : 0;
  if (key == line.npos && dash != line.npos && line.compare(dash, 2, "- ") == 0) begin = dash + 2;
  std::string const value(trimmed(line.substr(begin)));
  std::string const fixed = value_with_quotes(value);
  return fixed == value ? "" : std::string(trimmed(line.substr(0, begin))) + " " + fixed;
}

// Suggested correction of the line with the error or one of the two before it; else empty.
std::string fix(std::string const &text, YAML::Mark const &mark) {
  if (mark.is_null()) return {};
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line) && static_cast<int>(lines.size()) <= mark.line;) lines.push_back(line);
  for (std::size_t k = 0; k < 3 && k < lines.size(); ++k) {
    std::string const &line = lines[lines.size() - 1 - k];
    if (std::size_t const first = line.find_first_not_of(' '); first != line.npos && line[first] == '\t')
      return "; indent with blanks, not with tabs";
    if (std::string const fixed = with_quotes(line); !fixed.empty()) return "; write it in quotes: " + fixed;
  }
  return {};
}

Place at(std::string const &file, YAML::Mark const &mark) {
  if (mark.is_null()) return {file};
  return {file, static_cast<unsigned>(mark.line) + 1, static_cast<unsigned>(mark.column) + 1};
}

} // namespace

Place Yaml::place() const { return at(file_, node_.Mark()); }

rewrite::ConfiguredText Yaml::text() const {
  if (!node_.IsScalar()) fail("expected text here");
  Place where = place();
  if (node_.Tag() == "!") ++where.column; // skips the quote
  return {node_.Scalar(), where};
}

bool Yaml::truth() const {
  bool value = false;
  if (!node_.IsScalar() || !YAML::convert<bool>::decode(node_, value)) fail("expected true or false here");
  return value;
}

std::vector<Yaml> Yaml::list() const {
  if (!node_.IsSequence()) return {*this};
  std::vector<Yaml> elements;
  for (YAML::Node const &one : node_) elements.emplace_back(file_, one);
  return elements;
}

std::vector<Yaml::Entry> Yaml::entries() const {
  if (node_.IsNull()) return {};
  if (!node_.IsMap()) fail("expected a list of 'key: value' here");
  std::vector<Entry> entries;
  std::set<std::string> known;
  for (auto const &one : node_) {
    Entry entry{Yaml(file_, one.first).text(), Yaml(file_, one.second)};
    if (!known.insert(entry.key.text).second)
      symreal::fail(DiagnosticId::configuration, entry.key.place, "'" + entry.key.text + "' appears twice");
    entries.push_back(std::move(entry));
  }
  return entries;
}

Yaml read_yaml(std::string const &file) {
  std::string const text = read_file(file);
  try {
    return {file, YAML::Load(text)};
  } catch (YAML::Exception const &problem) {
    symreal::fail(DiagnosticId::configuration, at(file, problem.mark), problem.msg + fix(text, problem.mark));
  }
}

} // namespace symreal::tool
