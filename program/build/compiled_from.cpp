#include "program/build/compiled_from.h"

#include "engine/support/files.h"
#include "rewrite/facts/bytes.h"
#include "rewrite/request/request.h"
#include "rewrite/text/source_text.h"

#include <llvm/Support/MemoryBuffer.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace symreal::program {

template <class Take> void visit(Take &take, CompiledFrom &object) {
  auto &[files, directories, names, absent] = object;
  take(files, directories, names, absent);
}

namespace {

namespace fs = std::filesystem;
using rewrite::is_word;

std::string shortened(std::string const &path, std::string const &workspace) {
  return path.starts_with(workspace) ? "@" + path.substr(workspace.size()) : path;
}
std::string lengthened(std::string const &path, std::string const &workspace) {
  return path.starts_with('@') ? workspace + path.substr(1) : path;
}

std::optional<std::string> text_of(std::string const &path) {
  auto const buffer = llvm::MemoryBuffer::getFile(path);
  return buffer ? std::optional((*buffer)->getBuffer().str()) : std::nullopt;
}

// Numbers texts in order of first occurrence.
class Numbered {
public:
  explicit Numbered(std::vector<std::string> &all) : all_(all) {}
  std::size_t operator()(std::string const &text) {
    auto const [at, is_new] = numbers_.try_emplace(text, all_.size());
    if (is_new) all_.push_back(text);
    return at->second;
  }

private:
  std::vector<std::string> &all_;
  std::map<std::string, std::size_t> numbers_;
};

// Records where a compiler looks for a name: beside the including text, if quoted, and in all search directories, since
// #include_next continues past the first match.
class InclusionSearch {
public:
  InclusionSearch(CompiledFrom &result, std::string const &base, std::vector<std::string> const &directories,
                  std::string const &workspace)
      : result_(result),
        base_(base),
        workspace_(workspace),
        directory_(result.directories),
        name_(result.names),
        directories_(directories) {}

  void look(Inclusion const &inclusion, std::string const &beside) {
    if (inclusion.name.starts_with('/')) return look_in("", inclusion.name);
    if (inclusion.quoted) look_in(beside, inclusion.name);
    if (!looked_for_.insert(inclusion.name).second) return;
    for (std::string const &directory : directories_) look_in(directory, inclusion.name);
  }

private:
  void look_in(std::string const &directory, std::string const &name) {
    fs::path const path = fs::path(base_) / directory / name;
    std::error_code error;
    if (fs::exists(path, error)) return;
    std::string const full = directory.empty() ? "" : (fs::path(base_) / directory).string();
    std::pair const place{directory_(shortened(full, workspace_)), name_(name)};
    if (known_.insert(place).second) result_.absent.push_back(place);
  }

  CompiledFrom &result_;
  std::string const &base_, &workspace_;
  Numbered directory_, name_;
  std::vector<std::string> const &directories_;
  std::set<std::string> looked_for_;
  std::set<std::pair<std::size_t, std::size_t>> known_;
};

std::string_view without_blanks(std::string_view text) {
  std::size_t const at = text.find_first_not_of(" \t\f\v\r");
  return at == text.npos ? std::string_view() : text.substr(at);
}

bool take(std::string_view &text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

// Parses <name> or "name" at the beginning.
std::optional<Inclusion> name_at(std::string_view text) {
  if (text.empty() || (text[0] != '<' && text[0] != '"')) return {};
  std::size_t const end = text.find(text[0] == '<' ? '>' : '"', 1);
  if (end == text.npos || text.substr(0, end).find('\n') != text.npos) return {};
  return Inclusion{std::string(text.substr(1, end - 1)), text[0] == '"'};
}

std::string_view word_at(std::string_view text) {
  return text.substr(0, static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_word) - text.begin()));
}

// May a directive follow this text? Blanks and a comment may precede one.
bool begins_line(std::string_view before) {
  std::size_t const last = before.find_last_not_of(" \t\f\v\r");
  return last == before.npos || before[last] == '\n' || before.substr(0, last + 1).ends_with("*/");
}

// Parses what follows the `#` of a directive. False if an inclusion cannot be determined.
bool add_directive(std::string_view rest, Inclusions &all) {
  rest = without_blanks(rest);
  if (rest.starts_with('\\') || rest.starts_with("/*")) return false; // the keyword follows a line splice or comment
  if (!take(rest, "include_next") && !take(rest, "include") && !take(rest, "import") && !take(rest, "embed"))
    return true;
  std::string_view const operand = without_blanks(rest);
  constexpr std::string_view begins = "<\"\\/"; // or a word; anything else is prose in a comment, or an error
  if (operand.empty() || (!is_word(operand[0]) && begins.find(operand[0]) == begins.npos)) return true;
  auto const found = name_at(operand);
  if (found) all.names.push_back(*found);
  std::string_view const macro = word_at(operand);
  bool const is_macro = !macro.empty() && without_blanks(operand.substr(macro.size())).substr(0, 1) == "\n";
  if (is_macro) all.macros.emplace_back(macro);
  return found || is_macro;
}

// Parses `__has_include(<name>)`. The bare word asks whether the operator exists.
bool add_question(std::string_view rest, Inclusions &all) {
  take(rest, "_next");
  rest = without_blanks(rest);
  if (rest.starts_with("__") || rest.starts_with('\\') || rest.starts_with("/*")) return false;
  if (!take(rest, "(")) return true;
  auto const found = name_at(without_blanks(rest));
  if (found) all.names.push_back(*found);
  return found.has_value();
}

// False if one of the questions cannot be determined.
bool add_questions(std::string_view text, Inclusions &all) {
  constexpr std::string_view question = "__has_include";
  bool are_told = true;
  for (std::size_t at = 0; (at = text.find(question, at)) != text.npos;) {
    bool const begins = at == 0 || !is_word(text[at - 1]);
    at += question.size();
    if (begins && !add_question(text.substr(at), all)) are_told = false;
  }
  return are_told;
}

} // namespace

std::optional<Inclusions> inclusions_of(std::string_view text) {
  for (std::string_view macro : {"__DATE__", "__TIME__", "__TIMESTAMP__"})
    if (text.find(macro) != text.npos) return {};
  Inclusions all;
  for (std::string_view mark : {"#", "%:"})
    for (std::size_t at = 0; (at = text.find(mark, at)) != text.npos; at += mark.size())
      if (begins_line(text.substr(0, at)) && !add_directive(text.substr(at + mark.size()), all)) return {};
  if (!add_questions(text, all)) return {};
  std::sort(all.names.begin(), all.names.end());
  all.names.erase(std::unique(all.names.begin(), all.names.end()), all.names.end());
  return all;
}

std::vector<Inclusion> questions_of(std::string_view text) {
  Inclusions all;
  add_questions(text, all);
  return all.names;
}

bool defines(std::string_view text, std::string_view macro) {
  for (std::size_t at = 0; (at = text.find(macro, at)) != text.npos; at += macro.size()) {
    bool const is_all = word_at(text.substr(at)) == macro && (at == 0 || !is_word(text[at - 1]));
    std::size_t const before = text.substr(0, at).find_last_not_of(" \t\\\r\n");
    if (is_all && before != text.npos && text.substr(0, before + 1).ends_with("define")) return true;
  }
  return false;
}

std::vector<std::string> searched_directories(std::string_view messages) {
  std::vector<std::string> directories;
  bool in_list = false;
  while (!messages.empty()) {
    std::size_t const end = std::min(messages.find('\n'), messages.size());
    std::string_view line = messages.substr(0, end);
    messages.remove_prefix(std::min(end + 1, messages.size()));
    if (take(line, "ignoring nonexistent directory \"")) {
      directories.emplace_back(line.substr(0, line.rfind('"')));
    } else if (line.starts_with("#include ") && line.ends_with("search starts here:")) {
      in_list = true;
    } else if (line.starts_with("End of search list.")) {
      in_list = false;
    } else if (in_list && take(line, " ")) {
      directories.emplace_back(line);
    }
  }
  return directories;
}

std::string const &FilesNow::content_id(std::string const &path) {
  {
    std::lock_guard const lock(mutex_);
    if (auto const known = ids_.find(path); known != ids_.end()) return known->second;
  }
  std::optional<std::string> const text = text_of(path);
  std::string id = text ? rewrite::content_id(*text) : "";
  std::lock_guard const lock(mutex_);
  return ids_.try_emplace(path, std::move(id)).first->second;
}

bool FilesNow::exists(std::string const &path) {
  std::lock_guard const lock(mutex_);
  auto const [at, is_new] = exist_.try_emplace(path);
  std::error_code error;
  if (is_new) at->second = fs::exists(path, error);
  return at->second;
}

bool CompiledFrom::still_holds(FilesNow &now, std::string const &workspace) const {
  return std::all_of(files.begin(), files.end(),
                     [&](auto const &one) { return now.content_id(lengthened(one.first, workspace)) == one.second; }) &&
         std::none_of(absent.begin(), absent.end(), [&](auto const &place) {
           return now.exists(lengthened(directories[place.first], workspace) + "/" + names[place.second]);
         });
}

std::optional<CompiledFrom> compiled_from(Command const &compilation, std::vector<std::string> const &files,
                                          std::string_view messages, std::string const &workspace) {
  std::string const base = compilation.directory.empty() ? fs::current_path().string() : compilation.directory;
  std::vector<std::string> const directories = searched_directories(messages);
  if (directories.empty()) return {};
  CompiledFrom result;
  InclusionSearch search(result, base, directories, workspace);
  std::vector<std::string> const &words = compilation.arguments;
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (words[i] == "-include" || words[i] == "-imacros") search.look({words[i + 1], true}, ".");
  std::vector<std::string> texts;
  std::set<std::string> macros;
  for (std::string const &file : files) {
    std::string const path = (fs::path(base) / file).string();
    std::optional<std::string> text = text_of(path);
    if (!text) return {};
    if (!result.files.try_emplace(shortened(path, workspace), rewrite::content_id(*text)).second) continue;
    auto const inclusions = inclusions_of(*text);
    if (!inclusions) return {};
    for (Inclusion const &one : inclusions->names) search.look(one, fs::path(file).parent_path().string());
    macros.insert(inclusions->macros.begin(), inclusions->macros.end());
    texts.push_back(std::move(*text));
  }
  // An inclusion by a macro is ignored if nothing defines the macro.
  for (std::string const &macro : macros) {
    auto const names_it = [&](std::string const &word) { return word.find(macro) != word.npos; };
    auto const defines_it = [&](std::string const &text) { return defines(text, macro); };
    if (std::any_of(words.begin(), words.end(), names_it) || std::any_of(texts.begin(), texts.end(), defines_it))
      return {};
  }
  return result;
}

std::string to_bytes(CompiledFrom from, std::string object) {
  rewrite::Write write;
  write(from, object);
  return write.result();
}

std::optional<std::pair<CompiledFrom, std::string>> compiled_from_bytes(std::string_view bytes) {
  rewrite::Read read(bytes);
  std::pair<CompiledFrom, std::string> both;
  read(both.first, both.second);
  auto const &[from, object] = both;
  bool const good = read.is_complete() && std::all_of(from.absent.begin(), from.absent.end(), [&](auto const &place) {
                      return place.first < from.directories.size() && place.second < from.names.size();
                    });
  return good ? std::optional(std::move(both)) : std::nullopt;
}

} // namespace symreal::program
