#include "rewrite/collect/instances.h"

#include "rewrite/collect/collector.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

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

void collect_instances(ASTContext &context, SourceMap const &map, Reals const &reals, ScalarState const &scalars,
                       Surroundings const &surroundings, Facts &facts) {
  Instances instances(context, map, reals, scalars, surroundings, facts);
  instances.TraverseDecl(context.getTranslationUnitDecl());
  instances.finish();
}

} // namespace symreal::rewrite
