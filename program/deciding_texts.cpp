#include "program/deciding_texts.h"

#include <fmt/format.h>

namespace symreal::program {
namespace {

using rewrite::DecidingText;
using Position = std::pair<unsigned, unsigned>;

Position position(Place const &place) { return {place.line, place.column}; }

// Of those around the position the one that begins last; of several that begin there the longest that begins at the
// very position, else the shortest.
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

constexpr std::string_view conversion_of = "the conversion of ";

} // namespace

DecidingTexts::DecidingTexts(std::vector<DecidingText> const &texts) {
  for (DecidingText const &text : texts) {
    File &file = files_[text.begin.file];
    (text.type.empty() ? file.conditions : file.conversions).emplace(position(text.begin), &text);
    if (!text.keyword.file.empty()) file.by_keyword.emplace(position(text.keyword), &text);
  }
}

DecidingText const *DecidingTexts::condition(Place const &place) const {
  auto const file = files_.find(place.file);
  if (file == files_.end() || place.column == 0) return nullptr;
  auto const keyword = file->second.by_keyword.find(position(place));
  return keyword != file->second.by_keyword.end() ? keyword->second
                                                  : innermost(file->second.conditions, position(place));
}

DecidingText const *DecidingTexts::conversion(Place const &place) const {
  auto const file = files_.find(place.file);
  if (file == files_.end() || place.column == 0) return nullptr;
  return innermost(file->second.conversions, position(place));
}

SaidDecision said_by_source(std::string const &recorded, Place const &place, DecidingTexts const &texts) {
  bool const converts = recorded.starts_with(conversion_of);
  DecidingText const *text = converts ? texts.conversion(place) : texts.condition(place);
  if (!text) return {recorded, {}};
  std::string const value = converts ? recorded.substr(conversion_of.size()) : recorded;
  bool const is_cut_off = value.find("...") != value.npos;
  std::string const more = is_cut_off || bare(value) == bare(text->text) ? "" : value;
  if (!converts) return {text->text, more};
  return {fmt::format("{}{} to {}", conversion_of, text->text, text->type), more};
}

} // namespace symreal::program
