#include "compiler/dependencies.h"

#include <filesystem>

namespace symreal::compiler {
namespace {

namespace fs = std::filesystem;

// As make reads it.
std::string escaped(std::string const &name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    char const c = name[i];
    if (c == ' ' || c == '\t') {
      for (std::size_t back = i; back > 0 && name[back - 1] == '\\'; --back) text += '\\';
      text += '\\';
    } else if (c == '#') {
      text += '\\';
    } else if (c == '$') {
      text += '$';
    }
    text += c;
  }
  return text;
}

// Words of a rule, broken into lines.
class Line {
public:
  void add(std::string const &word) {
    constexpr std::size_t most = 72;
    if (column_ != 0 && column_ + word.size() > most) {
      text += " \\\n ";
      column_ = 1;
    } else if (column_ != 0) {
      text += ' ';
      ++column_;
    }
    text += word;
    column_ += word.size();
  }
  void end_targets() {
    text += ':';
    ++column_;
  }
  std::string text;

private:
  std::size_t column_ = 0;
};

} // namespace

Words read_dependencies(std::string const &text) {
  Words names;
  std::string name;
  auto finish = [&] {
    if (!name.empty()) names.push_back(std::move(name));
    name.clear();
  };
  // After the target, which is written without blanks.
  std::size_t i = text.find(": ");
  for (i = i == text.npos ? text.size() : i + 1; i < text.size(); ++i) {
    char const c = text[i], next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (c == '\\' && (next == ' ' || next == '\t' || next == '#')) {
      name += text[++i];
    } else if (c == '\\' && next == '\n') {
      ++i;
      finish();
    } else if (c == '$' && next == '$') {
      name += text[++i];
    } else if (c == '\n') {
      break;
    } else if (c == ' ' || c == '\t') {
      finish();
    } else {
      name += c;
    }
  }
  finish();
  return names;
}

std::string write_dependencies(DependencyOptions const &options, Words const &names) {
  Line line;
  for (auto const &[quoted, target] : options.targets) line.add(quoted ? escaped(target) : target);
  line.end_targets();
  for (std::string const &name : names) line.add(escaped(name));
  line.text += '\n';
  if (options.phony)
    for (std::size_t i = 1; i < names.size(); ++i) line.text += escaped(names[i]) + ":\n";
  return line.text;
}

DependencyOptions completed(CommandLine const &line, std::string const &source) {
  DependencyOptions options = line.dependencies;
  fs::path const stem = fs::path(source).stem();
  bool const names_object = line.action != Action::link && !line.output.empty();
  if (options.targets.empty()) options.targets.emplace_back(true, names_object ? line.output : stem.string() + ".o");
  if (!options.file.empty()) return options;
  if (line.action == Action::link)
    options.file = (line.output.empty() ? "a" : line.output) + "-" + stem.string() + ".d";
  else
    options.file = names_object ? fs::path(line.output).replace_extension(".d").string() : stem.string() + ".d";
  return options;
}

} // namespace symreal::compiler
