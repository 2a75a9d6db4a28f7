#include "rewrite/facts/facts.h"

#include "rewrite/facts/bytes.h"
#include "rewrite/facts/members.h"

#include <algorithm>

namespace symreal::rewrite {
namespace {

void merge_item(ItemFact &item, ItemFact const &other) {
  if (item.seen || !other.seen) return;
  item = other;
}

void merge_pragma(PragmaFact &pragma, PragmaFact &&other) {
  if (pragma.function.empty()) pragma.function = std::move(other.function);
  if (!pragma.loop_targets) pragma.loop_targets = std::move(other.loop_targets);
  pragma.tests_late |= other.tests_late;
  for (std::size_t c = 0; c < pragma.clauses.size() && c < other.clauses.size(); ++c)
    for (std::size_t i = 0; i < pragma.clauses[c].items.size() && i < other.clauses[c].items.size(); ++i)
      merge_item(pragma.clauses[c].items[i], other.clauses[c].items[i]);
}

void add_refusals(std::vector<Refusal> &refusals, std::vector<Refusal> const &others) {
  for (Refusal const &other : others)
    if (std::none_of(refusals.begin(), refusals.end(),
                     [&](Refusal const &known) { return to_string(known.condition) == to_string(other.condition); }))
      refusals.push_back(other);
}

void merge_decision(DecisionFact &decision, DecisionFact &&other) {
  if (!decision.alterations.empty() && !other.alterations.empty() && decision.alterations != other.alterations)
    for (Refusal refusal : other.uses) {
      refusal.reason = {ReasonId::differs_elsewhere};
      add_refusals(decision.refusals, {refusal});
    }
  add_refusals(decision.refusals, other.refusals);
  add_refusals(decision.misuses, other.misuses);
  add_refusals(decision.uses, other.uses);
  if (decision.alterations.empty()) {
    decision.alterations = std::move(other.alterations);
    decision.needs = std::move(other.needs);
  }
}

template <class Name> bool same_names(std::vector<ClassFact::Constituent<Name>> const &one,
                                      std::vector<ClassFact::Constituent<Name>> const &other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](auto const &left, auto const &right) { return left.name == right.name; });
}

// A class with other members is a contradiction, which is reported elsewhere (decide/configurations.h).
void merge_class(ClassFact &fact, ClassFact const &other) {
  if (!same_members(fact, other)) return;
  for (std::size_t i = 0; i < fact.bases.size(); ++i) fact.bases[i].holds |= other.bases[i].holds;
  for (std::size_t i = 0; i < fact.fields.size(); ++i) fact.fields[i].holds |= other.fields[i].holds;
}

void merge_file(FileFact &file, FileFact &&other, Facts &facts) {
  if (file.text != other.text)
    add_diagnostic(facts, {DiagnosticId::changed_file, {file.display_path}, "this file changed while it was read"});
}

// Renames a file that two sources name differently to the known name, so that its errors are reported once.
void use_known_names(std::vector<Diagnostic> &diagnostics, std::map<std::string, FileFact> const &files,
                     std::map<std::string, FileFact> const &known) {
  std::map<std::string, std::string> names;
  for (auto const &[path, file] : files)
    if (auto const found = known.find(path); found != known.end() && found->second.display_path != file.display_path)
      names[file.display_path] = found->second.display_path;
  if (names.empty()) return;
  auto const rename = [&](Place &place) {
    if (auto const found = names.find(place.file); found != names.end()) place.file = found->second;
  };
  for (Diagnostic &one : diagnostics) {
    rename(one.place);
    for (Note &note : one.notes) rename(note.place);
  }
}

template <class T> std::string written(T &object) {
  Write write;
  write(object);
  return write.result();
}

} // namespace

void note(TypeTokens &types, Span const &span, TypeToken token) {
  auto const [at, is_new] = types.try_emplace(span, token);
  TypeToken &known = at->second;
  // The first of several reasons to stay counts, and the last of several replacements in the order of words.
  if (std::tie(known.fate, known.replacement, token.why) < std::tie(token.fate, token.replacement, known.why))
    known = std::move(token);
}

bool meets(std::set<Span> const &spans, Span const &span) {
  auto at = spans.upper_bound({span.file, span.end, 0});
  while (at != spans.begin()) {
    --at;
    if (at->file != span.file) return false;
    if (at->begin < span.end && at->end > span.begin) return true;
    if (at->end <= span.begin) return false;
  }
  return false;
}

bool is_quoted(Facts const &facts, Span const &expression) {
  Span const first{expression.file, expression.begin, expression.begin + 1};
  return meets(facts.quoted, first) || meets(facts.quoted, {expression.file, expression.end - 1, expression.end});
}

std::string text_of(Span const &span, Facts const &facts) {
  return facts.files.at(span.file).text.substr(span.begin, span.end - span.begin);
}

Place place_in(FileFact const &file, std::size_t offset) {
  auto const end = file.text.begin() + static_cast<std::ptrdiff_t>(offset);
  std::size_t const line_start = offset == 0 ? std::string::npos : file.text.rfind('\n', offset - 1);
  auto const line = static_cast<unsigned>(std::count(file.text.begin(), end, '\n')) + 1;
  return {file.display_path, line,
          static_cast<unsigned>(offset - (line_start == std::string::npos ? 0 : line_start + 1)) + 1};
}

std::string definition_of(std::string const &name, std::string const &file) { return "own name " + name + " " + file; }

bool is_defined(Facts const &facts, Wrap const &own_name) {
  return facts.definitions.contains(definition_of(own_name.payload(Payload::name))) ||
         facts.definitions.contains(definition_of(own_name.payload(Payload::name), own_name.span.file));
}

bool same_members(ClassFact const &one, ClassFact const &other) {
  return same_names(one.bases, other.bases) && same_names(one.fields, other.fields);
}

void add_diagnostic(Facts &facts, Diagnostic const &diagnostic) {
  for (Diagnostic const &known : facts.diagnostics)
    if (known.id == diagnostic.id && to_string(known.place) == to_string(diagnostic.place) &&
        known.message == diagnostic.message)
      return;
  facts.diagnostics.push_back(diagnostic);
}

void merge(Choices &choices, Choices &&others) {
  for (auto &[key, choice] : others)
    if (auto const [at, is_new] = choices.try_emplace(key, std::move(choice)); !is_new)
      at->second.results.merge(choice.results);
}

void merge(Facts &facts, Facts &&other) {
  // Named one by one, so that a new kind of fact does not compile until it is merged as well.
  auto &[files, types, wraps, shared, members, reached, skipped, conversions, comparisons, printed, quoted, pasted,
         text_calls, pragmas, lists, arithmetic, choices, asking, by_hand, definitions, changeable, exported, uses,
         links, linked_words, names, deciding, decisions, externals, configured_externals, kernel_functions,
         taken_names, include_dirs, read, diagnostics, broken, makes_text] = other;
  use_known_names(diagnostics, files, facts.files);
  for (auto &[path, file] : files)
    if (auto const [at, is_new] = facts.files.try_emplace(path, std::move(file)); !is_new)
      merge_file(at->second, std::move(file), facts);
  for (auto &[span, token] : types) note(facts.types, span, std::move(token));
  facts.wraps.merge(wraps);
  facts.shared.merge(shared);
  for (auto &[brace, fact] : members)
    if (auto const [at, is_new] = facts.members.try_emplace(brace, std::move(fact)); !is_new)
      merge_class(at->second, fact);
  reached.clear(); // of one source alone (configurations.h)
  facts.skipped.merge(skipped);
  facts.conversions.merge(conversions);
  facts.comparisons.merge(comparisons);
  facts.printed.merge(printed);
  facts.quoted.merge(quoted);
  facts.pasted.merge(pasted);
  facts.text_calls.merge(text_calls);
  for (auto &[span, pragma] : pragmas)
    if (auto const [at, is_new] = facts.pragmas.try_emplace(span, std::move(pragma)); !is_new)
      merge_pragma(at->second, std::move(pragma));
  for (auto &[name, fact] : lists) {
    ListFact &known = facts.lists[name];
    known.reads |= fact.reads;
    known.prints |= fact.prints;
    known.handed.merge(fact.handed);
    known.outside.merge(fact.outside);
  }
  facts.arithmetic.merge(arithmetic);
  merge(facts.choices, std::move(choices));
  facts.asking.merge(asking);
  facts.by_hand.insert(facts.by_hand.end(), by_hand.begin(), by_hand.end());
  facts.definitions.merge(definitions);
  facts.changeable.merge(changeable);
  facts.exported.merge(exported);
  facts.uses.merge(uses);
  links.clear(), linked_words.clear(); // of one source alone (reachable_sources.h)
  facts.names.merge(names);
  facts.deciding.merge(deciding);
  for (auto &[span, decision] : decisions)
    if (auto const [at, is_new] = facts.decisions.try_emplace(span, std::move(decision)); !is_new)
      merge_decision(at->second, std::move(decision));
  facts.externals.merge(externals);
  facts.configured_externals.merge(configured_externals);
  facts.kernel_functions.merge(kernel_functions);
  facts.taken_names.merge(taken_names);
  for (std::string &directory : include_dirs)
    if (std::find(facts.include_dirs.begin(), facts.include_dirs.end(), directory) == facts.include_dirs.end())
      facts.include_dirs.push_back(std::move(directory));
  facts.read.merge(read);
  for (Diagnostic const &diagnostic : diagnostics) add_diagnostic(facts, diagnostic);
  facts.broken |= broken;
  facts.makes_text |= makes_text;
}

std::string to_bytes(Facts facts) { return written(facts); }
std::string to_bytes(ConfiguredKernel kernel) { return written(kernel); }
std::string to_bytes(ConfiguredExternal external) { return written(external); }

std::optional<Facts> facts_of_bytes(std::string_view bytes) {
  Read read(bytes);
  Facts facts;
  read(facts);
  return read.is_complete() ? std::optional(std::move(facts)) : std::nullopt;
}

} // namespace symreal::rewrite
