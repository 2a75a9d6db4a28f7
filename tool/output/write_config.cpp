#include "tool/output/write_config.h"

#include "engine/support/files.h"
#include "rewrite/facts/tables.h"
#include "tool/configuration/yaml.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <optional>

namespace symreal::tool {
namespace {

using Clauses = std::vector<std::pair<std::string, std::vector<std::string>>>; // by key, in the pragma's order

std::vector<std::string> split(std::string const &list) {
  std::vector<std::string> names;
  for (std::size_t begin = 0, end; begin < list.size(); begin = end + 2) {
    end = std::min(list.find(", ", begin), list.size());
    std::string const name = list.substr(begin, end - begin);
    names.push_back(name.find_first_of("[]{},:#&*") == name.npos ? name : "\"" + name + "\"");
  }
  return names;
}

Clauses clauses_of(Lacking const &lacking) {
  Clauses clauses;
  for (rewrite::ClauseInfo const &row : rewrite::clause_table())
    if (auto const found = lacking.clauses.find(std::string(row.name)); found != lacking.clauses.end())
      clauses.emplace_back(row.key, split(found->second));
  return clauses;
}

std::string list(std::vector<std::string> const &names) { return fmt::format("{}", fmt::join(names, ", ")); }

// Changes to the text of a file, at places that its reader reports.
class Changes {
public:
  explicit Changes(std::string text) : text_(std::move(text)) {
    for (std::size_t at = 0; at != std::string::npos; at = next_line(at)) lines_.push_back(at);
  }

  std::size_t offset(Place const &place) const { return lines_.at(place.line - 1) + place.column - 1; }
  std::size_t line_of(std::size_t offset) const { return text_.rfind('\n', offset) + 1; } // begin of the line
  std::size_t next_line(std::size_t offset) const {
    std::size_t const end = text_.find('\n', offset);
    return end == text_.npos || end + 1 >= text_.size() ? text_.npos : end + 1;
  }
  std::string indentation(std::size_t offset) const { return std::string(offset - line_of(offset), ' '); }
  char at(std::size_t offset) const { return text_[offset]; }

  // Offset behind the quoted or plain word that begins here.
  std::size_t end_of_word(std::size_t begin) const {
    if (text_[begin] == '"' || text_[begin] == '\'') return text_.find(text_[begin], begin + 1) + 1;
    std::size_t end = std::min(text_.find_first_of("\n#,]}", begin), text_.size());
    while (end > begin && text_[end - 1] == ' ') --end;
    return end;
  }
  // Offset of the bracket that closes the one here.
  std::size_t closing(std::size_t open) const {
    std::size_t depth = 0;
    for (std::size_t at = open; at < text_.size(); ++at) {
      if (text_[at] == '"' || text_[at] == '\'') at = text_.find(text_[at], at + 1);
      if (at == text_.npos) break;
      if (text_[at] == '[' || text_[at] == '{') ++depth;
      if ((text_[at] == ']' || text_[at] == '}') && --depth == 0) return at;
    }
    return text_.size();
  }

  void insert(std::size_t offset, std::string const &text) { insertions_[offset] += text; }
  // Adds a line below the one of this offset.
  void add_line(std::size_t offset, std::string const &text) {
    std::size_t const next = next_line(offset);
    next == text_.npos ? append(text + "\n") : insert(next, text + "\n");
  }
  void append(std::string const &text) {
    insert(text_.size(), (text_.empty() || text_.ends_with('\n') ? "" : "\n") + text);
  }

  std::string result() const {
    std::string text = text_;
    for (auto one = insertions_.rbegin(); one != insertions_.rend(); ++one) text.insert(one->first, one->second);
    return text;
  }

private:
  std::string text_;
  std::vector<std::size_t> lines_; // begins of the lines
  std::map<std::size_t, std::string> insertions_;
};

std::string entry(std::string const &function, Clauses const &clauses, std::string const &indentation) {
  std::string text = fmt::format("{}- function: {}\n", indentation, split(function).front());
  for (auto const &[key, names] : clauses) text += fmt::format("{}  {}: [{}]\n", indentation, key, list(names));
  return text;
}

void extend_list(Changes &changes, Yaml const &value, std::vector<std::string> const &names) {
  std::size_t const begin = changes.offset(value.place());
  if (changes.at(begin) == '[') {
    std::size_t const end = changes.closing(begin);
    changes.insert(end, (value.list().empty() ? "" : ", ") + list(names));
  } else if (!value.is_list()) {
    changes.insert(begin, "[");
    changes.insert(changes.end_of_word(begin), ", " + list(names) + "]");
  } else { // one line each
    std::size_t const line = changes.line_of(begin);
    for (std::string const &name : names) changes.insert(line, changes.indentation(begin) + "- " + name + "\n");
  }
}

rewrite::ConfiguredText function_of(Yaml const &kernel) {
  for (Yaml::Entry const &one : kernel.entries())
    if (one.key.text == "function") return one.value.text();
  return {};
}

void extend_entry(Changes &changes, Yaml const &kernel, Clauses const &clauses) {
  std::vector<Yaml::Entry> const entries = kernel.entries();
  for (auto const &[key, names] : clauses) {
    auto const known = std::find_if(entries.begin(), entries.end(), [&key](Yaml::Entry const &one) {
      return one.key.text == key || one.key.text + "s" == key;
    });
    std::size_t const begin = changes.offset(kernel.place());
    if (known != entries.end()) {
      extend_list(changes, known->value, names);
    } else if (changes.at(begin) == '{') {
      changes.insert(changes.closing(begin), fmt::format(", {}: [{}]", key, list(names)));
    } else
      changes.add_line(changes.offset(function_of(kernel).place),
                       fmt::format("{}{}: [{}]", changes.indentation(begin), key, list(names)));
  }
}

// The entry for this kernel: the kernel's place is that of the function's name in the entry.
std::optional<Yaml> entry_of(rewrite::Kernel const &kernel, std::string const &function, Yaml const &kernels) {
  for (Yaml const &one : kernels.list()) {
    if (!one.is_map()) continue;
    rewrite::ConfiguredText const name = function_of(one);
    if (to_string(name.place) == to_string(kernel.place) || name.text == function) return one;
  }
  return {};
}

void add_entry(Changes &changes, Yaml const &kernels, std::string const &function, Clauses const &clauses) {
  std::size_t const begin = changes.offset(kernels.place());
  if (changes.at(begin) != '-') kernels.fail("an entry can be added only to a list of a line for each");
  changes.insert(changes.line_of(begin), entry(function, clauses, changes.indentation(begin)));
}

} // namespace

std::string with_clauses(std::string const &file, std::vector<Lacking> const &lacking) {
  bool const exists = std::filesystem::exists(file);
  Changes changes(exists ? read_file(file) : "");
  std::optional<Yaml> kernels;
  if (exists)
    for (Yaml::Entry const &one : read_yaml(file).entries())
      if (one.key.text == "kernels") kernels = one.value;
  std::string fresh;
  for (Lacking const &one : lacking) {
    Clauses const clauses = clauses_of(one);
    std::string const &qualified = one.kernel.signature.redefinition.qualified;
    std::string const function = qualified.empty() ? one.kernel.name : qualified;
    std::optional<Yaml> const known = kernels ? entry_of(one.kernel, function, *kernels) : std::nullopt;
    if (!one.kernel.is_function || one.kernel.place.file == "--kernel")
      fail(DiagnosticId::configuration, one.kernel.place,
           "kernel '" + one.kernel.name +
               "' is not a function with a pragma, which an entry could name: add the clause here");
    if (known)
      extend_entry(changes, *known, clauses);
    else if (kernels)
      add_entry(changes, *kernels, function, clauses);
    else
      fresh += entry(function, clauses, "  ");
  }
  if (!fresh.empty()) changes.append("kernels:\n" + fresh);
  return changes.result();
}

} // namespace symreal::tool
