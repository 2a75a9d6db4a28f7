#include "rewrite/decide/text_calls.h"

#include "rewrite/decide/use_text.h"
#include "rewrite/facts/spans.h"
#include "rewrite/text/source_text.h"

#include <algorithm>

namespace symreal::rewrite {
namespace {

bool holds(Span const &outer, Span const &inner) {
  return outer.file == inner.file && outer.begin <= inner.begin && inner.end <= outer.end;
}

// The outermost calls, without those that paste an argument or contain a directive.
std::vector<Span> calls_to_copy(Facts const &facts) {
  std::vector<Span> calls;
  for (Span const &call : facts.text_calls) { // of those that begin at the same place the longest is last
    std::string const text = text_of(call, facts);
    if (meets(facts.pasted, call) || text.find('#') != text.npos || text.find("//") != text.npos) continue;
    if (!calls.empty() && holds(calls.back(), call)) continue;
    if (!calls.empty() && holds(call, calls.back()))
      calls.back() = call;
    else
      calls.push_back(call);
  }
  return calls;
}

bool needs_copy(Facts const &facts, Span const &call) {
  auto const within = [&](Span const &span) { return holds(call, span) && is_quoted(facts, span); };
  for (auto at = facts.types.lower_bound({{call.file, call.begin, 0}, ""});
       at != facts.types.end() && at->span.file == call.file && at->span.begin < call.end; ++at)
    if (!at->replacement.empty() && within(at->span)) return true;
  for (auto at = facts.wraps.lower_bound({{call.file, call.begin, 0}, Use{}, ""});
       at != facts.wraps.end() && at->span.file == call.file && at->span.begin < call.end; ++at)
    if (info(at->use).has(trait::NEEDED) && at->span != call && within(at->span)) return true;
  return false;
}

void erase_within(std::set<Span> &spans, Span const &outer) {
  std::erase_if(spans, [&](Span const &span) { return holds(outer, span); });
}

// The first copies from the rewriting before.
std::vector<Span> originals(std::string const &path, std::string const &text) {
  constexpr std::string_view opening = "REAL_EITHER((";
  std::vector<Span> spans;
  for (std::size_t at = text.find(opening); at != text.npos; at = text.find(opening, at)) {
    std::size_t const open = at + opening.size() - 1;
    at = std::min(closing_parenthesis(text, open), text.size());
    spans.push_back({path, open + 1, at});
  }
  return spans;
}

} // namespace

void copy_text_calls(Facts &facts, std::map<std::string, std::vector<Rewording>> &rewordings) {
  std::vector<Span> const calls = calls_to_copy(facts);
  std::vector<Span> copied;
  for (auto const &[path, file] : facts.files)
    for (Span &span : originals(path, file.text)) copied.push_back(std::move(span));
  for (Span const &call : calls) {
    bool const again = std::any_of(copied.begin(), copied.end(), [&](Span const &one) { return holds(one, call); });
    if (again || !needs_copy(facts, call)) continue;
    erase_within(facts.quoted, call);
    std::string original = text_of(call, facts);
    std::replace(original.begin(), original.end(), '\n', ' ');
    std::erase(original, '\r');
    rewordings[call.file].push_back(
        {call.begin, call.end, "SYMREAL_REAL_EITHER((" + original + "), ", ")", false, depth::copy});
  }
  for (Span const &span : copied) {
    erase_within(facts.quoted, span);
    std::erase_if(facts.wraps, [&](Wrap const &wrap) { return holds(span, wrap.span); });
    facts.quoted.insert(span);
  }
}

} // namespace symreal::rewrite
