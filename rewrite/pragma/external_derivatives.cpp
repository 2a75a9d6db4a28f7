#include "rewrite/pragma/external_derivatives.h"

#include "engine/support/quoted.h"

namespace symreal::rewrite {

using namespace clang;

// A derivative takes pointers to const, even for the function's output parameters.
bool DerivativeForm::is_same_parameter(QualType wanted, QualType found) const {
  if (!wanted->isPointerType() || !found->isPointerType())
    return context_.hasSameUnqualifiedType(wanted.getCanonicalType(), found.getCanonicalType());
  return found->getPointeeType().isConstQualified() &&
         context_.hasSameUnqualifiedType(wanted->getPointeeType(), found->getPointeeType());
}

std::string DerivativeForm::form() const {
  std::string parameters;
  for (QualType type : given_) {
    if (type->isPointerType()) type = context_.getPointerType(type->getPointeeType().withConst());
    parameters += type.getAsString() + ", ";
  }
  std::string const size = partials_ == 0 ? "" : std::to_string(partials_);
  return "it should be void (" + parameters + "double partials[" + size + "])";
}

std::string DerivativeForm::add(FunctionDecl const *derivative) {
  QualType const returned = derivative->getReturnType();
  bool const is_returned = context_.hasSameUnqualifiedType(returned, context_.DoubleTy);
  if (is_returned ? partials_ != 1 : !returned->isVoidType()) return form();
  std::size_t const count = derivative->getNumParams();
  if (count != given_.size() + (is_returned ? 0 : 1)) return form();
  for (std::size_t i = 0; i < given_.size(); ++i)
    if (!is_same_parameter(given_[i], derivative->getParamDecl(static_cast<unsigned>(i))->getType())) return form();
  if (!is_returned) {
    ParmVarDecl const *last = derivative->getParamDecl(static_cast<unsigned>(count - 1));
    QualType const type = last->getType();
    if (!type->isPointerType() || type->getPointeeType().isConstQualified() ||
        !context_.hasSameType(context_.getBaseElementType(type->getPointeeType()), context_.DoubleTy))
      return form();
    auto const *decayed = type->getAs<DecayedType>();
    auto const *array = decayed ? context_.getAsConstantArrayType(decayed->getOriginalType()) : nullptr;
    if (array && partials_ != 0) {
      std::uint64_t size = static_cast<std::uint64_t>(context_.getConstantArrayElementCount(array));
      if (size != partials_) return form() + ", and its array has " + std::to_string(size) + " elements";
    }
  }
  text_ += (is_returned ? " derivative returned " : " derivative ") + in_quotes(derivative->getNameAsString());
  partials_ *= numbers_;
  return {};
}

} // namespace symreal::rewrite
