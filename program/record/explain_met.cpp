#include "program/record/explain_met.h"

#include "engine/graph/guard_words.h"
#include "program/record/call_paths.h"

#include <algorithm>

namespace symreal::program {
namespace {

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

} // namespace symreal::program
