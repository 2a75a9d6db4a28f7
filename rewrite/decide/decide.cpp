#include "rewrite/decide/decide.h"

#include "rewrite/decide/argument_lists.h"
#include "rewrite/decide/original_text.h"
#include "rewrite/decide/text_calls.h"
#include "rewrite/decide/use_text.h"
#include "rewrite/edit/compose.h"
#include "rewrite/facts/own_names.h"
#include "rewrite/text/pragma_text.h"
#include "rewrite/text/source_text.h"
#include "rewrite/text/type_name.h"
#ifdef SYMREAL_MUTATION
#include "rewrite/decide/mutation/drop_rule.h"
#endif

#include <algorithm>

namespace symreal::rewrite {
namespace {

using ByFile = std::map<std::string, std::vector<Rewording>>;

// A library's typedef keeps its name where the program prints it.
std::string replacement_of(TypeToken const &token, Facts const &facts) {
  if (token.replacement == reserved_type_name || !meets(facts.printed, token.span)) return token.replacement;
  return "SYMREAL_REAL_TYPE(" + text_of(token.span, facts) + ", " + token.replacement + ")";
}

void add_types(Facts const &facts, std::set<Span> const &pragmas, Ledger const &ledger, ByFile &rewordings,
               Result &result) {
  for (TypeToken const &token : facts.types) {
    if (meets(pragmas, token.span) || ledger.is_kept(token.span)) continue;
    if (!meets(facts.quoted, token.span)) {
      if (!token.replacement.empty())
        rewordings[token.span.file].push_back(
            {token.span.begin, token.span.end, replacement_of(token, facts), "", true});
      continue;
    }
    FileFact const &file = facts.files.at(token.span.file);
    std::string const text = text_of(token.span, facts);
    result.diagnostics.push_back({DiagnosticId::quoted_double, place_in(file, token.span.begin),
                                  "'" + text + "' stays as it is: a macro turns this argument into text"});
  }
}

// A few places have no type in the syntax tree, such as the explicit instantiation of a function or an attribute. There
// `double` follows its neighbours; if that is wrong the symbolic program does not compile.
void add_unaccounted(Facts const &facts, std::set<Span> const &pragmas, Ledger const &ledger, ByFile &rewordings,
                     Result &result) {
  for (Span const &span : facts.doubles) {
    auto const known = facts.types.lower_bound({span, ""});
    bool const accounted = known != facts.types.end() && known->span == span;
    if (accounted || meets(pragmas, span) || meets(facts.quoted, span) || ledger.stays_in_text(span)) continue;
    rewordings[span.file].push_back({span.begin, span.end, reserved_type_name, "", true});
    result.diagnostics.push_back({DiagnosticId::unaccounted_double, place_in(facts.files.at(span.file), span.begin),
                                  "the syntax tree does not say what this double is part of; it becomes REAL"});
  }
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
  std::string_view const whole = text;
  std::string const words = "REAL_ONLY(" + wrap.detail + ")";
  if (wrap.use == Use::before) return whole.substr(0, wrap.span.begin).ends_with(words + " ");
  std::string_view const behind = whole.substr(wrap.span.end);
  return wrap.use == Use::behind && (behind.starts_with(" " + words) || behind.starts_with(" SYMREAL_" + words));
}

void add_wraps(Facts const &facts, std::set<Span> const &pragmas, ByFile &rewordings, Result &result) {
  Wrap const *before = nullptr;
  for (Wrap const &wrap : facts.wraps) {
    // A repeated wrap of the same characters: its words may differ, as two sources may name a file differently.
    bool const again = before && before->span == wrap.span && before->use == wrap.use;
    if (again && wrap.use == Use::argument)
      result.diagnostics.push_back({DiagnosticId::instantiations_differ,
                                    place_in(facts.files.at(wrap.span.file), wrap.span.begin),
                                    "'" + text_of(wrap.span, facts) + "' is converted to " + before->detail +
                                        " in one instantiation and to " + wrap.detail + " in another"});
    before = &wrap;
    if (info(wrap.use).has(trait::BRACE) && is_laid_out(facts.files.at(wrap.span.file).text, wrap)) continue;
    if (again || is_rewritten(facts.files.at(wrap.span.file).text, wrap.span)) continue;
    if (is_inserted(facts.files.at(wrap.span.file).text, wrap)) continue;
    // The function reads the REALs itself, as REALs.
    if (wrap.use == Use::value && reads_numbers(facts, wrap.detail)) continue;
    bool const is_name = wrap.use == Use::name || wrap.use == Use::own_name;
    if (wrap.use == Use::own_name && !is_defined(facts, wrap)) continue;
    if (wrap.use == Use::of_library && is_defined(facts, wrap)) continue;
    bool const is_text = wrap.use != Use::pasted && is_quoted(facts, wrap.span);
    if (is_text && is_name)
      result.diagnostics.push_back(
          {DiagnosticId::c_source, place_in(facts.files.at(wrap.span.file), wrap.span.begin),
           "'" + wrap.detail + "' has another name in symbolic mode, and a macro turns it into text"});
    if (!meets(pragmas, wrap.span) && !is_text)
      rewordings[wrap.span.file].push_back(rewording(wrap, facts.shared.contains(wrap.span)));
  }
}

// A type in the words of the file, with the types in it that change.
std::string type_text(Facts const &facts, Span const &span) {
  std::string const &file = facts.files.at(span.file).text;
  std::string text; // becomes one line: insertions keep line numbers
  std::size_t at = span.begin;
  for (auto token = facts.types.lower_bound({{span.file, span.begin, 0}, ""}); token != facts.types.end(); ++token) {
    if (token->span.file != span.file || token->span.end > span.end) break;
    if (token->replacement.empty() || token->span.begin < at) continue;
    text += file.substr(at, token->span.begin - at) + token->replacement;
    at = token->span.end;
  }
  return normalised(text + file.substr(at, span.end - at));
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

// Whether the base is a pack: `struct overloaded : Cases... {`.
bool is_pack(Facts const &facts, Span const &base) {
  std::string const &text = facts.files.at(base.file).text;
  std::string const behind = normalised(text.substr(base.end, text.find('{', base.end) - base.end));
  return behind.starts_with("...") || behind.starts_with(" ...");
}

void add_members(Facts const &facts, ByFile &rewordings) {
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

void add_pragmas(Facts const &facts, ByFile &rewordings) {
  for (auto const &[span, pragma] : facts.pragmas) {
    std::string const lines(pragma.continued_lines, '\n');
    std::vector<Rewording> &here = rewordings[span.file];
    if (!pragma.configured)
      here.push_back({span.begin, span.end, (pragma.is_function ? "" : region_text(pragma)) + lines, "", true});
    if (pragma.is_function && !pragma.function.empty()) {
      Span const &brace = pragma.function[0].brace;
      here.push_back({brace.begin, brace.end, "", " " + function_text(pragma)});
    }
  }
}

void add_arithmetic(Facts const &facts, ByFile &rewordings) {
  for (auto const &[span, fact] : facts.arithmetic)
    rewordings[span.file].push_back(
        {span.begin, span.end,
         "SYMREAL_REAL_EITHER((" + fact.own + "), " + fact.instead + ")" + std::string(fact.continued_lines, '\n'), "",
         true});
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
      names[wrap.span.file].all.insert(wrap.detail);
    else if (wrap.use == Use::own_name && is_defined(facts, wrap))
      names[wrap.span.file].at_file_scope.insert(wrap.detail);
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
             "'" + name_of(clause.clause) + "' is about rewritten text, and --via-ir records instructions"});
  for (auto const &[mangled, pragma] : facts.externals)
    result.diagnostics.push_back({DiagnosticId::clause_of_text, pragma.place,
                                  "'external' is about rewritten text, and --via-ir records instructions"});
}

// Result for the original with its annotations: texts and kernels.
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

} // namespace

Result annotated_original(Result const &result) {
  Result original;
  original.include_dirs = result.include_dirs;
  for (File const &file : result.files) {
    File &annotated = original.files.emplace_back(file);
    annotated.edits = file.annotations;
    annotated.text = apply_edits(file.original, file.annotations);
  }
  return original;
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
  std::set<Span> pragmas;
  for (auto const &[span, pragma] : facts.pragmas)
    if (!pragma.configured) pragmas.insert(span);
  follow_argument_lists(facts, result);
  if (!facts.makes_text)
    std::erase_if(facts.wraps, [](Wrap const &wrap) {
      return wrap.use == Use::formatting || wrap.use == Use::shown || wrap.use == Use::text;
    });
  ByFile rewordings;
  copy_text_calls(facts, rewordings);
  Ledger const ledger(facts);
  add_types(facts, pragmas, ledger, rewordings, result);
  add_unaccounted(facts, pragmas, ledger, rewordings, result);
  add_wraps(facts, pragmas, rewordings, result);
  add_selects(facts, rewordings, result);
  add_members(facts, rewordings);
  add_arithmetic(facts, rewordings);
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
