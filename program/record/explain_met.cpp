#include "program/record/explain_met.h"

#include "engine/graph/graph.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <map>
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

// A condition, or "the conversion of x", recorded in terms of the kernel's inputs.
struct SaidDecision {
  std::string text;     // source text, if known
  std::string recorded; // text in terms of the inputs, if it tells more
};
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

// The innermost condition around the place: the one that begins last.
rewrite::Refusal const *refusal_at(Place const &place, std::vector<rewrite::Refusal> const &refusals) {
  rewrite::Refusal const *found = nullptr;
  for (rewrite::Refusal const &one : refusals) {
    bool const covers = one.condition.file == place.file && one.condition.line <= place.line &&
                        place.line <= one.last_line &&
                        (one.condition.line < place.line || one.condition.column <= place.column || !found);
    if (covers) found = &one;
  }
  return found;
}

struct Met {
  Diagnostic diagnostic;     // the notes give the call path
  std::size_t count = 0;     // occurrences along this path; 0: not counted
  std::size_t frames = 0;    // length of the call path
  std::string recorded = {}; // its subject in terms of the kernel's inputs, unless the message says so
};

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

std::string times_met(AtPlace const &place) {
  std::string text;
  if (place.count != 0) text = fmt::format("met {} time{}", place.count, place.count == 1 ? "" : "s");
  if (place.paths.size() > 1)
    text +=
        fmt::format("{}on {} call paths, of which this is the shortest", text.empty() ? "" : " ", place.paths.size());
  return text.empty() ? text : " (" + text + ")";
}

// Diagnostics merged to one for each place, however many call paths lead there, in order of first occurrence. Each has
// the shortest of its paths; its message gives the number of occurrences and of paths.
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
    one.message += times_met(place);
    diagnostics.push_back(std::move(one));
  }
  return diagnostics;
}

constexpr std::size_t most_frames = 8; // frames of a call path that become notes
constexpr char const *here_in = "here, in ";

Met locate(DiagnosticId id, std::vector<std::uint64_t> const &addresses, Symbolizer &symbolizer) {
  Met met{{id}};
  Diagnostic &diagnostic = met.diagnostic;
  std::vector<Frame> frames = symbolizer.frames(addresses);
  met.frames = frames.size();
  // The innermost place in a rewritten file is where the user can act; frames further in (Eigen, std) are libraries.
  auto own = std::find_if(frames.begin(), frames.end(), [](Frame const &frame) { return frame.rewritten; });
  if (own == frames.end()) own = frames.begin();
  if (own != frames.end()) diagnostic.place = own->place;
  for (auto frame = frames.begin(); frame != frames.end() && diagnostic.notes.size() < most_frames; ++frame) {
    if (frame == own) continue;
    diagnostic.notes.push_back({frame->place, std::string(frame < own ? here_in : "called from ") + frame->function});
  }
  return met;
}

bool same(Diagnostic const &one, Diagnostic const &other) {
  auto const same_note = [](Note const &a, Note const &b) {
    return a.message == b.message && to_string(a.place) == to_string(b.place);
  };
  return one.id == other.id && one.message == other.message && to_string(one.place) == to_string(other.place) &&
         std::equal(one.notes.begin(), one.notes.end(), other.notes.begin(), other.notes.end(), same_note);
}

// Message around a condition.
struct Phrase {
  DiagnosticId id;
  std::string before, after;
};

Met explain(Decision const &decision, Phrase const &phrase, Symbolizer &symbolizer, DecidingTexts const &texts) {
  Met met = locate(phrase.id, decision.addresses, symbolizer);
  bool const is_further_in = !met.diagnostic.notes.empty() && met.diagnostic.notes.front().message.starts_with(here_in);
  SaidDecision const said = is_further_in ? SaidDecision{decision.condition, {}}
                                          : said_by_source(decision.condition, met.diagnostic.place, texts);
  met.diagnostic.message = phrase.before + said.text + phrase.after;
  met.recorded = said.recorded;
  return met;
}

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

std::vector<Diagnostic> explain_met(Events const &events, Symbolizer &symbolizer, DecidingTexts const &texts) {
  std::vector<Met> all;
  for (Located const &located : events.located) {
    all.push_back(locate(located.id, located.addresses, symbolizer));
    all.back().diagnostic.message = located.message;
    all.back().count = located.count;
    // Two instructions of one expression count as one.
    bool const is_known = std::any_of(all.begin(), all.end() - 1,
                                      [&](Met const &other) { return same(other.diagnostic, all.back().diagnostic); });
    if (is_known) all.pop_back();
  }
  Phrase const decided{DiagnosticId::symbolic_decision, "the program decides on a symbolic value: ", ""};
  for (Decision const &one : events.decisions) {
    all.push_back(explain(one, decided, symbolizer, texts));
    all.back().count = one.count;
  }
  Phrase const carried{DiagnosticId::carried_decision, "a pragma says that no output depends on ", ""};
  for (Decision const &one : events.carried) all.push_back(explain(one, carried, symbolizer, texts));
  Phrase const settled{DiagnosticId::settled_condition, "", " is constant: in mode finite every value is finite"};
  for (Decision const &one : events.settled) {
    all.push_back(explain(one, settled, symbolizer, texts));
    all.back().diagnostic.notes.clear();
  }
  return once_a_place(all);
}

void explain_crash(Diagnostic &diagnostic, std::vector<std::uint64_t> const &addresses, Symbolizer &symbolizer) {
  Met met = locate(diagnostic.id, addresses, symbolizer);
  if (met.diagnostic.place.file.empty()) return;
  std::vector<Note> notes = {{diagnostic.place, "Symreal waited for this"}};
  if (diagnostic.place.file.empty()) notes.clear();
  diagnostic.place = met.diagnostic.place;
  diagnostic.message += "; it stood here";
  diagnostic.notes = std::move(met.diagnostic.notes);
  diagnostic.notes.insert(diagnostic.notes.end(), notes.begin(), notes.end());
}

void say_in_words_of_source(Graph &graph, DecidingTexts const &texts) {
  for (Guard &guard : graph.guards) {
    // Decisions inside a library (Eigen, std) have no source text of the user's.
    if (guard.location == no_location || graph.locations[guard.location].places.size() != 1) continue;
    std::size_t const end = end_of_condition(guard.text);
    SaidDecision const said =
        said_by_source(guard.text.substr(0, end), graph.locations[guard.location].places.front(), texts);
    guard.text = said.text + (said.recorded.empty() ? "" : " (" + said.recorded + ")") + guard.text.substr(end);
  }
}

void explain_refusals(std::vector<Diagnostic> &diagnostics, std::vector<rewrite::Refusal> const &refusals) {
  for (Diagnostic &diagnostic : diagnostics) {
    if (diagnostic.id != DiagnosticId::symbolic_decision) continue;
    if (rewrite::Refusal const *refusal = refusal_at(diagnostic.place, refusals))
      diagnostic.notes.insert(diagnostic.notes.begin(), {refusal->token, "not selectable: " + words(refusal->reason)});
  }
}

} // namespace symreal::program
