#include "rewrite/decide/decide.h"

#include "rewrite/text/source_text.h"

#include <set>

namespace symreal::rewrite {
namespace {

void report(Result &result, DiagnosticId id, Place const &place, std::string message) {
  result.diagnostics.push_back({id, place, std::move(message)});
}

void check_item(ClauseFact const &clause, ItemFact const &item, Result &result) {
  auto const wrong = [&](std::string const &message) {
    report(result, DiagnosticId::pragma_item, item.place, "'" + item.label + "' " + message);
  };
  if (item.is_return && clause.clause != Clause::output) return wrong("can only be an output");
  if (item.is_return) return;
  if (item.type.empty()) return; // no function follows the pragma, which is reported
  bool const is_pointer = item.base_kind == Base::pointer || item.base_kind == Base::pointer_to_const ||
                          item.base_kind == Base::const_pointer_to_const;
  if (clause.clause == Clause::scratch) return; // whatever is left there, and wherever a pointer points to
  if (item.base_is_name && is_pointer && item.sections.empty()) {
    if (clause.clause == Clause::constant) return; // the pointer itself
    return wrong("is a pointer and needs an extent: '*" + item.label + "' for one object, or '" + item.label +
                 "[0:n]'");
  }
  if (clause.clause == Clause::constant && !item.carries_real && !item.holds_scalar)
    return wrong("holds nothing that could be constant: it is " + item.type);
  if (clause.clause != Clause::constant && !item.carries_real) return wrong("holds no double: it is " + item.type);
  if (!info(clause.clause).has(trait::GIVEN)) return;
  if (item.base_kind == Base::const_object) return wrong("is const: the compiler may have used its value already");
}

// Whether an item of its own names this member.
bool is_named(PragmaFact const &pragma, std::string const &member) {
  for (ClauseFact const &clause : pragma.clauses)
    for (ItemFact const &item : clause.items) {
      std::string const text = item.base + " ";
      for (std::string const before : {".", "->"})
        for (std::string const after : {" ", "[", ".", "-", ")"})
          if (text.find(before + member + after) != text.npos) return true;
    }
  return false;
}

void warn_of_members(PragmaFact const &pragma, ItemFact const &item, Result &result) {
  std::string pointers, others;
  for (std::string const &member : item.left_out)
    if (!is_named(pragma, member)) pointers += (pointers.empty() ? "'" : ", '") + member + "'";
  for (std::string const &member : item.kept) others += (others.empty() ? "'" : ", '") + member + "'";
  auto const warn = [&](std::string const &message) {
    result.diagnostics.push_back({DiagnosticId::members_left_out, item.place, "'" + item.label + "' " + message});
  };
  if (!pointers.empty()) warn("does not include what its members " + pointers + " point to");
  if (!others.empty()) warn("has members that are not double and stay as they are: " + others);
}

void check_table(ItemFact const &item, Result &result) {
  bool const is_pointer = item.base_kind == Base::pointer || item.base_kind == Base::pointer_to_const ||
                          item.base_kind == Base::const_pointer_to_const;
  bool const has_extent = item.sections.size() == 1 && item.sections[0].low == "0" && item.section_on_base;
  if (!is_pointer || !has_extent)
    report(result, DiagnosticId::pragma_item, item.place, "table() needs a pointer and an extent, as in table(t[0:n])");
  else if (!item.carries_real)
    report(result, DiagnosticId::pragma_item, item.place, "'" + item.label + "' holds no double: it is " + item.type);
}

void check_returned_place(PragmaFact const &pragma, ClauseFact const &clause, Result &result) {
  for (ItemFact const &item : clause.items)
    if (item.is_return && !pragma.is_function)
      report(result, DiagnosticId::pragma_item, item.place, "'return' belongs in a function pragma");
}

// decisions(...), loop(N) and exact.
bool is_setting(ClauseFact const &clause) { return info(clause.clause).has(trait::SETTING); }

void check_setting(PragmaFact const &pragma, ClauseFact const &clause, Result &result) {
  std::string const &argument = clause.argument;
  static std::set<std::string> const policies = {"error", "guard", "select", "carry"};
  if (clause.clause == Clause::decisions && policies.count(argument) == 0)
    report(result, DiagnosticId::pragma_syntax, clause.place,
           "decisions takes error, guard, select or carry, not '" + argument + "'");
  bool const is_number = argument.find_first_not_of("0123456789") == std::string::npos && argument.size() < 8 &&
                         argument.find_first_not_of('0') != std::string::npos;
  if (clause.clause == Clause::loop && !is_number)
    report(result, DiagnosticId::pragma_syntax, clause.place,
           "loop(N) takes the largest number of runs, not '" + argument + "'");
  if (!pragma.is_function && pragma.is_kernel())
    report(result, DiagnosticId::pragma_syntax, clause.place,
           "'" + name_of(clause.clause) + "' applies to the next statement and needs a pragma of its own");
}

void check(PragmaFact const &pragma, Result &result) {
  bool after_input = false, has_begun = pragma.is_function;
  std::set<std::string> outputs;
  for (ClauseFact const &clause : pragma.clauses) {
    if (is_setting(clause)) {
      check_setting(pragma, clause, result);
      continue;
    }
    check_returned_place(pragma, clause, result);
    for (ItemFact const &item : clause.items) {
      if (!pragma.is_function && !item.seen) {
        report(result, DiagnosticId::pragma_position, pragma.place, "this pragma stands where no statement can stand");
        return;
      }
      if (info(clause.clause).has(trait::OBJECTS)) check_item(clause, item, result);
      if (clause.clause == Clause::output && !outputs.insert(item.label).second)
        report(result, DiagnosticId::pragma_item, item.place, "'" + item.label + "' is an output already");
      warn_of_members(pragma, item, result);
      if (clause.clause == Clause::table) check_table(item, result);
    }
    if (clause.clause == Clause::range && (clause.items.size() != 2 || !after_input))
      report(result, DiagnosticId::pragma_syntax, clause.place,
             "range(low, high) stands after input(...) and has two numbers");
    else if (clause.clause == Clause::range)
      if (std::string const wrong = wrong_range(clause.items[0].label, clause.items[1].label); !wrong.empty())
        report(result, DiagnosticId::bad_range, clause.items[0].place, wrong);
    if (clause.clause == Clause::state && (clause.items.size() != 2 || !has_begun))
      report(result, DiagnosticId::pragma_syntax, clause.place,
             "state(x, dx) stands after input(...) or output(...), and names an input and the output that is its "
             "derivative by time");
    if (clause.clause == Clause::implicit && clause.items.size() != 2)
      report(result, DiagnosticId::pragma_syntax, clause.place,
             "implicit(x, r) names the numbers that were found, and the residual that is 0 there");
    if (info(clause.clause).has(trait::WORDS) && !has_begun)
      report(result, DiagnosticId::pragma_syntax, clause.place,
             "'" + name_of(clause.clause) + "' stands after input(...) or output(...)");
    if (clause.clause == Clause::generate && (clause.items.size() != 1 || clause.argument.front() != '"'))
      report(result, DiagnosticId::pragma_syntax, clause.place,
             "generate takes the name of a file, as in generate(\"step.c\")");
    if (clause.clause == Clause::call && clause.argument.find_first_not_of("0123456789") != std::string::npos)
      report(result, DiagnosticId::pragma_syntax, clause.place, "call(k) takes the number of a call, counted from 1");
    after_input = after_input || clause.clause == Clause::input;
    has_begun = has_begun || info(clause.clause).has(trait::OBJECTS);
  }
}

std::vector<Annotation> annotations(PragmaFact const &pragma) {
  std::vector<Annotation> result;
  for (ClauseFact const &clause : pragma.clauses)
    if (info(clause.clause).has(trait::OBJECTS))
      for (ItemFact const &item : clause.items)
        result.push_back({name_of(clause.clause), item.label, item.place, item.base, item.sections, item.layout});
  return result;
}

bool has_output(std::vector<Annotation> const &annotations) {
  for (Annotation const &one : annotations)
    if (one.kind == info(Clause::output).name) return true;
  return false;
}

// "out/step.c" names the kernel step.
std::string stem(std::string const &file) {
  std::size_t const slash = file.rfind('/');
  std::string const name = slash == std::string::npos ? file : file.substr(slash + 1);
  return name.substr(0, name.rfind('.'));
}

// The annotations of one file that no `generate` has closed yet.
struct Open {
  std::vector<Annotation> annotations;
  Place place;
};

void region(PragmaFact const &pragma, Open &open, Result &result) {
  if (open.annotations.empty()) open.place = pragma.place;
  for (Annotation &one : annotations(pragma)) open.annotations.push_back(std::move(one));
  for (ClauseFact const &clause : pragma.clauses) {
    if (clause.clause != Clause::generate || clause.argument.size() < 2) continue;
    if (!open.annotations.empty() && !has_output(open.annotations))
      report(result, DiagnosticId::kernel_incomplete, clause.place, "no output(...) stands before this generate");
    std::string const file = clause.argument.substr(1, clause.argument.size() - 2);
    result.kernels.push_back({.name = stem(file),
                              .is_function = false,
                              .place = clause.place,
                              .output_file = file,
                              .signature = {},
                              .annotations = std::move(open.annotations),
                              .source = pragma.display_file});
    open = {};
  }
}

} // namespace

void collect_kernels(Facts const &facts, Result &result) {
  std::map<std::string, Open> regions;
  for (auto const &[span, pragma] : facts.pragmas) {
    if (pragma.clauses.empty()) continue; // malformed, and reported
    check(pragma, result);
    if (!pragma.is_function) {
      region(pragma, regions[span.file], result);
      continue;
    }
    if (pragma.function.empty() || !pragma.is_kernel()) continue; // not attached, and reported; or no kernel
    if (!has_output(annotations(pragma)))
      report(result, DiagnosticId::kernel_incomplete, pragma.place, "this pragma has no output(...)");
    result.kernels.push_back({.name = pragma.function[0].name,
                              .is_function = true,
                              .place = pragma.place,
                              .output_file = {},
                              .signature = pragma.function[0].signature,
                              .annotations = annotations(pragma),
                              .source = pragma.display_file});
  }
  for (Kernel kernel : facts.by_hand) {
    kernel.name = stem(kernel.output_file);
    result.kernels.push_back(std::move(kernel));
  }
  bool any_region = false;
  for (Kernel const &kernel : result.kernels) any_region = any_region || !kernel.is_function;
  for (auto const &[file, open] : regions)
    if (!open.annotations.empty() && !any_region)
      report(result, DiagnosticId::kernel_incomplete, open.place, "no generate(\"...\") follows these annotations");
}

} // namespace symreal::rewrite
