#include "rewrite/recorder.h"

namespace symreal::rewrite {
using namespace clang;

// It works on the bytes of its operands.
void Recorder::assembly(GCCAsmStmt const *assembly) {
  auto const refuse = [&](Expr const *operand) {
    if (reals_.carries_real(operand->getType()))
      report(DiagnosticId::boundary_call, operand->getBeginLoc(), "a REAL is an operand of assembly");
  };
  for (Expr const *operand : assembly->outputs()) refuse(operand);
  for (Expr const *operand : assembly->inputs()) refuse(operand);
}

// C++ has designators in the order of the members, one name each; those of arrays are compiled if they skip nothing.
void Recorder::designators(InitListExpr const *list) {
  if (map_.language().CPlusPlus) return;
  InitListExpr const *written = list->isSemanticForm() ? list->getSyntacticForm() : list;
  if (!written) return;
  std::uint64_t next = 0;
  for (Expr const *element : written->inits()) {
    if (auto const *designated = dyn_cast_or_null<DesignatedInitExpr>(element)) {
      DesignatedInitExpr::Designator const *first = designated->getDesignator(0);
      FieldDecl const *field = first->isFieldDesignator() ? first->getFieldDecl() : nullptr;
      Expr::EvalResult index;
      bool const in_order = field ? field->getFieldIndex() >= next
                                  : first->isArrayDesignator() &&
                                        designated->getArrayIndex(*first)->EvaluateAsInt(index, context_) &&
                                        index.Val.getInt().getLimitedValue() == next;
      if (designated->size() != 1 || !in_order)
        return report(DiagnosticId::c_source, designated->getBeginLoc(),
                      "C++ has designators in the order of the members, and one at a time");
      if (field) next = field->getFieldIndex();
    }
    ++next;
  }
}

} // namespace symreal::rewrite
