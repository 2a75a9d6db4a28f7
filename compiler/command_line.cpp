#include "compiler/command_line.h"

#include "program/make_rule.h"
#include "program/process.h"
#include "support/files.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace symreal::compiler {
namespace {

// Options of gcc and clang whose operand is the next word.
constexpr std::string_view with_operand[] = {
    "-D",
    "-U",
    "-I",
    "-L",
    "-l",
    "-u",
    "-z",
    "-T",
    "-e",
    "-A",
    "-B",
    "-G",
    "-include",
    "-imacros",
    "-iprefix",
    "-iwithprefix",
    "-isystem",
    "-iquote",
    "-isysroot",
    "-idirafter",
    "-iwithprefixbefore",
    "-imultilib",
    "-Xlinker",
    "-Xclang",
    "-mllvm",
    "--param",
    "-Xassembler",
    "-Xpreprocessor",
    "-aux-info",
    "-wrapper",
    "-dumpbase",
    "-dumpdir",
    "-target",
    "--sysroot",
    "-arch",
    "-framework",
    "-specs",
    "--include",
    "-rpath",
    "-soname",
    "-dumpbase-ext",
};

// With one of these the compiler only tells something.
bool asks(std::string_view flag) {
  for (std::string_view known : {"--version", "--help", "--target-help", "-###", "-dumpversion", "-dumpfullversion",
                                 "-dumpmachine", "-dumpspecs", "-M", "-MM"})
    if (flag == known) return true;
  return flag.starts_with("-print-") || flag.starts_with("--print-") || flag.starts_with("--help=");
}

bool is_among(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

Language language(std::string const &name, std::string const &named, Language c_ending) {
  if (named == "c") return Language::c;
  if (named == "c++") return Language::cxx;
  if (named == "cpp-output" || named == "c++-cpp-output") return Language::preprocessed;
  if (named == "c-header" || named == "c++-header") return Language::header;
  if (!named.empty()) return Language::other;
  std::string const ending = std::filesystem::path(name).extension();
  if (ending == ".c") return c_ending;
  if (is_among(ending, {".cc", ".cp", ".cpp", ".cxx", ".c++", ".C", ".CC", ".CPP", ".CXX"})) return Language::cxx;
  if (is_among(ending, {".h", ".hh", ".hpp", ".hxx", ".H"})) return Language::header;
  if (is_among(ending, {".i", ".ii"})) return Language::preprocessed;
  return Language::other;
}

Words expanded(Words const &arguments, unsigned depth = 0) {
  Words words;
  for (std::string const &word : arguments) {
    std::error_code error;
    bool const is_file =
        word.size() > 1 && word[0] == '@' && depth < 16 && std::filesystem::is_regular_file(word.substr(1), error);
    Words const inner = is_file ? expanded(program::split_words(read_file(word.substr(1))), depth + 1) : Words{word};
    words.insert(words.end(), inner.begin(), inner.end());
  }
  return words;
}

class Parser {
public:
  Parser(Words words, Language c_ending) : c_ending_(c_ending) { line_.words = std::move(words); }

  CommandLine parse() {
    for (; at_ < line_.words.size(); ++at_) {
      std::string const &word = line_.words[at_];
      if (word.size() < 2 || word[0] != '-')
        line_.inputs.push_back({word, language(word, language_, c_ending_), at_});
      else if (!action(word) && !output(word) && !dependencies(word))
        flag(word);
    }
    if (line_.inputs.empty()) line_.action = Action::other; // -v, or an error that the compiler finds itself
    return std::move(line_);
  }

private:
  // The operand of an option that takes it in the same word or in the next.
  std::string operand(std::string const &word, std::size_t length) {
    if (word.size() > length) return word.substr(length);
    return at_ + 1 < line_.words.size() ? line_.words[++at_] : std::string();
  }

  // Whichever stops earliest counts.
  void stop_at(Action action) {
    if (line_.action == Action::other) return;
    line_.action = line_.action == Action::link ? action : std::max(line_.action, action);
  }

  bool action(std::string const &word) {
    if (word == "-c")
      stop_at(Action::compile);
    else if (word == "-S")
      stop_at(Action::assembly);
    else if (word == "-E")
      stop_at(Action::preprocess);
    else if (word == "-fsyntax-only")
      stop_at(Action::check);
    else if (asks(word))
      line_.action = Action::other;
    else
      return false;
    return true;
  }

  bool output(std::string const &word) {
    if (word.starts_with("-o")) {
      line_.output = operand(word, 2);
      return true;
    }
    if (word.starts_with("-x")) {
      language_ = operand(word, 2);
      if (language_ == "none") language_.clear();
      return true;
    }
    return false;
  }

  bool dependencies(std::string const &word) {
    DependencyOptions &options = line_.dependencies;
    if (word == "-MD" || word == "-MMD") {
      options.wanted = true;
      options.system = word == "-MD";
    } else if (word == "-MP") {
      options.phony = true;
    } else if (word.starts_with("-MF")) {
      options.file = operand(word, 3);
    } else if (word.starts_with("-MT") || word.starts_with("-MQ")) {
      bool const quoted = word[2] == 'Q';
      std::string const target = operand(word, 3);
      options.targets.push_back(quoted ? program::make_escaped(target) : target);
    } else if (word.starts_with("-Wp,-MD,") || word.starts_with("-Wp,-MMD,")) {
      options.wanted = true;
      options.system = word.starts_with("-Wp,-MD,");
      options.file = word.substr(word.find(',', 4) + 1);
    } else {
      return false;
    }
    return true;
  }

  void flag(std::string const &word) {
    // As CMake gives clang headers that were compiled ahead: before they were rewritten, so they are no use. The header
    // itself is named as well.
    if (word == "-Xclang" && at_ + 3 < line_.words.size() && line_.words[at_ + 1].starts_with("-include")) {
      if (line_.words[at_ + 1] == "-include") line_.flags.insert(line_.flags.end(), {"-include", line_.words[at_ + 3]});
      at_ += 3;
      return;
    }
    line_.flags.push_back(word);
    if (std::find(std::begin(with_operand), std::end(with_operand), word) != std::end(with_operand) &&
        at_ + 1 < line_.words.size())
      line_.flags.push_back(line_.words[++at_]);
  }

  CommandLine line_;
  std::size_t at_ = 0;
  std::string language_; // of -x
  Language const c_ending_;
};

} // namespace

CommandLine parse(Words const &arguments, Language c_ending) { return Parser(expanded(arguments), c_ending).parse(); }

} // namespace symreal::compiler
