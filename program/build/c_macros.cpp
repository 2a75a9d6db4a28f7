#include "program/build/c_macros.h"

#include "engine/support/installation.h"
#include "engine/support/parallel.h"
#include "program/build/directives.h"
#include "rewrite/text/compose.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <optional>

namespace symreal::program {
namespace {

using Words = std::vector<std::string>;
using Names = std::set<std::string>;

constexpr unsigned at_a_time = 2;
constexpr std::string_view mark = "symreal_asks_";

std::string renamed(std::string const &name) { return "symreal_c_" + name; }

// Names exempt from renaming: not a macro, context-dependent, the same in both languages, or Symreal's own.
bool is_exempt(std::string const &name) {
  static Names const names = {"NULL",          "defined",    "__COUNTER__", "__LINE__",      "__FILE__",
                              "__BASE_FILE__", "__DATE__",   "__TIME__",    "__TIMESTAMP__", "__INCLUDE_LEVEL__",
                              "__VA_ARGS__",   "__VA_OPT__", "and",         "and_eq",        "bitand",
                              "bitor",         "compl",      "not",         "not_eq",        "or",
                              "or_eq",         "xor",        "xor_eq"};
  return names.contains(name) || name.starts_with("MBD_") || name.starts_with("SYMREAL_") ||
         name.starts_with("REAL_") || name.starts_with("symreal_") || name.starts_with("__has_");
}

// Names that the files' directives ask about, including those in macros that they use.
class Questions {
public:
  explicit Questions(std::vector<rewrite::File> const &files) {
    for (rewrite::File const &file : files) read_.push_back(read_directives(file.original));
    for (Directives const &one : read_)
      for (Directive const &directive : one.directives)
        if (directive.keyword == "define" && !directive.identifiers.empty())
          for (Identifier const &word : directive.identifiers)
            within_[directive.identifiers.front().text].insert(word.text);
  }

  // A copy of the file that prints the answer to each question before it.
  std::string asking(std::string const &text, std::size_t file, Names const &apart) {
    std::string result = fmt::format("?"
                                     "?=define symreal_trigraphs\n#ifdef symreal_trigraphs\n{0}trigraphs\n#endif\n"
                                     "{0}file {1}\n",
                                     mark, file);
    std::size_t at = 0;
    auto const copy = [&](std::size_t end) {
      result += with_names(text.substr(at, end - at), apart);
      at = end;
    };
    std::vector<Directive> const &all = read_[file].directives;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].keyword != "if" && all[i].keyword != "ifdef" && all[i].keyword != "ifndef") continue;
      copy(all[i].begin);
      for (std::string const &name : asked(all, i)) {
        auto const line =
            static_cast<unsigned>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
        lines_.try_emplace({file, name}, line + 1);
        std::string const here = apart.contains(name) ? renamed(name) : name;
        result += fmt::format("#ifdef {0}\n{1}{2} {3} 1 {0} ;\n#else\n{1}{2} {3} 0\n#endif\n", here, mark, file,
                              number(name));
      }
    }
    copy(text.size());
    return result;
  }

  static std::string with_names(std::string const &text, Names const &apart) {
    if (apart.empty()) return text;
    std::string result;
    std::size_t at = 0;
    for (Identifier const &word : read_directives(text).identifiers) {
      if (!apart.contains(word.text)) continue;
      result.append(text, at, word.begin - at).append(renamed(word.text));
      at = word.end;
    }
    return result.append(text, at);
  }

  std::string const &name(std::size_t number) const { return names_[number]; }
  // Line where the file first asks about the name.
  unsigned line(std::pair<std::size_t, std::string> const &where) const { return lines_.at(where); }
  bool empty() const {
    return std::none_of(read_.begin(), read_.end(), [](Directives const &one) {
      return std::any_of(one.directives.begin(), one.directives.end(),
                         [](Directive const &directive) { return directive.keyword.starts_with("if"); });
    });
  }

private:
  std::size_t number(std::string const &name) {
    auto const [at, is_new] = numbers_.try_emplace(name, names_.size());
    if (is_new) names_.push_back(name);
    return at->second;
  }

  void add(std::string const &name, Names &names) const {
    if (is_exempt(name) || !names.insert(name).second) return;
    if (auto const found = within_.find(name); found != within_.end())
      for (std::string const &inner : found->second) add(inner, names);
  }

  // Names that a directive and its #elif branches ask about.
  Names asked(std::vector<Directive> const &all, std::size_t first) const {
    Names names;
    int depth = 0;
    for (std::size_t i = first; i < all.size(); ++i) {
      std::string const &keyword = all[i].keyword;
      bool const opens = keyword.starts_with("if");
      if (keyword == "endif" && --depth == 0) break;
      if (opens) ++depth;
      bool const is_own = i == first || (depth == 1 && keyword.starts_with("elif"));
      if (is_own)
        for (Identifier const &word : all[i].identifiers) add(word.text, names);
    }
    return names;
  }

  std::vector<Directives> read_;
  std::map<std::string, Names> within_; // words of a macro's definitions, by macro
  std::map<std::pair<std::size_t, std::string>, unsigned> lines_;
  std::map<std::string, std::size_t> numbers_;
  std::vector<std::string> names_;
};

// Expansion of the macro; nullopt if it is undefined.
using Answer = std::optional<std::string>;

struct Answers {
  std::set<std::size_t> files;
  std::map<std::pair<std::size_t, std::string>, std::vector<Answer>> all; // by file and name, in order
  std::map<std::string, Answer> first;                                    // by name
  bool has_trigraphs = false;
};

Answers read_answers(std::string const &output, Questions const &questions) {
  Answers answers;
  std::size_t at = 0;
  while ((at = output.find(mark, at)) != output.npos) {
    at += mark.size();
    std::size_t const end = std::min({output.find('\n', at), output.find(mark, at), output.size()});
    std::string const line = output.substr(at, end - at);
    std::size_t file = 0, name = 0;
    if (line == "trigraphs") answers.has_trigraphs = true;
    if (line.starts_with("file ")) {
      std::from_chars(line.data() + 5, line.data() + line.size(), file);
      answers.files.insert(file);
    }
    auto const [rest, problem] = std::from_chars(line.data(), line.data() + line.size(), file);
    if (problem != std::errc()) continue;
    auto const [state, again] = std::from_chars(rest + 1, line.data() + line.size(), name);
    if (again != std::errc()) continue;
    std::string_view const words(state, line.data() + line.size());
    Answer answer;
    if (words.starts_with(" 1 ")) answer = words.substr(3, std::min(words.rfind(';'), words.size()) - 3);
    if (answer && answer->ends_with(' ')) answer->pop_back();
    answers.first.try_emplace(questions.name(name), answer);
    answers.all[{file, questions.name(name)}].push_back(std::move(answer));
  }
  return answers;
}

bool is_integer(std::string const &text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) &&
         text.find_first_not_of("0123456789abcdefABCDEFxXuUlL") == text.npos;
}

// Is the name defined in one language only, or as another number?
bool differ(Answer const &c, Answer const &cpp) {
  if (c.has_value() != cpp.has_value()) return true;
  return c && *c != *cpp && is_integer(*c);
}

// A copy of the sources that prints the answers to their questions.
class Inquiry {
public:
  Inquiry(rewrite::Result const &rewritten, std::vector<rewrite::Compilation> const &sources, Words const &compiler,
          Words const &c_compiler, std::string const &type_name, Workspace const &workspace)
      : files_(rewritten),
        sources_(sources),
        compiler_(compiler),
        c_compiler_(c_compiler),
        type_name_(type_name),
        workspace_(workspace),
        questions_(rewritten.files),
        c_(sources.size()) {
    lay_out({});
    in_parallel(sources.size(), at_a_time, [&](std::size_t i) { c_[i] = ask_in_c(sources[i]); });
  }

  // Names that the two languages answer differently, iterated until no further answers differ.
  Names differences() {
    Names apart;
    if (questions_.empty()) return apart;
    for (int round = 0; round < 4; ++round) {
      std::size_t const before = apart.size();
      if (round != 0) lay_out(apart);
      cpp_.assign(sources_.size(), {});
      in_parallel(sources_.size(), at_a_time, [&](std::size_t i) { cpp_[i] = ask_as_cpp(i, apart); });
      if (round == 0) first_ = cpp_;
      for (std::size_t i = 0; i < sources_.size(); ++i) compare(i, apart, before);
      if (apart.size() == before) return apart;
    }
    return apart;
  }

  std::set<std::size_t> files_of_c() const {
    std::set<std::size_t> files;
    for (Answers const &one : c_) files.insert(one.files.begin(), one.files.end());
    return files;
  }

  // Flags of a source in C.
  Words flags(std::size_t source, Names const &apart) const {
    Words words = {"-DSYMREAL_SOURCE_OF_C"};
    if (c_[source].has_trigraphs) words.emplace_back("-trigraphs");
    for (std::string const &name : apart)
      if (Answer const answer = first(c_[source], name))
        words.push_back("-D" + renamed(name) + "=" + (is_integer(*answer) ? *answer : name));
    return words;
  }

  // Flags of a source in C++, which may include C headers: the answers of C++.
  Words flags_of_cpp(Names const &apart) const {
    Words words;
    for (std::string const &name : apart)
      for (Answers const &one : first_)
        if (first(one, name)) {
          words.push_back("-D" + renamed(name) + "=" + name);
          break;
        }
    return words;
  }

private:
  static Answer first(Answers const &answers, std::string const &name) {
    auto const found = answers.first.find(name);
    return found == answers.first.end() ? std::nullopt : found->second;
  }

  void lay_out(Names const &apart) {
    rewrite::Result copy;
    copy.include_dirs = files_.include_dirs;
    for (std::size_t i = 0; i < files_.files.size(); ++i) {
      rewrite::File file = files_.files[i];
      file.text = questions_.asking(file.original, i, apart);
      file.edits.clear();
      copy.files.push_back(std::move(file));
    }
    copy_ = std::make_unique<Overlay>(copy, workspace_.directory("conditionals"));
  }

  std::string preprocessed(Words words, rewrite::Compilation const &source) const {
    words.insert(words.end(), {"-w", "-E", "-P", "-o", "-", copy_->compiled_path(rewrite::real_source(source))});
    return capture(compiler_run(std::move(words), source.directory)).output;
  }

  Answers ask_in_c(rewrite::Compilation const &source) {
    Words words = c_compiler_;
    Words const flags = copy_->search_flags(c_flags(source.flags), source.directory);
    append(words, flags);
    append(words, {"-x", "c"});
    return read_answers(preprocessed(std::move(words), source), questions_);
  }

  Answers ask_as_cpp(std::size_t source, Names const &apart) const {
    Words words = compiler_;
    rewrite::Compilation const &one = sources_[source];
    Words const adapted = copy_->search_flags(variant_flags(one.flags, Variant::symbolic), one.directory);
    append(words, adapted);
    append(words, {"-isystem", runtime_include()});
    append(words, rewrite::type_name_flags(type_name_));
    append(words, flags(source, apart));
    append(words, {"-x", "c++"});
    return read_answers(preprocessed(std::move(words), one), questions_);
  }

  void compare(std::size_t source, Names &apart, std::size_t before) const {
    for (auto const &[where, in_c] : c_[source].all) {
      auto const found = cpp_[source].all.find(where);
      if (found == cpp_[source].all.end()) continue;
      for (std::size_t k = 0; k < std::min(in_c.size(), found->second.size()); ++k)
        if (differ(in_c[k], found->second[k])) {
          if (!apart.insert(where.second).second && before != 0)
            fail(DiagnosticId::c_source, {files_.files[where.first].display_path, questions_.line(where)},
                 "directives ask about '" + where.second + "', and C gives different answers at different places");
          break;
        }
    }
  }

  rewrite::Result const &files_;
  std::vector<rewrite::Compilation> const &sources_;
  Words const &compiler_, &c_compiler_;
  std::string const &type_name_;
  Workspace const &workspace_;
  Questions questions_;
  std::unique_ptr<Overlay> copy_;
  std::vector<Answers> c_, cpp_, first_; // by source; first_: before any renaming
};

void rename(rewrite::File &file, Names const &apart) {
  std::string const behind = file.text.substr(rewrite::apply_edits(file.original, file.edits).size());
  std::vector<rewrite::Edit> edits;
  auto edit = file.edits.begin();
  for (Identifier const &word : read_directives(file.original).identifiers) {
    if (!apart.contains(word.text)) continue;
    while (edit != file.edits.end() && edit->offset + edit->length <= word.begin) edits.push_back(*edit++);
    if (edit == file.edits.end() || edit->offset >= word.end)
      edits.push_back({word.begin, word.end - word.begin, renamed(word.text)});
    else if (edit->offset <= word.begin && edit->offset + edit->length >= word.end)
      continue; // handled with the edit, below
    else {
      // Insertions before the word's first character and behind its last merge into one edit.
      std::string text;
      std::size_t at = word.begin;
      for (; edit != file.edits.end() && edit->offset < word.end; ++edit) {
        text += file.original.substr(at, edit->offset - at) + edit->text;
        at = edit->offset + edit->length;
      }
      edits.push_back({word.begin, word.end - word.begin, text + file.original.substr(at, word.end - at)});
    }
  }
  edits.insert(edits.end(), edit, file.edits.end());
  for (rewrite::Edit &one : edits) one.text = Questions::with_names(one.text, apart);
  file.edits = std::move(edits);
  file.text = rewrite::apply_edits(file.original, file.edits) + behind;
}

} // namespace

CSources as_in_c(rewrite::Result &rewritten, std::vector<rewrite::Compilation> const &sources, Words const &compiler,
                 Words const &c_compiler, std::string const &type_name, Workspace const &workspace) {
  CSources result;
  std::vector<rewrite::Compilation> c, cpp;
  for (rewrite::Compilation const &source : sources) (is_c(source) ? c : cpp).push_back(source);
  if (c.empty()) return result;
  Inquiry inquiry(rewritten, c, compiler, c_compiler, type_name, workspace);
  Names const apart = inquiry.differences();
  for (std::size_t i = 0; i < c.size(); ++i) {
    std::string const real = rewrite::real_source(c[i]);
    result.sources.insert(real);
    result.flags[real] = inquiry.flags(i, apart);
  }
  for (rewrite::Compilation const &source : cpp)
    result.flags[rewrite::real_source(source)] = inquiry.flags_of_cpp(apart);
  if (!apart.empty())
    for (std::size_t file : inquiry.files_of_c()) rename(rewritten.files[file], apart);
  return result;
}

} // namespace symreal::program
