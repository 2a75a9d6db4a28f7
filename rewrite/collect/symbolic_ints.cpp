#include "rewrite/collect/symbolic_ints.h"

#include "rewrite/model/conditions.h"
#include "rewrite/source/walk.h"

#include <algorithm>

namespace symreal::rewrite {
namespace {

using namespace clang;

bool takes_references(CallExpr const *call) {
  FunctionDecl const *function = call->getDirectCallee();
  return function && is_std_function(function, {"min", "max", "clamp"});
}

// Uses of a function's integer variables.
class Uses : public Walk {
public:
  struct Variable {
    std::vector<Expr const *> values;
    DeclStmt const *declared_in = nullptr; // its declarators share their type
  };
  std::map<VarDecl const *, Variable> variables;
  bool fits(Variable const &variable) const { return !unfit_.contains(variable.declared_in); }
  std::vector<Expr const *> contexts; // uses of a conversion in arithmetic

  bool VisitDeclStmt(DeclStmt *statement) override {
    bool all_fit = true;
    for (Decl const *declaration : statement->decls()) {
      auto const *variable = dyn_cast<VarDecl>(declaration);
      bool const fits = variable && fits_alone(variable);
      all_fit = all_fit && fits && (statement->isSingleDecl() || !variable->getType()->getContainedAutoType());
      if (!fits) continue;
      variables[variable].declared_in = statement;
      if (variable->getInit()) variables[variable].values.push_back(variable->getInit());
    }
    if (!all_fit) unfit_.insert(statement);
    return true;
  }
  bool VisitBinaryOperator(BinaryOperator *binary) override {
    if (binary->isAssignmentOp()) {
      if (VarDecl const *variable = named(binary->getLHS())) {
        changed_.insert(Reals::spelled_integer(binary->getLHS()));
        variables[variable].values.push_back(binary->getRHS());
      }
    } else if (binary->isComparisonOp() && Reals::is_integer(binary->getLHS()->getType()) &&
               !loop_comparisons_.contains(binary)) {
      contexts.push_back(binary->getLHS());
      contexts.push_back(binary->getRHS());
    }
    return true;
  }
  bool VisitForStmt(ForStmt *loop) override { return loop_condition(loop->getCond()); }
  bool VisitWhileStmt(WhileStmt *loop) override { return loop_condition(loop->getCond()); }
  bool VisitDoStmt(DoStmt *loop) override { return loop_condition(loop->getCond()); }
  bool VisitUnaryOperator(UnaryOperator *unary) override {
    if (unary->isIncrementDecrementOp()) changed_.insert(Reals::spelled_integer(unary->getSubExpr()));
    return true;
  }
  bool VisitCastExpr(CastExpr *cast) override {
    if (cast->getCastKind() == CK_LValueToRValue) read_.insert(cast->getSubExpr()->IgnoreParens());
    if (cast->getCastKind() == CK_IntegralToFloating && Reals::is_double(cast->getType()))
      contexts.push_back(cast->getSubExpr());
    return true;
  }
  bool VisitCallExpr(CallExpr *call) override { // these take and return references
    if (takes_references(call))
      for (Expr const *argument : call->arguments()) read_.insert(Reals::spelled_integer(argument));
    return true;
  }
  bool VisitDeclRefExpr(DeclRefExpr *reference) override {
    references_.push_back(reference);
    return true;
  }

  // Excludes variables whose address or reference may escape.
  void finish() {
    for (DeclRefExpr const *reference : references_)
      if (auto const *variable = dyn_cast<VarDecl>(reference->getDecl()))
        if (auto found = variables.find(variable); found != variables.end())
          if (!read_.contains(reference) && !changed_.contains(reference)) unfit_.insert(found->second.declared_in);
  }

private:
  static bool fits_alone(VarDecl const *variable) {
    return variable->hasLocalStorage() && Reals::is_integer(variable->getType()) && !variable->isConstexpr() &&
           !variable->getType()->isReferenceType() && !isa<DecompositionDecl>(variable);
  }
  VarDecl const *named(Expr const *expression) const {
    auto const *reference = dyn_cast<DeclRefExpr>(Reals::spelled_integer(expression));
    auto const *variable = reference ? dyn_cast<VarDecl>(reference->getDecl()) : nullptr;
    return variable && variables.count(variable) != 0 ? variable : nullptr;
  }

  bool loop_condition(Expr const *condition) {
    for_each_comparison(condition, [&](BinaryOperator const *one) { loop_comparisons_.insert(one); });
    return true;
  }

  llvm::SmallPtrSet<BinaryOperator const *, 8> loop_comparisons_;
  llvm::SmallPtrSet<DeclStmt const *, 8> unfit_; // for a class in place of the integer
  llvm::SmallPtrSet<Expr const *, 16> read_, changed_;
  std::vector<DeclRefExpr const *> references_;
};

class Finder {
public:
  Finder(SourceMap const &map, Facts &facts, Reals &reals) : map_(map), facts_(facts), reals_(reals) {}

  void find(Uses &uses) {
    // A variable is symbolic if one of its values is, which may be another variable.
    for (bool more = true; more;) {
      more = false;
      for (auto const &[variable, use] : uses.variables) {
        if (!uses.fits(use) || reals_.is_symbolic_integer(variable) || !type_span(variable)) continue;
        if (std::none_of(use.values.begin(), use.values.end(), [&](Expr const *value) { return depends(value); }))
          continue;
        for (Decl const *each : use.declared_in->decls()) reals_.add_symbolic_integer(cast<VarDecl>(each));
        more = true;
      }
    }
    for (auto const &[variable, use] : uses.variables) {
      if (!reals_.is_symbolic_integer(variable)) continue;
      if (!variable->getType()->getContainedAutoType()) facts_.wraps.insert({*type_span(variable), Use::integer, ""});
      for (Expr const *value : use.values) keep(value);
    }
    for (Expr const *expression : uses.contexts)
      if (depends(expression)) keep(expression);
  }

  // Whether the integer depends on a REAL in a way that can be recorded.
  bool depends(Expr const *expression) const {
    return reals_.integer_depends(expression, [this](CastExpr const *cast) { return can_be_spelled(cast); });
  }

  // Spells the conversions in it so that they stay symbolic.
  void keep(Expr const *expression) {
    expression = Reals::spelled_integer(expression);
    if (!depends(expression)) return;
    if (auto const *cast = dyn_cast<CastExpr>(expression)) {
      reals_.keep_integer(cast);
      if (auto const *written = dyn_cast<ExplicitCastExpr>(cast))
        facts_.wraps.insert({*cast_span(written), Use::integer, ""});
      keep(cast->getSubExpr());
    } else if (auto const *unary = dyn_cast<UnaryOperator>(expression))
      keep(unary->getSubExpr());
    else if (auto const *binary = dyn_cast<BinaryOperator>(expression)) {
      keep(binary->getLHS());
      keep(binary->getRHS());
    } else if (auto const *call = dyn_cast<CallExpr>(expression))
      for (Expr const *argument : call->arguments()) keep(argument);
  }

private:
  // An implicit conversion is spelled by a macro of its own.
  bool can_be_spelled(CastExpr const *cast) const {
    auto const *written = dyn_cast<ExplicitCastExpr>(cast);
    return map_.in_roots(cast->getBeginLoc()) && (!written || cast_span(written));
  }
  std::optional<Span> cast_span(ExplicitCastExpr const *cast) const {
    return span_of(cast->getTypeInfoAsWritten()->getTypeLoc());
  }
  std::optional<Span> type_span(VarDecl const *variable) const {
    return span_of(variable->getTypeSourceInfo()->getTypeLoc());
  }
  // Span of the type without its qualifiers; nullopt if these stand in its middle.
  std::optional<Span> span_of(TypeLoc type) const {
    TypeLoc const plain = type.getUnqualifiedLoc();
    std::optional<Span> const span = map_.range(plain.getSourceRange());
    if (!span) return std::nullopt;
    // Another name there, a macro's, may stand for another type the next time that the text is compiled.
    std::optional<Span> const spelled = map_.first_character(plain.getBeginLoc());
    bool const is_named = !spelled || spelled->file != span->file || spelled->begin != span->begin;
    if (is_named && map_.is_shared(plain.getSourceRange())) return std::nullopt;
    std::string const text = map_.text(*span, plain.getBeginLoc());
    bool const is_simple = text.find("const") == text.npos && text.find("volatile") == text.npos;
    return is_simple ? span : std::nullopt;
  }

  SourceMap const &map_;
  Facts &facts_;
  Reals &reals_;
};

} // namespace

void for_each_comparison(Expr const *condition, llvm::function_ref<void(BinaryOperator const *)> action) {
  std::vector<Stmt const *> parts = {condition};
  while (!parts.empty()) {
    Stmt const *part = parts.back();
    parts.pop_back();
    if (!part || isa<LambdaExpr>(part)) continue;
    if (auto const *binary = dyn_cast<BinaryOperator>(part); binary && binary->isComparisonOp()) action(binary);
    for (Stmt const *child : part->children()) parts.push_back(child);
  }
}

void collect_symbolic_ints(ASTContext &context, SourceMap const &map, Facts &facts, Reals &reals) {
  Uses uses;
  std::vector<Decl *> declarations;
  for (Decl *declaration : context.getTranslationUnitDecl()->decls())
    if (map.in_roots(declaration->getLocation()) || map.in_roots(declaration->getBeginLoc()))
      declarations.push_back(declaration);
  for (Decl *declaration : declarations) uses.TraverseDecl(declaration);
  uses.finish();
  Finder finder(map, facts, reals);
  finder.find(uses);
  auto const depends = [&](Expr const *expression) { return finder.depends(expression); };
  auto const keep = [&](Expr const *expression) { finder.keep(expression); };
  collect_integer_uses(context, declarations, depends, keep, map, facts, reals);
}

} // namespace symreal::rewrite
