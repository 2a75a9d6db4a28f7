#include "rewrite/select/arms.h"
#include "rewrite/source/walk.h"
#include "rewrite/text/compose.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// Whether the type consists of REALs alone, in memory of its own.
bool only_reals(QualType type, Reals const &reals) {
  type = type.getCanonicalType();
  if (type.isVolatileQualified() || type.isConstQualified() || type->isReferenceType()) return false;
  if (Reals::is_double(type)) return true;
  if (auto const *array = dyn_cast<ConstantArrayType>(type.getTypePtr()))
    return only_reals(array->getElementType(), reals);
  auto const *record = type->getAsRecordDecl();
  if (!record || !record->getDefinition()) return false;
  record = record->getDefinition();
  if (auto const *special = dyn_cast<ClassTemplateSpecializationDecl>(record)) {
    std::string const name = special->getQualifiedNameAsString();
    TemplateArgumentList const &arguments = special->getTemplateArgs();
    if (name == "std::array" || name == "std::complex") return only_reals(arguments[0].getAsType(), reals);
    if (name == "Eigen::Matrix" || name == "Eigen::Array")
      return only_reals(arguments[0].getAsType(), reals) && arguments[1].getAsIntegral().getExtValue() > 0 &&
             arguments[2].getAsIntegral().getExtValue() > 0;
  }
  if (!reals.in_roots(record) || record->isUnion() || record->field_empty()) return false;
  if (auto const *derived = dyn_cast<CXXRecordDecl>(record))
    if (derived->getNumBases() > 0 || !derived->isTriviallyCopyable()) return false;
  for (FieldDecl const *field : record->fields())
    if (!only_reals(field->getType(), reals) || field->getType()->getAsCXXRecordDecl()) return false;
  return true;
}

// One step from a part to the object it is part of, where both lie in the same memory.
Expr const *whole_of(Expr const *part) {
  part = part->IgnoreParenImpCasts();
  if (auto const *member = dyn_cast<MemberExpr>(part); member && !member->isArrow()) return member->getBase();
  if (auto const *element = dyn_cast<ArraySubscriptExpr>(part)) {
    Expr const *base = element->getBase()->IgnoreParenImpCasts();
    return base->getType()->isArrayType() ? base : nullptr;
  }
  if (auto const *call = dyn_cast<CXXOperatorCallExpr>(part);
      call && isa_and_nonnull<CXXMethodDecl>(call->getDirectCallee()))
    if (call->getOperator() == OO_Subscript || call->getOperator() == OO_Call) return call->getArg(0);
  if (auto const *call = dyn_cast<CXXMemberCallExpr>(part); call && call->getNumArgs() == 0)
    return call->getImplicitObjectArgument(); // v.x() of Eigen
  return nullptr;
}

class Mentions : public Walk {
public:
  explicit Mentions(std::set<VarDecl const *> const &variables) : variables_(variables) {}
  bool VisitDeclRefExpr(DeclRefExpr *reference) override {
    auto const *variable = dyn_cast<VarDecl>(reference->getDecl());
    found = found || (variable && variables_.count(variable) != 0);
    return !found;
  }
  bool found = false;

private:
  std::set<VarDecl const *> const &variables_;
};

// The symbolic integers that are arms of a `?:`, which stays one where a target names its element.
class ArmsOfIntegers : public Walk {
public:
  explicit ArmsOfIntegers(Reals const &reals) : reals_(reals) {}
  bool VisitConditionalOperator(ConditionalOperator *choice) override {
    for (Expr const *arm : {choice->getTrueExpr(), choice->getFalseExpr()})
      if (reals_.is_symbolic_integer(arm)) found.push_back(Reals::spelled_integer(arm));
    return true;
  }
  std::vector<Expr const *> found;

private:
  Reals const &reals_;
};

} // namespace

std::string ArmWalker::words(Expr const *expression) const {
  std::optional<Span> const span = analysis_.map_.range(expression->getSourceRange());
  return span ? "'" + normalised(analysis_.map_.text(*span, expression->getBeginLoc())) + "'" : "this";
}

VarDecl const *ArmWalker::home(Expr const *object) const {
  while (Expr const *whole = whole_of(object)) object = whole;
  auto const *reference = dyn_cast<DeclRefExpr>(object->IgnoreParenImpCasts());
  return reference ? dyn_cast<VarDecl>(reference->getDecl()) : nullptr;
}

bool ArmWalker::is_own(Expr const *object) const {
  VarDecl const *variable = home(object);
  if (!variable) {
    // A constructor writes the object that it makes.
    while (Expr const *whole = whole_of(object)) object = whole;
    auto const *member = dyn_cast<MemberExpr>(object->IgnoreParenImpCasts());
    return member && function_ && isa<CXXConstructorDecl>(function_) && isa<CXXThisExpr>(member->getBase());
  }
  if (variable->getType()->isReferenceType()) return false;
  // An element of an allocating container lies outside of the container, but does not alias other objects either.
  return own_.count(variable) != 0 || allowed_.counters.count(variable) != 0;
}

bool ArmWalker::mentions_own(Expr const *expression) const {
  Mentions mentions(own_);
  mentions.TraverseStmt(const_cast<Expr *>(expression));
  return mentions.found;
}

Expr const *ArmWalker::without_own_indices(Expr const *target) const {
  while (target && mentions_own(target)) target = whole_of(target);
  return target ? target->IgnoreParenImpCasts() : nullptr;
}

// Whether the expression refers to the same object before and after the arms.
bool ArmWalker::index_is_fixed(Expr const *target) {
  Expr const *at = target->IgnoreParenImpCasts();
  while (true) {
    if (isa<DeclRefExpr>(at) || isa<CXXThisExpr>(at)) return true;
    if (auto const *member = dyn_cast<MemberExpr>(at)) {
      at = member->getBase()->IgnoreParenImpCasts();
      continue;
    }
    std::vector<Expr const *> indices;
    Expr const *next = nullptr;
    if (auto const *element = dyn_cast<ArraySubscriptExpr>(at)) {
      next = element->getBase();
      indices = {element->getIdx()};
    } else if (auto const *unary = dyn_cast<UnaryOperator>(at); unary && unary->getOpcode() == UO_Deref) {
      next = unary->getSubExpr();
    } else if (auto const *sum = dyn_cast<BinaryOperator>(at); sum && sum->isAdditiveOp()) {
      next = sum->getLHS();
      indices = {sum->getRHS()};
    } else if (auto const *call = dyn_cast<CXXOperatorCallExpr>(at); call && whole_of(call)) {
      next = call->getArg(0);
      for (unsigned i = 1; i < call->getNumArgs(); ++i) indices.push_back(call->getArg(i));
    } else if (Expr const *whole = whole_of(at)) {
      next = whole;
    } else {
      block(at->getExprLoc(), {ReasonId::assigned_through_pointer, words(at)});
      return false;
    }
    for (Expr const *index : indices) {
      if (analysis_.conditions_.mentions_real(index)) {
        block(index->getExprLoc(), {ReasonId::real_index});
        return false;
      }
      expression(index);
    }
    at = next->IgnoreParenImpCasts();
  }
}

void ArmWalker::assignment(Expr const *target) {
  if (blocked()) return;
  target = target->IgnoreParens();
  if (is_own(target)) {
    // Its indices are computed all the same.
    for (Expr const *part = target; part; part = whole_of(part)) {
      Expr const *step = part->IgnoreParenImpCasts();
      if (auto const *element = dyn_cast<ArraySubscriptExpr>(step)) expression(element->getIdx());
      if (auto const *call = dyn_cast<CXXOperatorCallExpr>(step))
        for (unsigned i = 1; i < call->getNumArgs(); ++i) expression(call->getArg(i));
    }
    return;
  }
  SourceLocation const place = target->getExprLoc();
  if (target->getType().isVolatileQualified()) return block(place, {ReasonId::assigned_volatile});
  if (scope_ == Scope::body) return block(place, {ReasonId::assigned_not_own, words(target)});
  VarDecl const *variable = home(target);
  if (variable && own_.count(variable) != 0) return block(place, {ReasonId::assigned_reference, words(target)});
  auto const *reference = dyn_cast<DeclRefExpr>(target);
  auto const *integer = reference ? dyn_cast<VarDecl>(reference->getDecl()) : nullptr;
  if (integer && analysis_.reals_.is_symbolic_integer(integer)) return add_target(target);
  if (Reals::is_double(target->getType()) ? !analysis_.reals_.is_real(target)
                                          : !only_reals(target->getType(), analysis_.reals_))
    return block(place, {ReasonId::assigned_no_real, words(target)});
  if (index_is_fixed(target)) add_target(target);
}

void ArmWalker::add_target(Expr const *target) {
  SourceLocation const place = target->getExprLoc();
  if (mentions_own(target)) {
    Expr const *whole = without_own_indices(target);
    if (!whole || !only_reals(whole->getType(), analysis_.reals_))
      return block(place, {ReasonId::assigned_by_own, words(target)});
    target = whole;
  }
  std::optional<Span> const span = analysis_.map_.range_in(allowed_.frame, target->getSourceRange());
  if (!span) return block(place, {ReasonId::assigned_by_macro});
  ArmsOfIntegers arms(analysis_.reals_);
  arms.TraverseStmt(const_cast<Expr *>(target));
  std::vector<Rewording> conversions;
  for (Expr const *arm : arms.found) {
    std::optional<Span> const part = analysis_.map_.range_in(allowed_.frame, arm->getSourceRange());
    if (!part || part->file != span->file || part->begin < span->begin || part->end > span->end)
      return block(place, {ReasonId::assigned_by_macro});
    conversions.push_back({part->begin - span->begin, part->end - span->begin, "SYMREAL_REAL_ERASED(", ")"});
  }
  std::string const original = analysis_.map_.text_in(allowed_.frame, *span);
  std::string const text = with_real(normalised(apply_edits(original, compose(original, conversions))));
  for (std::string const &known : result.targets)
    if (known == text) return;
  result.targets.push_back(text);
}

} // namespace symreal::rewrite
