// The types that a source spells, and the questions of a program for the name of a type: typeid, related functions of
// the standard library, and __PRETTY_FUNCTION__. A class replaces double, and the runtime returns the names of the
// original.
#include "rewrite/collect/handlers.h"
#include "rewrite/model/library.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

TypeToken const to_real{Fate::converted, reserved_type_name};

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

bool is_of_std(Expr const *object, llvm::StringRef name) {
  QualType const type = object->getType().getNonReferenceType();
  return is_std_class((type->isPointerType() ? type->getPointeeType() : type)->getAsCXXRecordDecl(), name);
}

// The instantiation of a template, or with a number among the types of its parameters.
bool shows_type(FunctionDecl const *function, Reals const &reals) {
  for (DeclContext const *context = function; context && !context->isFileContext(); context = context->getParent()) {
    auto const *one = dyn_cast<FunctionDecl>(context);
    if (context->isDependentContext() || isa<ClassTemplateSpecializationDecl>(context)) return true;
    if (one && (one->isTemplateInstantiation() || reals.mentions_real(one->getType()))) return true;
  }
  return false;
}

class SpelledTypes : public SyntaxHandler {
public:
  explicit SpelledTypes(SyntaxTable &table) : SyntaxHandler(table) {
    on<BuiltinTypeLoc>(ANYWHERE, &SpelledTypes::builtin_type);
    on<ComplexTypeLoc>(ANYWHERE, &SpelledTypes::complex_type);
    on<ElaboratedTypeLoc>(NUMBERS, &SpelledTypes::elaborated);
    on<NestedNameSpecifierLoc>(NUMBERS, &SpelledTypes::qualifier);
    on<NamedDecl>(ANYWHERE, &SpelledTypes::constrained);
    on<FunctionDecl>(ANYWHERE, &SpelledTypes::constrained);
  }

private:
  void builtin_type(BuiltinTypeLoc type);
  void complex_type(ComplexTypeLoc type);
  void elaborated(ElaboratedTypeLoc type);
  void qualifier(NestedNameSpecifierLoc name);
  void constrained(NamedDecl const *declaration) {
    if (auto const *described = dyn_cast<TemplateDecl>(declaration)) constrained(described->getTemplateParameters());
  }
  void constrained(FunctionDecl const *function) {
    for (unsigned i = 0; i < function->getNumTemplateParameterLists(); ++i)
      constrained(function->getTemplateParameterList(i));
  }

  void constrained(TemplateParameterList const *parameters);
  // A name outside the roots for a type with double in it: Eigen's Vector3d, double_t.
  void named_type(TypeLoc type, NestedNameSpecifierLoc qualifier);
  void typedef_name(TypedefNameDecl const *declaration, SourceLocation name, bool qualified, bool within_type);
};

// Questions of a program for the name of a type.
class TypeNames : public SyntaxHandler {
public:
  explicit TypeNames(SyntaxTable &table) : SyntaxHandler(table) {
    on<CXXTypeidExpr>(NUMBERS, &TypeNames::type_asked);
    on<CXXMemberCallExpr>(NUMBERS, &TypeNames::type_asked);
    on<PredefinedExpr>(NUMBERS, &TypeNames::signature_asked);
    on<PredefinedExpr>(ANYWHERE, &TypeNames::printed_signature);
  }

private:
  void type_asked(CXXTypeidExpr const *type);
  void type_asked(CXXMemberCallExpr const *call);
  void signature_asked(PredefinedExpr const *name);
  // A function whose declaration text is part of the program: __PRETTY_FUNCTION__, which assert prints.
  void printed_signature(PredefinedExpr const *name);

  void type_asked(SourceLocation user, Expr const *expression, std::string const &place);
};

} // namespace

void SpelledTypes::builtin_type(BuiltinTypeLoc type) {
  if (type.getTypePtr()->getKind() == BuiltinType::LongDouble)
    for (SourceLocation const end : {type.getBeginLoc(), type.getEndLoc()})
      if (std::optional<Span> const span = map_.token(end)) note(facts_.types, *span, {Fate::passive, "", long_double});
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
    note(facts_.types, *span, at_.passive ? TypeToken{Fate::passive, "", at_.passive} : to_real);
  else
    report(DiagnosticId::unaccounted_double, location, "a double spelled as '" + text + "'");
}

// `requires C<T> double f(T x)`: what replaces the type begins with `::`, which would go on with the name before it.
void SpelledTypes::constrained(TemplateParameterList const *parameters) {
  Expr const *constraint = parameters->getRequiresClause();
  if (!constraint) return;
  std::optional<Span> const last = map_.token(constraint->getEndLoc());
  if (last && map_.text(*last, constraint->getEndLoc()).find_first_of(")}") != std::string::npos) return;
  auto const next = Lexer::findNextToken(constraint->getEndLoc(), map_.sources(), map_.language());
  std::optional<Span> const span = next ? map_.token(next->getLocation()) : std::nullopt;
  if (!span) return;
  later([this, span] {
    auto const type = facts_.types.find(*span);
    if (type != facts_.types.end() && type->second == to_real)
      facts_.wraps.insert({*span, Use::before, "__attribute__(())"});
  });
}

void SpelledTypes::complex_type(ComplexTypeLoc type) {
  if (!map_.in_roots(type.getBeginLoc())) return;
  auto const *complex = type.getTypePtr()->getAs<ComplexType>();
  if (!complex || !Reals::is_double(complex->getElementType())) return;
  for (SourceLocation const end : {type.getBeginLoc(), type.getEndLoc()})
    if (std::optional<Span> const span = map_.token(end))
      note(facts_.types, *span, {Fate::diagnosed, "", complex_double});
  report(DiagnosticId::unconvertible_type, type.getBeginLoc(), "C's complex double has no symbolic counterpart");
}

void SpelledTypes::named_type(TypeLoc type, NestedNameSpecifierLoc qualifier) {
  bool const qualified = static_cast<bool>(qualifier);
  bool const within_type = qualified && qualifier.getNestedNameSpecifier()->getAsType();
  if (auto const named = type.getAs<TypedefTypeLoc>())
    typedef_name(named.getTypedefNameDecl(), named.getNameLoc(), qualified, within_type);
  else if (auto const used = type.getAs<UsingTypeLoc>())
    typedef_name(dyn_cast<TypedefNameDecl>(used.getFoundDecl()->getTargetDecl()), used.getNameLoc(), qualified,
                 within_type);
}

void SpelledTypes::elaborated(ElaboratedTypeLoc type) { named_type(type.getNamedTypeLoc(), type.getQualifierLoc()); }

void SpelledTypes::qualifier(NestedNameSpecifierLoc name) {
  if (name.getNestedNameSpecifier()->getAsType()) named_type(name.getTypeLoc(), name.getPrefix());
}

void SpelledTypes::typedef_name(TypedefNameDecl const *declaration, SourceLocation name, bool qualified,
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
      note(facts_.types, *span, to_real);
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
  note(facts_.types, *span, {Fate::converted, replacement});
}

void TypeNames::printed_signature(PredefinedExpr const *name) {
  FunctionDecl const *function = at_.function;
  if (!function || name->getIdentKind() != PredefinedIdentKind::PrettyFunction) return;
  for (FunctionDecl const *declaration : function->redecls()) {
    SourceLocation const end =
        declaration->doesThisDeclarationHaveABody() ? declaration->getBody()->getBeginLoc() : declaration->getEndLoc();
    if (std::optional<Span> const span = map_.range({declaration->getOuterLocStart(), end}))
      facts_.printed.insert(*span);
  }
}

// `place`: as source text; empty for a mere comparison of types.
void TypeNames::type_asked(SourceLocation user, Expr const *expression, std::string const &place) {
  SourceLocation const begin = expression->getBeginLoc();
  if (!map_.in_roots(begin) || !map_.language().CPlusPlus) return;
  if (std::optional<Span> const span = map_.range_for(user, expression->getSourceRange())) {
    facts_.wraps.insert({*span, Use::named, place});
    return;
  }
  auto const *type = dyn_cast<CXXTypeidExpr>(expression); // in the body of a library's macro
  if (type && type->isTypeOperand() && reals_.mentions_real(type->getTypeOperand(context_)))
    report(DiagnosticId::split_expression, begin, "a macro makes a part of this expression, which needs a conversion");
}

void TypeNames::type_asked(CXXTypeidExpr const *type) { type_asked(type->getBeginLoc(), type, "nullptr"); }

void TypeNames::type_asked(CXXMemberCallExpr const *call) {
  CXXMethodDecl const *method = call->getMethodDecl();
  if (!method || !method->getParent()->isInStdNamespace() || !method->getDeclName().isIdentifier()) return;
  llvm::StringRef const asked = method->getName();
  Expr const *object = call->getImplicitObjectArgument()->IgnoreParenImpCasts();
  auto const named = [&](Expr const *expression) {
    type_asked(call->getRParenLoc(), expression, in_quotes(to_string(map_.place(expression->getBeginLoc()))));
  };
  if (asked == "function_name" && is_of_std(object, "source_location")) return named(call);
  // std::any::type(), std::function::target_type()
  if (is_of_std(call, "type_info")) return type_asked(call->getRParenLoc(), call, "nullptr");
  bool const is_type = is_of_std(object, "type_info") || is_of_std(object, "type_index");
  if (!is_type || (asked != "name" && asked != "hash_code" && asked != "before")) return;
  named(object);
  for (Expr const *other : call->arguments()) named(other->IgnoreParenImpCasts());
}

void TypeNames::signature_asked(PredefinedExpr const *name) {
  FunctionDecl const *function = at_.function;
  if (!function || !map_.language().CPlusPlus || name->getIdentKind() != PredefinedIdentKind::PrettyFunction) return;
  if (!shows_type(function, reals_)) return;
  std::optional<Span> const token = map_.token(name->getLocation(), "__PRETTY_FUNCTION__");
  if (token && !map_.is_argument_of(name->getLocation(), "REAL_EITHER"))
    facts_.wraps.insert({*token, Use::instead, "SYMREAL_SIGNATURE"});
}

void add_types(SyntaxTable &table) {
  table.add<SpelledTypes>();
  table.add<TypeNames>();
}

} // namespace symreal::rewrite
