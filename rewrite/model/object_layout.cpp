#include "rewrite/model/object_layout.h"

#include "rewrite/model/plain_declaration.h"

#include "rewrite/model/scalar_state.h"

#include <clang/AST/QualTypeNames.h>
#include <clang/AST/RecordLayout.h>

namespace symreal::rewrite {
namespace {

using namespace clang;

std::string number(std::int64_t value) { return std::to_string(value); }

// The first function of this name that the class or a base of it has.
template <class Wanted> CXXMethodDecl const *find_method(CXXRecordDecl const *record, Wanted wanted) {
  for (CXXMethodDecl const *method : record->methods())
    if (wanted(method)) return method;
  for (CXXBaseSpecifier const &base : record->bases())
    if (auto const *shared = base.getType()->getAsCXXRecordDecl(); shared && shared->hasDefinition())
      if (CXXMethodDecl const *method = find_method(shared->getDefinition(), wanted)) return method;
  return nullptr;
}

bool has_function(CXXRecordDecl const *record, llvm::StringRef name) {
  return find_method(record, [name](CXXMethodDecl const *method) {
    return method->getIdentifier() && method->getName() == name && method->getNumParams() == 0;
  });
}

// Type that `object[i]` or `object(i, j)` refers to; null if the operator returns a copy or does not exist.
QualType element_by(CXXRecordDecl const *record, OverloadedOperatorKind kind, unsigned parameters) {
  CXXMethodDecl const *method = find_method(record, [=](CXXMethodDecl const *one) {
    return one->getOverloadedOperator() == kind && one->getNumParams() == parameters &&
           one->getReturnType()->isLValueReferenceType();
  });
  return method ? method->getReturnType().getNonReferenceType() : QualType();
}

bool is_standard(CXXRecordDecl const *record, llvm::StringRef name) {
  return record->isInStdNamespace() && record->getIdentifier() && record->getName() == name;
}

} // namespace

QualType element_of(CXXRecordDecl const *record) {
  if (has_function(record, "rows") && has_function(record, "cols"))
    if (QualType const element = element_by(record, OO_Call, 2); !element.isNull()) return element;
  return has_function(record, "size") ? element_by(record, OO_Subscript, 1) : QualType();
}

namespace {

class Description {
public:
  Description(ASTContext const &context, Reals const &reals, DescribedObject &result)
      : context_(context),
        reals_(reals),
        result_(result) {}

  // Appends the shape of the type; whether there is anything in it.
  bool shape(QualType type, std::string const &path, std::string &text) {
    type = type.getCanonicalType().getUnqualifiedType();
    if (auto const *array = context_.getAsConstantArrayType(type)) {
      text += "[" + number(static_cast<std::int64_t>(array->getSize().getZExtValue())) + "]";
      return shape(array->getElementType(), path, text);
    }
    if (Reals::is_double(type)) return text += "d", true;
    if (is_counted(type)) {
      text += (type->isSignedIntegerOrEnumerationType() ? "i" : "u") + number(size(type));
      return true;
    }
    if (ScalarState::is_function_pointer(type)) return text += "p" + number(size(type)), true;
    if (ScalarState::is_floating(type)) {
      result_.others.push_back(path);
      return text += "f" + number(size(type)), true;
    }
    if (RecordDecl const *record = type->getAsRecordDecl()) return of_record(record->getDefinition(), type, path, text);
    bool const refers = type->isPointerType() || type->isReferenceType();
    if (refers && reals_.mentions_real(type)) result_.pointers.push_back(path);
    if (type->isPointerType()) return text += "t" + number(size(type)), true;
    if (!refers && (type->isRealFloatingType() || type->isAnyComplexType() || type->isIncompleteArrayType()))
      result_.others.push_back(path);
    return false;
  }

  bool has_members = false; // or something else that a walk over the type does not reach

private:
  std::int64_t size(QualType type) const { return context_.getTypeSizeInChars(type).getQuantity(); }

  // Text is data of another kind.
  bool is_counted(QualType type) const {
    bool const is_text = type->isAnyCharacterType() && !type->isSpecificBuiltinType(BuiltinType::SChar) &&
                         !type->isSpecificBuiltinType(BuiltinType::UChar);
    return ScalarState::is_integer(type) && !is_text && size(type) <= 8;
  }

  bool of_record(RecordDecl const *record, QualType type, std::string const &path, std::string &text) {
    if (!record) return false;
    if (auto const *derived = dyn_cast<CXXRecordDecl>(record)) {
      if (ScalarState::has_value_of_its_own(type)) {
        if (reals_.mentions_real(type)) result_.pointers.push_back(path);
        return text += "o1", true;
      }
      if (is_standard(derived, "complex")) return text += "[2]d", true;
      if (is_standard(derived, "array")) return shape(derived->field_begin()->getType(), path, text);
      if (QualType const element = element_of(derived); !element.isNull())
        return of_container(type, element, path, text);
      bool const is_opaque = derived->isInStdNamespace() && !is_standard(derived, "pair");
      if (is_opaque || (!reals_.in_roots(record) && !reals_.carries_real(type))) {
        if (reals_.mentions_real(type)) result_.pointers.push_back(path);
        return false;
      }
      if (derived->getNumVBases() > 0 && reals_.carries_real(type)) return refuse(path, "has a virtual base");
    }
    if (record->isUnion()) {
      if (reals_.carries_real(type)) return refuse(path, "is a union, and which of its members counts is not known");
      return false;
    }
    std::string list;
    members(record, 0, path, list);
    if (list.empty()) return false;
    has_members = true;
    text += "{" + list + "}" + number(size(type));
    return true;
  }

  bool refuse(std::string const &path, std::string const &reason) {
    if (result_.refusal.empty()) result_.refusal = (path.empty() ? "" : "has a member '" + path + "', which ") + reason;
    return false;
  }

  bool of_container(QualType type, QualType element, std::string const &path, std::string &text) {
    std::string inner;
    bool const had_members = std::exchange(has_members, false);
    bool const any = shape(element, path, inner);
    has_members = has_members || had_members;
    if (!any) return false;
    text += "@" + number(static_cast<std::int64_t>(result_.layout.containers.size())) + "," + number(size(type)) + ":" +
            inner;
    result_.layout.containers.push_back(type_text(type, context_));
    return true;
  }

  // Members of bases and of unnamed members count as the class's own.
  void members(RecordDecl const *record, std::int64_t begin, std::string const &path, std::string &list) {
    ASTRecordLayout const &layout = context_.getASTRecordLayout(record);
    if (auto const *derived = dyn_cast<CXXRecordDecl>(record))
      for (CXXBaseSpecifier const &base : derived->bases()) {
        auto const *shared = base.getType()->getAsCXXRecordDecl();
        if (!base.isVirtual() && !shared->isEmpty())
          members(shared->getDefinition(), begin + layout.getBaseClassOffset(shared).getQuantity(), path, list);
      }
    for (FieldDecl const *field : record->fields()) {
      if (field->isBitField()) continue; // no address, and its reads are not checked either
      std::int64_t const offset =
          begin + context_.toCharUnitsFromBits(static_cast<std::int64_t>(layout.getFieldOffset(field->getFieldIndex())))
                      .getQuantity();
      RecordDecl const *unnamed = field->getIdentifier() ? nullptr : field->getType()->getAsRecordDecl();
      std::string const name = field->getNameAsString(), here = path.empty() ? name : path + "." + name;
      if (unnamed && !unnamed->isUnion()) {
        members(unnamed->getDefinition(), offset, path, list);
        continue;
      }
      std::string what;
      if (shape(field->getType(), unnamed ? here + "(anonymous)" : here, what))
        list += name + "+" + number(offset) + ":" + what + ";";
    }
  }

  ASTContext const &context_;
  Reals const &reals_;
  DescribedObject &result_;
};

} // namespace

DescribedObject describe_object(QualType type, bool is_packed, ASTContext const &context, Reals const &reals) {
  DescribedObject result;
  if (type.isNull()) return result;
  type = type.getNonReferenceType();
  if (type->isDependentType() || type->isIncompleteType()) return result;
  Description description(context, reals, result);
  std::string text;
  description.shape(type, "", text);
  bool const is_needed = description.has_members || is_packed;
  if (!is_needed || !reals.carries_real(type))
    result.layout = {};
  else
    result.layout.text = text;
  return result;
}

} // namespace symreal::rewrite
