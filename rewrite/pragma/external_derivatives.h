// `derivative(f_jacobian, f_hessian)` of a pragma `external`: whether each function has the form of the derivative of
// the one before it. DerivativeFunction describes the form.
#pragma once

#include "rewrite/source/clang.h"

#include <string>
#include <vector>

namespace symreal::rewrite {

class DerivativeForm {
public:
  // `given`: types of the input parameters; `numbers` and `results`: counts of the numbers in them and of the results;
  // 0 if only a call determines them.
  DerivativeForm(clang::ASTContext &context, std::vector<clang::QualType> given, std::size_t numbers,
                 std::size_t results)
      : context_(context),
        given_(std::move(given)),
        numbers_(numbers),
        partials_(numbers * results) {}

  // Error message if it cannot be the next derivative, else empty.
  std::string add(clang::FunctionDecl const *derivative);
  // Text of the derivatives for the graph.
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
