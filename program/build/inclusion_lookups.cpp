#include "program/build/inclusion_lookups.h"

#include <algorithm>

namespace symreal::program {
namespace {

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

bool is_word(char c) { return c == '_' || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

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

} // namespace symreal::program
