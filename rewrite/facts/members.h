// Members of the structs of facts, listed once for all forms in which they are written and read.
//
// `visit(take, object)` calls take.members(names, member...), the same for each direction. It names all members with
// `auto &[...]`, so that a new member does not compile until it is listed here.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

// clang-format off
#define SYMREAL_CONSISTS_OF(...)                                                                                       \
  {                                                                                                                    \
    auto &[__VA_ARGS__] = object;                                                                                      \
    take.members(#__VA_ARGS__, __VA_ARGS__);                                                                                 \
  }

template <class Take> void visit(Take &take, Place &object)
  SYMREAL_CONSISTS_OF(file, line, column)
template <class Take> void visit(Take &take, Note &object)
  SYMREAL_CONSISTS_OF(place, message)
template <class Take> void visit(Take &take, Diagnostic &object)
  SYMREAL_CONSISTS_OF(id, place, message, notes, severity)
template <class Take> void visit(Take &take, Span &object)
  SYMREAL_CONSISTS_OF(file, begin, end)
template <class Take> void visit(Take &take, TypeToken &object)
  SYMREAL_CONSISTS_OF(fate, replacement, why)
template <class Take> void visit(Take &take, Wrap &object)
  SYMREAL_CONSISTS_OF(span, use, detail)
template <class Take> void visit(Take &take, Section &object)
  SYMREAL_CONSISTS_OF(low, length)
template <class Take> void visit(Take &take, ObjectLayout &object)
  SYMREAL_CONSISTS_OF(text, containers)
template <class Take> void visit(Take &take, Annotation &object)
  SYMREAL_CONSISTS_OF(kind, label, place, expression, sections, layout)
template <class Take> void visit(Take &take, Include &object)
  SYMREAL_CONSISTS_OF(name, beside)
template <class Take> void visit(Take &take, Baked &object)
  SYMREAL_CONSISTS_OF(label, expression, sections, shape, is_object, place)
template <class Take> void visit(Take &take, Overlap &object)
  SYMREAL_CONSISTS_OF(first, second, first_in_rows, second_in_rows, first_there, second_there, calls)
template <class Take> void visit(Take &take, ReturnedObject &object)
  SYMREAL_CONSISTS_OF(form, type, obstacle, begin, others)
template <class Take> void visit(Take &take, Redefinition &object)
  SYMREAL_CONSISTS_OF(obstacle, qualified, head, includes, declarations, namespaces, missing, varying, mangled,
    arguments, parameters, returned, has_this, file, body, is_template, baked, overlaps, result)
template <class Take> void visit(Take &take, Signature &object)
  SYMREAL_CONSISTS_OF(declaration, arguments, returns_value, redefinition)
template <class Take> void visit(Take &take, Kernel &object)
  SYMREAL_CONSISTS_OF(name, is_function, by_hand, place, output_file, signature, annotations, source)
template <class Take> void visit(Take &take, ItemFact &object)
  SYMREAL_CONSISTS_OF(label, expression, tested, base, sections, place, is_return, base_is_name, section_on_base, seen,
    carries_real, holds_scalar, type, base_kind, layout, left_out, kept)
template <class Take> void visit(Take &take, ClauseFact &object)
  SYMREAL_CONSISTS_OF(clause, place, argument, items)
template <class Take> void visit(Take &take, FunctionFact::Value &object)
  SYMREAL_CONSISTS_OF(name, place)
template <class Take> void visit(Take &take, FunctionFact &object)
  SYMREAL_CONSISTS_OF(name, signature, brace, values, parameters, leads, is_template)
template <class Take> void visit(Take &take, PragmaFact &object)
  SYMREAL_CONSISTS_OF(span, continued_lines, place, display_file, is_function, configured, clauses, function,
    around, leads, loop_targets, tests_late)
template <class Take> void visit(Take &take, UseFact &object)
  SYMREAL_CONSISTS_OF(mangled, name, parameters, declaration, place, source)
template <class Take> void visit(Take &take, Alteration &object)
  SYMREAL_CONSISTS_OF(span, before, after, replaces, inside)
template <class Take> void visit(Take &take, Reason &object)
  SYMREAL_CONSISTS_OF(id, subject, because, place)
template <class Take> void visit(Take &take, Refusal &object)
  SYMREAL_CONSISTS_OF(condition, last_line, reason, token)
template <class Take> void visit(Take &take, DecisionFact &object)
  SYMREAL_CONSISTS_OF(alterations, refusals, misuses, uses, needs)
template <class Take> void visit(Take &take, SpelledType &object)
  SYMREAL_CONSISTS_OF(span, is_float, is_long, kept, where, name, within)
template <class Take> void visit(Take &take, FileFact &object)
  SYMREAL_CONSISTS_OF(display_path, compiled_name, text, spelled, conditions, directives, kept)
template <class Take, class Name> void visit(Take &take, ClassFact::Constituent<Name> &object)
  SYMREAL_CONSISTS_OF(name, holds)
template <class Take> void visit(Take &take, ClassFact &object)
  SYMREAL_CONSISTS_OF(access, bases, fields)
template <class Take> void visit(Take &take, ListFact::Outside &object)
  SYMREAL_CONSISTS_OF(place, function, leaves)
template <class Take> void visit(Take &take, ListFact &object)
  SYMREAL_CONSISTS_OF(reads, prints, handed, outside)
template <class Take> void visit(Take &take, ArithmeticFact &object)
  SYMREAL_CONSISTS_OF(own, instead, continued_lines)
template <class Take> void visit(Take &take, Choice &object)
  SYMREAL_CONSISTS_OF(place, what, results)
template <class Take> void visit(Take &take, ConversionFact &object)
  SYMREAL_CONSISTS_OF(span, type, to_integer)
template <class Take> void visit(Take &take, NamedStatement &object)
  SYMREAL_CONSISTS_OF(begin, end, name)
template <class Take> void visit(Take &take, DecidingText &object)
  SYMREAL_CONSISTS_OF(keyword, begin, end, text, type)
template <class Take> void visit(Take &take, ConfiguredText &object)
  SYMREAL_CONSISTS_OF(text, place)
template <class Take> void visit(Take &take, ConfiguredClause &object)
  SYMREAL_CONSISTS_OF(name, items)
template <class Take> void visit(Take &take, ConfiguredKernel &object)
  SYMREAL_CONSISTS_OF(function, file, clauses)
template <class Take> void visit(Take &take, ConfiguredExternal &object)
  SYMREAL_CONSISTS_OF(function, pure, clauses, derivatives)
template <class Take> void visit(Take &take, Facts &object)
  SYMREAL_CONSISTS_OF(files, types, wraps, shared, members, reached, skipped, conversions,
    comparisons, printed, quoted, pasted, text_calls, pragmas, lists, arithmetic, choices, asking, by_hand, definitions,
    changeable, exported, uses, links, linked_words, names, deciding, decisions, externals, configured_externals, kernel_functions, taken_names,
    include_dirs, read, diagnostics, broken, makes_text)

#undef SYMREAL_CONSISTS_OF
// clang-format on

} // namespace symreal::rewrite
