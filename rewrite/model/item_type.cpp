#include "rewrite/model/item_type.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

std::vector<std::string> words_of(std::string const &text) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (isAsciiIdentifierContinue(text[i]))
      while (end < text.size() && isAsciiIdentifierContinue(text[end])) ++end;
    else if (text.compare(i, 2, "->") == 0 || text.compare(i, 2, "::") == 0)
      end = i + 2;
    if (!isWhitespace(text[i])) words.push_back(text.substr(i, end - i));
    i = end;
  }
  return words;
}

bool is_packed_member(ValueDecl const *member) {
  auto const *field = dyn_cast<FieldDecl>(member);
  return field && (field->hasAttr<PackedAttr>() || field->getParent()->hasAttr<PackedAttr>() ||
                   field->getParent()->hasAttr<MaxFieldAlignmentAttr>());
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
  Reader(std::string const &expression, FunctionDecl const *function,
         llvm::function_ref<ValueDecl const *(std::string const &)> look_up)
      : words_(words_of(expression)),
        function_(function),
        context_(function->getASTContext()),
        look_up_(look_up) {}

  ItemType run() {
    QualType const type = item();
    if (type.isNull() || at_ != words_.size()) return {};
    return {type, is_packed_};
  }

private:
  bool is(std::string const &text) const { return at_ < words_.size() && words_[at_] == text; }
  bool accept(std::string const &text) { return is(text) && (++at_, true); }

  QualType item() {
    if (accept("*")) return pointee(item());
    if (accept("&")) {
      QualType const type = item();
      return type.isNull() ? type : context_.getPointerType(type);
    }
    QualType type = primary();
    while (!type.isNull()) {
      if (accept("."))
        type = member(type);
      else if (accept("->"))
        type = member(pointee(type));
      else if (is("["))
        skip(), type = element(type);
      else if (is("("))
        skip(), type = type->isFunctionType() ? object(type->castAs<FunctionType>()->getReturnType()) : QualType();
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
      auto const *method = dyn_cast<CXXMethodDecl>(function_);
      return method && method->isInstance() ? method->getThisType() : QualType();
    }
    DeclContext const *scope = accept("::") ? context_.getTranslationUnitDecl() : nullptr;
    while (at_ < words_.size() && isAsciiIdentifierStart(words_[at_][0])) {
      std::string const name = words_[at_++];
      if (!accept("::")) return declared(scope ? find(scope, name) : look_up_(name));
      scope = inner_scope(scope, name);
      if (!scope) break;
    }
    return {};
  }

  // Those whose names the function's own scopes see.
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
    return object(declaration->getType());
  }

  QualType member(QualType type) {
    if (type.isNull() || at_ == words_.size()) return {};
    return declared(find_member(type->getAsRecordDecl(), &context_.Idents.get(words_[at_++])));
  }

  QualType by_operator(QualType type, OverloadedOperatorKind kind) {
    ValueDecl const *method = find_member(type->getAsRecordDecl(), context_.DeclarationNames.getCXXOperatorName(kind));
    is_packed_ = false;
    return method ? object(method->getType()->castAs<FunctionType>()->getReturnType()) : QualType();
  }

  QualType pointee(QualType type) {
    if (type.isNull()) return type;
    if (type->isArrayType()) return element(type);
    is_packed_ = false;
    return type->isPointerType() ? object(type->getPointeeType()) : by_operator(type, OO_Star);
  }

  QualType element(QualType type) {
    if (type->isArrayType()) return type->getAsArrayTypeUnsafe()->getElementType(); // as packed as the array
    is_packed_ = false;
    return type->isPointerType() ? object(type->getPointeeType()) : by_operator(type, OO_Subscript);
  }

  void skip() {
    int depth = 0;
    do {
      std::string const &word = words_[at_++];
      depth += (word == "(" || word == "[") - (word == ")" || word == "]");
    } while (depth > 0 && at_ < words_.size());
  }

  std::vector<std::string> words_;
  std::size_t at_ = 0;
  FunctionDecl const *function_;
  ASTContext &context_;
  llvm::function_ref<ValueDecl const *(std::string const &)> look_up_;
  bool is_packed_ = false;
};

} // namespace

ItemType type_of_item(std::string const &expression, FunctionDecl const *function,
                      llvm::function_ref<ValueDecl const *(std::string const &)> look_up) {
  return Reader(expression, function, look_up).run();
}

ItemType type_of_item(Expr const *expression) {
  ItemType result{expression->getType(), false};
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
