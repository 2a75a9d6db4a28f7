#include "engine/ops/operation.h"
#include "rewrite/collect/symbolic_ints.h"
#include "rewrite/model/conditions.h"
#include "rewrite/model/table_elements.h"
#include "rewrite/source/walk.h"
#include "rewrite/text/pragma_text.h"

#include <algorithm>

namespace symreal::rewrite {
namespace {

using namespace clang;

class Uses : public Walk {
public:
  Uses(ASTContext &context, IntegerTest depends, IntegerAction keep, SourceMap const &map, Facts &facts, Reals &reals)
      : context_(context),
        depends_(depends),
        keep_(keep),
        map_(map),
        facts_(facts),
        reals_(reals) {}

  bool VisitImplicitCastExpr(ImplicitCastExpr *cast) override {
    if (cast->getCastKind() != CK_LValueToRValue || !Reals::is_double(cast->getType())) return true;
    std::vector<Expr const *> indices;
    Expr const *element = cast->getSubExpr()->IgnoreParens(), *table = element;
    while (Expr const *whole = subscripted(table, indices)) table = whole;
    if (indices.empty() || indices.size() > 2 || !is_table(table->getType(), indices.size())) return true;
    if (std::none_of(indices.begin(), indices.end(), depends_)) return true;
    std::optional<Span> const span = map_.range(table->getSourceRange());
    if (!span || (map_.is_shared(table->getSourceRange()) && is_written(*span))) return true;
    std::string const name = normalised(map_.text(*span, table->getBeginLoc()));
    facts_.wraps.insert(
        {*span, Use::table, in_quotes(name) + ", " + in_quotes(to_string(map_.place(table->getBeginLoc())))});
    reals_.add_table_load(element, table);
    for (Expr const *index : indices) {
      keep_(index);
      table_indices_.insert(index);
    }
    return true;
  }

  bool VisitCallExpr(CallExpr *call) override {
    FunctionDecl const *function = call->getDirectCallee();
    if (!function || is_std_function(function, {"min", "max", "clamp"})) return true;
    if (computes_with_numbers(function)) {
      for (Expr const *argument : call->arguments()) keep_(argument);
      return true;
    }
    // Streams have an operator for it; of the others these are indices.
    auto const *operation = dyn_cast<CXXOperatorCallExpr>(call);
    if (operation && operation->getOperator() != OO_Subscript && operation->getOperator() != OO_Call) return true;
    unsigned const object = operation && isa<CXXMethodDecl>(function) ? 1 : 0;
    for (unsigned i = object; i < call->getNumArgs(); ++i)
      argument(call->getArg(i),
               function->isVariadic() && i - object >= function->getNumParams() && !reals_.in_roots(function));
    return true;
  }
  bool VisitCXXConstructExpr(CXXConstructExpr *construction) override {
    for (Expr const *each : construction->arguments()) argument(each, false);
    return true;
  }
  bool VisitForStmt(ForStmt *loop) override { return loop_condition(loop->getCond()); }
  bool VisitWhileStmt(WhileStmt *loop) override { return loop_condition(loop->getCond()); }
  bool VisitDoStmt(DoStmt *loop) override { return loop_condition(loop->getCond()); }
  // A class and a number cannot be alternatives of `?:`.
  bool VisitConditionalOperator(ConditionalOperator *choice) override {
    if (!Reals::is_integer(choice->getType())) return true;
    make_plain(choice->getTrueExpr());
    make_plain(choice->getFalseExpr());
    return true;
  }

private:
  // Whether a mathematical function takes numbers only: an integer argument is converted.
  bool computes_with_numbers(FunctionDecl const *function) const {
    if (!reals_.is_math(function) || !Reals::is_double(function->getReturnType())) return false;
    std::span<OperationInfo const> const table = operations();
    return std::any_of(table.begin(), table.end(), [&](OperationInfo const &operation) {
      return operation.form == Form::call && function->getName() == llvm::StringRef(operation.c);
    });
  }

  // A printed argument stays symbolic; any other function is selected by the type of a plain integer, and a variadic
  // one of the program may compute with it.
  void argument(Expr const *argument, bool is_printed) {
    if (table_indices_.contains(argument)) return;
    if (!is_printed || !depends_(argument)) return make_plain(argument);
    keep_(argument);
    wrap(argument, Use::value, "");
  }

  bool loop_condition(Expr const *condition) {
    for_each_comparison(condition, [&](BinaryOperator const *one) {
      make_plain(one->getLHS());
      make_plain(one->getRHS());
    });
    return true;
  }

  void make_plain(Expr const *expression) {
    if (!reals_.is_symbolic_integer(expression)) return;
    Expr const *written = Reals::spelled_integer(expression);
    PrintingPolicy const policy(map_.language());
    wrap(written, Use::conversion, written->getType().getUnqualifiedType().getAsString(policy));
  }

  void wrap(Expr const *expression, Use use, std::string detail) {
    if (!map_.in_roots(expression->getBeginLoc())) return;
    if (std::optional<Span> const span = map_.range(expression->getSourceRange()))
      facts_.wraps.insert({*span, use, std::move(detail)});
  }

  // A table is a copy of its elements.
  bool is_written(Span const &span) {
    if (!written_) written_ = shared_and_written(context_, map_);
    return written_->contains(span);
  }

  // Whether the object has contiguous elements, with this many indices.
  static bool is_table(QualType type, std::size_t indices) {
    for (std::size_t k = 0; k < indices; ++k) {
      type = type.getNonReferenceType();
      if (auto const *array = type->getAsArrayTypeUnsafe()) {
        if (k > 0 && !isa<ConstantArrayType>(array)) return false;
        type = array->getElementType();
      } else if (k == 0 && type->isPointerType())
        type = type->getPointeeType();
      else {
        auto const *record = dyn_cast_or_null<ClassTemplateSpecializationDecl>(type->getAsCXXRecordDecl());
        if (!record || (k > 0 && record->getName() == "vector")) return false; // rows apart from each other
        type = record->getTemplateArgs()[0].getAsType();
      }
    }
    return Reals::is_double(type);
  }

  ASTContext &context_;
  IntegerTest depends_;
  IntegerAction keep_;
  SourceMap const &map_;
  Facts &facts_;
  Reals &reals_;
  llvm::SmallPtrSet<Expr const *, 16> table_indices_;
  std::optional<std::set<Span>> written_;
};

} // namespace

void collect_integer_uses(ASTContext &context, std::vector<Decl *> const &declarations, IntegerTest depends,
                          IntegerAction keep, SourceMap const &map, Facts &facts, Reals &reals) {
  Uses uses(context, depends, keep, map, facts, reals);
  for (Decl *declaration : declarations) uses.TraverseDecl(declaration);
}

} // namespace symreal::rewrite
