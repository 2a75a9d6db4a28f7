#include "rewrite/decide/decide.h"
#include "rewrite/decide/use_text.h"
#include "rewrite/text/source_text.h"

#include <algorithm>
#include <cctype>
#include <tuple>

namespace symreal::rewrite {
namespace {

// A word that takes the place of punctuation is set apart from its neighbours.
std::string set_apart(std::string word, std::string const &text, Span const &span) {
  if (word.empty() || !is_word(word.back())) return word;
  if (span.begin > 0 && !std::isspace(static_cast<unsigned char>(text[span.begin - 1]))) word = " " + word;
  if (span.end < text.size() && !std::isspace(static_cast<unsigned char>(text[span.end]))) word += " ";
  return word;
}

Rewording rewording(Alteration const &one, std::string const &text) {
  if (one.replaces) return {one.span.begin, one.span.end, set_apart(one.before, text, one.span), "", true};
  return {one.span.begin, one.span.end, one.before, one.after, false, one.inside ? depth::within_uses : depth::select};
}

bool is_made(std::map<Span, DecisionFact> const &decisions, DecisionFact const &fact) {
  if (!fact.refusals.empty() || fact.alterations.empty()) return false;
  if (!fact.needs) return true;
  auto const needed = decisions.find(*fact.needs);
  return needed != decisions.end() && is_made(decisions, needed->second);
}

// Refuses selects in an argument that a macro stringifies or pastes: its text is data.
void refuse_quoted(Facts const &facts, DecisionFact &fact) {
  for (Alteration const &one : fact.alterations) {
    if (!meets(facts.quoted, one.span)) continue;
    Place const place = place_in(facts.files.at(one.span.file), one.span.begin);
    fact.refusals.push_back({place, place.line, {ReasonId::quoted}, place});
    return;
  }
}

// Other uses of the macro matter only to a decision on REALs.
void refuse_misuses(DecisionFact &fact) {
  if (fact.alterations.empty() && fact.refusals.empty()) return;
  fact.refusals.insert(fact.refusals.end(), fact.misuses.begin(), fact.misuses.end());
}

DecisionFact const *in_the_way(std::map<Span, DecisionFact> const &decisions, DecisionFact const &fact) {
  if (!fact.refusals.empty() || !fact.needs) return &fact;
  auto const needed = decisions.find(*fact.needs);
  return needed == decisions.end() ? &fact : in_the_way(decisions, needed->second);
}

void report_decision(Facts const &facts, Span const &key, DecisionFact const &fact, Result &result) {
  FileFact const &file = facts.files.at(key.file);
  std::string kind = file.text.substr(key.begin, key.end - key.begin);
  if (kind == "{" || (fact.alterations.empty() && fact.refusals.empty())) return; // a function's returns
  if (kind == "?") kind = "?:";
  Decision decision{place_in(file, key.begin), std::move(kind), is_made(facts.decisions, fact)};
  DecisionFact const *blocked = in_the_way(facts.decisions, fact);
  if (!decision.selectable && !blocked->refusals.empty()) {
    decision.reason = blocked->refusals[0].reason;
    decision.token = blocked->refusals[0].token;
  }
  result.decisions.push_back(std::move(decision));
}

} // namespace

void add_selects(Facts &facts, std::map<std::string, std::vector<Rewording>> &rewordings, Result &result) {
  for (auto &[key, fact] : facts.decisions) {
    refuse_misuses(fact);
    refuse_quoted(facts, fact);
  }
  std::set<Span> kernels; // the braces of functions whose returned value is an output
  for (auto const &[span, pragma] : facts.pragmas)
    for (FunctionFact const &function : pragma.function)
      if (pragma.clause(Clause::output)) kernels.insert(function.brace);
  for (auto const &[key, fact] : facts.decisions) {
    report_decision(facts, key, fact, result);
    result.refusals.insert(result.refusals.end(), fact.refusals.begin(), fact.refusals.end());
    if (!fact.refusals.empty())
      for (Refusal use : fact.uses) {
        use.reason = fact.refusals[0].reason;
        use.token = fact.refusals[0].token;
        result.refusals.push_back(std::move(use));
      }
    if (!is_made(facts.decisions, fact)) continue;
    for (Alteration one : fact.alterations) {
      if (one.span == key && kernels.count(key) != 0) one.after += "_OF(symreal_kernel)";
      rewordings[one.span.file].push_back(rewording(one, facts.files.at(one.span.file).text));
    }
  }
  std::stable_sort(result.refusals.begin(), result.refusals.end(), [](Refusal const &a, Refusal const &b) {
    return std::tie(a.condition.file, a.condition.line, a.condition.column) <
           std::tie(b.condition.file, b.condition.line, b.condition.column);
  });
}

} // namespace symreal::rewrite
