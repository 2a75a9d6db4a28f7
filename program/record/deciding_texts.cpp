#include "program/record/deciding_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace symreal::program {
namespace {

using rewrite::DecidingText;
using Position = std::pair<unsigned, unsigned>;

Position position(Place const &place) { return {place.line, place.column}; }

// The text around the position that begins last; of several, the longest if they begin at the position, else the
// shortest.
DecidingText const *innermost(std::multimap<Position, DecidingText const *> const &texts, Position at) {
  constexpr int most_before = 64;
  DecidingText const *found = nullptr;
  auto one = texts.upper_bound(at);
  for (int k = 0; k < most_before && one != texts.begin(); ++k) {
    --one;
    DecidingText const *text = one->second;
    if (position(text->end) < at) continue;
    if (found && position(found->begin) != position(text->begin)) break;
    bool const is_better = !found || (one->first == at ? position(text->end) > position(found->end)
                                                       : position(text->end) < position(found->end));
    if (is_better) found = text;
  }
  return found;
}

std::string bare(std::string const &text) {
  std::string result;
  for (char const c : text)
    if (c != ' ' && c != '(' && c != ')') result += c;
  return result;
}

std::set<std::string> names(std::string const &text) {
  auto const is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  std::set<std::string> result;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t const end = static_cast<std::size_t>(
        std::find_if_not(text.begin() + std::ptrdiff_t(at), text.end(), is_part) - text.begin());
    if (end > at && std::isdigit(static_cast<unsigned char>(text[at])) == 0) result.insert(text.substr(at, end - at));
    at = std::max(end, at + 1);
  }
  return result;
}

// Picks the operand of && or || that was recorded: compilers give both the end of the condition as place. If `found`
// names other objects than the recorded condition and an earlier operand on its line names the same, the latter.
DecidingText const *meant(std::string const &recorded, DecidingText const *found,
                          std::multimap<Position, DecidingText const *> const &texts) {
  std::set<std::string> const of_recorded = names(recorded);
  if (!found || of_recorded.empty() || names(found->text) == of_recorded) return found;
  for (auto one = texts.lower_bound({found->begin.line, 0}); one != texts.end() && one->first < position(found->begin);
       ++one)
    if (names(one->second->text) == of_recorded && position(one->second->end) < position(found->begin))
      return one->second;
  return found;
}

constexpr std::string_view conversion_of = "the conversion of ";

} // namespace

DecidingTexts::DecidingTexts(std::vector<DecidingText> const &texts) {
  for (DecidingText const &text : texts) {
    File &file = files_[text.begin.file];
    (text.type.empty() ? file.conditions : file.conversions).emplace(position(text.begin), &text);
    if (!text.keyword.file.empty()) file.by_keyword.emplace(position(text.keyword), &text);
  }
}

DecidingText const *DecidingTexts::condition(Place const &place, std::string const &recorded) const {
  auto const file = files_.find(place.file);
  if (file == files_.end() || place.column == 0) return nullptr;
  auto const keyword = file->second.by_keyword.find(position(place));
  return keyword != file->second.by_keyword.end()
             ? keyword->second
             : meant(recorded, innermost(file->second.conditions, position(place)), file->second.conditions);
}

DecidingText const *DecidingTexts::conversion(Place const &place) const {
  auto const file = files_.find(place.file);
  if (file == files_.end() || place.column == 0) return nullptr;
  return innermost(file->second.conversions, position(place));
}

SaidDecision said_by_source(std::string const &recorded, Place const &place, DecidingTexts const &texts) {
  bool const converts = recorded.starts_with(conversion_of);
  DecidingText const *text = converts ? texts.conversion(place) : texts.condition(place, recorded);
  if (!text) return {recorded, {}};
  std::string const value = converts ? recorded.substr(conversion_of.size()) : recorded;
  bool const is_cut_off = value.find("...") != value.npos;
  std::string const more = is_cut_off || bare(value) == bare(text->text) ? "" : value;
  if (!converts) return {text->text, more};
  return {fmt::format("{}{} to {}", conversion_of, text->text, text->type), more};
}

} // namespace symreal::program
