#include "rewrite/model/library.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

struct FunctionRow {
  unsigned traits;
  llvm::StringRef effect;
};

llvm::StringMap<FunctionRow> const &functions() {
  using namespace library;
  static llvm::StringMap<FunctionRow> const rows = {
#define FUNCTION(name, traits, effect) {name, {traits, effect}},
#include "rewrite/model/library.def"
  };
  return rows;
}

struct ClassRow {
  llvm::StringRef scope, name;
  unsigned traits;
};

llvm::StringRef name_of(NamedDecl const *declaration) {
  return declaration && declaration->getDeclName().isIdentifier() ? declaration->getName() : llvm::StringRef();
}

CXXRecordDecl const *class_of(QualType type) {
  CXXRecordDecl const *record = type.getNonReferenceType()->getAsCXXRecordDecl();
  return record && record->hasDefinition() ? record->getDefinition() : nullptr;
}

// Whether the record is one of these templates of the standard library, or derived from one.
bool is_one_of_std(CXXRecordDecl const *record, llvm::ArrayRef<llvm::StringRef> names) {
  if (!record) return false;
  if (record->isInStdNamespace() && llvm::is_contained(names, name_of(record))) return true;
  return llvm::any_of(record->bases(),
                      [&](CXXBaseSpecifier const &base) { return is_one_of_std(class_of(base.getType()), names); });
}

bool is_file(QualType type) {
  auto const *record = type->getAsRecordDecl();
  llvm::StringRef const name = name_of(record);
  return name == "_IO_FILE" || name == "__sFILE" || name == "FILE";
}

} // namespace

bool library::has(llvm::StringRef function, Function trait) {
  return (functions().lookup(function).traits & trait) != 0;
}

llvm::StringRef library::environment_effect(llvm::StringRef function) { return functions().lookup(function).effect; }

bool library::has(llvm::StringRef method, Method trait) {
  static llvm::StringMap<unsigned> const rows = {
#define METHOD(name, traits) {name, traits},
#include "rewrite/model/library.def"
  };
  return (rows.lookup(method) & trait) != 0;
}

bool library::has(llvm::StringRef scope, llvm::StringRef class_name, Class trait) {
  static ClassRow const rows[] = {
#define CLASS(scope, name, traits) {scope, name, traits},
#include "rewrite/model/library.def"
  };
  return llvm::any_of(rows, [&](ClassRow const &row) {
    return row.name == class_name && row.scope == scope && (row.traits & trait) != 0;
  });
}

// Functions and variables of the C library's headers (glibc's, with all that g++ makes them declare). The program's own
// names are compared with these: symbolic mode includes more headers than the program does.
bool is_library_name(llvm::StringRef name) {
  constexpr llvm::StringLiteral names =
#include "rewrite/model/library_names.def"
      ;
  static llvm::StringSet<> const known = [names] {
    llvm::SmallVector<llvm::StringRef> words;
    names.split(words, ' ', /*MaxSplit=*/-1, /*KeepEmpty=*/false);
    llvm::StringSet<> set;
    set.insert(words.begin(), words.end());
    return set;
  }();
  return known.contains(name);
}

bool is_std_function(FunctionDecl const *function, std::initializer_list<llvm::StringRef> names) {
  if (!function->isInStdNamespace() || !function->getDeclName().isIdentifier()) return false;
  return llvm::is_contained(names, function->getName());
}

bool is_std_class(CXXRecordDecl const *record, llvm::StringRef name) {
  return record && record->isInStdNamespace() && record->getIdentifier() && record->getName() == name;
}

bool moves_bytes(FunctionDecl const *function) {
  llvm::StringRef name = function->getDeclName().isIdentifier() ? function->getName() : "operator delete";
  if (name.consume_front("__builtin_")) name.consume_back("_chk");
  return library::has(name, library::MOVES_BYTES);
}

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
         is_one_of_std(method->getParent(), {"basic_string", "basic_string_view", "basic_istream", "basic_ostream"});
}

bool compares_keys(CXXMethodDecl const *method) {
  if (!library::has(name_of(method), library::COMPARES_KEYS) && method->getOverloadedOperator() != OO_Subscript)
    return false;
  return is_one_of_std(method->getParent(), {"map", "multimap", "set", "multiset", "unordered_map",
                                             "unordered_multimap", "unordered_set", "unordered_multiset"});
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

bool is_text_character(QualType type) {
  return type->isAnyCharacterType() && !type->isSpecificBuiltinType(BuiltinType::SChar) &&
         !type->isSpecificBuiltinType(BuiltinType::UChar);
}

bool is_string(QualType type) { return is_one_of_std(class_of(type), {"basic_string", "basic_string_view"}); }

bool is_source(QualType type) {
  type = type.getNonReferenceType();
  return is_one_of_std(class_of(type), {"basic_istream"}) || (type->isPointerType() && is_file(type->getPointeeType()));
}

bool is_text(QualType type) {
  type = type.getNonReferenceType();
  if (auto const *array = type->getAsArrayTypeUnsafe()) return is_character(array->getElementType());
  if (type->isPointerType()) return is_character(type->getPointeeType()) || is_file(type->getPointeeType());
  return is_string(type) || is_one_of_std(class_of(type), {"basic_istream", "basic_ostream"});
}

bool keeps_text(QualType type) {
  return is_one_of_std(class_of(type),
                       {"basic_ostringstream", "basic_stringstream", "basic_ofstream", "basic_fstream"});
}

} // namespace symreal::rewrite
