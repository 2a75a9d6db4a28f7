// Whole objects that may outlive a kernel and that are passed to code that is not rewritten: its reads and changes are
// noted at the call.
#include "rewrite/collect/handlers.h"
#include "rewrite/collect/objects.h"
#include "rewrite/model/library.h"

#include <llvm/ADT/StringSwitch.h>

namespace symreal::rewrite {
using namespace clang;

namespace {

std::string name_of(FunctionDecl const *function) {
  return function->getDeclName().isIdentifier() ? function->getName().str() : std::string();
}

// Effect of a library's member function on the numbers of its object, if the name says more than the type.
enum class Effect { reads, overwrites, changes, nothing };

Effect effect(CXXMethodDecl const *method) {
  static llvm::StringMap<Effect> const known = {
      {"assign", Effect::overwrites},     {"fill", Effect::overwrites},        {"clear", Effect::overwrites},
      {"reset", Effect::overwrites},      {"store", Effect::overwrites},       {"setZero", Effect::overwrites},
      {"setOnes", Effect::overwrites},    {"setConstant", Effect::overwrites}, {"setIdentity", Effect::overwrites},
      {"setRandom", Effect::overwrites},  {"setUnit", Effect::overwrites},     {"setLinSpaced", Effect::overwrites},
      {"noalias", Effect::overwrites},    {"push_back", Effect::changes},      {"emplace_back", Effect::changes},
      {"pop_back", Effect::changes},      {"push_front", Effect::changes},     {"emplace_front", Effect::changes},
      {"pop_front", Effect::changes},     {"resize", Effect::changes},         {"reserve", Effect::changes},
      {"insert", Effect::changes},        {"emplace", Effect::changes},        {"erase", Effect::changes},
      {"shrink_to_fit", Effect::changes}, {"size", Effect::nothing},           {"empty", Effect::nothing},
      {"rows", Effect::nothing},          {"cols", Effect::nothing},           {"capacity", Effect::nothing},
      {"max_size", Effect::nothing},      {"innerStride", Effect::nothing},    {"outerStride", Effect::nothing},
  };
  auto const found = known.find(name_of(method));
  return found == known.end() ? Effect::reads : found->second;
}

// Whether the type is a container of the standard library with a variable number of elements.
bool counts(QualType type) {
  auto const *record = type.getNonReferenceType()->getAsCXXRecordDecl();
  return record && record->isInStdNamespace() && (Storage::owns_elements(type) || Storage::is_view(type)) &&
         record->getName() != "array" && record->getName() != "pair" && record->getName() != "tuple" &&
         record->getName() != "complex";
}

// Whether a function changes its object rather than returning a part of it. Uses of the part show changes of numbers.
bool changes_value(CXXMethodDecl const *method) {
  std::string const name = name_of(method);
  bool const shows = llvm::StringSwitch<bool>(name)
                         .Cases("at", "front", "back", "data", "begin", "end", "rbegin", "rend", true)
                         .Cases("value", "get", "find", "view", "base", true)
                         .Default(false);
  OverloadedOperatorKind const symbol = method->getOverloadedOperator();
  bool const is_access = symbol == OO_Subscript || symbol == OO_Star || symbol == OO_Arrow || symbol == OO_Call;
  return !method->isConst() && !shows && !is_access && !isa<CXXConversionDecl>(method);
}

// A container of the standard library is asked how many elements it has, or where they begin and end; a smart pointer,
// how many there are of it.
bool asks_count(CXXMethodDecl const *method) {
  bool const asks = llvm::StringSwitch<bool>(name_of(method))
                        .Cases("size", "empty", "capacity", "data", "use_count", true)
                        .Cases("begin", "end", "cbegin", "cend", true)
                        .Cases("rbegin", "rend", "crbegin", "crend", true)
                        .Default(false);
  return asks && method->getParent()->isInStdNamespace() && !is_string(method->getThisType()->getPointeeType());
}

// Functions of <algorithm> and <numeric> that only write to the range they are given.
bool only_writes(FunctionDecl const *function) {
  return function->isInStdNamespace() && library::has(name_of(function), library::ONLY_WRITES);
}

// The contents of its objects go from one to another.
bool takes_over(FunctionDecl const *function) {
  std::string const name = name_of(function);
  return name == "swap" || name == "exchange" || name == "getline";
}

// Whether the function stores results of the caller's function, which may read the range.
bool asks_caller(FunctionDecl const *function) { return llvm::StringRef(name_of(function)).starts_with("generate"); }

// Index of the output-only argument of a function of <algorithm> or <numeric>; else -1u.
unsigned output_of(FunctionDecl const *function, std::size_t arguments) {
  if (!function->isInStdNamespace() || arguments < 3) return -1u;
  return llvm::StringSwitch<unsigned>(name_of(function))
      .Cases("copy", "copy_if", "copy_n", "move", "reverse_copy", "partial_sum", "adjacent_difference", 2)
      .Cases("uninitialized_copy", "uninitialized_copy_n", "uninitialized_move", 2)
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

bool is_same_variable(Expr const *one, Expr const *other) {
  auto const *first = dyn_cast<DeclRefExpr>(spelled_expression(one));
  auto const *second = dyn_cast<DeclRefExpr>(spelled_expression(other));
  return first && second && first->getDecl() == second->getDecl();
}

class StateOfCalls : public ObjectUses {
public:
  explicit StateOfCalls(SyntaxTable &table) : ObjectUses(table) {
    on<CallExpr>(RUNNING, &StateOfCalls::call);
    on<CXXConstructExpr>(RUNNING, &StateOfCalls::state_of_construction);
    on<InitListExpr>(RUNNING, &StateOfCalls::element);
    on<CXXNewExpr>(RUNNING, &StateOfCalls::made_in_place);
  }

private:
  void element(InitListExpr const *list) {
    for (Expr const *element : converted_elements(list))
      if (auto const *made = element ? dyn_cast<CXXConstructExpr>(element->IgnoreImplicit()) : nullptr)
        state_of_construction(made);
  }

  // Notes that the object's class decides which function a virtual call reaches.
  void dispatch(CXXMemberCallExpr const *call) {
    CXXMethodDecl const *method = call->getMethodDecl();
    auto const *callee = dyn_cast<MemberExpr>(call->getCallee()->IgnoreParens());
    if (!method || !callee || !method->isVirtual() || callee->hasQualifier()) return;
    if (method->hasAttr<FinalAttr>() || method->getParent()->isEffectivelyFinal()) return;
    decides_by_pointer(callee->getBase());
  }

  // Whether a range begins there, and ends at the next argument; not where the pointers themselves are taken, to swap
  // them.
  bool begins_range(Arguments arguments, std::size_t first) const {
    if (arguments[first]->isGLValue() || first + 1 == arguments.size() || arguments[first + 1]->isTypeDependent())
      return false;
    return context_.hasSameUnqualifiedType(arguments[first]->getType(), arguments[first + 1]->getType());
  }

  void range(Arguments arguments, std::size_t first, Use begin, Use end) {
    if (is_fixed(arguments[first]) && !reals_.carries_real(Storage::base(arguments[first])->getType())) return;
    note(arguments[first]->IgnoreImpCasts(), begin);
    note(arguments[first + 1]->IgnoreImpCasts(), end, arguments[first]->IgnoreImpCasts());
  }

  // A container or a value that a library looks into as a whole; text that is printed decides nothing.
  void looked_into_whole(FunctionDecl const *function, Expr const *argument) {
    bool const prints = function->getOverloadedOperator() == OO_LessLess;
    argument = spelled_expression(argument);
    if (auto const *address = dyn_cast<UnaryOperator>(argument); address && address->getOpcode() == UO_AddrOf)
      argument = spelled_expression(address->getSubExpr()); // std::get_if<int>(&one)
    QualType const type = argument->getType();
    if (argument->isTypeDependent() || prints) return;
    bool const is_text =
        is_string(type) || (type->isArrayType() && is_character(type->getAsArrayTypeUnsafe()->getElementType()));
    auto const *method = dyn_cast<CXXMethodDecl>(function);
    bool const is_standard = method ? method->getParent()->isInStdNamespace() : function->isInStdNamespace();
    if ((is_text && is_standard) || (type->isRecordType() && (is_value(type) || counts(type)))) decides(argument);
  }

  void library_arguments(FunctionDecl const *function, Arguments arguments) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      Expr const *argument = arguments[i];
      if (argument->isTypeDependent()) continue;
      QualType const type = argument->getType();
      looked_into_whole(function, argument);
      if (type->isPointerType() && i == output_of(function, arguments.size())) target(argument);
      if (auto const *call = iterator(argument); call && i == output_of(function, arguments.size())) {
        object(call->getImplicitObjectArgument(), Use::changed);
      } else if (call && only_writes(function)) {
        if (!asks_caller(function)) object(call->getImplicitObjectArgument(), Use::written);
      } else if (only_writes(function) && type->isPointerType() && holds_state(type->getPointeeType())) {
        if (asks_caller(function)) continue;
        if (begins_range(arguments, i))
          range(arguments, i++, Use::fill_begin, Use::fill_end);
        else
          target(argument); // std::fill_n: its first
      } else if (type->isPointerType() && holds_state(type->getPointeeType()) &&
                 !is_character(type->getPointeeType())) {
        if (begins_range(arguments, i)) range(arguments, i++, Use::range_begin, Use::range_end);
      } else if (argument->isGLValue() && Reals::is_double(type)) {
        if (reals_.is_real(argument) && may_outlive(argument)) note(argument, Use::read);
      } else if (argument->isGLValue() && ScalarState::is_scalar(type)) {
        if (!isa<MaterializeTemporaryExpr>(argument->IgnoreParens()))
          scalar(argument->IgnoreParenImpCasts(), Use::read);
      } else {
        object(argument, Use::read);
        if (takes_over(function)) object(argument, Use::changed);
      }
    }
  }

  void library_object(CallExpr const *call, FunctionDecl const *function, Expr const *object_argument) {
    auto const *method = dyn_cast<CXXMethodDecl>(function);
    if (!method || method->isStatic()) return;
    Effect const what = effect(method);
    if (is_value(object_argument->getType()) && what != Effect::overwrites && changes_value(method))
      return changed_value(object_argument);
    bool const gives = !call->getType()->isVoidType();
    bool const is_viewed = is_string(object_argument->getType()) && isa<CXXConversionDecl>(method);
    if (is_viewed && !printed_.contains(call)) decides(object_argument); // text as a std::string_view
    if (compares_keys(method) || (gives && scalars_.is_unknown(object_argument->getType()))) decides(object_argument);
    if (asks_count(method)) decides(object_argument);
    if (what == Effect::nothing) return;
    if (takes_over(function)) object(object_argument, Use::changed);
    if (what == Effect::overwrites || what == Effect::changes) {
      object(object_argument, what == Effect::changes ? Use::changed : Use::written);
      return;
    }
    // An element or a view is checked where it is used.
    QualType const type = call->getType();
    bool const is_element = call->isGLValue() && reals_.carries_real(type);
    if (is_element || (Storage::holds_pointer(type) && !(call->isGLValue() && type->isPointerType())))
      leads(object_argument);
    if (is_element || Storage::is_view(type)) return;
    object(object_argument, Use::read);
  }

  void operator_call(CXXOperatorCallExpr const *call, FunctionDecl const *function) {
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
    case OO_Arrow: leads(left); break; // a smart pointer: the member behind it is checked at its use
    case OO_PlusEqual:
    case OO_MinusEqual:
    case OO_StarEqual:
    case OO_SlashEqual:
      if (is_value(left->getType())) return changed_value(left);
      object(left, Use::read);
      break;
    default:
      if (isa<CXXMethodDecl>(function))
        library_object(call, function, left);
      else
        library_arguments(function, left);
    }
    library_arguments(function, rest);
  }

  // The call's arguments of which their own calls must know, wherever the walk meets these.
  void mark(CallExpr const *call, FunctionDecl const *function) {
    auto const *operation = dyn_cast<CXXOperatorCallExpr>(call);
    if (operation && operation->getOperator() == OO_LessLess)
      for (unsigned i = 1; i < call->getNumArgs(); ++i) printed_.insert(spelled_expression(call->getArg(i)));
    auto const *member = operation ? nullptr : dyn_cast<CXXMemberCallExpr>(call);
    bool const changes = member && effect(member->getMethodDecl()) == Effect::changes; // v.erase(v.begin())
    std::size_t const first = operation ? 1 : 0, count = call->getNumArgs() - first;
    for (std::size_t i = 0; i < count; ++i) {
      auto const *at = iterator(call->getArg(static_cast<unsigned>(first + i)));
      if (!at) continue;
      bool const is_own =
          changes && is_same_variable(at->getImplicitObjectArgument(), member->getImplicitObjectArgument());
      if (is_own || i == output_of(function, count) || only_writes(function)) iterators_.insert(at);
    }
  }

  void call(CallExpr const *call) {
    if (call->isTypeDependent()) return;
    if (auto const *member = dyn_cast<CXXMemberCallExpr>(call)) dispatch(member);
    FunctionDecl const *function = call->getDirectCallee();
    if (!function) return;
    // A rewritten function is checked at its definition.
    bool const rewritten = reals_.in_roots(Reals::pattern(function)) && function->getBuiltinID() == 0;
    if (rewritten && !function->isDefaulted()) return;
    mark(call, function);
    soon([this, call, function] { state_of_call(call, function); });
  }

  void state_of_call(CallExpr const *call, FunctionDecl const *function) {
    if (iterators_.contains(call) || moved_bytes(call, function)) return;
    if (!isa<CXXMemberCallExpr, CXXOperatorCallExpr>(call) && !function->isTemplateInstantiation())
      targets(call, function);
    if (function->isInStdNamespace() && name_of(function) == "construct_at") note(call, Use::target);
    if (auto const *operation = dyn_cast<CXXOperatorCallExpr>(call)) {
      operator_call(operation, function);
      return;
    }
    if (auto const *member = dyn_cast<CXXMemberCallExpr>(call))
      library_object(call, function, member->getImplicitObjectArgument());
    library_arguments(function, {call->getArgs(), call->getNumArgs()});
  }

  // A pointer, by which a function of a library gives something back.
  void target(Expr const *pointer) {
    Expr const *at = pointer->IgnoreParenImpCasts();
    QualType const target = pointer->getType()->getPointeeType();
    if (at->isTypeDependent() || target.isNull() || target.isConstQualified() || at->getType()->isNullPtrType()) return;
    bool const is_array = at->getType()->isArrayType();
    QualType const type = is_array ? at->getType()->getAsArrayTypeUnsafe()->getElementType() : Reals::pointee(at);
    if (type.isNull()) return;
    if (at->isNullPointerConstant(context_, Expr::NPC_ValueDependentIsNotNull)) return;
    if (!is_character(type) && !ScalarState::is_scalar(type) && !Reals::is_double(type) && !type->isPointerType())
      return;
    auto const *address = dyn_cast<UnaryOperator>(at);
    Expr const *object = address && address->getOpcode() == UO_AddrOf ? address->getSubExpr() : nullptr;
    if (!object && at->getType()->isArrayType()) object = at;
    if (object && !may_outlive(object)) return;
    if (object && !ScalarState::has_address(object)) return;
    if (!isa<StringLiteral>(at)) note(at, Use::target);
  }

  void targets(CallExpr const *call, FunctionDecl const *function) {
    llvm::StringRef const name = function->getDeclName().isIdentifier() ? function->getName() : "";
    bool const is_checked = name.starts_with("__builtin_") && name.ends_with("_overflow");
    bool const is_scan = name.ends_with("scanf") || is_checked; // no parameter declares their outputs
    if (name.contains("atomic") || name == "free" ||
        (function->getBuiltinID() != 0 && name.starts_with("__builtin_va")))
      return;
    for (unsigned i = 0; i < call->getNumArgs(); ++i)
      if (i < function->getNumParams() ? function->getParamDecl(i)->getType()->isPointerType() : is_scan)
        target(call->getArg(i));
  }

  // An object is made where another one may lie.
  void made_in_place(CXXNewExpr const *made) {
    if (made->getNumPlacementArgs() == 1 && !made->isTypeDependent() && holds_state(made->getAllocatedType()) &&
        made->getPlacementArg(0)->getType()->isPointerType())
      note(made, Use::target);
  }

  void state_of_construction(CXXConstructExpr const *construction) {
    CXXConstructorDecl const *constructor = construction->getConstructor();
    bool const rewritten = reals_.in_roots(constructor) && constructor->isUserProvided();
    if (rewritten || construction->isTypeDependent()) return;
    soon([this, construction, constructor] {
      if (!printed_.contains(construction))
        library_arguments(constructor, {construction->getArgs(), construction->getNumArgs()});
    });
  }

  llvm::SmallPtrSet<Expr const *, 8> printed_;   // copies made for printing
  llvm::SmallPtrSet<Expr const *, 8> iterators_; // calls that return one without reading through it
};

} // namespace

void add_state_of_calls(SyntaxTable &table) { table.add<StateOfCalls>(); }

} // namespace symreal::rewrite
