#include "rewrite/model/library.h"

namespace symreal::rewrite::library {
namespace {

struct FunctionRow {
  unsigned traits;
  llvm::StringRef effect;
};

llvm::StringMap<FunctionRow> const &functions() {
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

} // namespace

bool has(llvm::StringRef function, Function trait) { return (functions().lookup(function).traits & trait) != 0; }

llvm::StringRef environment_effect(llvm::StringRef function) { return functions().lookup(function).effect; }

bool has(llvm::StringRef method, Method trait) {
  static llvm::StringMap<unsigned> const rows = {
#define METHOD(name, traits) {name, traits},
#include "rewrite/model/library.def"
  };
  return (rows.lookup(method) & trait) != 0;
}

bool has(llvm::StringRef scope, llvm::StringRef class_name, Class trait) {
  static ClassRow const rows[] = {
#define CLASS(scope, name, traits) {scope, name, traits},
#include "rewrite/model/library.def"
  };
  return llvm::any_of(rows, [&](ClassRow const &row) {
    return row.name == class_name && row.scope == scope && (row.traits & trait) != 0;
  });
}

} // namespace symreal::rewrite::library
