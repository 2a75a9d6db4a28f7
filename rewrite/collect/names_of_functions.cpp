// Functions of <cmath> as values, builtins, and functions that C++20 removed.
#include "rewrite/collect/handlers.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

class NamesOfFunctions : public SyntaxHandler {
public:
  explicit NamesOfFunctions(SyntaxTable &table) : SyntaxHandler(table) {
    on<CallExpr>(NUMBERS, &NamesOfFunctions::call);
    on<DeclRefExpr>(NUMBERS, &NamesOfFunctions::function_value);
    on<DeclRefExpr>(NUMBERS, &NamesOfFunctions::builtin);
    on<CXXMemberCallExpr>(NUMBERS, &NamesOfFunctions::removed_member);
  }

private:
  void call(CallExpr const *call) {
    if (call->getDirectCallee()) callees_.insert(call->getCallee()->IgnoreParenImpCasts());
  }
  void function_value(DeclRefExpr const *name);
  void builtin(DeclRefExpr const *name);
  void removed_member(CXXMemberCallExpr const *call);

  llvm::SmallPtrSet<Expr const *, 32> callees_;
};

} // namespace

// C++20, which symbolic mode is, has functions in place of std::allocator<T>::construct and destroy.
void NamesOfFunctions::removed_member(CXXMemberCallExpr const *call) {
  auto const *callee = dyn_cast<MemberExpr>(call->getCallee());
  CXXMethodDecl const *method = call->getMethodDecl();
  if (map_.language().CPlusPlus20 || !callee || !method || !method->getParent()->isInStdNamespace() ||
      !method->getIdentifier() || callee->isArrow() || !map_.in_roots(callee->getMemberLoc()))
    return;
  bool const constructs = method->getName() == "construct", destroys = method->getName() == "destroy";
  if ((!constructs && !destroys) || method->getParent()->getName() != "__new_allocator" ||
      callee->getBase()->HasSideEffects(context_) || map_.is_argument_of(callee->getBeginLoc(), "REAL_EITHER"))
    return;
  if (std::optional<Span> const span = map_.range({callee->getBeginLoc(), callee->getMemberLoc()}))
    facts_.wraps.insert({*span, Use::instead, constructs ? "::std::construct_at" : "::std::destroy_at"});
}

// sin as a value: which of the overloads in the symbolic program, its type says.
void NamesOfFunctions::function_value(DeclRefExpr const *name) {
  auto const *function = dyn_cast<FunctionDecl>(name->getDecl());
  if (!function || !reals_.is_math(function) || function->isVariadic()) return;
  auto const is_kept = [](QualType type) { // the overload has a number there, or the original's type
    if (QualType const pointee = type->getPointeeType(); !pointee.isNull() && !type->isReferenceType()) type = pointee;
    return !type->isReferenceType() && (Reals::is_double(type) || type->isSpecificBuiltinType(BuiltinType::Int));
  };
  QualType const result = function->getReturnType();
  if (!Reals::is_double(result) && !result->isVoidType()) return;
  std::string parameters;
  bool takes_double = false;
  for (ParmVarDecl const *parameter : function->parameters()) {
    if (!is_kept(parameter->getType())) return;
    takes_double |= Reals::is_double(parameter->getType());
    parameters.append(parameters.empty() ? "" : ", ").append(spelled(parameter->getType()));
  }
  if (!takes_double) return;
  bool const is_nothrow = map_.language().CPlusPlus ? function->getType()->castAs<FunctionProtoType>()->isNothrow()
                                                    : function->hasAttr<NoThrowAttr>();
  later([this, name, type = spelled(result) + "(" + parameters + ")" + (is_nothrow ? " noexcept" : "")] {
    if (!callees_.contains(name)) wrap(name, Use::function, type);
  });
}

// __builtin_sqrt takes a double and nothing else.
void NamesOfFunctions::builtin(DeclRefExpr const *name) {
  auto const *function = dyn_cast<FunctionDecl>(name->getDecl());
  if (!function || function->getBuiltinID() == 0 || !map_.in_roots(name->getBeginLoc())) return;
  llvm::StringRef known = function->getName();
  if (!known.consume_front("__builtin_") || !Reals::is_math_name(known) || known == "sincos") return;
  // A name that a library's macro spells, or pastes, is the library's concern.
  if (std::optional<Span> const span = map_.token(name->getLocation(), function->getName()))
    note(facts_.types, *span, {Fate::converted, "SYMREAL_REAL_BUILTIN(" + known.str() + ")"});
}

void add_names_of_functions(SyntaxTable &table) { table.add<NamesOfFunctions>(); }

} // namespace symreal::rewrite
