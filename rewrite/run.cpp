#include "engine/support/mutation/is_dropped.h"
#include "rewrite/collected.h"
#include "rewrite/decide/decide.h"
#include "rewrite/pragma/configured.h"
#include "rewrite/reading.h"
#include "rewrite/rewrite.h"
#include "rewrite/source/source_map.h"
#include "rewrite/unit/rewritten_choices.h"

#include <algorithm>

namespace symreal::rewrite {
namespace {

Scope scope_of(Request const &request, std::vector<Compilation> const &sources) {
  Scope scope{{}, request.exclude};
  std::vector<std::string> &roots = scope.roots;
  for (std::string const &root : request.roots) roots.push_back(real_path(root));
  for (Compilation const &source : sources) roots.push_back(llvm::sys::path::parent_path(real_source(source)).str());
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  return scope;
}

std::vector<Compilation> sources_of(Request const &request) {
  std::vector<Compilation> sources = compilations_of(request);
  std::erase_if(sources, [&](Compilation const &one) { return request.exclude.matches(real_source(one)); });
  return sources;
}

bool has_errors(Result const &result) {
  return std::any_of(result.diagnostics.begin(), result.diagnostics.end(),
                     [](symreal::Diagnostic const &one) { return one.severity == Severity::error; });
}

// The number's name goes to compilers as a word of the command line.
void require_type_name(std::string const &name) {
  if (name.empty()) return;
  clang::LangOptions language;
  language.CPlusPlus = language.CPlusPlus11 = language.CPlusPlus20 = language.Bool = true;
  clang::IdentifierTable words(language);
  if (!clang::isValidAsciiIdentifier(name) || words.get(name).isKeyword(language))
    fail(DiagnosticId::bad_option, {}, "the number's type cannot be called '" + name + "'");
}

} // namespace

Collected collect(Request const &request) {
  std::vector<Compilation> const sources = sources_of(request);
  Scope const scope = scope_of(request, sources);
  Reading reading(request, sources, scope);
  Facts facts = reading.all();
  if (!facts.broken) report_configured(request, facts);
  // Other errors may follow from a name that was not found.
  std::stable_partition(facts.diagnostics.begin(), facts.diagnostics.end(),
                        [](symreal::Diagnostic const &one) { return one.id == DiagnosticId::configured_function; });
  return {std::move(facts),           std::move(reading.left_out), std::move(reading.unreached),
          reading.collector().read(), reading.collector().kept(),  reading.collector().seconds()};
}

Result run(Request const &request) {
  require_type_name(request.type_name);
  Collected collected = collect(request);
  Choices const choices = std::exchange(collected.facts.choices, {});
  std::set<std::string> const asking = std::exchange(collected.facts.asking, {});
  Result result = decide(std::move(collected.facts), request);
  if (!request.annotations_only && !has_errors(result) && !is_dropped("SYM120")) {
    std::vector<Compilation> sources = sources_of(request);
    Scope const scope = scope_of(request, sources);
    std::erase_if(sources, [&](Compilation const &one) { return !asking.contains(real_source(one)); });
    compare_choices(choices, sources, scope, request, result);
  }
  result.left_out = std::move(collected.left_out);
  result.unreached = std::move(collected.unreached);
  result.sources_read = collected.read;
  result.sources_kept = collected.kept;
  result.reading_seconds = std::move(collected.reading_seconds);
  return result;
}

} // namespace symreal::rewrite
