#include "rewrite/facts/fact_bytes.h"

#include "rewrite/facts/bytes.h"

namespace symreal::rewrite {

// What each consists of (bytes.h).
template <class Take> void visit(Take &take, Place &object) {
  auto &[file, line, column] = object;
  take(file, line, column);
}
template <class Take> void visit(Take &take, Note &object) {
  auto &[place, message] = object;
  take(place, message);
}
template <class Take> void visit(Take &take, Diagnostic &object) {
  auto &[id, place, message, notes, severity] = object;
  take(id, place, message, notes, severity);
}
template <class Take> void visit(Take &take, Span &object) {
  auto &[file, begin, end] = object;
  take(file, begin, end);
}
template <class Take> void visit(Take &take, TypeToken &object) {
  auto &[span, replacement, why] = object;
  take(span, replacement, why);
}
template <class Take> void visit(Take &take, Wrap &object) {
  auto &[span, use, detail] = object;
  take(span, use, detail);
}
template <class Take> void visit(Take &take, Section &object) {
  auto &[low, length] = object;
  take(low, length);
}
template <class Take> void visit(Take &take, ObjectLayout &object) {
  auto &[text, containers] = object;
  take(text, containers);
}
template <class Take> void visit(Take &take, Annotation &object) {
  auto &[kind, label, place, expression, sections, layout] = object;
  take(kind, label, place, expression, sections, layout);
}
template <class Take> void visit(Take &take, Include &object) {
  auto &[name, beside] = object;
  take(name, beside);
}
template <class Take> void visit(Take &take, Redefinition &object) {
  auto &[obstacle, qualified, head, includes, declarations, namespaces, missing, varying, mangled, arguments,
         parameters, returned, has_this] = object;
  take(obstacle, qualified, head, includes, declarations, namespaces, missing, varying, mangled, arguments, parameters,
       returned, has_this);
}
template <class Take> void visit(Take &take, Signature &object) {
  auto &[declaration, arguments, returns_value, redefinition] = object;
  take(declaration, arguments, returns_value, redefinition);
}
template <class Take> void visit(Take &take, Kernel &object) {
  auto &[name, is_function, by_hand, place, output_file, signature, annotations, source] = object;
  take(name, is_function, by_hand, place, output_file, signature, annotations, source);
}
template <class Take> void visit(Take &take, ItemFact &object) {
  auto &[label, expression, base, sections, place, is_return, base_is_name, section_on_base, seen, carries_real,
         holds_integer, type, base_kind, layout, left_out, kept] = object;
  take(label, expression, base, sections, place, is_return, base_is_name, section_on_base, seen, carries_real,
       holds_integer, type, base_kind, layout, left_out, kept);
}
template <class Take> void visit(Take &take, ClauseFact &object) {
  auto &[name, place, argument, items] = object;
  take(name, place, argument, items);
}
template <class Take> void visit(Take &take, FunctionFact::Value &object) {
  auto &[name, place] = object;
  take(name, place);
}
template <class Take> void visit(Take &take, FunctionFact &object) {
  auto &[name, signature, brace, values, parameters] = object;
  take(name, signature, brace, values, parameters);
}
template <class Take> void visit(Take &take, PragmaFact &object) {
  auto &[span, continued_lines, place, display_file, is_function, configured, clauses, function, around, loop_targets,
         tests_late] = object;
  take(span, continued_lines, place, display_file, is_function, configured, clauses, function, around, loop_targets,
       tests_late);
}
template <class Take> void visit(Take &take, UseFact &object) {
  auto &[mangled, name, parameters, declaration, place, source] = object;
  take(mangled, name, parameters, declaration, place, source);
}
template <class Take> void visit(Take &take, Alteration &object) {
  auto &[span, before, after, replaces, inside] = object;
  take(span, before, after, replaces, inside);
}
template <class Take> void visit(Take &take, Refusal &object) {
  auto &[condition, last_line, reason, token] = object;
  take(condition, last_line, reason, token);
}
template <class Take> void visit(Take &take, DecisionFact &object) {
  auto &[alterations, refusals, misuses, uses, needs] = object;
  take(alterations, refusals, misuses, uses, needs);
}
template <class Take> void visit(Take &take, SpelledType &object) {
  auto &[span, is_float, is_long, kept, where, name, within] = object;
  take(span, is_float, is_long, kept, where, name, within);
}
template <class Take> void visit(Take &take, FileFact &object) {
  auto &[display_path, compiled_name, text, spelled, conditions, directives, kept] = object;
  take(display_path, compiled_name, text, spelled, conditions, directives, kept);
}
template <class Take, class Name> void visit(Take &take, ClassFact::Part<Name> &object) {
  auto &[name, holds] = object;
  take(name, holds);
}
template <class Take> void visit(Take &take, ClassFact &object) {
  auto &[access, bases, fields] = object;
  take(access, bases, fields);
}
template <class Take> void visit(Take &take, ConversionFact &object) {
  auto &[span, type, to_integer] = object;
  take(span, type, to_integer);
}
template <class Take> void visit(Take &take, NamedStatement &object) {
  auto &[begin, end, name] = object;
  take(begin, end, name);
}
template <class Take> void visit(Take &take, DecidingText &object) {
  auto &[keyword, begin, end, text, type] = object;
  take(keyword, begin, end, text, type);
}
template <class Take> void visit(Take &take, ConfiguredText &object) {
  auto &[text, place] = object;
  take(text, place);
}
template <class Take> void visit(Take &take, ConfiguredClause &object) {
  auto &[name, items] = object;
  take(name, items);
}
template <class Take> void visit(Take &take, ConfiguredKernel &object) {
  auto &[function, file, clauses] = object;
  take(function, file, clauses);
}
template <class Take> void visit(Take &take, ConfiguredExternal &object) {
  auto &[function, pure, clauses] = object;
  take(function, pure, clauses);
}
template <class Take> void visit(Take &take, Facts &object) {
  auto &[files, types, doubles, wraps, shared, members, reached, skipped, consumed, conversions, comparisons, printed,
         quoted, pasted, text_calls, pragmas, number_readers, by_hand, definitions, exported, uses, links, linked_words,
         names, deciding, decisions, externals, configured_externals, kernel_functions, taken_names, include_dirs, read,
         diagnostics, broken, makes_text] = object;
  take(files, types, doubles, wraps, shared, members, reached, skipped, consumed, conversions, comparisons, printed,
       quoted, pasted, text_calls, pragmas, number_readers, by_hand, definitions, exported, uses, links, linked_words,
       names, deciding, decisions, externals, configured_externals, kernel_functions, taken_names, include_dirs, read,
       diagnostics, broken, makes_text);
}

namespace {

template <class T> std::string written(T &object) {
  Write write;
  write(object);
  return write.result();
}

} // namespace

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
