// Walk of the instantiations of templates, which show facts that a template does not: which function is called, how an
// argument converts for it, whose bytes are used. A wrap changes the template's text, so each macro passes other types
// on. Handlers of other files meet calls and casts there as well.
#include "rewrite/collect/handlers.h"
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

// Operators of the program that take an enumeration, or anything: beside an integer in its place they would not be
// chosen.
class OperatorsOfEnumerations : public Walk {
public:
  explicit OperatorsOfEnumerations(SourceMap const &map) : map_(map) {}
  bool TraverseDecl(Decl *declaration) override {
    return !declaration || map_.is_outside(declaration) || Walk::TraverseDecl(declaration);
  }
  bool VisitFunctionDecl(FunctionDecl *function) override {
    bool const is_operator = function->isOverloadedOperator() && map_.in_roots(function->getLocation());
    found = found || (is_operator && llvm::any_of(function->parameters(), [](ParmVarDecl const *parameter) {
                        QualType const type = parameter->getType().getNonReferenceType();
                        return type->isDependentType() || type->isEnumeralType();
                      }));
    return !found;
  }
  bool found = false;

private:
  SourceMap const &map_;
};

bool has_wrap(Facts const &facts, Span const &span, Use use) {
  auto const found = facts.wraps.lower_bound({span, use, ""});
  return found != facts.wraps.end() && found->span == span && found->use == use;
}

class InstantiatedConversions : public SyntaxHandler {
public:
  explicit InstantiatedConversions(SyntaxTable &table) : SyntaxHandler(table) {
    on<CallSite>(INSTANCES, &InstantiatedConversions::arguments);
    on<VarDecl>(INSTANCES, &InstantiatedConversions::initializer);
    on<ReturnStmt>(INSTANCES, &InstantiatedConversions::result);
    on<BinaryOperator>(INSTANCES, &InstantiatedConversions::assignment);
    on<ImplicitCastExpr>(INSTANCES, &InstantiatedConversions::enumerator);
  }

private:
  void initializer(VarDecl const *variable) {
    if (!variable->isConstexpr() && !isa<ParmVarDecl>(variable)) value(variable->getInit());
  }
  void result(ReturnStmt const *statement) { value(statement->getRetValue()); }
  void assignment(BinaryOperator const *assignment) {
    if (assignment->getOpcode() == BO_Assign) value(assignment->getRHS());
  }

  void arguments(CallSite const *site) {
    for (Expr const *argument : site->arguments) given_.insert(argument->IgnoreParenImpCasts());
    for (Expr const *argument : site->arguments)
      if (ImplicitCastExpr const *cast = conversion_of_double(argument)) {
        Expr const *from = cast->getSubExpr();
        std::optional<Span> const span = map_.range(from->getSourceRange());
        // A conversion that the template shows as well has its wrap already.
        bool const known = span && has_wrap(facts_, *span, Use::conversion);
        if (!known && reals_.is_real(from)) wrap(from, Use::argument, spelled(cast->getType()));
      }
  }

  // `int i = v;` in a template, where v is a double.
  void value(Expr const *value) {
    ImplicitCastExpr const *cast = value ? conversion_of_double(value) : nullptr;
    if (!cast || cast->isTypeDependent() || !reals_.is_real(cast->getSubExpr())) return;
    std::optional<Span> const span = wrap_for({}, cast->getSubExpr(), Use::conversion, spelled(cast->getType()));
    if (span) facts_.shared.insert(*span);
  }

  // `double v = e;`, `x * e` and a fold of one element in a template, where e is an enumerator. An argument may choose
  // among functions.
  void enumerator(ImplicitCastExpr const *cast) {
    Expr const *from = cast->getSubExpr();
    if (cast->getCastKind() != CK_IntegralToFloating || cast->isPartOfExplicitCast() ||
        !Reals::is_double(cast->getType()) || !from->IgnoreParenImpCasts()->getType()->isUnscopedEnumerationType())
      return;
    soon([this, from] {
      if (given_.contains(from->IgnoreParenImpCasts())) return;
      if (!has_operators_) {
        OperatorsOfEnumerations operators(map_);
        operators.TraverseDecl(context_.getTranslationUnitDecl());
        has_operators_ = operators.found;
      }
      if (!*has_operators_) wrap(from->IgnoreImpCasts(), Use::counted);
    });
  }

  llvm::SmallPtrSet<Expr const *, 32> given_; // to functions
  std::optional<bool> has_operators_;
};

class Instances : public Walk {
public:
  explicit Instances(Collection const &all) : map_(all.map), table_(all) {}

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

  void finish() { table_.finish(); }

#define MEET(SYNTAX)                                                                                                   \
  bool Visit##SYNTAX(SYNTAX *node) override {                                                                          \
    if (is_here(node)) table_.meet<SYNTAX>(node, INSTANCES, {});                                                       \
    return true;                                                                                                       \
  }
  SYMREAL_MET_STATEMENTS(MEET)
  SYMREAL_MET_DECLARATIONS(MEET)
#undef MEET

private:
  // Scope of an instantiation: facts collected within belong to it, or to none.
  class Scope {
  public:
    Scope(Instances &walk, std::optional<Note> instance)
        : walk_(walk),
          outer_(std::exchange(walk.instance_, std::move(instance))) {
      walk_.table_.set_instance(walk_.instance_);
    }
    ~Scope() {
      walk_.instance_ = outer_;
      walk_.table_.set_instance(outer_);
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

  bool is_here(Stmt const *statement) const {
    auto const *expression = dyn_cast<Expr>(statement);
    return instance_ && map_.in_roots(statement->getBeginLoc()) &&
           !(expression && expression->isInstantiationDependent());
  }
  bool is_here(Decl const *declaration) const { return instance_ && map_.in_roots(declaration->getLocation()); }

  SourceMap const &map_;
  SyntaxTable table_;
  std::optional<Note> instance_; // the enclosing instantiation
};

} // namespace

void add_instantiated(SyntaxTable &table) { table.add<InstantiatedConversions>(); }

void collect_instances(Collection const &all) {
  Instances instances(all);
  instances.TraverseDecl(all.context.getTranslationUnitDecl());
  instances.finish();
}

} // namespace symreal::rewrite
