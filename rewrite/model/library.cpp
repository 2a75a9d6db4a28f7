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

} // namespace

unsigned function(llvm::StringRef name) { return functions().lookup(name).traits; }

llvm::StringRef environment_effect(llvm::StringRef function) { return functions().lookup(function).effect; }

unsigned method(llvm::StringRef name) {
  static llvm::StringMap<unsigned> const rows = {
#define METHOD(name, traits) {name, traits},
#include "rewrite/model/library.def"
  };
  return rows.lookup(name);
}

unsigned class_in(llvm::StringRef scope, llvm::StringRef name) {
  static llvm::StringMap<unsigned> const rows = {
#define CLASS(scope, name, traits) {scope "::" name, traits},
#include "rewrite/model/library.def"
  };
  return rows.lookup((scope + "::" + name).str());
}

} // namespace symreal::rewrite::library
