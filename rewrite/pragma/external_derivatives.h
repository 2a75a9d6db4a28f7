// `derivative(f_jacobian, f_hessian)` of a pragma `external`: whether these functions can give the derivatives of the
// one before them. DerivativeFunction says what form that is.
#pragma once

#include "rewrite/source/clang.h"

#include <string>
#include <vector>

namespace symreal::rewrite {

class DerivativeForm {
public:
  // `given`: types of the parameters that the function is given; how many numbers these are, and its results: 0 where
  // only a call knows.
  DerivativeForm(clang::ASTContext &context, std::vector<clang::QualType> given, std::size_t numbers,
                 std::size_t results)
      : context_(context),
        given_(std::move(given)),
        numbers_(numbers),
        partials_(numbers * results) {}

  // Why it cannot be the next derivative, or nothing.
  std::string add(clang::FunctionDecl const *derivative);
  // What they add to the text.
  std::string const &text() const { return text_; }

private:
  bool is_same_parameter(clang::QualType wanted, clang::QualType found) const;
  std::string form() const;

  clang::ASTContext &context_;
  std::vector<clang::QualType> given_;
  std::size_t numbers_, partials_; // of the next derivative
  std::string text_;
};

} // namespace symreal::rewrite
