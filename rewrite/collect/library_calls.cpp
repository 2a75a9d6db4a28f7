// Calls of functions that are not rewritten: conversions of numbers within the standard library
// (<symreal/library_conversions.h>), results of functions that are compiled elsewhere or that read a library's state,
// and the calls that the pragmas stand for (<symreal/symbolic_main.h>).
#include "rewrite/collect/handlers.h"
#include "rewrite/model/effects.h"
#include "rewrite/model/library.h"
#include "rewrite/model/object_layout.h"
#include "rewrite/text/pragma_text.h"

#include <clang/Tooling/Inclusions/StandardLibrary.h>

namespace symreal::rewrite {
using namespace clang;

namespace {

bool is_plain_number(QualType type) { return type->isArithmeticType() && !Reals::is_double(type); }

// Element type of a pointer or iterator; null for any other type.
QualType element_type(QualType iterator) {
  iterator = iterator.getNonReferenceType();
  if (iterator->isPointerType()) return iterator->getPointeeType().getUnqualifiedType();
  CXXRecordDecl const *record = iterator->getAsCXXRecordDecl();
  if (!record || !record->hasDefinition()) return {};
  for (CXXMethodDecl const *method : record->getDefinition()->methods())
    if (method->getOverloadedOperator() == OO_Star && method->getNumParams() == 0)
      return method->getReturnType().getNonReferenceType().getUnqualifiedType();
  return {};
}

bool is_of_doubles(Expr const *iterator) {
  QualType const element = element_type(iterator->getType());
  return !element.isNull() && Reals::is_double(element);
}

FunctionDecl const *called(Expr const *callable) {
  callable = callable->IgnoreImplicit();
  if (CXXRecordDecl const *lambda = callable->getType()->getAsCXXRecordDecl(); lambda && lambda->isLambda())
    return lambda->getLambdaCallOperator();
  auto const *name = dyn_cast<DeclRefExpr>(callable);
  return name ? dyn_cast<FunctionDecl>(name->getDecl()) : nullptr;
}

// Index of the output iterator among an algorithm's arguments; 0 for other functions.
unsigned output_of(llvm::StringRef algorithm, unsigned arguments) {
  if (algorithm == "copy" || algorithm == "copy_n" || algorithm == "copy_if" || algorithm == "move" ||
      algorithm == "partial_sum" || algorithm == "adjacent_difference")
    return 2;
  return algorithm == "transform" ? arguments - 2 : 0;
}

// `errno` expands to the target of a pointer that a function of the C library returns.
bool is_error_number(Expr const *expression) {
  auto const *target = dyn_cast<UnaryOperator>(expression->IgnoreParens());
  if (!target || target->getOpcode() != UO_Deref) return false;
  auto const *call = dyn_cast<CallExpr>(target->getSubExpr()->IgnoreParenImpCasts());
  FunctionDecl const *function = call ? call->getDirectCallee() : nullptr;
  if (!function || !function->getDeclName().isIdentifier()) return false;
  return library::has(function->getName(), library::ERROR_NUMBER);
}

// Whether the function has a hook that reports its results to the recording.
bool is_watched(llvm::StringRef name) {
  static llvm::StringSet<> const names = {
#define OUTSIDE(result, symbol, name, parameters, arguments) #symbol,
#include "engine/support/outside.def"
#undef OUTSIDE
  };
  return names.contains(name);
}

bool is_standard(FunctionDecl const *function) {
  if (function->isInStdNamespace() || function->getBuiltinID() != 0) return true;
  if (!function->getDeclName().isIdentifier()) return false;
  llvm::StringRef const name = function->getName();
  using tooling::stdlib::Lang;
  using tooling::stdlib::Symbol;
  return is_watched(name) || Symbol::named("", name, Lang::C) || Symbol::named("std::", name, Lang::CXX);
}

bool has_variable(NamedVariables const &named) {
  return llvm::any_of(named.read, [](VarDecl const *variable) { return !variable->getType().isConstQualified(); });
}

class LibraryConversions : public SyntaxHandler {
public:
  explicit LibraryConversions(SyntaxTable &table) : SyntaxHandler(table) {
    on<CXXConstructExpr>(NUMBERS, &LibraryConversions::kept_callable);
    on<CallExpr>(NUMBERS, &LibraryConversions::converted_by_library);
  }

private:
  // A std::function with an integer or a float as its result, of a callable with a double.
  void kept_callable(CXXConstructExpr const *construction) {
    auto const *type = dyn_cast<ClassTemplateSpecializationDecl>(construction->getConstructor()->getParent());
    if (!is_std_class(type, "function") || construction->getNumArgs() != 1) return;
    auto const *signature = type->getTemplateArgs()[0].getAsType()->getAs<FunctionProtoType>();
    FunctionDecl const *function = called(construction->getArg(0));
    if (!signature || !function || !reals_.in_roots(function) || !Reals::is_double(function->getReturnType())) return;
    if (is_plain_number(signature->getReturnType()))
      wrap(construction->getArg(0)->IgnoreImplicit(), Use::before,
           "::symreal::SymrealReturning<" + spelled(signature->getReturnType()) + ">() ->*");
  }

  void converted_by_library(CallExpr const *call) {
    FunctionDecl const *function = call->getDirectCallee();
    if (call->isTypeDependent() || !function || !function->getIdentifier() || call->getNumArgs() < 2) return;
    llvm::StringRef const name = function->getName();
    if (auto const *method = dyn_cast<CXXMethodDecl>(function)) {
      if (name != "assign" && name != "insert") return;
      unsigned const first = call->getNumArgs() - 2;
      Expr const *begin = call->getArg(first), *end = call->getArg(first + 1);
      auto const *container = dyn_cast<ClassTemplateSpecializationDecl>(method->getParent());
      if (!container || !container->isInStdNamespace() || !is_of_doubles(begin) || !is_of_doubles(end)) return;
      TemplateArgument const &value = container->getTemplateArgs()[0];
      if (value.getKind() != TemplateArgument::Type || !is_plain_number(value.getAsType())) return;
      for (Expr const *side : {begin, end})
        wrap(side->IgnoreImpCasts(), Use::before,
             "::symreal::SymrealReading<" + spelled(value.getAsType()) + ">() ->*");
      return;
    }
    if (!function->isInStdNamespace()) return;
    if (name == "accumulate" || name == "inner_product") {
      Expr const *initial = call->getNumArgs() > 2 ? call->getArg(name == "accumulate" ? 2 : 3) : nullptr;
      QualType const total = initial ? initial->getType() : QualType();
      if (initial && is_plain_number(total) && is_of_doubles(call->getArg(0)))
        wrap(initial->IgnoreImpCasts(), Use::conversion, "::symreal::SymrealTotal<" + spelled(total) + ">");
      return;
    }
    unsigned const at = output_of(name, call->getNumArgs());
    if (at == 0 || at >= call->getNumArgs()) return;
    QualType const element = element_type(call->getArg(at)->getType());
    FunctionDecl const *function_of_elements = name == "transform" ? called(call->getArg(at + 1)) : nullptr;
    bool const gives_double = name == "transform"
                                  ? function_of_elements && Reals::is_double(function_of_elements->getReturnType())
                                  : is_of_doubles(call->getArg(0));
    if (!element.isNull() && is_plain_number(element) && gives_double)
      wrap(call->getArg(at)->IgnoreImpCasts(), Use::before, "::symreal::SymrealWriting() ->*");
  }
};

class LibraryState : public SyntaxHandler {
public:
  explicit LibraryState(SyntaxTable &table) : SyntaxHandler(table) {
    on<CallExpr>(RUNNING, &LibraryState::environment_of_call);
    on<CallExpr>(RUNNING, &LibraryState::call_outside);
    on<CXXMemberCallExpr>(RUNNING, &LibraryState::stream_asked);
    on<ImplicitCastExpr>(RUNNING, &LibraryState::error_read);
    on<BinaryOperator>(RUNNING, &LibraryState::error_assigned);
  }

private:
  // errno, and the flags and modes of floating-point arithmetic, are state that a kernel may read or set beside its
  // numbers. Notes the whole expression, up to the macro of a library that makes it.
  void environment(Expr const *expression, char const *what, std::string const &name) {
    SourceManager const &sources = map_.sources();
    SourceLocation begin = expression->getBeginLoc(), end = expression->getEndLoc();
    if (!map_.in_roots(begin)) return;
    while (begin.isMacroID() && !map_.token(begin)) begin = sources.getImmediateExpansionRange(begin).getBegin();
    while (end.isMacroID() && !map_.token(end)) end = sources.getImmediateExpansionRange(end).getEnd();
    std::optional<Span> const span = map_.range({begin, end});
    if (!span)
      return report(DiagnosticId::split_expression, begin,
                    "a macro makes a part of this expression: Symreal does not see " + name + " in it");
    facts_.wraps.insert({*span, Use::environment,
                         std::string(what) + ", " + in_quotes(name) + ", " + in_quotes(to_string(map_.place(begin)))});
  }

  void environment_of_call(CallExpr const *call) {
    FunctionDecl const *function = call->getDirectCallee();
    if (!function || !function->getDeclName().isIdentifier() || reals_.in_roots(function)) return;
    std::string const name = function->getName().str();
    if (llvm::StringRef const what = library::environment_effect(name); !what.empty())
      environment(call, "environment", name + ", which " + what.str());
  }

  void error_read(ImplicitCastExpr const *cast) {
    Expr const *value = cast->getSubExpr();
    if (cast->getCastKind() == CK_LValueToRValue && !cast->isTypeDependent() && is_error_number(value))
      environment(value->IgnoreParens(), "error_read", "errno");
  }

  void error_assigned(BinaryOperator const *assignment) {
    Expr const *target = assignment->getLHS();
    if (assignment->isAssignmentOp() && is_error_number(target))
      environment(target->IgnoreParens(), assignment->isCompoundAssignmentOp() ? "error_read" : "error_written",
                  "errno");
  }

  // Results of functions are baked in like other state. Those of the standard library are known (support/outside.def);
  // `external` declares others.
  void call_outside(CallExpr const *call) {
    FunctionDecl const *function = call->getDirectCallee();
    if (!function || call->isTypeDependent() || !map_.in_roots(call->getBeginLoc())) return;
    FunctionDecl const *pattern = Reals::pattern(function);
    if (reals_.in_roots(pattern) || reals_.external(function) || reals_.is_math(function) || is_standard(function))
      return;
    if (function->isConstexpr() || function->hasAttr<ConstAttr>() || isa<CXXOperatorCallExpr>(call)) return;
    QualType const type = call->getType();
    if (!type->isArithmeticType() || reals_.is_real(call)) return;
    bool const is_number = type->isFloatingType();
    FunctionDecl const *definition = nullptr;
    if (function->isDefined(definition)) {
      if (!is_number || !definition->getBody() || !has_variable(named_variables_.of(definition))) return;
    } else if (!is_number && map_.sources().isInSystemHeader(function->getLocation()))
      return; // a function of the system, such as open()
    environment(call, "outside", function->getQualifiedNameAsString() + "()");
  }

  // The format and the state of a stream that the whole program has.
  void stream_asked(CXXMemberCallExpr const *call) {
    CXXMethodDecl const *method = call->getMethodDecl();
    if (!method || !method->getDeclName().isIdentifier() || !method->getParent()->isInStdNamespace() ||
        call->getNumArgs() != 0)
      return;
    constexpr llvm::StringLiteral asked[] = {"precision", "width", "flags",   "fill",       "good",  "fail",
                                             "bad",       "eof",   "rdstate", "exceptions", "gcount"};
    auto const *object = dyn_cast<DeclRefExpr>(call->getImplicitObjectArgument()->IgnoreParenImpCasts());
    auto const *variable = object ? dyn_cast<VarDecl>(object->getDecl()) : nullptr;
    if (!llvm::is_contained(asked, method->getName()) || !variable || !variable->hasGlobalStorage()) return;
    environment(call, "outside", variable->getQualifiedNameAsString() + "." + method->getName().str() + "()");
  }

  NamedVariableAnalysis named_variables_;
};

// Calls by hand of what the pragmas stand for.
class SymbolicMain : public SyntaxHandler {
public:
  explicit SymbolicMain(SyntaxTable &table) : SyntaxHandler(table) {
    on<CallExpr>(NUMBERS, &SymbolicMain::symbolic_main);
  }

private:
  void symbolic_main(CallExpr const *call) {
    FunctionDecl const *function = call->getDirectCallee();
    if (!function || !function->getDeclName().isIdentifier() || call->getNumArgs() == 0) return;
    llvm::StringRef const called = function->getName();
    if (called == "generate_code") {
      auto const *name = dyn_cast<StringLiteral>(call->getArg(0)->IgnoreParenImpCasts());
      if (!name) return;
      Place const place = map_.place(call->getBeginLoc());
      facts_.by_hand.push_back({.name = {},
                                .is_function = false,
                                .by_hand = true,
                                .place = place,
                                .output_file = name->getString().str(),
                                .signature = {},
                                .annotations = {},
                                .source = place.file});
    }
    bool const annotates = called == "input" || called == "parameter" || called == "output";
    if (annotates && call->getNumArgs() >= 2 &&
        map_.sources().getFilename(function->getLocation()).ends_with("symreal/symbolic_main.h"))
      annotated_structure(call->getArg(1));
  }

  // The header knows numbers and containers; a structure's layout is passed to it here.
  void annotated_structure(Expr const *argument) {
    Expr const *object = argument->IgnoreParenImpCasts();
    DescribedObject const described = describe_object(object->getType(), false, context_, reals_);
    if (!described.refusal.empty())
      return report(DiagnosticId::pragma_item, object->getBeginLoc(),
                    "this object " + described.refusal + ": name the numbers that are meant");
    if (described.layout.text.empty()) return;
    std::optional<Span> const span = map_.range(argument->getSourceRange());
    if (!span)
      return report(DiagnosticId::pragma_item, object->getBeginLoc(),
                    "an object whose expression comes from a macro cannot be annotated: name it here");
    std::string types;
    for (std::string const &type : described.layout.containers) types += (types.empty() ? "" : ", ") + type;
    StringRef const text = Lexer::getSourceText(CharSourceRange::getTokenRange(argument->getSourceRange()),
                                                map_.sources(), map_.language());
    facts_.wraps.insert({*span, Use::instead,
                         "::symreal::symreal_laid_out<" + types + ">(\"" + described.layout.text +
                             "\", __builtin_addressof(" + text.str() + "))"});
  }
};

} // namespace

void add_library_calls(SyntaxTable &table) {
  table.add<LibraryConversions>();
  table.add<LibraryState>();
  table.add<SymbolicMain>();
}

} // namespace symreal::rewrite
