#include "rewrite/collect/views.h"
#include "rewrite/collect/handlers.h"
#include "rewrite/model/library.h"

#include <clang/AST/ParentMapContext.h>

namespace symreal::rewrite {
using namespace clang;

namespace {

// Destination of a pointer: an immediate use or a local variable; any other copy may be read in a kernel other than the
// one that is analysed.
struct Destination {
  bool is_kept = false;
  VarDecl const *local = nullptr;
};

// The variable in p, p + 1, p++, (int *)p.
DeclRefExpr const *named_pointer(Expr const *pointer) {
  pointer = pointer->IgnoreParenCasts();
  if (auto const *name = dyn_cast<DeclRefExpr>(pointer)) return name;
  if (auto const *step = dyn_cast<UnaryOperator>(pointer); step && step->isIncrementDecrementOp())
    return named_pointer(step->getSubExpr());
  auto const *sum = dyn_cast<BinaryOperator>(pointer);
  if (!sum || !sum->isAdditiveOp()) return nullptr;
  return named_pointer(sum->getLHS()->getType()->isPointerType() ? sum->getLHS() : sum->getRHS());
}

// Pointer operand of p[i] and *p; any other expression itself.
Expr const *pointer_of(Expr const *value) {
  if (auto const *element = dyn_cast<ArraySubscriptExpr>(value)) return element->getBase();
  auto const *behind = dyn_cast<UnaryOperator>(value);
  return behind && behind->getOpcode() == UO_Deref ? behind->getSubExpr() : value;
}

// Whether the pointer is passed to a function that may read its pointee.
bool is_argument(Expr const *pointer, ASTContext &context) {
  for (Expr const *part = pointer;;) {
    DynTypedNodeList const parents = context.getParents(*part);
    auto const *outer = parents.empty() ? nullptr : parents[0].get<Expr>();
    if (!outer) return false;
    if (auto const *call = dyn_cast<CallExpr>(outer)) {
      FunctionDecl const *function = call->getDirectCallee();
      bool const looks =
          function && function->getIdentifier() && (function->getName() == "memcmp" || function->getName() == "fwrite");
      return looks || !function || !moves_bytes(function);
    }
    if (isa<CXXConstructExpr>(outer)) return true;
    if (!outer->getType()->isPointerType()) return false;
    part = outer;
  }
}

Destination destination(Expr const *pointer, ASTContext &context) {
  auto const local = [](Decl const *declaration) {
    auto const *variable = dyn_cast<VarDecl>(declaration);
    return Destination{!variable || !variable->hasLocalStorage(), variable};
  };
  for (Expr const *part = pointer;;) {
    DynTypedNodeList const parents = context.getParents(*part);
    if (parents.empty()) return {true};
    if (auto const *variable = parents[0].get<VarDecl>()) return local(variable);
    auto const *outer = parents[0].get<Expr>();
    if (!outer) return {parents[0].get<ReturnStmt>() != nullptr || parents[0].get<CXXCtorInitializer>() != nullptr};
    if (auto const *assignment = dyn_cast<BinaryOperator>(outer); assignment && assignment->isAssignmentOp()) {
      auto const *name = dyn_cast<DeclRefExpr>(assignment->getLHS()->IgnoreParens());
      return name ? local(name->getDecl()) : Destination{assignment->getRHS()->IgnoreParens() == part};
    }
    if (isa<InitListExpr>(outer)) return {true};
    if (!outer->getType()->isPointerType() || isa<CallExpr>(outer)) return {};
    part = outer;
  }
}

// The stored value in *(int *)&x = 1; null for another use of the pointer.
Expr const *stored_through(Expr const *pointer, ASTContext &context) {
  for (Expr const *part = pointer;;) {
    DynTypedNodeList const parents = context.getParents(*part);
    auto const *outer = parents.empty() ? nullptr : parents[0].get<Expr>();
    if (!outer) return nullptr;
    if (auto const *assignment = dyn_cast<BinaryOperator>(outer); assignment && assignment->getOpcode() == BO_Assign)
      return part->isGLValue() && assignment->getLHS() == part ? part : nullptr;
    auto const *unary = dyn_cast<UnaryOperator>(outer);
    bool const is_way = outer->getType()->isPointerType() ? isa<BinaryOperator>(outer) || isa<ImplicitCastExpr>(outer)
                                                          : unary && unary->getOpcode() == UO_Deref;
    if (!is_way && !isa<ParenExpr>(outer) && !isa<ArraySubscriptExpr>(outer)) return nullptr;
    if (auto const *element = dyn_cast<ArraySubscriptExpr>(outer); element && element->getBase() != part)
      return nullptr;
    part = outer;
  }
}

bool is_address_of_one(Expr const *pointer) {
  auto const *taken = dyn_cast<UnaryOperator>(pointer->IgnoreParenImpCasts());
  return taken && taken->getOpcode() == UO_AddrOf;
}

} // namespace

void Views::view(ExplicitCastExpr const *cast, bool of_integers) {
  Destination const to = cast->getType()->isPointerType() ? destination(cast, context_) : Destination{};
  if (to.is_kept)
    report(DiagnosticId::reinterpretation, cast->getBeginLoc(),
           "the bytes of a REAL are read as " + cast->getType().getAsString() + ", by a pointer that is kept");
  else if (to.local && of_integers && !instance_) {
    views_.insert(to.local);
    if (is_address_of_one(cast->getSubExprAsWritten())) views_of_one_.insert(to.local);
  } else if (Expr const *stored = of_integers ? stored_through(cast, context_) : nullptr)
    note(stored, Use::part, nullptr, "replaced, 0, 0, ");
  else
    looked_into(cast->getSubExprAsWritten());
}

// Notes a read through a local pointer variable, or a copy of it.
void Views::read_view(Expr const *value) {
  if (!value->isGLValue()) return;
  value = value->IgnoreParens();
  auto const *name = named_pointer(pointer_of(value));
  auto const *variable = name ? dyn_cast<VarDecl>(name->getDecl()) : nullptr;
  if (variable && variable->hasLocalStorage()) through_pointers_.emplace_back(value, name);
}

bool Views::view_of_union(Expr const *part) {
  if (instance_) return false;
  DynTypedNodeList const parents = context_.getParents(*part);
  auto const *outer = parents.empty() ? nullptr : parents[0].get<Expr>();
  auto const *taken = dyn_cast_or_null<UnaryOperator>(outer);
  auto const *decay = dyn_cast_or_null<ImplicitCastExpr>(outer);
  bool const is_address =
      (taken && taken->getOpcode() == UO_AddrOf && !taken->getSubExpr()->getType()->isArrayType()) ||
      (decay && decay->getCastKind() == CK_ArrayToPointerDecay);
  if (!is_address) return false;
  Destination const to = destination(outer, context_);
  if (!to.local || to.is_kept || !to.local->getType()->isPointerType()) return false;
  if (QualType const pointee = to.local->getType()->getPointeeType(); !pointee->isIntegralOrEnumerationType())
    return false;
  views_.insert(to.local);
  return true;
}

void Views::assignment(BinaryOperator const *assignment) {
  Expr const *left = assignment->getLHS()->IgnoreParens();
  if (!assignment->isAssignmentOp() || assignment->isTypeDependent() || left->isTypeDependent()) return;
  if (assignment->isCompoundAssignmentOp())
    read_view(left);
  else
    store_to_view(left);
}

void Views::step(UnaryOperator const *step) {
  Expr const *operand = step->getSubExpr()->IgnoreParens();
  if (step->isIncrementDecrementOp() && !operand->isTypeDependent()) read_view(operand);
}

void Views::store_to_view(Expr const *left) {
  auto const *name = pointer_of(left) == left ? nullptr : named_pointer(pointer_of(left));
  auto const *variable = name ? dyn_cast<VarDecl>(name->getDecl()) : nullptr;
  if (variable && variable->hasLocalStorage()) stores_through_.emplace_back(left, name);
}

// True if another variable has become one.
bool Views::use_of_view(Expr const *value, DeclRefExpr const *name) {
  if (pointer_of(value) != value) {
    note(value, Use::bits);
    return false;
  }
  Destination const to = destination(name, context_);
  if (to.local && !to.is_kept) {
    if (views_of_one_.contains(cast<VarDecl>(name->getDecl()))) views_of_one_.insert(to.local);
    return views_.insert(to.local).second;
  }
  if (is_argument(name, context_)) note(name, Use::view);
  return false;
}

void Views::finish() {
  for (bool again = !views_.empty(); again;) {
    again = false;
    std::erase_if(through_pointers_, [&](auto const &one) {
      if (!views_.contains(cast<VarDecl>(one.second->getDecl()))) return false;
      again |= use_of_view(one.first, one.second);
      return true;
    });
  }
  for (auto const &[left, name] : stores_through_)
    if (auto const *variable = cast<VarDecl>(name->getDecl()); views_.contains(variable))
      note(left, Use::part, nullptr,
           std::string(views_of_one_.contains(variable) ? "replaced" : "stored") + ", 0, 0, ");
}

Views &add_views(SyntaxTable &table) { return table.add<Views>(); }

} // namespace symreal::rewrite
