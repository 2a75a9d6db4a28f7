#include "engine/ops/operation.h"
#include "rewrite/collect/walks.h"
#include "rewrite/model/library.h"
#include "rewrite/source/walk.h"
#include "rewrite/text/pragma_text.h"

#include <algorithm>

namespace symreal::rewrite {
using namespace clang;

namespace {

// Calls `action` for each comparison of a loop's condition, where integers become plain: they are one number there, not
// one decision in each iteration.
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

// The indexed object of an element, such as `a` of a[i], an array, a pointer, std::array or std::vector; appends its
// index. Null for any other expression.
Expr const *subscripted(Expr const *expression, std::vector<Expr const *> &indices) {
  expression = expression->IgnoreParenImpCasts();
  if (auto const *subscript = dyn_cast<ArraySubscriptExpr>(expression)) {
    if (subscript->isTypeDependent() || subscript->getBase() != subscript->getLHS()) return nullptr; // 2[tab]
    indices.push_back(subscript->getIdx());
    return subscript->getBase()->IgnoreParenImpCasts();
  }
  auto const *call = dyn_cast<CXXOperatorCallExpr>(expression);
  if (!call || call->getOperator() != OO_Subscript || call->getNumArgs() != 2) return nullptr;
  auto const *record = call->getArg(0)->getType()->getAsCXXRecordDecl();
  if (!is_std_class(record, "array") && !is_std_class(record, "vector")) return nullptr;
  indices.push_back(call->getArg(1));
  return call->getArg(0)->IgnoreParenImpCasts();
}

// Finds the elements that are more than read.
class Writes : public Walk {
public:
  explicit Writes(SourceMap const &map) : map_(map) {}

  std::set<Span> found;

  bool VisitImplicitCastExpr(ImplicitCastExpr *cast) override {
    if (cast->getCastKind() == CK_LValueToRValue) parts(cast->getSubExpr());
    return true;
  }
  bool VisitArraySubscriptExpr(ArraySubscriptExpr *element) override { return element_of(element); }
  bool VisitCXXOperatorCallExpr(CXXOperatorCallExpr *element) override { return element_of(element); }

private:
  // A parent is visited before its parts, and a row is a part of its element.
  Expr const *parts(Expr const *element) {
    std::vector<Expr const *> indices;
    element = element->IgnoreParenImpCasts();
    while (Expr const *whole = subscripted(element, indices)) {
      known_.insert(element);
      element = whole;
    }
    return element;
  }

  bool element_of(Expr const *element) {
    if (known_.contains(element)) return true;
    Expr const *whole = parts(element);
    if (whole == element || !map_.in_roots(whole->getBeginLoc()) || !map_.is_shared(whole->getSourceRange()))
      return true;
    if (std::optional<Span> const span = map_.range(whole->getSourceRange())) found.insert(*span);
    return true;
  }

  SourceMap const &map_;
  llvm::SmallPtrSet<Expr const *, 16> known_;
};

// Texts of objects whose elements are assigned, or whose address is taken, somewhere in the source, in a macro or a
// file that is included again: an expansion that reads elements there may write them elsewhere.
std::set<Span> shared_and_written(std::vector<Decl *> const &declarations, SourceMap const &map) {
  Writes writes(map);
  for (Decl *declaration : declarations) writes.TraverseDecl(declaration);
  return std::move(writes.found);
}

// Collects the elements read at a symbolic index, and the uses that need a plain integer.
class IntegerUses : public Walk {
public:
  IntegerUses(std::vector<Decl *> const &declarations, Finder &finder, SourceMap const &map, Facts &facts, Reals &reals)
      : declarations_(declarations),
        finder_(finder),
        map_(map),
        facts_(facts),
        reals_(reals) {}

  void run() {
    for (Decl *declaration : declarations_) TraverseDecl(declaration);
  }

  bool VisitImplicitCastExpr(ImplicitCastExpr *cast) override {
    if (cast->getCastKind() != CK_LValueToRValue || !Reals::is_double(cast->getType())) return true;
    std::vector<Expr const *> indices;
    Expr const *element = cast->getSubExpr()->IgnoreParens(), *table = element;
    while (Expr const *whole = subscripted(table, indices)) table = whole;
    if (indices.empty() || indices.size() > 2 || !is_table(table->getType(), indices.size())) return true;
    if (llvm::none_of(indices, [&](Expr const *index) { return finder_.depends(index); })) return true;
    std::optional<Span> const span = map_.range(table->getSourceRange());
    if (!span || (map_.is_shared(table->getSourceRange()) && is_written(*span))) return true;
    std::string const name = normalised(map_.text(*span, table->getBeginLoc()));
    facts_.wraps.insert(
        {*span, Use::table, in_quotes(name) + ", " + in_quotes(to_string(map_.place(table->getBeginLoc())))});
    reals_.add_table_load(element, table);
    for (Expr const *index : indices) {
      finder_.keep(index);
      table_indices_.insert(index);
    }
    return true;
  }

  bool VisitCallExpr(CallExpr *call) override {
    FunctionDecl const *function = call->getDirectCallee();
    if (!function || is_std_function(function, {"min", "max", "clamp"})) return true;
    if (computes_with_numbers(function)) {
      for (Expr const *argument : call->arguments()) finder_.keep(argument);
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
    if (!is_printed || !finder_.depends(argument)) return make_plain(argument);
    finder_.keep(argument);
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
    if (!written_) written_ = shared_and_written(declarations_, map_);
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

  std::vector<Decl *> const &declarations_;
  Finder &finder_;
  SourceMap const &map_;
  Facts &facts_;
  Reals &reals_;
  llvm::SmallPtrSet<Expr const *, 16> table_indices_;
  std::optional<std::set<Span>> written_;
};

} // namespace

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
  IntegerUses(declarations, finder, map, facts, reals).run();
}

} // namespace symreal::rewrite
