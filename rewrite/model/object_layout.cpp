#include "rewrite/model/object_layout.h"

#include "rewrite/model/library.h"
#include "rewrite/model/scalar_state.h"
#include "rewrite/model/signature.h"

#include <clang/AST/RecordLayout.h>

namespace symreal::rewrite {
using namespace clang;

namespace {

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
    return ScalarState::is_integer(type) && !is_text_character(type) && size(type) <= 8;
  }

  bool of_record(RecordDecl const *record, QualType type, std::string const &path, std::string &text) {
    if (!record) return false;
    if (auto const *derived = dyn_cast<CXXRecordDecl>(record)) {
      if (ScalarState::has_value_of_its_own(type)) {
        if (reals_.mentions_real(type)) result_.pointers.push_back(path);
        return text += "o1", true;
      }
      if (is_std_class(derived, "complex")) return text += "[2]d", true;
      if (is_std_class(derived, "array")) return shape(derived->field_begin()->getType(), path, text);
      if (QualType const element = element_of(derived); !element.isNull())
        return of_container(type, element, path, text);
      bool const is_opaque = derived->isInStdNamespace() && !is_std_class(derived, "pair");
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

// Whether all that an object consists of are numbers; the first member that is something else.
std::string other_than_number(QualType type, ASTContext const &context) {
  type = type.getCanonicalType().getUnqualifiedType();
  if (auto const *array = context.getAsConstantArrayType(type))
    return other_than_number(array->getElementType(), context);
  RecordDecl const *record = type->getAsRecordDecl();
  if (!record || !record->getDefinition())
    return type->isSpecificBuiltinType(BuiltinType::Double) ? "" : type.getAsString();
  if (auto const *derived = dyn_cast<CXXRecordDecl>(record->getDefinition())) {
    if (is_std_class(derived, "complex")) return "";
    if (QualType const element = element_of(derived->getDefinition()); !element.isNull())
      return other_than_number(element.getNonReferenceType(), context);
    for (CXXBaseSpecifier const &base : derived->bases())
      if (std::string const inner = other_than_number(base.getType(), context); !inner.empty()) return inner;
    if (derived->isPolymorphic()) return "its virtual functions";
  }
  for (FieldDecl const *field : record->getDefinition()->fields()) {
    std::string const inner = other_than_number(field->getType(), context);
    if (!inner.empty())
      return field->getType()->isRecordType() ? inner : "'" + field->getNameAsString() + "' (" + inner + ")";
  }
  return "";
}

bool may_be_made(CXXRecordDecl const *record) {
  if (is_std_class(record, "pair")) return true; // by a template
  if (!record->hasDefaultConstructor()) return false;
  if (record->needsImplicitDefaultConstructor()) return true;
  return std::any_of(record->ctor_begin(), record->ctor_end(), [](CXXConstructorDecl const *one) {
    return one->isDefaultConstructor() && !one->isDeleted() && one->getAccess() == AS_public;
  });
}

bool has_public_members(CXXRecordDecl const *record) {
  for (CXXBaseSpecifier const &base : record->bases())
    if (auto const *inner = base.getType()->getAsCXXRecordDecl();
        base.getAccessSpecifier() != AS_public || !inner || !has_public_members(inner->getDefinition()))
      return false;
  return std::all_of(record->field_begin(), record->field_end(), [](FieldDecl const *field) {
    auto const *inner = field->getType()->getBaseElementTypeUnsafe()->getAsCXXRecordDecl();
    bool const is_walked = inner && (is_std_class(inner, "complex") || !element_of(inner->getDefinition()).isNull());
    return field->getAccess() == AS_public && (!inner || is_walked || has_public_members(inner->getDefinition()));
  });
}

// The members of an object that are not numbers, by their places.
void add_others(QualType type, std::int64_t offset, ASTContext const &context, std::string &others) {
  type = type.getCanonicalType().getUnqualifiedType();
  std::int64_t const size = context.getTypeSizeInChars(type).getQuantity();
  if (auto const *array = context.getAsConstantArrayType(type)) {
    std::int64_t const each = context.getTypeSizeInChars(array->getElementType()).getQuantity();
    for (std::int64_t at = 0; at < size && each != 0; at += each)
      add_others(array->getElementType(), offset + at, context, others);
    return;
  }
  auto const add = [&](std::string const &what) { others += what + "+" + std::to_string(offset) + ";"; };
  bool const is_single = type->isSpecificBuiltinType(BuiltinType::Float);
  if (is_constant_text(type)) return add("t");
  if (type->isPointerType()) return add("p");
  if (type->isIntegralOrEnumerationType() || is_single) return add("b" + std::to_string(size));
  RecordDecl const *record = type->getAsRecordDecl();
  record = record ? record->getDefinition() : nullptr;
  if (!record || record->isUnion()) return;
  ASTRecordLayout const &layout = context.getASTRecordLayout(record);
  auto const *derived = dyn_cast<CXXRecordDecl>(record);
  constexpr std::int64_t text_size = 32; // of libstdc++
  if (is_std_class(derived, "basic_string") && size == text_size) return add("s");
  if (derived && derived->isInStdNamespace() && !is_std_class(derived, "pair") && !is_std_class(derived, "array"))
    return;
  if (derived)
    for (CXXBaseSpecifier const &base : derived->bases())
      if (auto const *shared = base.getType()->getAsCXXRecordDecl(); shared && !base.isVirtual() && !shared->isEmpty())
        add_others(base.getType(), offset + layout.getBaseClassOffset(shared).getQuantity(), context, others);
  for (FieldDecl const *field : record->fields())
    if (!field->isBitField())
      add_others(field->getType(),
                 offset +
                     static_cast<std::int64_t>(layout.getFieldOffset(field->getFieldIndex())) / context.getCharWidth(),
                 context, others);
}

} // namespace

bool is_constant_text(QualType type) {
  QualType const to = type->getPointeeType();
  return !to.isNull() && to.isConstQualified() && to->isCharType();
}

QualType element_of(CXXRecordDecl const *record) {
  if (has_function(record, "rows") && has_function(record, "cols"))
    if (QualType const element = element_by(record, OO_Call, 2); !element.isNull()) return element;
  return has_function(record, "size") ? element_by(record, OO_Subscript, 1) : QualType();
}

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

ReturnedObject returned_object(FunctionDecl const *function) {
  using Form = ReturnedObject::Form;
  ASTContext const &context = function->getASTContext();
  QualType const type = function->getReturnType();
  ReturnedObject object;
  if (type->isVoidType()) return object;
  object.type = declared(type.getUnqualifiedType(), "", context);
  // The copy of the source that has it is where it is named.
  constexpr llvm::StringLiteral unwritten = "(anonymous namespace)::";
  for (std::size_t at; (at = object.type.find(unwritten)) != object.type.npos;) object.type.erase(at, unwritten.size());
  if (type->isReferenceType() || type->isPointerType())
    object.obstacle = "it returns a " + std::string(type->isPointerType() ? "pointer" : "reference");
  if (!object.obstacle.empty() || type->isDependentType()) return object;
  if (type->isIntegralOrEnumerationType()) object.form = Form::integer;
  if (type->isAnyComplexType()) object.obstacle = "it returns a complex number of C";
  RecordDecl const *record = type->getAsRecordDecl();
  if (!record || !record->getDefinition()) return object;
  std::string const other = other_than_number(type, context);
  if (!other.empty()) object.obstacle = "what it returns has more than numbers: " + other;
  if (!type->isDependentType()) add_others(type, 0, context, object.others);
  object.form = Form::members;
  auto const *derived = dyn_cast<CXXRecordDecl>(record->getDefinition());
  if (!derived || !object.obstacle.empty()) return object;
  bool const is_walked = is_std_class(derived, "complex") || !element_of(derived).isNull();
  if (is_walked)
    object.form = Form::walked;
  else if (!has_public_members(derived) || !may_be_made(derived))
    object.form = Form::bytes;
  if (object.form == Form::walked && !may_be_made(derived))
    object.obstacle = "what it returns cannot be made without arguments";
  if (object.form == Form::bytes && !derived->isTriviallyCopyable())
    object.obstacle =
        "what it returns has private members or cannot be made without arguments, and cannot be copied as bytes";
  return object;
}

} // namespace symreal::rewrite
