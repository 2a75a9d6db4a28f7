// The program that verification runs as the original: annotations in its own language, and nothing else
// (<symreal/original.h>).
#include "rewrite/decide/decide.h"
#include "rewrite/text/pragma_text.h"

#include <fmt/format.h>

namespace symreal::rewrite {
namespace {

// A loop over each dimension of its sections, outermost first.
std::string loops(std::vector<Section> const &sections) {
  std::string extents, text;
  for (Section const &section : sections)
    extents += fmt::format("{}(__SIZE_TYPE__)({})", extents.empty() ? "" : ", ", section.length);
  if (!sections.empty())
    text = fmt::format("__SIZE_TYPE__ const symreal_n[{0}] = {{{1}}}; __SIZE_TYPE__ symreal_i[{0}]; ", sections.size(),
                       extents);
  for (std::size_t k = 0; k < sections.size(); ++k)
    text += fmt::format("for (symreal_i[{0}] = 0; symreal_i[{0}] < symreal_n[{0}]; ++symreal_i[{0}]) ", k);
  return text;
}

std::string annotation(Clause clause, ItemFact const &item, bool is_template) {
  bool const has_layout = !item.layout.text.empty();
  std::string const object = is_template && is_counted(clause, item)
                                 ? "::symreal_original::symreal_instance(" + evaluated(item) + ")"
                                 : evaluated(item);
  return fmt::format("if (symreal_original_object(\"{}\", {}, SYMREAL_ORIGINAL_FRAME)) {{ {}SYMREAL_ORIGINAL_{}({}{}); "
                     "symreal_original_object_end(); }} ",
                     name_of(clause), place_arguments(item.label, item.place), loops(item.sections),
                     means_file(clause, item)        ? "STATICS"
                     : has_layout                    ? "LAYOUT"
                     : info(clause).has(trait::KEPT) ? "BYTES"
                                                     : "NUMBERS",
                     has_layout ? layout_arguments(item.layout) + ", " : "", object);
}

// The macro for an argument that the caller may choose as it likes; empty for others.
std::string choice(Baked const &baked) {
  bool const is_name = baked.expression.find_first_of(" *.-[(") == baked.expression.npos;
  if (baked.shape == "s") return is_name ? "SYMREAL_ORIGINAL_TEXT" : "";
  return is_name && (baked.shape == "@" || baked.shape.starts_with("?it is a ")) ? "SYMREAL_ORIGINAL_CHOSEN" : "";
}

std::string clause_text(ClauseFact const &clause, bool is_template = false) {
  if (clause.clause == Clause::generate)
    return fmt::format("symreal_original_generate({}, {}, {}, {}); ", clause.argument, in_quotes(clause.place.file),
                       clause.place.line, clause.place.column);
  if (clause.clause == Clause::range) return fmt::format("symreal_original_range({}); ", clause.argument);
  if (clause.clause == Clause::state)
    return fmt::format("symreal_original_state({}, {}, {}, {}, {}); ", in_quotes(clause.items.front().label),
                       in_quotes(clause.items.back().label), in_quotes(clause.place.file), clause.place.line,
                       clause.place.column);
  if (info(clause.clause).has(trait::WORDS))
    return fmt::format("symreal_original_differentiate({}); ",
                       place_arguments(name_of(clause.clause) + "(" + clause.argument + ")", clause.place));
  std::string text;
  if (info(clause.clause).has(trait::OBJECTS)) // tables and fates of decisions concern the symbolic program only
    for (ItemFact const &item : clause.items)
      if (!item.is_return) text += annotation(clause.clause, item, is_template);
  return text;
}

// The annotations of a region pragma, on one line.
std::string original_region_text(PragmaFact const &pragma) {
  std::string text;
  for (ClauseFact const &clause : pragma.clauses) text += clause_text(clause);
  return text;
}

// Text to insert after the opening brace of a function with a pragma.
std::string original_function_text(PragmaFact const &pragma) {
  if (!pragma.is_kernel()) return "";
  std::string entry, exit;
  for (ClauseFact const &clause : pragma.clauses)
    (info(clause.clause).has(trait::RESULTS) ? exit : entry) += clause_text(clause, pragma.function[0].is_template);
  std::string own;
  for (FunctionFact::Value const &one : pragma.function[0].parameters)
    own += fmt::format("SYMREAL_ORIGINAL_OWN({}) ", one.name);
  for (Baked const &one : pragma.function[0].signature.redefinition.baked)
    if (std::string const macro = choice(one); !macro.empty()) own += fmt::format("{}({}) ", macro, one.expression);
  std::string const place = place_arguments(pragma.function[0].name, pragma.place);
  return fmt::format("SYMREAL_ORIGINAL_FUNCTION({0}, {1}) {2}{3}SYMREAL_ORIGINAL_OUTPUTS({4}) "
                     "SYMREAL_ORIGINAL_WRAPPER({0})",
                     place, call_text(pragma, "::symreal_original"), own, entry, exit);
}

// Whether the diagnostic concerns rewriting only: the original compiles as it is.
bool is_about_rewriting(Diagnostic const &diagnostic) {
  switch (diagnostic.id) {
  case DiagnosticId::boundary_function:
  case DiagnosticId::boundary_call:
  case DiagnosticId::unconvertible_type:
  case DiagnosticId::double_from_macro:
  case DiagnosticId::implicit_narrowing:
  case DiagnosticId::reinterpretation:
  case DiagnosticId::class_layout:
  case DiagnosticId::evaluation_order:
  case DiagnosticId::instantiations_differ:
  case DiagnosticId::long_double:
  case DiagnosticId::c_source:
  case DiagnosticId::reserved_name:
  case DiagnosticId::quoted_double:
  case DiagnosticId::split_expression:
  case DiagnosticId::unaccounted_double:
  case DiagnosticId::scalar_not_looked_at:
  case DiagnosticId::state_not_looked_for: return true;
  default: return false;
  }
}

// Clauses that change how the text is rewritten.
void refuse_clauses_of_text(Facts const &facts, Result &result) {
  for (auto const &[span, pragma] : facts.pragmas)
    for (ClauseFact const &clause : pragma.clauses)
      if (clause.clause == Clause::table || clause.clause == Clause::implicit ||
          info(clause.clause).has(trait::SETTING))
        result.diagnostics.push_back(
            {DiagnosticId::clause_of_text, clause.place,
             "'" + name_of(clause.clause) + "' is about rewritten text, and --record=instructions rewrites nothing"});
  for (auto const &[mangled, pragma] : facts.externals)
    result.diagnostics.push_back({DiagnosticId::clause_of_text, pragma.place,
                                  "'external' is about rewritten text, and --record=instructions rewrites nothing"});
}

} // namespace

std::vector<Edit> original_edits(Facts const &facts, std::string const &path) {
  std::vector<Rewording> rewordings;
  for (auto const &[span, pragma] : facts.pragmas) {
    if (span.file != path) continue;
    std::string const lines(pragma.continued_lines, '\n');
    if (!pragma.configured)
      rewordings.push_back(
          {span.begin, span.end, (pragma.is_function ? "" : original_region_text(pragma)) + lines, "", true});
    if (pragma.is_function && !pragma.function.empty()) {
      Span const &entry = pragma.function[0].brace;
      std::string const own = original_function_text(pragma);
      if (is_brace(entry))
        rewordings.push_back({entry.begin, entry.end, "", " " + own});
      else if (!own.empty())
        rewordings.push_back({entry.begin, entry.end, "{ " + own + " ", " }"});
    }
  }
  for (auto const &[span, fact] : facts.arithmetic)
    if (span.file == path)
      rewordings.push_back({span.begin, span.end,
                            "SYMREAL_ORIGINAL_EITHER((" + fact.own + "), " + fact.instead + ")" +
                                std::string(fact.continued_lines, '\n'),
                            "", true});
  if (rewordings.empty()) return {};
  for (Wrap const &wrap : facts.wraps)
    if (wrap.span.file == path && wrap.use == Use::returned)
      rewordings.push_back(
          {wrap.span.begin, wrap.span.end, "SYMREAL_RETURN" + wrap.payload(Payload::arguments) + ", ", ")"});
  return compose(facts.files.at(path).text, std::move(rewordings));
}

Result annotated(Facts const &facts, Result result) {
  std::erase_if(result.diagnostics, is_about_rewriting);
  collect_kernels(facts, result);
  refuse_clauses_of_text(facts, result);
  for (auto const &[path, file] : facts.files) {
    std::vector<Edit> const edits = original_edits(facts, path);
    result.files.push_back(
        {path, file.display_path, file.text, apply_edits(file.text, edits), edits, {}, file.compiled_name, edits});
  }
  return result;
}

Result annotated_original(Result const &result) {
  Result original;
  original.include_dirs = result.include_dirs;
  original.kernels = result.kernels;
  for (File const &file : result.files) {
    File &annotated = original.files.emplace_back(file);
    annotated.edits = file.annotations;
    annotated.text = apply_edits(file.original, file.annotations);
  }
  return original;
}

} // namespace symreal::rewrite
