#include "rewrite/pragma/externals.h"

#include "rewrite/source/walk.h"
#include "rewrite/text/pragma_text.h"

#include <algorithm>

namespace symreal::rewrite {
namespace {

using namespace clang;

// Spelling of a parameter or result in the graph's text, or the error that prevents it.
struct Value {
  std::string text;
  std::string size = "0"; // if only a call determines it
  std::string error = {};

  bool is(std::string_view kind) const { return text.starts_with(kind); }
  std::size_t count() const {
    std::size_t const space = text.rfind(' ');
    return is("number") || is("integer") || space == text.npos ? 1 : std::stoul(text.substr(space + 1));
  }
};

Value wrong(std::string error) { return {"", "0", std::move(error)}; }

// Number of doubles that an object of the type consists of; 0 if it holds anything else.
std::uint64_t doubles_in(QualType type, ASTContext const &context) {
  if (Reals::is_double(type) && !type->isReferenceType()) return 1;
  if (auto const *array = context.getAsConstantArrayType(type))
    return array->getSize().getZExtValue() * doubles_in(array->getElementType(), context);
  auto const *record = type->getAsRecordDecl();
  record = record ? record->getDefinition() : nullptr;
  if (!record || record->isUnion()) return 0;
  if (auto const *derived = dyn_cast<CXXRecordDecl>(record);
      derived && (!derived->isStandardLayout() || !derived->isTriviallyCopyable()))
    return 0;
  std::uint64_t sum = 0;
  for (FieldDecl const *field : record->fields()) {
    std::uint64_t const count = doubles_in(field->getType(), context);
    if (count == 0) return 0;
    sum += count;
  }
  return sum;
}

std::string integer_name(QualType type) {
  if (type->isEnumeralType()) return "int";
  PrintingPolicy policy{LangOptions()};
  policy.Bool = false;
  return type.getCanonicalType().getUnqualifiedType().getAsString(policy);
}

Value scalar_or_object(QualType type, ASTContext const &context) {
  if (Reals::is_double(type) && !type->isReferenceType()) return {"number"};
  if (type->isIntegralOrEnumerationType()) return {"integer \"" + integer_name(type) + "\""};
  if (type->isRecordType())
    if (std::uint64_t const count = doubles_in(type, context)) return {"object " + std::to_string(count)};
  return wrong("is " + type.getAsString() + ", and neither a number, an integer nor made of doubles");
}

// `derivative(f_jacobian, f_hessian)` of a pragma `external`: whether each function has the form of the derivative of
// the one before it. DerivativeFunction describes the form.
class DerivativeForm {
public:
  // `given`: types of the input parameters; `numbers` and `results`: counts of the numbers in them and of the results;
  // 0 if only a call determines them.
  DerivativeForm(ASTContext &context, std::vector<QualType> given, std::size_t numbers, std::size_t results)
      : context_(context),
        given_(std::move(given)),
        numbers_(numbers),
        partials_(numbers * results) {}

  // Error message if it cannot be the next derivative, else empty.
  std::string add(FunctionDecl const *derivative) {
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
  // Text of the derivatives for the graph.
  std::string const &text() const { return text_; }

private:
  // A derivative takes pointers to const, even for the function's output parameters.
  bool is_same_parameter(QualType wanted, QualType found) const {
    if (!wanted->isPointerType() || !found->isPointerType())
      return context_.hasSameUnqualifiedType(wanted.getCanonicalType(), found.getCanonicalType());
    return found->getPointeeType().isConstQualified() &&
           context_.hasSameUnqualifiedType(wanted->getPointeeType(), found->getPointeeType());
  }

  std::string form() const {
    std::string parameters;
    for (QualType type : given_) {
      if (type->isPointerType()) type = context_.getPointerType(type->getPointeeType().withConst());
      parameters += type.getAsString() + ", ";
    }
    std::string const size = partials_ == 0 ? "" : std::to_string(partials_);
    return "it should be void (" + parameters + "double partials[" + size + "])";
  }

  ASTContext &context_;
  std::vector<QualType> given_;
  std::size_t numbers_, partials_; // of the next derivative
  std::string text_;
};

class Resolver {
public:
  Resolver(ASTContext &context, SourceMap const &map, Facts &facts, Reals &reals)
      : context_(context),
        map_(map),
        facts_(facts),
        reals_(reals) {}

  void resolve(ExternalPragma const &pragma) {
    FunctionDecl const *function = look_up(pragma.function, pragma.name_place, pragma.configured.has_value());
    if (function && pragma.configured) facts_.configured_externals.insert(*pragma.configured);
    if (!function || !is_callable(pragma.function, pragma.name_place, function)) return;
    std::string text, sizes;
    std::vector<QualType> given;
    std::size_t numbers = 0, results = 0; // among its inputs, and among its outputs
    if (!function->getReturnType()->isVoidType()) {
      Value const returned = scalar_or_object(function->getReturnType(), context_);
      if (!returned.error.empty())
        return refuse(pragma.name_place, "what '" + pragma.function + "' returns " + returned.error);
      text = "returns " + returned.text;
      results = returned.count();
    }
    bool any_size = false, good = check_names(pragma, function);
    for (unsigned i = 0; i < function->getNumParams(); ++i) {
      Value const value = parameter(pragma, function, i);
      if (!value.error.empty()) {
        refuse(pragma.name_place, "parameter " + name_of(function, i) + " of '" + pragma.function + "' " + value.error);
        good = false;
      }
      text += (i != 0 ? " " : text.empty() ? "takes " : " takes ") + value.text;
      sizes += (i == 0 ? "" : " ") + value.size;
      any_size |= value.size != "0";
      if (!value.is("output")) given.push_back(function->getParamDecl(i)->getType());
      if (!value.is("output") && !value.is("integer")) numbers += value.count();
      if (value.is("output") || value.is("updated")) results += value.count();
    }
    if (!good) return;
    DerivativeForm form(context_, std::move(given), any_size ? 0 : numbers, results);
    if (!add_derivatives(pragma, form)) return;
    text += form.text();
    std::string const arguments = in_quotes(function->getNameAsString()) + (pragma.pure ? ", true, " : ", false, ") +
                                  in_quotes(text) + ", " + in_quotes(any_size ? sizes : "") + ", " +
                                  place_words(map_.place(function->getLocation()));
    reals_.add_external(function, {arguments, pragma.pure});
    declare(function, pragma.name_place);
  }

private:
  void refuse(Place const &place, std::string message, DiagnosticId id = DiagnosticId::external_function) {
    add_diagnostic(facts_, {id, place, std::move(message)});
  }

  void declare(FunctionDecl const *function, Place const &place) {
    facts_.externals.emplace(ASTNameGenerator(context_).getName(function), Note{place, function->getNameAsString()});
    keep_linkage(function);
  }

  // The functions that give derivatives, each that of the one before it.
  bool add_derivatives(ExternalPragma const &pragma, DerivativeForm &form) {
    for (auto const &[name, place] : pragma.derivatives) {
      FunctionDecl const *derivative = look_up(name, place, false);
      if (!derivative || !is_callable(name, place, derivative)) return false;
      std::string const why = pragma.pure ? form.add(derivative) : "'" + pragma.function + "' is not said to be pure";
      if (!why.empty()) {
        refuse(place, "'" + name + "' cannot be the derivative: " + why, DiagnosticId::external_derivative);
        return false;
      }
      declare(derivative, place);
    }
    return true;
  }

  FunctionDecl const *look_up(std::string const &function_name, Place const &place, bool may_be_elsewhere) {
    DeclContext const *scope = context_.getTranslationUnitDecl();
    llvm::StringRef rest = function_name;
    rest.consume_front("::");
    while (true) {
      auto const [name, inner] = rest.split("::");
      DeclContext const *next = nullptr;
      for (NamedDecl const *found : scope->lookup(&context_.Idents.get(name))) {
        if (auto const *shadow = dyn_cast<UsingShadowDecl>(found)) found = shadow->getTargetDecl();
        if (auto const *function = dyn_cast<FunctionDecl>(found); function && inner.empty()) return function;
        if (isa<NamespaceDecl>(found)) next = cast<NamespaceDecl>(found);
      }
      if (!next || inner.empty()) break;
      scope = next;
      rest = inner;
    }
    if (!may_be_elsewhere)
      refuse(place, "no function '" + function_name + "' is declared in this file",
             DiagnosticId::pragma_undeclared_name);
    return nullptr;
  }

  bool is_callable(std::string const &function_name, Place const &place, FunctionDecl const *function) {
    std::string const name = "'" + function_name + "' ";
    std::string why;
    if (isa<CXXMethodDecl>(function) || !function->isExternC())
      why = "has C++ linkage: the generated C cannot name it";
    else if (!function->isExternallyVisible())
      why = "is static";
    else if (function->isDefined())
      why = "is defined in the sources, so its calls are recorded as they are";
    else if (function->isVariadic() || !function->getType()->getAs<FunctionProtoType>())
      why = "has no prototype that tells its parameters";
    if (!why.empty()) refuse(place, name + why);
    return why.empty();
  }

  // The parameter's name may stand in another declaration than the first.
  static std::string name_of(FunctionDecl const *function, unsigned index) {
    for (FunctionDecl const *declaration : function->redecls())
      if (std::string const name = declaration->getParamDecl(index)->getNameAsString(); !name.empty())
        return "'" + name + "'";
    return std::to_string(index + 1);
  }
  static std::optional<unsigned> index_of(FunctionDecl const *function, std::string const &name) {
    for (unsigned i = 0; i < function->getNumParams(); ++i)
      for (FunctionDecl const *declaration : function->redecls())
        if (declaration->getParamDecl(i)->getName() == name) return i;
    return std::nullopt;
  }

  bool check_names(ExternalPragma const &pragma, FunctionDecl const *function) {
    bool good = true;
    for (auto const *items : {&pragma.inputs, &pragma.outputs})
      for (ExternalPragma::Item const &item : *items)
        if (std::optional<unsigned> const index = index_of(function, item.name); !index) {
          refuse(item.place, "'" + item.name + "' is not a parameter of '" + pragma.function + "'",
                 DiagnosticId::pragma_undeclared_name);
          good = false;
        } else if (!function->getParamDecl(*index)->getType()->isPointerType()) {
          refuse(item.place, "'" + item.name + "' is not an array: only what a pointer points to needs a size");
          good = false;
        } else if (items == &pragma.outputs && points_to_const(function->getParamDecl(*index)->getType())) {
          refuse(item.place, "'" + item.name + "' points to const and cannot be an output");
          good = false;
        }
    return good;
  }

  bool points_to_const(QualType pointer) const {
    return context_.getBaseElementType(pointer->getPointeeType()).isConstQualified();
  }

  static ExternalPragma::Item const *find(std::vector<ExternalPragma::Item> const &items, FunctionDecl const *function,
                                          unsigned index) {
    for (ExternalPragma::Item const &item : items)
      if (index_of(function, item.name) == index) return &item;
    return nullptr;
  }

  Value parameter(ExternalPragma const &pragma, FunctionDecl const *function, unsigned index) {
    QualType const type = function->getParamDecl(index)->getType();
    if (!type->isPointerType()) return scalar_or_object(type, context_);
    QualType const pointee = type->getPointeeType();
    std::uint64_t const unit = doubles_in(pointee, context_);
    if (unit == 0) return wrong("is " + type.getAsString() + ", which does not point to doubles");
    ExternalPragma::Item const *input = find(pragma.inputs, function, index);
    ExternalPragma::Item const *output = find(pragma.outputs, function, index);
    std::string const kind = points_to_const(type) ? "input " : input ? "updated " : "output ";
    for (ExternalPragma::Item const *item : {input, output})
      if (item && !item->lengths.empty()) return sized(kind, unit, *item, function);
    if (auto const *decayed = type->getAs<DecayedType>())
      if (auto const *array = context_.getAsConstantArrayType(decayed->getOriginalType()))
        return {kind + std::to_string(array->getSize().getZExtValue() * unit)};
    if (Reals::is_double(pointee)) return wrong("does not say how many doubles it points to");
    return {kind + std::to_string(unit)};
  }

  Value sized(std::string const &kind, std::uint64_t unit, ExternalPragma::Item const &item,
              FunctionDecl const *function) {
    // Each section is one dimension; extents of the declared type are known already.
    QualType rest = function->getParamDecl(*index_of(function, item.name))->getType()->getPointeeType();
    for (std::size_t k = 1; k < item.lengths.size(); ++k) {
      auto const *array = context_.getAsConstantArrayType(rest);
      if (!array) return wrong("has fewer dimensions than its sections");
      rest = array->getElementType();
      if (item.lengths[k] != std::to_string(array->getSize().getZExtValue()))
        return wrong("is declared with another size than '" + item.lengths[k] + "'");
    }
    std::string const &length = item.lengths[0];
    if (std::optional<std::uint64_t> const number = constant(length)) {
      if (*number == 0) return wrong("has no elements");
      return {kind + std::to_string(*number * unit)};
    }
    std::optional<unsigned> const index = index_of(function, length);
    if (!index || !function->getParamDecl(*index)->getType()->isIntegralOrEnumerationType())
      return wrong("has the size '" + length + "', which is neither a number nor an integer parameter");
    return {kind + "1", std::to_string(unit) + "*$" + std::to_string(*index)};
  }

  // A number, an enumerator, or a constant.
  std::optional<std::uint64_t> constant(std::string const &text) {
    if (std::uint64_t value = 0; !llvm::StringRef(text).getAsInteger(0, value)) return value;
    for (NamedDecl const *found : context_.getTranslationUnitDecl()->lookup(&context_.Idents.get(text))) {
      if (auto const *enumerator = dyn_cast<EnumConstantDecl>(found))
        return static_cast<std::uint64_t>(enumerator->getInitVal().getExtValue());
      auto const *variable = dyn_cast<VarDecl>(found);
      Expr::EvalResult value;
      if (variable && variable->getType().isConstQualified() && variable->hasInit() &&
          variable->getInit()->EvaluateAsInt(value, context_))
        return static_cast<std::uint64_t>(value.Val.getInt().getExtValue());
    }
    return std::nullopt;
  }

  // A C source is compiled as C++, where a declaration must say that the name is a C one.
  void keep_linkage(FunctionDecl const *function) {
    if (map_.language().CPlusPlus) return;
    for (FunctionDecl const *declaration : function->redecls()) {
      if (!map_.in_roots(declaration->getLocation())) continue;
      if (std::optional<Span> const span = map_.range(declaration->getSourceRange()))
        facts_.wraps.insert({*span, Use::linkage, ""});
      else
        refuse(map_.place(declaration->getLocation()), "this declaration is partly made by a macro");
    }
  }

  ASTContext &context_;
  SourceMap const &map_;
  Facts &facts_;
  Reals &reals_;
};

// Calls with effects that the language lets happen in either order: the symbolic program need not have them in the
// order of the original.
class Order : public Walk {
public:
  Order(SourceMap const &map, Facts &facts, Reals const &reals) : map_(map), facts_(facts), reals_(reals) {}

  bool VisitBinaryOperator(BinaryOperator *binary) override {
    if (!binary->isLogicalOp() && !binary->isCommaOp())
      check({binary->getLHS(), binary->getRHS()}, binary->getOperatorLoc());
    return true;
  }
  bool VisitCallExpr(CallExpr *call) override {
    check({call->arg_begin(), call->arg_end()}, call->getBeginLoc());
    return true;
  }

private:
  class Effects : public Walk {
  public:
    explicit Effects(Reals const &reals) : reals_(reals) {}
    bool TraverseLambdaExpr(LambdaExpr *) override { return true; }
    bool VisitCallExpr(CallExpr *call) override {
      FunctionDecl const *function = call->getDirectCallee();
      Reals::External const *external = function ? reals_.external(function) : nullptr;
      found = found || (external && !external->pure);
      return !found;
    }
    bool found = false;

  private:
    Reals const &reals_;
  };

  void check(std::vector<Expr *> const &operands, SourceLocation location) {
    int count = 0;
    for (Expr *operand : operands) {
      Effects effects(reals_);
      effects.TraverseStmt(operand);
      count += effects.found;
    }
    if (count < 2 || !map_.in_roots(location)) return;
    facts_.diagnostics.push_back({DiagnosticId::external_function,
                                  map_.place(location),
                                  "the language does not say which of these external functions is called first",
                                  {{{}, "put the calls into statements of their own, or say that they are pure"}}});
  }

  SourceMap const &map_;
  Facts &facts_;
  Reals const &reals_;
};

} // namespace

void collect_externals(ASTContext &context, SourceMap const &map, PragmaIndex const &index, Facts &facts,
                       Reals &reals) {
  Resolver resolver(context, map, facts, reals);
  for (ExternalPragma const &pragma : index.externals) resolver.resolve(pragma);
  if (std::ranges::all_of(index.externals, &ExternalPragma::pure)) return;
  for (Decl *declaration : context.getTranslationUnitDecl()->decls())
    if (map.in_roots(declaration->getLocation())) Order(map, facts, reals).TraverseDecl(declaration);
}

} // namespace symreal::rewrite
