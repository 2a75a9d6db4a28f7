#include "rewrite/model/text_functions.h"

#include "rewrite/model/library.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

llvm::StringRef name_of(NamedDecl const *declaration) {
  return declaration && declaration->getDeclName().isIdentifier() ? declaration->getName() : llvm::StringRef();
}

CXXRecordDecl const *class_of(QualType type) {
  CXXRecordDecl const *record = type.getNonReferenceType()->getAsCXXRecordDecl();
  return record && record->hasDefinition() ? record->getDefinition() : nullptr;
}

// Whether the record is one of these templates of the standard library, or derived from one.
bool is_standard(CXXRecordDecl const *record, llvm::ArrayRef<llvm::StringRef> names) {
  if (!record) return false;
  if (record->isInStdNamespace() && llvm::is_contained(names, name_of(record))) return true;
  return llvm::any_of(record->bases(),
                      [&](CXXBaseSpecifier const &base) { return is_standard(class_of(base.getType()), names); });
}

bool is_file(QualType type) {
  auto const *record = type->getAsRecordDecl();
  llvm::StringRef const name = name_of(record);
  return name == "_IO_FILE" || name == "__sFILE" || name == "FILE";
}

} // namespace

TextUse text_use(FunctionDecl const *function) {
  if (isa<CXXMethodDecl>(function)) return TextUse::none;
  llvm::StringRef name = name_of(function);
  name.consume_front("__builtin_");
  if (library::has(name, library::TEXT_TO_MEMORY)) return TextUse::memory;
  if (library::has(name, library::TEXT_TO_FILE)) return TextUse::outside;
  return library::has(name, library::READS_TEXT) ? TextUse::reader : TextUse::none;
}

bool reads_its_text(CXXMethodDecl const *method) {
  return library::has(name_of(method), library::READS_ITS_TEXT) &&
         is_standard(method->getParent(), {"basic_string", "basic_string_view", "basic_istream", "basic_ostream"});
}

bool compares_keys(CXXMethodDecl const *method) {
  if (!library::has(name_of(method), library::COMPARES_KEYS) && method->getOverloadedOperator() != OO_Subscript)
    return false;
  return is_standard(method->getParent(), {"map", "multimap", "set", "multiset", "unordered_map", "unordered_multimap",
                                           "unordered_set", "unordered_multiset"});
}

bool is_character(QualType type) {
  auto const *builtin = type->getAs<BuiltinType>();
  if (!builtin) return false;
  switch (builtin->getKind()) {
  case BuiltinType::Char_S:
  case BuiltinType::Char_U:
  case BuiltinType::SChar:
  case BuiltinType::UChar:
  case BuiltinType::WChar_S:
  case BuiltinType::WChar_U:
  case BuiltinType::Char16:
  case BuiltinType::Char32:
  case BuiltinType::Char8: return true;
  default: return false;
  }
}

bool is_string(QualType type) { return is_standard(class_of(type), {"basic_string", "basic_string_view"}); }

bool is_source(QualType type) {
  type = type.getNonReferenceType();
  return is_standard(class_of(type), {"basic_istream"}) || (type->isPointerType() && is_file(type->getPointeeType()));
}

bool is_text(QualType type) {
  type = type.getNonReferenceType();
  if (auto const *array = type->getAsArrayTypeUnsafe()) return is_character(array->getElementType());
  if (type->isPointerType()) return is_character(type->getPointeeType()) || is_file(type->getPointeeType());
  return is_string(type) || is_standard(class_of(type), {"basic_istream", "basic_ostream"});
}

bool keeps_text(QualType type) {
  return is_standard(class_of(type), {"basic_ostringstream", "basic_stringstream", "basic_ofstream", "basic_fstream"});
}

} // namespace symreal::rewrite
