// Whole objects that may outlive a kernel and that are given to code that is not rewritten: what it reads and changes
// there is noted where they are given.
#include "rewrite/collect/collector.h"
#include "rewrite/model/library.h"
#include "rewrite/model/text_functions.h"

#include <llvm/ADT/StringSwitch.h>

namespace symreal::rewrite {
using namespace clang;

namespace {

std::string name_of(FunctionDecl const *function) {
  return function->getDeclName().isIdentifier() ? function->getName().str() : std::string();
}

// What a library's member function does with the numbers of its object, where the name says more than the type.
enum class Effect { reads, overwrites, changes, nothing };

Effect effect(CXXMethodDecl const *method) {
  static llvm::StringMap<Effect> const known = {
      {"assign", Effect::overwrites},      {"fill", Effect::overwrites},         {"clear", Effect::overwrites},
      {"reset", Effect::overwrites},       {"setZero", Effect::overwrites},      {"setOnes", Effect::overwrites},
      {"setConstant", Effect::overwrites}, {"setIdentity", Effect::overwrites},  {"setRandom", Effect::overwrites},
      {"setUnit", Effect::overwrites},     {"setLinSpaced", Effect::overwrites}, {"noalias", Effect::overwrites},
      {"push_back", Effect::changes},      {"emplace_back", Effect::changes},    {"pop_back", Effect::changes},
      {"push_front", Effect::changes},     {"emplace_front", Effect::changes},   {"pop_front", Effect::changes},
      {"resize", Effect::changes},         {"reserve", Effect::changes},         {"insert", Effect::changes},
      {"emplace", Effect::changes},        {"erase", Effect::changes},           {"shrink_to_fit", Effect::changes},
      {"size", Effect::nothing},           {"empty", Effect::nothing},           {"rows", Effect::nothing},
      {"cols", Effect::nothing},           {"capacity", Effect::nothing},        {"max_size", Effect::nothing},
      {"innerStride", Effect::nothing},    {"outerStride", Effect::nothing},
  };
  auto const found = known.find(name_of(method));
  return found == known.end() ? Effect::reads : found->second;
}

// A container of the standard library is asked how many elements it has.
bool asks_count(CXXMethodDecl const *method) {
  std::string const name = name_of(method);
  return (name == "size" || name == "empty") && method->getParent()->isInStdNamespace() &&
         !is_string(method->getThisType()->getPointeeType());
}

// Functions of <algorithm> and <numeric> that only write to the range they are given.
bool only_writes(FunctionDecl const *function) {
  return function->isInStdNamespace() && library::has(name_of(function), library::ONLY_WRITES);
}

// The same with what a function of the caller gives, which may read the range.
bool asks_caller(FunctionDecl const *function) { return llvm::StringRef(name_of(function)).starts_with("generate"); }

// Which argument of a function of <algorithm> or <numeric> says where it writes, and reads nothing; else -1u.
unsigned output_of(FunctionDecl const *function, std::size_t arguments) {
  if (!function->isInStdNamespace() || arguments < 3) return -1u;
  return llvm::StringSwitch<unsigned>(name_of(function))
      .Cases("copy", "copy_if", "copy_n", "move", "reverse_copy", "partial_sum", "adjacent_difference", 2)
      .Case("transform", static_cast<unsigned>(arguments) - 2)
      .Default(-1u);
}

// v.begin(), v.end() - 1 or their like, as an argument of such a function.
CXXMemberCallExpr const *iterator(Expr const *argument) {
  for (;;) {
    argument = argument->IgnoreUnlessSpelledInSource();
    auto const *step = dyn_cast<CXXOperatorCallExpr>(argument);
    if (!step || (step->getOperator() != OO_Plus && step->getOperator() != OO_Minus)) break;
    argument = step->getArg(0);
  }
  return dyn_cast<CXXMemberCallExpr>(argument);
}

bool is_parameter(Expr const *expression) {
  auto const *reference = dyn_cast<DeclRefExpr>(expression);
  return reference && isa<ParmVarDecl>(reference->getDecl());
}

bool is_same_variable(Expr const *one, Expr const *other) {
  auto const *first = dyn_cast<DeclRefExpr>(spelled_expression(one));
  auto const *second = dyn_cast<DeclRefExpr>(spelled_expression(other));
  return first && second && first->getDecl() == second->getDecl();
}

} // namespace

// An object, array or view as a whole.
void Collector::object(Expr const *expression, Use use) {
  expression = spelled_expression(expression);
  QualType const type = expression->getType();
  if (expression->isTypeDependent() || type->isPointerType() || Reals::is_double(type)) return;
  if (!expression->isGLValue() && !Storage::is_view(type)) return;
  if (!type->isRecordType() && !type->isArrayType()) return;
  // Text is looked at where it is read, and an argument such as a function is the caller's choice, as a count is.
  if (is_string(type) || (is_parameter(expression) && ScalarState::is_opaque(type))) return;
  bool const is_pointer = use == Use::read && ScalarState::is_smart_pointer(type);
  if ((is_pointer || holds_state(type)) && may_outlive(expression)) note(expression, use);
}

// The text, the pointer to an object or the container decides what the kernel does. As an argument it is the caller's
// choice.
void Collector::decides(Expr const *expression) {
  expression = spelled_expression(expression);
  if (expression->isTypeDependent() || !expression->isGLValue() || is_parameter(expression)) return;
  if (!is_fixed(expression) && may_outlive(expression)) note(expression, Use::decides);
}

// Which function a virtual call reaches.
void Collector::dispatch(CXXMemberCallExpr const *call) {
  CXXMethodDecl const *method = call->getMethodDecl();
  auto const *callee = dyn_cast<MemberExpr>(call->getCallee()->IgnoreParens());
  if (!method || !callee || !method->isVirtual() || callee->hasQualifier()) return;
  if (method->hasAttr<FinalAttr>() || method->getParent()->isEffectivelyFinal()) return;
  decides_by_pointer(callee->getBase());
}

// Through which pointer the object is reached, if it is.
void Collector::decides_by_pointer(Expr const *object) {
  if (object->isTypeDependent()) return;
  object = spelled_expression(object);
  if (auto const *star = dyn_cast<UnaryOperator>(object); star && star->getOpcode() == UO_Deref)
    object = spelled_expression(star->getSubExpr());
  else if (auto const *step = dyn_cast<CXXOperatorCallExpr>(object);
           step && (step->getOperator() == OO_Arrow || step->getOperator() == OO_Star))
    object = spelled_expression(step->getArg(0));
  else if (!object->getType()->isPointerType())
    return;
  decides(object);
}

// Whether a range begins there, and ends at the next argument; not where the pointers themselves are taken, to swap
// them.
bool Collector::begins_range(Arguments arguments, std::size_t first) const {
  if (arguments[first]->isGLValue() || first + 1 == arguments.size() || arguments[first + 1]->isTypeDependent())
    return false;
  return context_.hasSameUnqualifiedType(arguments[first]->getType(), arguments[first + 1]->getType());
}

void Collector::range(Arguments arguments, std::size_t first, Use begin, Use end) {
  if (is_fixed(arguments[first]) && !reals_.carries_real(Storage::base(arguments[first])->getType())) return;
  note(arguments[first]->IgnoreImpCasts(), begin);
  note(arguments[first + 1]->IgnoreImpCasts(), end, arguments[first]->IgnoreImpCasts());
}

void Collector::library_arguments(FunctionDecl const *function, Arguments arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    Expr const *argument = arguments[i];
    if (argument->isTypeDependent()) continue;
    QualType const type = argument->getType();
    if (auto const *call = iterator(argument); call && i == output_of(function, arguments.size())) {
      iterators_.insert(call);
    } else if (call && only_writes(function)) {
      if (!asks_caller(function)) object(call->getImplicitObjectArgument(), Use::written);
      iterators_.insert(call);
    } else if (only_writes(function) && type->isPointerType() && holds_state(type->getPointeeType())) {
      if (asks_caller(function) || !begins_range(arguments, i)) continue;
      range(arguments, i++, Use::fill_begin, Use::fill_end);
    } else if (type->isPointerType() && holds_state(type->getPointeeType()) && !is_character(type->getPointeeType())) {
      if (begins_range(arguments, i)) range(arguments, i++, Use::range_begin, Use::range_end);
    } else if (argument->isGLValue() && Reals::is_double(type)) {
      if (reals_.is_real(argument) && may_outlive(argument)) note(argument, Use::read);
    } else if (argument->isGLValue() && ScalarState::is_scalar(type)) {
      if (!isa<MaterializeTemporaryExpr>(argument->IgnoreParens())) scalar(argument->IgnoreParenImpCasts(), Use::read);
    } else
      object(argument, Use::read);
  }
}

void Collector::library_object(CallExpr const *call, FunctionDecl const *function, Expr const *object_argument) {
  auto const *method = dyn_cast<CXXMethodDecl>(function);
  if (!method || method->isStatic()) return;
  Effect const what = effect(method);
  if (compares_keys(method)) decides(object_argument);
  if (what == Effect::nothing) {
    if (asks_count(method)) decides(object_argument);
    return;
  }
  if (what == Effect::overwrites || what == Effect::changes) {
    object(object_argument, what == Effect::changes ? Use::changed : Use::written);
    return;
  }
  // An element, or a view: whoever uses it is looked at.
  QualType const type = call->getType();
  if (call->isGLValue() && reals_.carries_real(type)) return;
  if (Storage::is_view(type)) return;
  object(object_argument, Use::read);
}

void Collector::operator_call(CXXOperatorCallExpr const *call, FunctionDecl const *function) {
  Expr const *left = call->getArg(0);
  std::vector<Expr const *> const rest(call->arg_begin() + 1, call->arg_end());
  switch (call->getOperator()) {
  case OO_Equal: {
    auto const *inner = dyn_cast<CXXMemberCallExpr>(spelled_expression(left));
    bool const noalias = inner && inner->getMethodDecl() && name_of(inner->getMethodDecl()) == "noalias";
    object(noalias ? inner->getImplicitObjectArgument() : left, Use::written);
    break;
  }
  case OO_LessLess: // the comma initialiser of Eigen; a stream holds no numbers
    object(left, Use::written);
    break;
  case OO_Arrow: break; // a smart pointer: whoever uses the member behind it is looked at
  case OO_PlusEqual:
  case OO_MinusEqual:
  case OO_StarEqual:
  case OO_SlashEqual: object(left, Use::read); break;
  default:
    if (isa<CXXMethodDecl>(function))
      library_object(call, function, left);
    else
      library_arguments(function, left);
  }
  library_arguments(function, rest);
}

void Collector::state_of_call(CallExpr const *call) {
  if (auto const *member = dyn_cast<CXXMemberCallExpr>(call); member && !call->isTypeDependent()) dispatch(member);
  FunctionDecl const *function = call->getDirectCallee();
  if (!function || call->isTypeDependent()) return;
  if (iterators_.contains(call)) return;
  // A rewritten function is looked at where it stands.
  bool const rewritten = reals_.in_roots(Reals::pattern(function)) && function->getBuiltinID() == 0;
  if (rewritten && !function->isDefaulted()) return;
  if (moved_bytes(call, function)) return;
  if (auto const *operation = dyn_cast<CXXOperatorCallExpr>(call)) {
    operator_call(operation, function);
    return;
  }
  if (auto const *member = dyn_cast<CXXMemberCallExpr>(call)) {
    library_object(call, function, member->getImplicitObjectArgument());
    if (effect(member->getMethodDecl()) == Effect::changes) // v.erase(v.begin())
      for (Expr const *argument : call->arguments())
        if (auto const *at = iterator(argument);
            at && is_same_variable(at->getImplicitObjectArgument(), member->getImplicitObjectArgument()))
          iterators_.insert(at);
  }
  library_arguments(function, {call->getArgs(), call->getNumArgs()});
}

void Collector::state_of_construction(CXXConstructExpr const *construction) {
  CXXConstructorDecl const *constructor = construction->getConstructor();
  bool const rewritten = reals_.in_roots(constructor) && constructor->isUserProvided();
  if (rewritten || construction->isTypeDependent()) return;
  library_arguments(constructor, {construction->getArgs(), construction->getNumArgs()});
}

} // namespace symreal::rewrite
