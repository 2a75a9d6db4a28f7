#include "program/record/call_paths.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace symreal::program {
namespace {

constexpr std::size_t most_recorded = 4;

struct AtPlace {
  Diagnostic diagnostic;
  std::size_t count = 0, frames = 0;
  std::set<std::string> paths;
  std::vector<std::string> recorded, messages;
};

std::string path_of(Diagnostic const &diagnostic) {
  std::string all;
  for (Note const &note : diagnostic.notes) all += to_string(note.place) + note.message + "\n";
  return all;
}

void add_new(std::vector<std::string> &list, std::string const &text) {
  if (!text.empty() && std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
}

std::string joined(std::vector<std::string> const &list) {
  std::string text;
  for (std::size_t k = 0; k < list.size() && k < most_recorded; ++k) text += (k == 0 ? "" : "; ") + list[k];
  if (list.size() > most_recorded) text += fmt::format("; and {} more", list.size() - most_recorded);
  return text;
}

bool is_another(AtPlace const &place, Diagnostic const &one) {
  return place.paths.contains(path_of(one)) &&
         std::find(place.messages.begin(), place.messages.end(), one.message) == place.messages.end();
}

std::string met(AtPlace const &place) {
  std::string text;
  if (place.count != 0) text = fmt::format("met {} time{}", place.count, place.count == 1 ? "" : "s");
  if (place.paths.size() > 1)
    text +=
        fmt::format("{}on {} call paths, of which this is the shortest", text.empty() ? "" : " ", place.paths.size());
  return text.empty() ? text : " (" + text + ")";
}

} // namespace

std::vector<Diagnostic> once_a_place(std::vector<Met> const &all) {
  std::vector<AtPlace> places;
  std::map<std::string, std::size_t> known;
  for (Met const &one : all) {
    std::string key = code(one.diagnostic.id) + to_string(one.diagnostic.place);
    if (one.diagnostic.place.line == 0) key += one.diagnostic.message;
    // Two diagnostics along one path are two decisions of one expression.
    if (auto const other = known.find(key); other != known.end() && is_another(places[other->second], one.diagnostic))
      key += one.diagnostic.message;
    auto const [found, is_new] = known.try_emplace(std::move(key), places.size());
    if (is_new) places.push_back({one.diagnostic, 0, one.frames, {}, {}, {}});
    AtPlace &place = places[found->second];
    place.count += one.count;
    place.paths.insert(path_of(one.diagnostic));
    add_new(place.recorded, one.recorded);
    add_new(place.messages, one.diagnostic.message);
    if (one.frames >= place.frames) continue;
    place.frames = one.frames;
    place.diagnostic.notes = one.diagnostic.notes;
  }
  std::vector<Diagnostic> diagnostics;
  for (AtPlace &place : places) {
    Diagnostic &one = place.diagnostic;
    place.messages.erase(place.messages.begin());
    for (auto const &[what, list] : {std::pair("recorded as ", &place.recorded), std::pair("also: ", &place.messages)})
      if (!list->empty()) one.notes.insert(one.notes.begin(), {one.place, what + joined(*list)});
    one.message += met(place);
    diagnostics.push_back(std::move(one));
  }
  return diagnostics;
}

} // namespace symreal::program
