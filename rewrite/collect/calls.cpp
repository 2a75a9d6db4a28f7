// Calls, and their arguments: those for which a parameter declares no type are passed through `...`.
#include "engine/support/installation.h"
#include "rewrite/collect/call_site.h"
#include "rewrite/collect/handlers.h"
#include "rewrite/collect/objects.h"
#include "rewrite/model/conditions.h"
#include "rewrite/model/library.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

std::vector<Expr const *> written_arguments(llvm::ArrayRef<Expr const *> all) {
  std::vector<Expr const *> result;
  for (Expr const *argument : all)
    if (!isa<CXXDefaultArgExpr>(argument)) result.push_back(argument);
  return result;
}

// Whether another overload takes a type other than double here: it could win for a literal that is still a double while
// the declarations say REAL.
bool overload_competes(FunctionDecl const *function, unsigned index, unsigned count) {
  DeclContext const *scope = function->getDeclContext();
  auto const *constructor = dyn_cast<CXXConstructorDecl>(function);
  for (NamedDecl const *found : scope->lookup(function->getDeclName())) {
    if (isa<FunctionTemplateDecl>(found)) return true;
    if (auto const *shadow = dyn_cast<UsingShadowDecl>(found)) found = shadow->getTargetDecl();
    auto const *other = dyn_cast<FunctionDecl>(found);
    if (!other || other->getCanonicalDecl() == function->getCanonicalDecl()) continue;
    if (auto const *built = dyn_cast<CXXConstructorDecl>(other);
        built && constructor && built->isCopyOrMoveConstructor())
      continue;
    if (other->getMinRequiredArguments() > count || other->getNumParams() <= index) continue;
    if (!Reals::is_double(other->getParamDecl(index)->getType())) return true;
  }
  return false;
}

bool reads_numbers(FunctionDecl const *function) {
  return function->getDeclName().isIdentifier() && function->getName().ends_with("scanf");
}

// Type of a parameter that takes only double: a symbolic REAL is decided. The text survives a second rewriting.
constexpr char const *plain_double = "decltype(0.0)";

// The stream operators and to_string have overloads for RealNumber, and the runtime's own functions take it.
bool runtime_overloads(FunctionDecl const *function, SourceManager const &sources) {
  if (sources.getFilename(function->getLocation()).starts_with(runtime_include())) return true;
  if (function->isOverloadedOperator()) {
    auto const *method = dyn_cast<CXXMethodDecl>(function);
    return method && method->getParent()->isInStdNamespace();
  }
  return function->isInStdNamespace() && function->getDeclName().isIdentifier() && function->getName() == "to_string";
}

// Whether a function returns a new value, unlike an operator << that returns its argument. Text functions are excluded.
bool gives_something(FunctionDecl const *function) {
  QualType const type = function->getReturnType();
  return !isa<CXXConstructorDecl>(function) && !type->isVoidType() && !type->isReferenceType() &&
         text_use(function) == TextUse::none;
}

class CallArguments : public ObjectUses {
public:
  explicit CallArguments(SyntaxTable &table) : ObjectUses(table) {
    on<CallSite>(NUMBERS, &CallArguments::site);
    on<CallExpr>(NUMBERS, &CallArguments::dependent_variadic_call);
    on<ImplicitCastExpr>(NUMBERS, &CallArguments::conversion);
    on<InitListExpr>(RUNNING, &CallArguments::elements);
    on<CallSite>(INSTANCES, &CallArguments::instantiated_site);
  }

private:
  void site(CallSite const *site);
  void instantiated_site(CallSite const *site);
  void elements(InitListExpr const *list);
  void conversion(ImplicitCastExpr const *cast);
  void dependent_variadic_call(CallExpr const *call);

  void arguments(CallSite const *site);
  void literal_argument(FunctionDecl const *function, unsigned index, Expr const *argument, bool overloaded,
                        unsigned count, Use use = Use::literal);
  void outside_argument(SourceLocation call, FunctionDecl const *function, unsigned index, Expr const *argument);
  bool takes_only(FunctionDecl const *function) const;
  void converting_construction(CXXConstructExpr const *construction);
};

} // namespace

// Promoted type of an integer passed through `...`, as source text.
static std::string promoted_integer(Expr const *argument) {
  QualType const type = argument->getType().getCanonicalType();
  return type->isBooleanType() ? "int" : type.getUnqualifiedType().getAsString();
}

std::optional<CallSite> call_site(CallExpr const *call) {
  FunctionDecl const *function = call->getDirectCallee();
  if (!function) return std::nullopt;
  Expr const *callee = call->getCallee()->IgnoreParenImpCasts();
  bool overloaded = false;
  if (auto const *reference = dyn_cast<DeclRefExpr>(callee))
    overloaded = reference->hadMultipleCandidates();
  else if (auto const *member = dyn_cast<MemberExpr>(callee))
    overloaded = member->hadMultipleCandidates();
  std::vector<Expr const *> all(call->arg_begin(), call->arg_end());
  if (isa<CXXOperatorCallExpr>(call) && isa<CXXMethodDecl>(function) && !all.empty()) all.erase(all.begin());
  return CallSite{call, call->getRParenLoc(), function, written_arguments(all), overloaded};
}

std::optional<CallSite> call_site(CXXConstructExpr const *construction) {
  CXXConstructorDecl const *constructor = construction->getConstructor();
  if (construction->getLocation().isInvalid() || constructor->isCopyOrMoveConstructor()) return std::nullopt;
  std::vector<Expr const *> const all(construction->arg_begin(), construction->arg_end());
  return CallSite{construction, construction->getLocation(), constructor, written_arguments(all),
                  construction->hadMultipleCandidates()};
}

bool takes_as_declared(FunctionDecl const *function, Reals const &reals) {
  return !reals.is_math(function) && !reals.external(function);
}

bool is_outside(FunctionDecl const *function, SourceMap const &map, Reals const &reals) {
  return !reals.in_roots(function) && !runtime_overloads(function, map.sources());
}

void CallArguments::site(CallSite const *site) {
  auto const *call = dyn_cast<CallExpr>(site->expression);
  auto const *construction = dyn_cast<CXXConstructExpr>(site->expression);
  FunctionDecl const *function = site->function;
  if (Reals::External const *external = call ? reals_.external(function) : nullptr)
    return wrap(call->getCallee()->IgnoreParenImpCasts(), Use::external, external->arguments);
  // stream.operator<<(x): the operator for REALs is a free function.
  if (call && isa<CXXMemberCallExpr>(call) && function->getOverloadedOperator() == OO_LessLess &&
      runtime_overloads(function, map_.sources()) && site->arguments.size() == 1 && reals_.is_real(site->arguments[0]))
    wrap_for(site->place, site->arguments[0], Use::value, function->getQualifiedNameAsString());
  if (construction && construction->getParenOrBraceRange().isInvalid()) converting_construction(construction);
  arguments(site);
}

void CallArguments::elements(InitListExpr const *list) {
  for (Expr const *element : converted_elements(list))
    if (auto const *made = element ? dyn_cast<CXXConstructExpr>(element->IgnoreImplicit()) : nullptr;
        made && made->getParenOrBraceRange().isInvalid())
      converting_construction(made);
}

void CallArguments::conversion(ImplicitCastExpr const *cast) {
  auto const *construction = dyn_cast<CXXConstructExpr>(cast->getSubExpr()->IgnoreImplicit());
  if (construction && cast->getCastKind() == CK_ConstructorConversion && !cast->isTypeDependent() &&
      !cast->getSubExpr()->isTypeDependent())
    converting_construction(construction);
}

// An implicit conversion through a constructor that takes double: from a literal it would need two steps, double to
// REAL and REAL to the class, and the language takes only one.
void CallArguments::converting_construction(CXXConstructExpr const *construction) {
  if (construction->getNumArgs() == 0 || isa<CXXDefaultArgExpr>(construction->getArg(0))) return;
  CXXConstructorDecl const *constructor = construction->getConstructor();
  if (constructor->getNumParams() == 0 || !Reals::is_double(constructor->getParamDecl(0)->getType())) return;
  if (Reals::is_passive_class(construction->getType())) return;
  Expr const *argument = construction->getArg(0)->IgnoreParenImpCasts();
  if (argument->getType()->isArithmeticType() && reals_.stays_double(argument)) wrap(argument, Use::literal);
}

void CallArguments::arguments(CallSite const *site) {
  auto const &[expression, call, function, arguments, overloaded] = *site;
  if (!takes_as_declared(function, reals_)) return;
  auto const count = static_cast<unsigned>(arguments.size());
  bool const outside = is_outside(function, map_, reals_);
  for (unsigned i = 0; i < count; ++i) {
    if (arguments[i]->isTypeDependent()) continue;
    if (is_plain_double(arguments[i])) literal_argument(function, i, arguments[i], overloaded, count);
    if (outside)
      outside_argument(call, function, i, arguments[i]);
    else if (i < function->getNumParams() || !function->isVariadic())
      continue;
    else if (reals_.is_real(arguments[i]))
      wrap_for(call, arguments[i], Use::value, function->getQualifiedNameAsString());
    else if (may_be_truth(arguments[i])) // the program itself may compute with it
      wrap_for(call, arguments[i], Use::conversion, promoted_integer(arguments[i]));
  }
}

// A literal by which the template of another function is chosen.
void CallArguments::instantiated_site(CallSite const *site) {
  auto const *construction = dyn_cast<CXXConstructExpr>(site->expression);
  auto const count = static_cast<unsigned>(site->arguments.size());
  // `return 1.0;` in a template: a number here, and a class of numbers there.
  if (construction && construction->getParenOrBraceRange().isInvalid() && count > 0 &&
      is_plain_double(site->arguments[0]) && Reals::is_double(site->function->getParamDecl(0)->getType()) &&
      !Reals::is_passive_class(construction->getType()))
    return wrap(site->arguments[0], Use::fit);
  for (unsigned i = 0; i < count; ++i)
    if (Expr const *argument = site->arguments[i]; is_plain_double(argument)) {
      Use const use = isa<FloatingLiteral>(argument->IgnoreParenImpCasts()) ? Use::literal : Use::deduced;
      literal_argument(site->function, i, argument, true, count, use);
    }
}

void CallArguments::literal_argument(FunctionDecl const *function, unsigned index, Expr const *argument,
                                     bool overloaded, unsigned count, Use use) {
  if (index >= function->getNumParams()) {
    auto const *primary = function->getPrimaryTemplate();
    if (primary && !function->isVariadic()) wrap(argument, use); // an element of a parameter pack
    return;
  }
  if (auto const *method = dyn_cast<CXXMethodDecl>(function); method && Reals::is_passive_template(method->getParent()))
    return;
  if (FunctionTemplateDecl const *primary = function->getPrimaryTemplate()) {
    FunctionDecl const *pattern = primary->getTemplatedDecl();
    unsigned const at = std::min(index, pattern->getNumParams() - 1);
    if (pattern->getParamDecl(at)->getType()->isDependentType()) wrap(argument, use);
    return;
  }
  bool const rewritten = reals_.in_roots(function);
  bool const is_double_parameter = Reals::is_double(function->getParamDecl(index)->getType());
  if (rewritten && overloaded && is_double_parameter && overload_competes(function, index, count)) wrap(argument, use);
}

// Whether a function neither returns nor keeps doubles: its arguments leave the program.
bool CallArguments::takes_only(FunctionDecl const *function) const {
  if (reals_.mentions_real(function->getReturnType())) return false;
  for (ParmVarDecl const *parameter : function->parameters()) {
    QualType const type = parameter->getType();
    if (Reals::is_double(type) && !type->isReferenceType()) continue;
    QualType pointee = type->getPointeeType();
    if (pointee.isNull() || pointee.isConstQualified()) continue;
    auto const *record = pointee->getAsRecordDecl();
    if (!record) {
      if (reals_.mentions_real(pointee)) return false;
      continue;
    }
    if (!record->getDefinition()) return false;
    for (FieldDecl const *field : record->getDefinition()->fields())
      if (reals_.mentions_real(field->getType())) return false;
  }
  auto const *method = dyn_cast<CXXMethodDecl>(function);
  return !method || method->isStatic() || method->getParent()->isInStdNamespace();
}

void CallArguments::outside_argument(SourceLocation call, FunctionDecl const *function, unsigned index,
                                     Expr const *argument) {
  bool const real = reals_.is_real(argument);
  std::string const name = "'" + function->getQualifiedNameAsString() + "', which is outside the roots";
  if (index >= function->getNumParams()) {
    if (!function->isVariadic()) return;
    if (real || may_be_truth(argument))
      wrap_for(call, argument, Use::value);
    else if (argument->getType()->isPointerType() && !reads_numbers(function) &&
             Reals::is_double(argument->getType()->getPointeeType()))
      report(DiagnosticId::boundary_call, argument->getBeginLoc(), "the address of a REAL goes to " + name);
    return;
  }
  QualType const parameter = function->getParamDecl(index)->getType();
  QualType const declared = [&] {
    FunctionDecl const *pattern = Reals::pattern(function);
    unsigned const count = pattern->getNumParams();
    if (index < count) return pattern->getParamDecl(index)->getType();
    bool const in_pack = count > 0 && pattern->getParamDecl(count - 1)->isParameterPack();
    return in_pack ? pattern->getParamDecl(count - 1)->getType() : parameter;
  }();
  auto const *method = dyn_cast<CXXMethodDecl>(function);
  if (method && method->isDefaulted()) return; // it copies its own class, whatever that holds
  // complex<double>, written out by the library, is another class than complex<REAL>, and so are its members.
  if (method && Reals::pattern(function) == function && isa<ClassTemplateSpecializationDecl>(method->getParent()) &&
      reals_.carries_real(context_.getRecordType(method->getParent())))
    return;
  bool const passive_class = method && Reals::is_passive_template(method->getParent());
  if (passive_class && real) {
    wrap_for(call, argument, Use::conversion, plain_double);
    return;
  }
  if (declared->isDependentType()) return; // a template: instantiated on REAL it is traced
  if (Reals::is_double(parameter) &&
      (!parameter->isReferenceType() || parameter.getNonReferenceType().isConstQualified())) {
    if (!real) return;
    if (takes_only(function) && gives_something(function))
      wrap_for(call, argument, Use::conversion, plain_double); // its result depends on its argument
    else if (takes_only(function))
      wrap_for(call, argument, Use::value);
    else
      report(DiagnosticId::boundary_call, argument->getBeginLoc(), "a REAL goes to " + name);
    return;
  }
  if (parameter->isVoidPointerType()) return given_bytes(function, index, argument);
  bool const by_address = parameter->isPointerType() || parameter->isReferenceType();
  if (by_address && !declared->isDependentType() && reals_.mentions_real(parameter) && !reads_numbers(function))
    report(DiagnosticId::boundary_call, argument->getBeginLoc(), "a REAL goes to " + name);
}

// Whether the integer may be of a class in the symbolic program: a comparison, isnan, results of truth values and
// rounding. True in doubt: the macro passes plain integers on.
bool SyntaxHandler::may_be_truth(Expr const *argument) const {
  if (!ScalarState::is_integer(argument->getType())) return false;
  if (reals_.is_symbolic_integer(argument) || Conditions(map_, reals_).mentions_real(argument)) return true;
  Expr const *bare = argument->IgnoreParenImpCasts();
  if (auto const *negation = dyn_cast<UnaryOperator>(bare); negation && negation->getOpcode() == UO_LNot)
    return may_be_truth(negation->getSubExpr());
  if (auto const *reference = dyn_cast<DeclRefExpr>(bare)) {
    auto const *variable = dyn_cast<VarDecl>(reference->getDecl());
    return variable && variable->getType()->getContainedAutoType();
  }
  auto const *call = dyn_cast<CallExpr>(bare);
  FunctionDecl const *function = call ? call->getDirectCallee() : nullptr;
  return function && Reals::pattern(function)->getDeclaredReturnType()->getContainedAutoType();
}

// The arguments of printf in a template may turn out to be numbers.
void CallArguments::dependent_variadic_call(CallExpr const *call) {
  FunctionDecl const *function = call->getDirectCallee();
  if (auto const *names = dyn_cast<UnresolvedLookupExpr>(call->getCallee()->IgnoreParenImpCasts()))
    if (names->getNumDecls() == 1) function = dyn_cast<FunctionDecl>((*names->decls_begin())->getUnderlyingDecl());
  if (!function || !function->isVariadic()) return;
  std::string const reader = reals_.in_roots(function) ? function->getQualifiedNameAsString() : "";
  for (unsigned i = function->getNumParams(); i < call->getNumArgs(); ++i)
    if (call->getArg(i)->isTypeDependent() && !isa<PackExpansionExpr>(call->getArg(i)))
      wrap_for(call->getRParenLoc(), call->getArg(i), Use::value, reader);
}

void add_calls(SyntaxTable &table) { table.add<CallArguments>(); }

} // namespace symreal::rewrite
