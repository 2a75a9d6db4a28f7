#include "rewrite/instrument/operations.h"

#include <llvm/ADT/StringMap.h>

namespace symreal::oracle {

namespace {

// Operations spelled as calls; operators are instructions.
llvm::StringMap<Operation> make_functions() {
  enum Form { infix, prefix, call, cast, select, local, external };
  llvm::StringMap<Operation> functions;
#define OPERATION(id, arity, form, name, ...)                                                                          \
  if constexpr (form == call) functions.insert({name, {Op::id, arity}});
#include <symreal/operations.def>
#undef OPERATION
  functions.insert({"nearbyint", functions.lookup("rint")});
  return functions;
}

} // namespace

std::optional<Operation> operation_of_function(llvm::StringRef name) {
  static llvm::StringMap<Operation> const functions = make_functions();
  auto const found = functions.find(name);
  if (found == functions.end()) return std::nullopt;
  return found->second;
}

std::optional<Operation> operation_of_intrinsic(llvm::StringRef name) {
  if (!name.consume_front("llvm.") || !name.consume_back(".f64")) return std::nullopt;
  if (name == "minnum" || name == "maxnum") return operation_of_function(name == "minnum" ? "fmin" : "fmax");
  return operation_of_function(name);
}

} // namespace symreal::oracle
