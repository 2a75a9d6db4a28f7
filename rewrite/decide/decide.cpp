#include "rewrite/decide/decide.h"

#include "rewrite/text/type_name.h"
#ifdef SYMREAL_MUTATION
#include "rewrite/decide/mutation/drop_rule.h"
#endif

#include <algorithm>

namespace symreal::rewrite {
namespace {

// All functions that receive the list of `function`, itself included.
std::set<std::string> reached_from(Facts const &facts, std::string const &function) {
  std::set<std::string> reached;
  std::vector<std::string> pending = {function};
  while (!pending.empty()) {
    std::string const one = std::move(pending.back());
    pending.pop_back();
    if (!reached.insert(one).second) continue;
    if (auto const found = facts.lists.find(one); found != facts.lists.end())
      pending.insert(pending.end(), found->second.handed.begin(), found->second.handed.end());
  }
  return reached;
}

void report_lists(Facts const &facts, Place const &call, std::string const &function, Result &result) {
  bool const reads = reads_numbers(facts, function);
  for (std::string const &name : reached_from(facts, function)) {
    if (name.empty()) continue;
    auto const found = facts.lists.find(name);
    Note const given{call, "'" + function + "' is given a REAL here"};
    if (found == facts.lists.end()) {
      result.diagnostics.push_back(
          {DiagnosticId::boundary_call, call, "a REAL goes to '" + name + "', which the given sources do not define"});
      continue;
    }
    for (auto const &[place, outside] : found->second.outside)
      if (reads || !outside.leaves)
        result.diagnostics.push_back(
            {DiagnosticId::boundary_call,
             outside.place,
             "a list of arguments with a REAL in it goes to '" + outside.function + "', which is outside the roots",
             {given}});
  }
}

bool may_print(Facts const &facts, std::string const &function) {
  std::set<std::string> const reached = reached_from(facts, function);
  return std::any_of(facts.lists.begin(), facts.lists.end(), [&](auto const &one) {
    return one.second.prints && (reached.contains(one.first) || reached.contains(""));
  });
}

// Follows the argument lists from the functions that receive them to those that read them: these take REALs, all
// others carried values. A list that leaves the sources with a REAL in it is a diagnostic.
void follow_argument_lists(Facts &facts, Result &result) {
  for (auto &[name, list] : facts.lists)
    for (std::string const &reached : reached_from(facts, name))
      list.reads = list.reads || reads_numbers(facts, reached);
  std::set<std::string> given;
  for (Wrap const &wrap : facts.wraps)
    if (wrap.use == Use::value)
      if (std::string const &function = wrap.payload(Payload::function);
          facts.lists.contains(function) && given.insert(function).second)
        report_lists(facts, place_in(facts.files.at(wrap.span.file), wrap.span.begin), function, result);
  // A function of the library that prints such a list prints carried values, when the program runs.
  for (std::string const &name : given)
    if (reads_numbers(facts, name)) facts.makes_text |= may_print(facts, name);
}

// Whether the user vouches for a line that is kept: its bytes do not belong to a number, or a variable that leaves the
// program is kept as well.
bool is_answered_for(Diagnostic const &diagnostic, Facts const &facts) {
  if (diagnostic.id != DiagnosticId::reinterpretation && diagnostic.id != DiagnosticId::boundary_call) return false;
  for (auto const &[path, file] : facts.files)
    if (file.display_path == diagnostic.place.file)
      for (auto const &[begin, end] : file.kept)
        if (place_in(file, begin).line == diagnostic.place.line) return true;
  return false;
}

void add_boundaries(Facts const &facts, Result &result) {
  for (auto const &[mangled, pragma] : facts.externals) {
    result.externals.push_back(mangled);
    if (facts.definitions.count(mangled) != 0)
      result.diagnostics.push_back({DiagnosticId::external_function, pragma.place,
                                    "'" + pragma.message + "' is defined in the sources, so its calls are recorded"});
  }
  for (auto const &[mangled, use] : facts.uses) {
    if (facts.definitions.count(mangled) != 0) continue;
    result.boundaries.push_back({use.name, mangled, use.parameters, use.declaration, use.place});
    result.diagnostics.push_back({DiagnosticId::boundary_function,
                                  use.declaration,
                                  "'" + use.name + "' uses double but is not defined in the given sources",
                                  {{use.place, "it is used here"}}});
    if (to_string(use.source) != to_string(use.place))
      result.diagnostics.back().notes.push_back({use.source, "which is reached from here"});
  }
}

void add_dependence(Facts const &facts, Result &result) {
  for (auto const &[span, type, to_integer] : facts.conversions)
    result.conversions.push_back({place_in(facts.files.at(span.file), span.begin), type, to_integer});
  result.comparisons = facts.comparisons.size();
}

// Renamed names of symbolic mode, by file: inserted text may contain them as well.
std::map<std::string, RenamedNames> renamed_names(Facts const &facts) {
  std::map<std::string, RenamedNames> names;
  for (Wrap const &wrap : facts.wraps)
    if (wrap.use == Use::name)
      names[wrap.span.file].all.insert(wrap.payload(Payload::name));
    else if (wrap.use == Use::own_name && is_defined(facts, wrap))
      names[wrap.span.file].at_file_scope.insert(wrap.payload(Payload::name));
  return names;
}

// Whether a pragma has an error, so that its text is unknown. Other errors leave the texts of other places valid.
bool has_pragma_error(Result const &result) {
  return std::any_of(result.diagnostics.begin(), result.diagnostics.end(), [](Diagnostic const &one) {
    bool const is_of_pragma = one.id >= DiagnosticId::pragma_syntax && one.id <= DiagnosticId::pragma_outside_roots;
    return one.severity == Severity::error &&
           (is_of_pragma || one.id == DiagnosticId::external_function || one.id == DiagnosticId::pragma_loop ||
            one.id == DiagnosticId::configuration);
  });
}

} // namespace

bool reads_numbers(Facts const &facts, std::string const &function) {
  auto const found = facts.lists.find(function);
  return found != facts.lists.end() && found->second.reads;
}

Result decide(Facts facts, Request const &request) {
#ifdef SYMREAL_MUTATION
  drop_rule(facts);
#endif
  Result result;
  result.include_dirs = std::move(facts.include_dirs);
  result.diagnostics = std::move(facts.diagnostics);
  std::erase_if(result.diagnostics, [&](Diagnostic const &one) { return is_answered_for(one, facts); });
  result.read.assign(facts.read.begin(), facts.read.end());
  result.definitions.assign(facts.exported.begin(), facts.exported.end());
  result.changeable.assign(facts.changeable.begin(), facts.changeable.end());
  for (auto &[place, statement] : facts.names) result.names.push_back(std::move(statement));
  for (auto &[key, text] : facts.deciding) result.deciding.push_back(std::move(text));
  if (facts.broken) return result;
  if (request.annotations_only) return annotated(facts, std::move(result));
  result.type_name = choose_type_name(request, facts, result.diagnostics);
  follow_argument_lists(facts, result);
  if (!facts.makes_text)
    std::erase_if(facts.wraps, [](Wrap const &wrap) {
      return wrap.use == Use::formatting || wrap.use == Use::shown || wrap.use == Use::text;
    });
  Ledger const ledger(facts);
  Rewordings rewordings = reword(facts, ledger, result);
  collect_kernels(facts, result);
  if (!has_pragma_error(result)) add_pragmas(facts, rewordings);
  add_boundaries(facts, result);
  add_dependence(facts, result);
  auto renamed = renamed_names(facts);
  for (auto const &[path, file] : facts.files) {
    for (Rewording &one : rewordings[path])
      for (std::string *inserted : {&one.before, &one.after}) {
        // A rewording of the name itself holds it between the two.
        if (renamed.contains(path)) *inserted = with_renamed(*inserted, renamed[path]);
        *inserted = with_type_name(*inserted, result.type_name);
      }
    std::vector<Edit> edits = compose(file.text, std::move(rewordings[path]));
    std::string text = apply_edits(file.text, edits);
    std::vector<Spelling> entries = ledger.entries(path, edits);
    result.files.push_back({path, file.display_path, file.text, std::move(text), std::move(edits), std::move(entries),
                            file.compiled_name, original_edits(facts, path)});
  }
  return result;
}

} // namespace symreal::rewrite
