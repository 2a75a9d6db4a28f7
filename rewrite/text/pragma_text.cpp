#include "rewrite/text/pragma_text.h"

#include "rewrite/text/source_text.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

namespace symreal::rewrite {
namespace {

// The extents of the item's sections as an argument, if it has any.
std::string extents_argument(ItemFact const &item) {
  std::string extents;
  for (Section const &section : item.sections) extents += (extents.empty() ? "" : ", ") + section.length;
  return extents.empty() ? "" : "::symreal::symreal_extents(" + with_real(extents) + "), ";
}

// A value under its name, with its place.
std::string value_text(char const *macro, FunctionFact::Value const &value) {
  return macro + ("(" + in_quotes(value.name)) + ", " + in_quotes(to_string(value.place)) + ", " + value.name + ") ";
}

std::string leads_text(std::vector<std::string> const &leads) {
  std::string text;
  for (std::string const &object : leads) text += "SYMREAL_LEADS(" + object + ") ";
  return text;
}

std::string annotation(Clause clause, ItemFact const &item, bool is_template) {
  if (means_file(clause, item)) return "SYMREAL_FILE(" + place_arguments(item.label, item.place) + ")";
  std::string macro = info(clause).has(trait::KEPT) ? "SYMREAL_DECLARE" : "SYMREAL_OBJECT";
  std::string layout;
  if (!item.layout.text.empty()) {
    macro = "SYMREAL_LAYOUT";
    layout = layout_arguments(item.layout) + ", ";
  }
  if (!item.sections.empty()) macro = macro == "SYMREAL_OBJECT" ? "SYMREAL_SECTION" : macro + "_SECTION";
  return macro + "(" + name_of(clause) + ", " + place_arguments(item.label, item.place) + ", " +
         extents_argument(item) + layout +
         with_real(is_template && is_counted(clause, item) ? "::symreal::symreal_instance(" + evaluated(item) + ")"
                                                           : evaluated(item)) +
         ")";
}

// A private copy of a pointer-to-const's target replaces it before the kernel writes nodes there.
std::string rebinding(ClauseFact const &clause, ItemFact const &item) {
  if (!info(clause.clause).has(trait::GIVEN) || item.base_kind != Base::pointer_to_const) return "";
  if (is_pointee(item)) return "SYMREAL_REBIND(" + item.label.substr(1) + ", 0, 1) ";
  if (!item.section_on_base) return "";
  return "SYMREAL_REBIND(" + item.expression.substr(0, item.expression.find('[')) + ", " +
         with_real(item.sections[0].low) + ", " + with_real(item.sections[0].length) + ") ";
}

// A parameter that ends a range which one of these pointers begins moves along.
std::string rebound_ends(FunctionFact const &function, std::string const &entry) {
  std::set<std::string> ends;
  for (Baked const &baked : function.signature.redefinition.baked)
    if (std::size_t const at = baked.label.find(" - ");
        at != baked.label.npos && entry.find("SYMREAL_REBIND(" + baked.label.substr(at + 3) + ",") != entry.npos)
      ends.insert(baked.label.substr(0, at));
  std::string text;
  for (std::string const &end : ends) text += "SYMREAL_REBIND_END(" + end + ") ";
  return text;
}

std::string implicit_text(ItemFact const &item) {
  return (item.sections.empty() ? "SYMREAL_IMPLICIT(" : "SYMREAL_IMPLICIT_SECTION(") +
         place_arguments(item.label, item.place) + ", " + extents_argument(item) + with_real(evaluated(item)) + ") ";
}

std::string clause_text(PragmaFact const &pragma, ClauseFact const &clause) {
  if (clause.clause == Clause::generate)
    return "SYMREAL_GENERATE(" + clause.argument + ", " + place_words(clause.place) + ") ";
  if (clause.clause == Clause::decisions)
    return (pragma.is_function ? "SYMREAL_DECISIONS(" : "SYMREAL_REAL_DECISIONS(") + clause.argument + ") ";
  if (clause.clause == Clause::exact) return pragma.is_function ? "SYMREAL_EXACT " : "SYMREAL_REAL_EXACT ";
  if (clause.clause == Clause::loop) // the loop it names has its own text; a refused one is an error
    return (pragma.tests_late ? "SYMREAL_REAL_LATE_LOOP(" : "SYMREAL_REAL_LOOP(") + clause.argument + ", " +
           pragma.loop_targets.value_or("") + ") ";
  if (clause.clause == Clause::range) return "SYMREAL_RANGE(" + with_real(clause.argument) + ") ";
  if (clause.clause == Clause::state) // two items, or it is an error
    return "SYMREAL_STATE(" + place_arguments(clause.items.front().label, clause.place) + ", " +
           in_quotes(clause.items.back().label) + ") ";
  if (info(clause.clause).has(trait::WORDS))
    return "SYMREAL_DIFFERENTIATE(" +
           place_arguments(name_of(clause.clause) + "(" + clause.argument + ")", clause.place) + ") ";
  std::string text;
  if (clause.clause == Clause::table) {
    for (ItemFact const &item : clause.items)
      text += "SYMREAL_TABLE(" + with_real(item.base) + ", " + with_real(item.sections[0].length) + ") ";
    return text;
  }
  if (clause.clause == Clause::implicit) { // two items, or it is an error
    for (ItemFact const &item : clause.items) text += implicit_text(item);
    return text;
  }
  for (ItemFact const &item : clause.items)
    if (!item.is_return)
      text += rebinding(clause, item) +
              annotation(clause.clause, item, !pragma.function.empty() && pragma.function[0].is_template) + " ";
  return text;
}

bool is_annotated(PragmaFact const &pragma, std::string const &name) {
  for (ClauseFact const &clause : pragma.clauses)
    for (ItemFact const &item : clause.items)
      if (clause.clause != Clause::output && item.label == name) return true;
  return false;
}

} // namespace

std::string place_arguments(std::string const &label, Place const &place) {
  return in_quotes(label) + ", " + place_words(place);
}

std::string place_words(Place const &place) {
  return in_quotes(place.file) + ", " + std::to_string(place.line) + ", " + std::to_string(place.column);
}

std::string const &evaluated(ItemFact const &item) { return item.tested.empty() ? item.expression : item.tested; }

bool is_pointee(ItemFact const &item) {
  return item.label.size() > 1 && item.label[0] == '*' && !std::isdigit(static_cast<unsigned char>(item.label[1])) &&
         std::all_of(item.label.begin() + 1, item.label.end(), is_word);
}

bool means_file(Clause clause, ItemFact const &item) { return clause == Clause::scratch && item.label == "file"; }

bool is_counted(Clause clause, ItemFact const &item) {
  return (info(clause).has(trait::GIVEN) || info(clause).has(trait::RESULTS)) && !item.is_return &&
         item.layout.text.empty();
}

std::string call_text(PragmaFact const &pragma, std::string const &space) {
  std::string call = "1", types;
  for (ClauseFact const &clause : pragma.clauses)
    if (clause.clause == Clause::call)
      call = clause.argument;
    else
      for (ItemFact const &item : clause.items)
        if (is_counted(clause.clause, item)) types += (types.empty() ? "decltype(" : ", decltype(") + item.base + ")";
  if (!pragma.function[0].is_template || types.empty()) return call;
  return "(" + space + "::symreal_call_of<" + types + ">(" + call + "))";
}

std::string layout_arguments(ObjectLayout const &layout) {
  std::string types;
  for (std::string const &type : layout.containers) types += (types.empty() ? "" : ", ") + with_real(type);
  return in_quotes(layout.text) + ", (" + types + ")";
}

std::string region_text(PragmaFact const &pragma) {
  std::string text, around;
  for (FunctionFact::Value const &value : pragma.around) around += value_text("SYMREAL_AROUND", value);
  around += leads_text(pragma.leads);
  for (ClauseFact const &clause : pragma.clauses) {
    text += clause_text(pragma, clause);
    if (!clause.items.empty()) text += std::exchange(around, ""); // the kernel has begun
  }
  return trimmed(text);
}

bool is_brace(Span const &entry) { return entry.end == entry.begin + 1; }

std::string function_text(PragmaFact const &pragma) {
  std::string entry, exit;
  for (ClauseFact const &clause : pragma.clauses)
    if (clause.clause != Clause::call)
      (info(clause.clause).has(trait::RESULTS) ? exit : entry) += clause_text(pragma, clause);
  if (!pragma.is_kernel()) return trimmed(entry);
  std::string const call = call_text(pragma, "::symreal");
  std::string text = "SYMREAL_FUNCTION(" + place_arguments(pragma.function[0].name, pragma.place) +
                     (call == "1" ? "" : ", " + with_real(call)) + ") " + entry +
                     rebound_ends(pragma.function[0], entry);
  for (FunctionFact::Value const &value : pragma.function[0].parameters) text += value_text("SYMREAL_PARAMETER", value);
  for (FunctionFact::Value const &value : pragma.function[0].values)
    if (!is_annotated(pragma, value.name)) text += value_text("SYMREAL_ARGUMENT", value);
  text += leads_text(pragma.function[0].leads);
  // Needed even if `return` is the only output: it ends the annotations of the function's entry.
  return text + "SYMREAL_OUTPUTS_BEGIN " + exit + "SYMREAL_OUTPUTS_END";
}

} // namespace symreal::rewrite
