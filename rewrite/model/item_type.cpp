#include "rewrite/model/item_type.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

struct Word {
  std::string text;
  std::size_t begin;
};

std::vector<Word> words_of(std::string const &text) {
  std::vector<Word> words;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (isAsciiIdentifierContinue(text[i]))
      while (end < text.size() && isAsciiIdentifierContinue(text[end])) ++end;
    else if (text.compare(i, 2, "->") == 0 || text.compare(i, 2, "::") == 0)
      end = i + 2;
    if (!isWhitespace(text[i])) words.push_back({text.substr(i, end - i), i});
    i = end;
  }
  return words;
}

bool is_packed_member(ValueDecl const *member) {
  auto const *field = dyn_cast<FieldDecl>(member);
  return field && (field->hasAttr<PackedAttr>() || field->getParent()->hasAttr<PackedAttr>() ||
                   field->getParent()->hasAttr<MaxFieldAlignmentAttr>());
}

// Whether an array declared with at most one element may have more: the last member of a structure, a member of a
// union, or a parameter in the way of Fortran's a(1).
bool may_go_on(ValueDecl const *declaration, ConstantArrayType const *array) {
  if (array->getSize().getZExtValue() > 1) return false;
  if (isa<ParmVarDecl>(declaration)) return true;
  auto const *field = dyn_cast<FieldDecl>(declaration);
  if (!field) return false;
  bool is_last = true;
  for (FieldDecl const *other : field->getParent()->fields()) is_last = other == field;
  return is_last || field->getParent()->isUnion();
}

// Number of elements of a library class whose type determines it.
std::optional<std::int64_t> count_of_class(QualType type) {
  auto const *special = dyn_cast_or_null<ClassTemplateSpecializationDecl>(type->getAsCXXRecordDecl());
  if (!special || !special->getIdentifier()) return std::nullopt;
  std::vector<std::int64_t> sizes;
  for (TemplateArgument const &one : special->getTemplateArgs().asArray())
    if (one.getKind() == TemplateArgument::Integral) sizes.push_back(one.getAsIntegral().trySExtValue().value_or(-1));
  bool const is_array = special->isInStdNamespace() && special->getName() == "array" && sizes.size() == 1;
  if (is_array && sizes[0] >= 0) return sizes[0];
  std::string const name = special->getQualifiedNameAsString();
  bool const is_vector = (name == "Eigen::Matrix" || name == "Eigen::Array") && sizes.size() >= 2 && sizes[0] > 0 &&
                         sizes[1] > 0 && (sizes[0] == 1 || sizes[1] == 1);
  return is_vector ? std::optional(sizes[0] * sizes[1]) : std::nullopt;
}

ValueDecl const *find_member(RecordDecl const *record, DeclarationName name) {
  record = record ? record->getDefinition() : nullptr;
  if (!record) return nullptr;
  for (NamedDecl const *found : record->lookup(name))
    if (auto const *value = dyn_cast<ValueDecl>(found)) return value;
  if (auto const *derived = dyn_cast<CXXRecordDecl>(record))
    for (CXXBaseSpecifier const &base : derived->bases())
      if (ValueDecl const *value = find_member(base.getType()->getAsRecordDecl(), name)) return value;
  return nullptr;
}

class Reader {
public:
  Reader(std::string const &expression, ASTContext const &context, FunctionDecl const *function, LookUp look_up)
      : words_(words_of(expression)),
        function_(function),
        context_(context),
        look_up_(look_up) {}

  ItemType run() {
    QualType const type = item();
    if (at_ != words_.size()) return {};
    if (type.isNull()) return {type, false, std::move(indices_)};
    return {type, is_packed_, std::move(indices_)};
  }

private:
  bool is(std::string const &text) const { return at_ < words_.size() && words_[at_].text == text; }
  bool accept(std::string const &text) { return is(text) && (++at_, true); }

  QualType item() {
    if (accept("*")) return pointee(item());
    if (accept("&")) {
      QualType const type = item();
      return type.isNull() ? type : context_.getPointerType(type);
    }
    std::size_t const begin = at_ < words_.size() ? words_[at_].begin : 0;
    QualType type = primary();
    while (true) { // where the type is not known any more, the words still are
      if (accept("."))
        type = member(type);
      else if (accept("->"))
        type = member(pointee(type));
      else if (is("["))
        type = indexed(type, begin);
      else if (is("("))
        skip(), type = called(type);
      else
        break;
    }
    return type;
  }

  QualType primary() {
    if (accept("(")) {
      QualType const type = item();
      return accept(")") ? type : QualType();
    }
    if (accept("this")) {
      auto const *method = dyn_cast_or_null<CXXMethodDecl>(function_);
      return method && method->isInstance() ? method->getThisType() : QualType();
    }
    bool is_qualified = accept("::"), is_known = function_ || !is_qualified;
    DeclContext const *scope = is_qualified ? context_.getTranslationUnitDecl() : nullptr;
    while (at_ < words_.size() && isAsciiIdentifierStart(words_[at_].text[0])) {
      std::string const name = words_[at_++].text;
      if (!accept("::")) return is_known ? declared(is_qualified ? find(scope, name) : look_up_(name)) : QualType();
      scope = is_known && function_ ? inner_scope(scope, name) : nullptr;
      is_qualified = true;
      is_known = scope;
    }
    return {};
  }

  // Scope with this name, visible from the function's own scopes or declared in `scope`.
  DeclContext const *inner_scope(DeclContext const *scope, std::string const &name) {
    DeclarationName const wanted = &context_.Idents.get(name);
    for (DeclContext const *here = scope ? scope : function_->getDeclContext(); here; here = here->getLookupParent()) {
      for (NamedDecl const *found : here->lookup(wanted))
        if (auto const *inner = dyn_cast<DeclContext>(found)) return inner->getPrimaryContext();
      if (scope) break;
    }
    return nullptr;
  }

  ValueDecl const *find(DeclContext const *scope, std::string const &name) {
    for (NamedDecl const *found : scope->lookup(&context_.Idents.get(name)))
      if (auto const *value = dyn_cast<ValueDecl>(found)) return value;
    return nullptr;
  }

  static QualType object(QualType type) { return type.isNull() ? type : type.getNonReferenceType(); }

  QualType declared(ValueDecl const *declaration) {
    if (!declaration) return {};
    is_packed_ = is_packed_member(declaration);
    declaration_ = declaration;
    QualType const type = object(declaration->getType());
    auto const *decayed = type->getAs<DecayedType>(); // a parameter's declared extent bounds its target
    return decayed && decayed->getOriginalType()->isConstantArrayType() ? decayed->getOriginalType() : type;
  }

  QualType member(QualType type) {
    if (at_ == words_.size()) return {};
    std::string const &name = words_[at_++].text;
    return type.isNull() ? type : declared(find_member(type->getAsRecordDecl(), &context_.Idents.get(name)));
  }

  QualType by_operator(QualType type, OverloadedOperatorKind kind) {
    ValueDecl const *method = find_member(type->getAsRecordDecl(), context_.DeclarationNames.getCXXOperatorName(kind));
    is_packed_ = false;
    return method ? object(method->getType()->castAs<FunctionType>()->getReturnType()) : QualType();
  }

  QualType called(QualType type) {
    return !type.isNull() && type->isFunctionType() ? object(type->castAs<FunctionType>()->getReturnType())
                                                    : QualType();
  }

  QualType pointee(QualType type) {
    if (type.isNull()) return type;
    if (type->isArrayType()) return element(type);
    declaration_ = nullptr;
    is_packed_ = false;
    return type->isPointerType() ? object(type->getPointeeType()) : by_operator(type, OO_Star);
  }

  QualType element(QualType type) {
    if (type.isNull()) return type;
    declaration_ = nullptr;
    if (type->isArrayType()) return type->getAsArrayTypeUnsafe()->getElementType(); // as packed as the array
    is_packed_ = false;
    return type->isPointerType() ? object(type->getPointeeType()) : by_operator(type, OO_Subscript);
  }

  QualType indexed(QualType type, std::size_t begin) {
    ItemIndex index{begin, words_[at_].begin, 0, false, std::nullopt};
    skip();
    index.close = words_[at_ - 1].begin;
    if (!type.isNull()) note_count(type, index);
    indices_.push_back(index);
    return element(type);
  }

  void note_count(QualType type, ItemIndex &index) const {
    if (auto const *array = dyn_cast_or_null<ConstantArrayType>(type->getAsArrayTypeUnsafe())) {
      index.is_unbounded = declaration_ && may_go_on(declaration_, array);
      if (!index.is_unbounded) index.count = static_cast<std::int64_t>(array->getSize().getZExtValue());
    } else if (type->isPointerType() || type->isIncompleteArrayType())
      index.is_unbounded = true;
    else
      index.count = count_of_class(type);
  }

  void skip() {
    int depth = 0;
    do {
      std::string const &word = words_[at_++].text;
      depth += (word == "(" || word == "[") - (word == ")" || word == "]");
    } while (depth > 0 && at_ < words_.size());
  }

  std::vector<Word> words_;
  std::size_t at_ = 0;
  FunctionDecl const *function_;
  ASTContext const &context_;
  LookUp look_up_;
  bool is_packed_ = false;
  ValueDecl const *declaration_ = nullptr; // of the last name
  std::vector<ItemIndex> indices_;
};

// sum     := product { ("+" | "-") product }
// product := factor { ("*" | "/" | "%") factor }
// factor  := ("+" | "-") factor | number | name | "(" sum ")"
class Calculator {
public:
  Calculator(std::string const &expression, LookUp look_up) : words_(words_of(expression)), look_up_(look_up) {}

  std::optional<std::int64_t> run() {
    std::optional<std::int64_t> const value = sum();
    return at_ == words_.size() ? value : std::nullopt;
  }

private:
  using Value = std::optional<std::int64_t>;

  char next() const { return at_ < words_.size() && words_[at_].text.size() == 1 ? words_[at_].text[0] : '\0'; }

  Value sum() {
    Value value = product();
    while (value && (next() == '+' || next() == '-')) {
      bool const adds = words_[at_++].text == "+";
      Value const other = product();
      std::int64_t result = 0;
      bool const is_too_large = !other || (adds ? __builtin_add_overflow(*value, *other, &result)
                                                : __builtin_sub_overflow(*value, *other, &result));
      value = is_too_large ? std::nullopt : Value(result);
    }
    return value;
  }

  Value product() {
    Value value = factor();
    while (value && (next() == '*' || next() == '/' || next() == '%')) {
      char const operation = words_[at_++].text[0];
      Value const other = factor();
      std::int64_t result = 0;
      if (!other || (operation != '*' && *other <= 0) || *value < INT64_MIN / 2 ||
          (operation == '*' && __builtin_mul_overflow(*value, *other, &result)))
        return std::nullopt;
      value = operation == '*' ? result : operation == '/' ? *value / *other : *value % *other;
    }
    return value;
  }

  Value factor() {
    if (at_ == words_.size()) return std::nullopt;
    std::string const &word = words_[at_++].text;
    if (word == "+") return factor();
    if (word == "-") {
      Value const value = factor();
      return value && *value != INT64_MIN ? Value(-*value) : std::nullopt;
    }
    if (word == "(") {
      Value const value = sum();
      return next() == ')' ? (++at_, value) : std::nullopt;
    }
    if (isDigit(word[0])) {
      std::int64_t value = 0;
      return llvm::StringRef(word).rtrim("uUlL").getAsInteger(0, value) ? std::nullopt : Value(value);
    }
    return isAsciiIdentifierStart(word[0]) ? declared(look_up_(word)) : std::nullopt;
  }

  static Value declared(ValueDecl const *declaration) {
    if (auto const *enumerator = dyn_cast_or_null<EnumConstantDecl>(declaration))
      return enumerator->getInitVal().trySExtValue();
    auto const *variable = dyn_cast_or_null<VarDecl>(declaration);
    Expr const *value = variable && variable->getType().isConstQualified() ? variable->getAnyInitializer() : nullptr;
    Expr::EvalResult result;
    if (!value || value->isValueDependent() || !variable->getType()->isIntegralOrEnumerationType() ||
        !value->EvaluateAsInt(result, declaration->getASTContext()))
      return std::nullopt;
    return result.Val.getInt().trySExtValue();
  }

  std::vector<Word> words_;
  std::size_t at_ = 0;
  LookUp look_up_;
};

} // namespace

ItemType type_of_item(std::string const &expression, ASTContext const &context, FunctionDecl const *function,
                      LookUp look_up) {
  return Reader(expression, context, function, look_up).run();
}

std::optional<std::int64_t> constant_of(std::string const &expression, LookUp look_up) {
  return Calculator(expression, look_up).run();
}

ItemType type_of_item(Expr const *expression) {
  ItemType result{expression->getType(), false, {}};
  while (true) {
    expression = expression->IgnoreParenImpCasts();
    if (auto const *index = dyn_cast<ArraySubscriptExpr>(expression);
        index && index->getBase()->IgnoreImpCasts()->getType()->isArrayType())
      expression = index->getBase();
    else
      break;
  }
  if (auto const *member = dyn_cast<MemberExpr>(expression))
    result.is_packed = is_packed_member(member->getMemberDecl());
  return result;
}

} // namespace symreal::rewrite
