#include "rewrite/collect/collector.h"
#include "rewrite/facts/merge.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
using namespace clang;

void Collector::report(DiagnosticId id, SourceLocation location, std::string message, std::optional<Severity> unusual) {
  Diagnostic diagnostic{id, map_.place(location), std::move(message), map_.expansions(location)};
  if (instance_) diagnostic.notes.push_back(*instance_);
  if (unusual) diagnostic.severity = *unusual;
  add_diagnostic(facts_, diagnostic);
}

void Collector::builtin_type(BuiltinTypeLoc type, Passive passive) {
  if (type.getTypePtr()->getKind() == BuiltinType::LongDouble)
    for (SourceLocation const end : {type.getBeginLoc(), type.getEndLoc()})
      if (std::optional<Span> const span = map_.token(end)) facts_.types.insert({*span, "", long_double});
  if (type.getTypePtr()->getKind() != BuiltinType::Double) return;
  SourceLocation const location = type.getBeginLoc();
  if (!map_.in_roots(location)) return;
  std::optional<Span> const span = map_.token(location);
  if (!span) {
    // A hand-written symbolic main spells the type as REAL already.
    if (location.isMacroID() &&
        Lexer::getImmediateMacroName(location, map_.sources(), map_.language()) == reserved_type_name)
      return;
    report(DiagnosticId::double_from_macro, location, "this `double` is spelled by a macro that cannot be edited");
    return;
  }
  std::string const text = map_.text(*span, location);
  if (text == "double")
    facts_.types.insert({*span, passive ? "" : reserved_type_name, passive});
  else
    report(DiagnosticId::unaccounted_double, location, "a double spelled as '" + text + "'");
}

void Collector::complex_type(ComplexTypeLoc type) {
  if (!map_.in_roots(type.getBeginLoc())) return;
  auto const *complex = type.getTypePtr()->getAs<ComplexType>();
  if (!complex || !Reals::is_double(complex->getElementType())) return;
  for (SourceLocation const end : {type.getBeginLoc(), type.getEndLoc()})
    if (std::optional<Span> const span = map_.token(end)) facts_.types.insert({*span, "", complex_double});
  report(DiagnosticId::unconvertible_type, type.getBeginLoc(), "C's complex double has no symbolic counterpart");
}

namespace {

// Eigen has an alias template beside each typedef (Vector3d, Vector3<double>) and names its class templates likewise
// (Quaterniond, Quaternion<double>). Either has no comma, so that it survives a macro's argument list.
std::string one_argument_template(TypedefNameDecl const *declaration) {
  llvm::StringRef const name = declaration->getName();
  if (!name.ends_with("d")) return {};
  llvm::StringRef const stem = name.drop_back();
  DeclContext const *scope = declaration->getDeclContext();
  for (NamedDecl const *found : scope->lookup(&declaration->getASTContext().Idents.get(stem)))
    if (auto const *pattern = dyn_cast<TemplateDecl>(found))
      if (pattern->getTemplateParameters()->getMinRequiredArguments() == 1)
        return (stem + "<" + reserved_type_name + ">").str();
  return {};
}

} // namespace

void Collector::typedef_name(TypedefNameDecl const *declaration, SourceLocation name, bool qualified,
                             bool within_type) {
  if (!declaration || within_type || reals_.in_roots(declaration) || !map_.in_roots(name)) return;
  if (map_.is_argument_of(name, "REAL_TYPE")) return;
  if (isa<CXXRecordDecl>(declaration->getDeclContext())) return; // its class decides
  QualType const type = declaration->getUnderlyingType();
  if (type->isDependentType() || !reals_.mentions_real(type) || Reals::is_passive_class(type)) return;
  std::optional<Span> const span = map_.token(name, declaration->getName());
  if (!span) {
    report(DiagnosticId::unconvertible_type, name, "'" + declaration->getNameAsString() + "' is spelled by a macro");
    return;
  }
  if (Reals::is_double(type)) {
    if (!qualified)
      facts_.types.insert({*span, reserved_type_name});
    else
      report(DiagnosticId::unconvertible_type, name, "'" + declaration->getQualifiedNameAsString() + "' is a double");
    return;
  }
  PrintingPolicy policy(map_.language());
  policy.FullyQualifiedName = true;
  policy.PrintCanonicalTypes = true;
  std::string replacement = one_argument_template(declaration);
  auto const *scope = dyn_cast<NamespaceDecl>(declaration->getDeclContext());
  std::string const home = scope ? scope->getQualifiedNameAsString() + "::" : "";
  if (!replacement.empty())
    replacement = qualified ? replacement : home + replacement;
  else if (home == "Eigen::" && !name.isMacroID()) {
    replacement = with_real(type.getAsString(policy));
    if (qualified && llvm::StringRef(replacement).starts_with(home)) replacement = replacement.substr(home.size());
  } else {
    report(DiagnosticId::unconvertible_type, name,
           "'" + declaration->getQualifiedNameAsString() + "' is " + type.getAsString(policy) +
               ", declared outside the roots");
    return;
  }
  facts_.types.insert({*span, replacement});
}

void Collector::printed_signature(FunctionDecl const *function) {
  for (FunctionDecl const *declaration : function->redecls()) {
    SourceLocation const end =
        declaration->doesThisDeclarationHaveABody() ? declaration->getBody()->getBeginLoc() : declaration->getEndLoc();
    if (std::optional<Span> const span = map_.range({declaration->getOuterLocStart(), end}))
      facts_.printed.insert(*span);
  }
}

} // namespace symreal::rewrite
