// Facts that an instantiation shows and its template does not: which function is called, how an argument converts for
// it, and whose bytes are used. A wrap changes the template's text, so each macro passes other types on.
#include "rewrite/collect/collector.h"
#include "rewrite/collect/walks.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// A conversion of a double to another arithmetic type around an argument or a value; null without one.
ImplicitCastExpr const *conversion_of_double(Expr const *expression) {
  while (true) {
    if (auto const *temporary = dyn_cast<MaterializeTemporaryExpr>(expression))
      expression = temporary->getSubExpr();
    else if (auto const *full = dyn_cast<FullExpr>(expression))
      expression = full->getSubExpr();
    else if (auto const *cast = dyn_cast<ImplicitCastExpr>(expression)) {
      CastKind const kind = cast->getCastKind();
      if (Reals::is_double(cast->getSubExpr()->getType()) &&
          (kind == CK_FloatingToIntegral || kind == CK_FloatingToBoolean || kind == CK_FloatingCast))
        return cast;
      expression = cast->getSubExpr();
    } else
      return nullptr;
  }
}

bool has_wrap(Facts const &facts, Span const &span, Use use) {
  auto const found = facts.wraps.lower_bound({span, use, ""});
  return found != facts.wraps.end() && found->span == span && found->use == use;
}

class Instances : public Walk {
public:
  Instances(ASTContext &context, SourceMap const &map, Reals const &reals, ScalarState const &scalars,
            Surroundings const &surroundings, Facts &facts)
      : map_(map),
        collect_(context, map, reals, scalars, surroundings, facts) {}

  bool shouldVisitTemplateInstantiations() const override { return true; }

  bool TraverseDecl(Decl *declaration) override {
    if (!declaration || map_.is_outside(declaration)) return true;
    auto const *context = dyn_cast<DeclContext>(declaration);
    if (!context || (!isa<FunctionDecl>(declaration) && !isa<CXXRecordDecl>(declaration)))
      return Walk::TraverseDecl(declaration);
    Scope const scope(*this, instance_of(declaration, context));
    return Walk::TraverseDecl(declaration);
  }
  bool TraverseLambdaExpr(LambdaExpr *lambda) override {
    FunctionTemplateDecl *generic = lambda->getLambdaClass()->getDependentLambdaCallOperator();
    if (generic)
      for (FunctionDecl *one : generic->specializations())
        if (one->hasBody()) {
          Scope const scope(*this, instance_of(one, one));
          if (!TraverseStmt(one->getBody())) return false;
        }
    return Walk::TraverseLambdaExpr(lambda);
  }
  // Unevaluated operands and constant expressions are skipped.
  bool TraverseUnaryExprOrTypeTraitExpr(UnaryExprOrTypeTraitExpr *) override { return true; }
  bool TraverseCXXNoexceptExpr(CXXNoexceptExpr *) override { return true; }
  bool TraverseTypeLoc(TypeLoc) override { return true; }

  void finish() { collect_.finish(); }

  bool VisitCallExpr(CallExpr *call) override {
    if (is_here(call)) collect_.instantiated_call(call);
    return true;
  }
  bool VisitAtomicExpr(AtomicExpr *call) override {
    if (is_here(call)) collect_.atomic_builtin(call);
    return true;
  }
  bool VisitCXXConstructExpr(CXXConstructExpr *construction) override {
    if (is_here(construction)) collect_.instantiated_construction(construction);
    return true;
  }
  bool VisitExplicitCastExpr(ExplicitCastExpr *cast) override {
    if (!is_here(cast)) return true;
    collect_.explicit_cast(cast);
    collect_.pointer_cast(cast);
    return true;
  }
  bool VisitImplicitCastExpr(ImplicitCastExpr *cast) override {
    if (cast->getCastKind() == CK_LValueToRValue && is_here(cast)) collect_.instantiated_read(cast->getSubExpr());
    return true;
  }
  bool VisitMemberExpr(MemberExpr *member) override {
    if (is_here(member)) collect_.union_member(member);
    return true;
  }
  bool VisitVarDecl(VarDecl *variable) override {
    if (instance_ && !variable->isConstexpr() && map_.in_roots(variable->getLocation()) &&
        !isa<ParmVarDecl>(variable) && variable->getInit())
      collect_.instantiated_value(variable->getInit());
    return true;
  }
  bool VisitReturnStmt(ReturnStmt *statement) override {
    if (instance_ && map_.in_roots(statement->getBeginLoc())) collect_.instantiated_value(statement->getRetValue());
    return true;
  }
  bool VisitBinaryOperator(BinaryOperator *binary) override {
    if (binary->getOpcode() == BO_Assign && is_here(binary)) collect_.instantiated_value(binary->getRHS());
    return true;
  }

private:
  // Scope of an instantiation: facts collected within belong to it, or to none.
  class Scope {
  public:
    Scope(Instances &walk, std::optional<Note> instance)
        : walk_(walk),
          outer_(std::exchange(walk.instance_, std::move(instance))) {
      walk_.collect_.set_instance(walk_.instance_);
    }
    ~Scope() {
      walk_.instance_ = outer_;
      walk_.collect_.set_instance(outer_);
    }
    Scope(Scope const &) = delete;
    Scope &operator=(Scope const &) = delete;

  private:
    Instances &walk_;
    std::optional<Note> const outer_;
  };

  std::optional<Note> instance_of(Decl const *declaration, DeclContext const *context) const {
    if (context->isDependentContext()) return std::nullopt;
    std::string name;
    llvm::raw_string_ostream out(name);
    SourceLocation place;
    if (auto const *function = dyn_cast<FunctionDecl>(declaration)) {
      if (!function->getTemplateInstantiationPattern()) return instance_;
      place = function->getPointOfInstantiation();
      function->getNameForDiagnostic(out, policy(), true);
    } else if (auto const *special = dyn_cast<ClassTemplateSpecializationDecl>(declaration);
               special && special->getSpecializationKind() != TSK_ExplicitSpecialization) {
      place = special->getPointOfInstantiation();
      special->getNameForDiagnostic(out, policy(), true);
    } else
      return instance_;
    if (place.isInvalid() || !map_.in_roots(place)) place = declaration->getLocation();
    return Note{map_.place(place), "in the instantiation " + name};
  }
  PrintingPolicy policy() const { return PrintingPolicy(map_.language()); }

  bool is_here(Expr const *expression) const {
    return instance_ && map_.in_roots(expression->getBeginLoc()) && !expression->isInstantiationDependent();
  }

  SourceMap const &map_;
  Collector collect_;
  std::optional<Note> instance_; // the enclosing instantiation
};

} // namespace

void Collector::instantiated_call(CallExpr const *call) {
  FunctionDecl const *function = call->getDirectCallee();
  if (!function || call->isTypeDependent()) return;
  moved_bytes(call, function);
  bytes_of_arguments(call, function);
  std::vector<Expr const *> all(call->arg_begin(), call->arg_end());
  if (isa<CXXOperatorCallExpr>(call) && isa<CXXMethodDecl>(function) && !all.empty()) all.erase(all.begin());
  instantiated_arguments(function, all);
}

void Collector::instantiated_construction(CXXConstructExpr const *construction) {
  CXXConstructorDecl const *constructor = construction->getConstructor();
  if (construction->isTypeDependent() || constructor->isCopyOrMoveConstructor()) return;
  std::vector<Expr const *> const all(construction->arg_begin(), construction->arg_end());
  // `return 1.0;` in a template: a number here, and a class of numbers there.
  if (construction->getParenOrBraceRange().isInvalid() && !all.empty() && is_plain_double(all[0]) &&
      Reals::is_double(constructor->getParamDecl(0)->getType()) && !Reals::is_passive_class(construction->getType()))
    return wrap(all[0], Use::fit);
  instantiated_arguments(constructor, all);
}

void Collector::instantiated_arguments(FunctionDecl const *function, Arguments arguments) {
  bool const in_roots = reals_.in_roots(function);
  for (unsigned i = 0; i < arguments.size(); ++i) {
    Expr const *argument = arguments[i];
    if (isa<CXXDefaultArgExpr>(argument) || argument->isTypeDependent()) continue;
    if (!in_roots) given_bytes(function, i, argument);
    if (ImplicitCastExpr const *cast = conversion_of_double(argument)) {
      Expr const *from = cast->getSubExpr();
      std::optional<Span> const span = map_.range(from->getSourceRange());
      // A conversion that the template shows as well has its wrap already.
      bool const known = span && has_wrap(facts_, *span, Use::conversion);
      if (!known && reals_.is_real(from)) wrap(from, Use::argument, spelled(cast->getType()));
    } else if (is_plain_double(argument)) {
      Use const use = isa<FloatingLiteral>(argument->IgnoreParenImpCasts()) ? Use::literal : Use::deduced;
      literal_argument(function, i, argument, true, static_cast<unsigned>(arguments.size()), use);
    } else {
      truth_argument(function, i, argument, true);
    }
  }
}

// `int i = v;` in a template, where v is a double.
void Collector::instantiated_value(Expr const *value) {
  ImplicitCastExpr const *cast = value ? conversion_of_double(value) : nullptr;
  if (!cast || cast->isTypeDependent() || !reals_.is_real(cast->getSubExpr())) return;
  std::optional<Span> const span = wrap_for({}, cast->getSubExpr(), Use::conversion, spelled(cast->getType()));
  if (span) facts_.shared.insert(*span);
}

// A comparison of REALs as an argument by whose type a function is chosen or made: of a comparison that is bool.
void Collector::truth_argument(FunctionDecl const *function, unsigned index, Expr const *argument, bool overloaded) {
  if (index >= function->getNumParams() || !reals_.in_roots(function)) return;
  if (!argument->IgnoreParenImpCasts()->getType()->isBooleanType() || !may_be_truth(argument)) return;
  FunctionTemplateDecl const *primary = function->getPrimaryTemplate();
  QualType const parameter = function->getParamDecl(index)->getType();
  bool const is_deduced = primary && index < primary->getTemplatedDecl()->getNumParams() &&
                          primary->getTemplatedDecl()->getParamDecl(index)->getType()->isDependentType() &&
                          parameter.getNonReferenceType()->isBooleanType();
  if (!is_deduced && !(overloaded && !Reals::is_double(parameter))) return;
  wrap(argument->IgnoreImpCasts(), Use::argument, "bool");
}

// std::max<long>(i, x > 1): of the overloads for symbolic integers none is better than the others.
void Collector::extreme_argument(FunctionDecl const *function, unsigned index, Expr const *argument) {
  if (index >= function->getNumParams() || !function->isInStdNamespace() || !function->getPrimaryTemplate()) return;
  if (!function->getIdentifier() || (function->getName() != "min" && function->getName() != "max")) return;
  QualType const parameter = function->getParamDecl(index)->getType().getNonReferenceType();
  Expr const *written = argument->IgnoreParenImpCasts();
  if (auto const *temporary = dyn_cast<MaterializeTemporaryExpr>(argument)) written = temporary->getSubExpr();
  written = written->IgnoreParenImpCasts();
  if (parameter->isIntegerType() && !context_.hasSameUnqualifiedType(parameter, written->getType()) &&
      may_be_truth(written))
    wrap(written, Use::conversion, spelled(parameter));
}

// Thrown, or kept in a std::any: who takes it out names its type.
void Collector::erased(Expr const *operand) {
  Expr const *bare = operand->IgnoreParenImpCasts();
  if (auto const *temporary = dyn_cast<MaterializeTemporaryExpr>(operand))
    bare = temporary->getSubExpr()->IgnoreParenImpCasts();
  if (!map_.in_roots(bare->getBeginLoc())) return;
  bool const may_be_plain = bare->isTypeDependent() && !isa<CXXUnresolvedConstructExpr>(bare);
  // A handler for double takes REALs.
  if (Reals::is_double(bare->getType()) && reals_.stays_double(bare)) return wrap(bare, Use::literal);
  if (may_be_plain || (bare->getType()->isIntegralOrEnumerationType() && !bare->isEvaluatable(context_)))
    wrap(bare, Use::erased);
}

void Collector::kept_by_type(FunctionDecl const *function, std::vector<Expr const *> const &arguments) {
  if (arguments.size() != 1 || !function->getPrimaryTemplate()) return;
  auto const *method = dyn_cast<CXXMethodDecl>(function);
  auto const *named = method ? static_cast<NamedDecl const *>(method->getParent()) : function;
  bool const is_known = named->getIdentifier() && named->getName() == (method ? "any" : "make_exception_ptr");
  if (is_known && named->isInStdNamespace()) erased(arguments.front());
}

// sizeof(x > 1), decltype(x > 1): a comparison of REALs is a class of its own, and in a template it may be one.
void Collector::looked_at(Expr const *operand) {
  Expr const *bare = operand->IgnoreParens();
  if (!map_.in_roots(operand->getBeginLoc())) return;
  if (bare->isTypeDependent()) {
    auto const *binary = dyn_cast<BinaryOperator>(bare);
    auto const *unary = dyn_cast<UnaryOperator>(bare);
    auto const *overloaded = dyn_cast<CXXOperatorCallExpr>(bare);
    bool const is_truth = (binary && (binary->isComparisonOp() || binary->isLogicalOp())) ||
                          (unary && unary->getOpcode() == UO_LNot) ||
                          (overloaded && (overloaded->isComparisonOp() || overloaded->getOperator() == OO_Exclaim));
    auto const *name = dyn_cast<DeclRefExpr>(bare);
    bool const is_variable =
        name && isa<VarDecl>(name->getDecl()) && name->getDecl()->getType()->getContainedAutoType();
    if (is_truth || is_variable || isa<CallExpr>(bare)) wrap(operand, Use::truth);
  } else if (bare->getType()->isBooleanType() && may_be_truth(bare))
    wrap(operand, Use::truth);
}

void collect_instances(ASTContext &context, SourceMap const &map, Reals const &reals, ScalarState const &scalars,
                       Surroundings const &surroundings, Facts &facts) {
  Instances instances(context, map, reals, scalars, surroundings, facts);
  instances.TraverseDecl(context.getTranslationUnitDecl());
  instances.finish();
}

} // namespace symreal::rewrite
