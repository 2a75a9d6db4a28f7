// Rewordings of the sources: types, the macros around expressions, selects, members and pragmas.
#include "rewrite/decide/decide.h"
#include "rewrite/text/pragma_text.h"
#include "rewrite/text/source_text.h"

#include <algorithm>
#include <cctype>
#include <tuple>

namespace symreal::rewrite {
namespace {

// Nesting depths of rewordings of the same characters, the outermost first; uses lie between `select` and
// `within_uses`, in the order of their rows.
namespace depth {
constexpr int outermost = -2, select = -1, within_uses = 100, copy = 1000;
}

std::string with_payload(std::string_view text, std::string const &payload) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at)
    if (text[at] != '%')
      result += text[at];
    else if (text.substr(at).starts_with("%q")) {
      result += in_quotes(payload);
      ++at;
    } else
      result += payload;
  return result;
}

// `is_shared`: the text is compiled in several ways, so a conversion follows the type that its context expects.
Rewording rewording(Wrap const &wrap, bool is_shared) {
  bool const by_context = is_shared && (wrap.use == Use::conversion || wrap.use == Use::cast);
  internal_check(info(wrap.use).payload != Payload::none || wrap.detail.empty());
  UseInfo const &row = info(by_context ? Use::fit : wrap.use);
  std::size_t const expression = row.text.find('$');
  return {wrap.span.begin,
          wrap.span.end,
          with_payload(row.text.substr(0, expression), wrap.detail),
          with_payload(row.text.substr(expression + 1), wrap.detail),
          false,
          row.has(trait::OUTERMOST) ? depth::outermost : static_cast<int>(wrap.use)};
}

// A library's typedef keeps its name where the program prints it.
std::string replacement_of(Span const &span, TypeToken const &token, Facts const &facts) {
  if (token.replacement == reserved_type_name || !meets(facts.printed, span)) return token.replacement;
  return "SYMREAL_REAL_TYPE(" + text_of(span, facts) + ", " + token.replacement + ")";
}

void add_types(Facts const &facts, Ledger const &ledger, Rewordings &rewordings, Result &result) {
  std::vector<Diagnostic> unaccounted;
  for (auto const &[span, token] : facts.types) {
    if (token.fate == Fate::inactive || ledger.is_pragma(span)) continue;
    Spelling const judged = ledger.judged(span, token);
    FileFact const &file = facts.files.at(span.file);
    if (judged.fate == Fate::converted)
      rewordings[span.file].push_back({span.begin, span.end, replacement_of(span, token, facts), "", true});
    else if (judged.fate == Fate::follows) {
      // A few places have no type in the syntax tree, such as the explicit instantiation of a function or an attribute.
      // If what becomes of `double` there is wrong, the symbolic program does not compile.
      rewordings[span.file].push_back({span.begin, span.end, reserved_type_name, "", true});
      unaccounted.push_back({DiagnosticId::unaccounted_double, place_in(file, span.begin),
                             "the syntax tree does not say what this double is part of; it becomes REAL"});
    } else if (token.fate != Fate::follows && judged.detail == code(DiagnosticId::quoted_double))
      result.diagnostics.push_back(
          {DiagnosticId::quoted_double, place_in(file, span.begin),
           "'" + text_of(span, facts) + "' stays as it is: a macro turns this argument into text"});
  }
  result.diagnostics.insert(result.diagnostics.end(), unaccounted.begin(), unaccounted.end());
}

// Whether the expression is one call of a Symreal macro, from an earlier rewriting: it needs no further wraps.
bool is_rewritten(std::string const &text, Span const &span) {
  if (text.compare(span.begin, 5, "REAL_") != 0 && text.compare(span.begin, 8, "SYMREAL_") != 0) return false;
  std::size_t const at = text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_", span.begin);
  return at < span.end && text[at] == '(' && closing_parenthesis(text, at) + 1 == span.end;
}

// Whether an earlier rewriting has inserted the wrap behind an opening brace or before a closing one.
bool is_laid_out(std::string const &text, Wrap const &wrap) {
  if (wrap.use == Use::padding) {
    std::size_t const line = text.rfind('\n', wrap.span.begin);
    return text.substr(line + 1, wrap.span.begin - line).find("REAL_PADDING(") != text.npos;
  }
  std::size_t const end = text.find('\n', wrap.span.end);
  return text.substr(wrap.span.end, end - wrap.span.end).find("REAL_LAYOUT(") != text.npos;
}

// Whether an earlier rewriting has inserted the wrap's words for symbolic mode.
bool is_inserted(std::string const &text, Wrap const &wrap) {
  if (wrap.use != Use::before && wrap.use != Use::behind) return false;
  std::string_view const whole = text;
  std::string const words = "REAL_ONLY(" + wrap.payload(Payload::words) + ")";
  if (wrap.use == Use::before) return whole.substr(0, wrap.span.begin).ends_with(words + " ");
  std::string_view const behind = whole.substr(wrap.span.end);
  return behind.starts_with(" " + words) || behind.starts_with(" SYMREAL_" + words);
}

void add_wraps(Facts const &facts, Ledger const &ledger, Rewordings &rewordings, Result &result) {
  Wrap const *before = nullptr;
  for (Wrap const &wrap : facts.wraps) {
    // A repeated wrap of the same characters: its words may differ, as two sources may name a file differently.
    bool const again = before && before->span == wrap.span && before->use == wrap.use;
    if (again && wrap.use == Use::argument)
      result.diagnostics.push_back(
          {DiagnosticId::instantiations_differ, place_in(facts.files.at(wrap.span.file), wrap.span.begin),
           "'" + text_of(wrap.span, facts) + "' is converted to " + before->payload(Payload::type) +
               " in one instantiation and to " + wrap.payload(Payload::type) + " in another"});
    before = &wrap;
    if (info(wrap.use).has(trait::BRACE) && is_laid_out(facts.files.at(wrap.span.file).text, wrap)) continue;
    if (again || is_rewritten(facts.files.at(wrap.span.file).text, wrap.span)) continue;
    if (is_inserted(facts.files.at(wrap.span.file).text, wrap)) continue;
    // The function reads the REALs itself, as REALs.
    if (wrap.use == Use::value && reads_numbers(facts, wrap.payload(Payload::function))) continue;
    bool const is_name = wrap.use == Use::name || wrap.use == Use::own_name;
    if (wrap.use == Use::own_name && !is_defined(facts, wrap)) continue;
    if (wrap.use == Use::of_library && is_defined(facts, wrap)) continue;
    bool const is_text = wrap.use != Use::pasted && is_quoted(facts, wrap.span);
    if (is_text && is_name)
      result.diagnostics.push_back(
          {DiagnosticId::c_source, place_in(facts.files.at(wrap.span.file), wrap.span.begin),
           "'" + wrap.payload(Payload::name) + "' has another name in symbolic mode, and a macro turns it into text"});
    if (!ledger.is_pragma(wrap.span) && !is_text)
      rewordings[wrap.span.file].push_back(rewording(wrap, facts.shared.contains(wrap.span)));
  }
}

// A type in the words of the file, with the types in it that change.
std::string type_text(Facts const &facts, Span const &span) {
  std::string const &file = facts.files.at(span.file).text;
  std::string text; // becomes one line: insertions keep line numbers
  std::size_t at = span.begin;
  for (auto found = facts.types.lower_bound({span.file, span.begin, 0}); found != facts.types.end(); ++found) {
    auto const &[token, type] = *found;
    if (token.file != span.file || token.end > span.end) break;
    if (type.fate != Fate::converted || token.begin < at) continue;
    text += file.substr(at, token.begin - at) + type.replacement;
    at = token.end;
  }
  return normalised(text + file.substr(at, span.end - at));
}

// Whether the base is a pack: `struct overloaded : Cases... {`.
bool is_pack(Facts const &facts, Span const &base) {
  std::string const &text = facts.files.at(base.file).text;
  std::string const behind = normalised(text.substr(base.end, text.find('{', base.end) - base.end));
  return behind.starts_with("...") || behind.starts_with(" ...");
}

void add_members(Facts const &facts, Rewordings &rewordings) {
  for (auto const &[brace, members] : facts.members) {
    std::string_view const behind = std::string_view(facts.files.at(brace.file).text).substr(brace.end);
    if (behind.starts_with(" REAL_MEMBERS(") || behind.starts_with(" SYMREAL_REAL_MEMBERS(")) continue;
    std::string list;
    bool has_state = false;
    for (auto const &[base, holds] : members.bases)
      if (holds)
        list += ", static_cast<" + type_text(facts, base) + " const &>(*this)" + (is_pack(facts, base) ? "..." : "");
    for (auto const &[field, holds] : members.fields) {
      has_state = has_state || holds;
      if (holds && !field.empty()) list += ", " + field; // bit-fields have no address, and no name here
    }
    if (has_state && list.empty()) list = ", ";
    if (!list.empty())
      rewordings[brace.file].push_back(
          {brace.begin, brace.end, "", " SYMREAL_REAL_MEMBERS(" + members.access + list + ")"});
  }
}

void add_arithmetic(Facts const &facts, Rewordings &rewordings) {
  for (auto const &[span, fact] : facts.arithmetic)
    rewordings[span.file].push_back(
        {span.begin, span.end,
         "SYMREAL_REAL_EITHER((" + fact.own + "), " + fact.instead + ")" + std::string(fact.continued_lines, '\n'), "",
         true});
}

// Macro calls that turn an argument into text, as assert and the macros of test frameworks do: the text is data and
// stays. Conversions in such an argument are made in a second copy of the call, for symbolic mode. Numeric mode sees
// the first copy, the original, only:
//
//   SYMREAL_REAL_EITHER((CHECK(x == half(1.0))), CHECK(x == half(REAL_C(1.0))))
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
  for (auto at = facts.types.lower_bound({call.file, call.begin, 0});
       at != facts.types.end() && at->first.file == call.file && at->first.begin < call.end; ++at)
    if (at->second.fate == Fate::converted && within(at->first)) return true;
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

// Adds the wraps around calls that need a second copy, and removes their arguments from `quoted`. Copies from an
// earlier rewriting are quoted as a whole.
void copy_text_calls(Facts &facts, Rewordings &rewordings) {
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

// Adds the rewordings that turn decisions into selects, where no refusal stands against it.
void add_selects(Facts &facts, Rewordings &rewordings, Result &result) {
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

} // namespace

Rewordings reword(Facts &facts, Ledger const &ledger, Result &result) {
  Rewordings rewordings;
  copy_text_calls(facts, rewordings);
  add_types(facts, ledger, rewordings, result);
  add_wraps(facts, ledger, rewordings, result);
  add_selects(facts, rewordings, result);
  add_members(facts, rewordings);
  add_arithmetic(facts, rewordings);
  return rewordings;
}

void add_pragmas(Facts const &facts, Rewordings &rewordings) {
  for (auto const &[span, pragma] : facts.pragmas) {
    std::string const lines(pragma.continued_lines, '\n');
    std::vector<Rewording> &here = rewordings[span.file];
    if (!pragma.configured)
      here.push_back({span.begin, span.end, (pragma.is_function ? "" : region_text(pragma)) + lines, "", true});
    if (pragma.is_function && !pragma.function.empty()) {
      Span const &entry = pragma.function[0].brace;
      std::string const text = function_text(pragma);
      if (is_brace(entry))
        here.push_back({entry.begin, entry.end, "", " " + text});
      else
        here.push_back({entry.begin, entry.end, "SYMREAL_TRY_BEGIN " + text + " ", " SYMREAL_TRY_END"});
    }
  }
}

} // namespace symreal::rewrite
