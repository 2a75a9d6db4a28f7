#include "rewrite/decide/configurations.h"

#include "rewrite/text/type_name.h"

#include <algorithm>

namespace symreal::rewrite {
namespace {

bool in_directive(FileFact const &file, std::size_t offset) {
  auto const after =
      std::upper_bound(file.directives.begin(), file.directives.end(), std::pair(offset, std::string::npos));
  return after != file.directives.begin() && std::prev(after)->second > offset;
}

bool holds(std::vector<bool> const &reached, std::size_t offset) { return offset < reached.size() && reached[offset]; }

} // namespace

Configurations::View Configurations::view(std::string const &path, Facts const &facts) const {
  View view;
  FileFact const &file = facts.files.at(path);
  for (auto at = facts.types.lower_bound({path, 0, 0}); at != facts.types.end() && at->first.file == path; ++at)
    if (at->second.fate >= Fate::passive) view.types[at->first.begin] = at->second.replacement;
  for (auto at = facts.wraps.lower_bound({{path, 0, 0}, Use{}, ""}); at != facts.wraps.end() && at->span.file == path;
       ++at)
    if (info(at->use).has(trait::BY_TYPES) && !is_quoted(facts, at->span) && !in_directive(file, at->span.begin))
      view.wraps.try_emplace({at->span.begin, at->span.end, at->use},
                             info(at->use).payload == Payload::function ? "" : at->detail);
  for (auto at = facts.members.lower_bound({path, 0, 0}); at != facts.members.end() && at->first.file == path; ++at)
    view.members[at->first.begin] = at->second;
  if (auto const reached = facts.reached.find(path); reached != facts.reached.end()) view.reached = reached->second;
  // A macro's body is one text for all of its uses.
  for (auto const &[begin, end] : file.directives)
    for (std::size_t i = begin; i < std::min(end, view.reached.size()); ++i) view.reached[i] = false;
  return view;
}

bool Configurations::View::same(View const &other) const {
  return types == other.types && wraps == other.wraps && reached == other.reached &&
         std::equal(members.begin(), members.end(), other.members.begin(), other.members.end(),
                    [](auto const &one, auto const &another) {
                      return one.first == another.first && same_members(one.second, another.second);
                    });
}

void Configurations::add(std::string const &source, Facts const &facts) {
  for (auto const &[path, file] : facts.files) {
    View mine = view(path, facts);
    std::vector<View> &known = views_[path];
    if (std::any_of(known.begin(), known.end(), [&](View const &other) { return other.same(mine); })) continue;
    mine.source = source;
    for (View const &other : known) compare(path, file, other, mine);
    known.push_back(std::move(mine));
  }
}

void Configurations::compare(std::string const &path, FileFact const &file, View const &one, View const &other) {
  auto const words = [](std::string const &replacement) {
    return replacement.empty() ? std::string("stays") : "becomes " + with_type_name(replacement, usual_type_name);
  };
  for (auto const &[offset, replacement] : one.types)
    if (auto const found = other.types.find(offset);
        found != other.types.end() && found->second != replacement && !in_directive(file, offset))
      contradiction(file, offset,
                    "this type " + words(replacement) + " for " + one.source + " and " + words(found->second) +
                        " for " + other.source);
  for (auto const &[offset, list] : one.members)
    if (auto const found = other.members.find(offset);
        found != other.members.end() && !same_members(found->second, list))
      contradiction(file, offset, "this class has other members for " + one.source + " than for " + other.source);
  compare_wraps(path, file, one, other);
  compare_wraps(path, file, other, one);
}

void Configurations::compare_wraps(std::string const &path, FileFact const &file, View const &one, View const &other) {
  for (auto const &[key, detail] : one.wraps) {
    auto const found = other.wraps.find(key);
    if (found != other.wraps.end() ? found->second == detail
                                   : key.use != Use::division && !holds(other.reached, key.begin))
      continue;
    if (key.use == Use::division)
      contradiction(file, key.begin, "this is a division for " + one.source + " and a comment for " + other.source);
    else if (key.use == Use::conversion || key.use == Use::cast)
      shared_.insert({path, key.begin, key.end});
    else
      contradiction(file, key.begin,
                    "this expression is converted for " + one.source + " and not, or to another type, for " +
                        other.source);
  }
}

void Configurations::contradiction(FileFact const &file, std::size_t offset, std::string message) {
  for (SpelledType const &type : file.spelled)
    if (type.kept && type.span.begin == offset) return; // in all of them
  found_.push_back({DiagnosticId::contradictory_configurations, place_in(file, offset), std::move(message)});
}

void Configurations::report(Facts &facts) const {
  facts.shared.insert(shared_.begin(), shared_.end());
  for (Diagnostic const &one : found_) add_diagnostic(facts, one);
}

} // namespace symreal::rewrite
