// Names that the program has for numbers: of what a variable is initialised with, and of what is assigned.
#include "rewrite/collect/handlers.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// `x`, `p->x`, `x[i]`, `*x`: x.
llvm::StringRef name_of(Expr const *target) {
  target = target->IgnoreParenImpCasts();
  if (auto const *element = dyn_cast<ArraySubscriptExpr>(target)) return name_of(element->getBase());
  if (auto const *pointee = dyn_cast<UnaryOperator>(target); pointee && pointee->getOpcode() == UO_Deref)
    return name_of(pointee->getSubExpr());
  NamedDecl const *declaration = nullptr;
  if (auto const *reference = dyn_cast<DeclRefExpr>(target)) declaration = reference->getDecl();
  if (auto const *member = dyn_cast<MemberExpr>(target)) declaration = member->getMemberDecl();
  return declaration && declaration->getIdentifier() ? declaration->getName() : llvm::StringRef();
}

class NamedNumbers : public SyntaxHandler {
public:
  explicit NamedNumbers(SyntaxTable &table) : SyntaxHandler(table) {
    on<VarDecl>(NUMBERS, &NamedNumbers::variable);
    on<BinaryOperator>(NUMBERS, &NamedNumbers::target);
  }

private:
  void name(llvm::StringRef name, SourceLocation begin, SourceLocation end) {
    if (name.empty() || begin.isMacroID() || end.isMacroID() || !map_.in_roots(begin)) return;
    NamedStatement statement{map_.place(begin), map_.place(end), name.str()};
    facts_.names.try_emplace(to_string(statement.begin), std::move(statement));
  }

  void variable(VarDecl const *variable) {
    Expr const *value = variable->getInit();
    if (!value || !variable->getIdentifier() || !Reals::is_double(variable->getType())) return;
    if (!variable->isFileVarDecl()) name(variable->getName(), value->getBeginLoc(), value->getEndLoc());
  }

  void target(BinaryOperator const *assignment) {
    if (assignment->isAssignmentOp() && Reals::is_double(assignment->getLHS()->getType()))
      name(name_of(assignment->getLHS()), assignment->getBeginLoc(), assignment->getEndLoc());
  }
};

} // namespace

void add_named_numbers(SyntaxTable &table) { table.add<NamedNumbers>(); }

} // namespace symreal::rewrite
