#include "rewrite/collect/collector.h"

namespace symreal::rewrite {
using namespace clang;

// Inline assembly works on its operands' bytes. A memory operand lacks a conversion that shows a use of its value.
void Collector::assembly(GCCAsmStmt const *assembly) {
  auto const refuse = [&](Expr const *operand) {
    if (reals_.carries_real(operand->getType()))
      report(DiagnosticId::boundary_call, operand->getBeginLoc(), "a REAL is an operand of assembly");
  };
  for (Expr const *operand : assembly->outputs()) refuse(operand);
  for (Expr const *operand : assembly->inputs()) refuse(operand);
  for (unsigned k = 0; k < assembly->getNumOutputs(); ++k)
    if (Expr const *operand = assembly->getOutputExpr(k); ScalarState::is_scalar(operand->getType()))
      scalar(operand, assembly->isOutputPlusConstraint(k) ? Use::read : Use::written);
  for (Expr const *operand : assembly->inputs())
    if (operand->isGLValue() && ScalarState::is_scalar(operand->getType())) scalar(operand, Use::read);
}

namespace {

// Whether the written initialiser covers one element whole, rather than the first of the element's own.
bool is_whole(Expr const *written, QualType element) {
  return !element->isAggregateType() || isa<InitListExpr, StringLiteral>(written->IgnoreParens()) ||
         written->getType()->isRecordType();
}

} // namespace

// C++ requires designators in the order of the members, one name each. Those of arrays compile if they skip nothing;
// skipped elements are written out.
void Collector::designators(InitListExpr const *list) {
  if (map_.language().CPlusPlus) return;
  InitListExpr const *written = list->isSemanticForm() ? list->getSyntacticForm() : list;
  if (!written) return;
  ArrayType const *array = context_.getAsArrayType(list->getType());
  bool is_counted = array != nullptr;
  std::uint64_t next = 0;
  for (Expr const *element : written->inits()) {
    if (auto const *designated = dyn_cast_or_null<DesignatedInitExpr>(element)) {
      DesignatedInitExpr::Designator const *first = designated->getDesignator(0);
      FieldDecl const *field = first->isFieldDesignator() ? first->getFieldDecl() : nullptr;
      Expr::EvalResult index;
      bool in_order = field && field->getFieldIndex() >= next;
      if (first->isArrayDesignator() && designated->getArrayIndex(*first)->EvaluateAsInt(index, context_))
        in_order = fill(*designated, index.Val.getInt().getLimitedValue(), next, is_counted);
      if (designated->size() != 1 || !in_order)
        return report(DiagnosticId::c_source, designated->getBeginLoc(),
                      "C++ has designators in the order of the members, and one at a time");
      if (field) next = field->getFieldIndex();
      element = designated->getInit();
    }
    is_counted = is_counted && element && is_whole(element, array->getElementType());
    ++next;
  }
}

// The elements between `next` and the designated one, which becomes the next. False where they cannot be written.
bool Collector::fill(DesignatedInitExpr const &designated, std::uint64_t index, std::uint64_t &next, bool is_counted) {
  constexpr std::uint64_t most = 4096;
  if (index == next) return true;
  if (!is_counted || index < next || index - next > most) return false;
  std::string zeros;
  for (; next < index; ++next) zeros += "{}, ";
  SourceLocation const begin = designated.getBeginLoc();
  if (map_.is_argument_of(begin, "REAL_EITHER")) return true;
  std::optional<Span> const span = map_.range({begin, designated.getEqualOrColonLoc()});
  if (span) facts_.wraps.insert({*span, Use::instead, zeros});
  return span.has_value();
}

} // namespace symreal::rewrite
