// Constructs of C that C++ does not allow and that a cast alone cannot convert.
#include "rewrite/collect/handlers.h"
#include "rewrite/model/library.h"
#include "rewrite/source/token_watch.h"
#include "rewrite/text/pragma_text.h"

#include <clang/Basic/Builtins.h>

namespace symreal::rewrite {
using namespace clang;

namespace {

// The definition or another declaration, if it has parameters.
FunctionDecl const *parameters_of_c(FunctionDecl const *function) {
  FunctionDecl const *definition = function->getDefinition();
  if (definition && definition->getNumParams() > 0) return definition;
  for (FunctionDecl const *other : function->redecls())
    if (other->hasWrittenPrototype() && other->getNumParams() > 0) return other;
  return nullptr;
}

// Before it became a pointer to const; an array is a pointer to its elements, which are const in a const object.
Expr const *as_pointer(Expr const *argument) {
  auto const *cast = dyn_cast<ImplicitCastExpr>(argument->IgnoreParens());
  return cast && cast->getCastKind() != CK_ArrayToPointerDecay ? as_pointer(cast->getSubExpr()) : argument;
}

// The name NULL is a null pointer of any type in C++ as well.
bool is_null(ImplicitCastExpr const *cast, SourceMap const &map, LangOptions const &language) {
  SourceLocation const begin = cast->getSubExpr()->getBeginLoc();
  return cast->getCastKind() == CK_NullToPointer && begin.isMacroID() &&
         Lexer::getImmediateMacroName(begin, map.sources(), language) == "NULL";
}

constexpr char const *opens_declaration = "SYMREAL_REAL_EITHER((static), extern \"C++\" { namespace { extern)";
constexpr char const *opens_definition = "SYMREAL_REAL_EITHER((static), extern \"C++\" { namespace {)";
constexpr char const *closes = "; SYMREAL_REAL_EITHER((), }})";

std::vector<VarDecl const *> definitions_of(VarDecl const *variable, ASTContext &context) {
  std::vector<VarDecl const *> found;
  for (VarDecl const *one : variable->redecls())
    if (one->isThisDeclarationADefinition(context) != VarDecl::DeclarationOnly) found.push_back(one);
  return found;
}

// Whether the written initialiser covers one element whole, rather than the first of the element's own.
bool is_whole(Expr const *written, QualType element) {
  return !element->isAggregateType() || isa<InitListExpr, StringLiteral>(written->IgnoreParens()) ||
         written->getType()->isRecordType();
}

class DeclarationsOfC : public SyntaxHandler {
public:
  explicit DeclarationsOfC(SyntaxTable &table) : SyntaxHandler(table) {
    on<NamedDecl>(ANYWHERE, &DeclarationsOfC::c_declaration);
    on<InitListExpr>(ANYWHERE, &DeclarationsOfC::designators);
  }

private:
  void c_declaration(NamedDecl const *declaration) {
    if (map_.language().CPlusPlus || !declaration->getIdentifier()) return;
    llvm::StringRef const name = declaration->getName();
    if (is_keyword_of_cpp(name) && (!is_renamed(name) || !map_.token(declaration->getLocation(), name)))
      report(DiagnosticId::c_source, declaration->getLocation(), "'" + name.str() + "' is a keyword of C++");
    if (auto const *variable = dyn_cast<VarDecl>(declaration)) tentative_definitions(variable);
    if (auto const *function = dyn_cast<FunctionDecl>(declaration)) c_prototype(function);
  }

  // A function that is declared as before C89, f() or f(a, b) double a; int b; and defined with parameters: C++ needs
  // them in the declaration. Numeric mode keeps the old text.
  void c_prototype(FunctionDecl const *function) {
    FunctionDecl const *definition = parameters_of_c(function);
    if (function->hasWrittenPrototype() || !definition || !map_.in_roots(function->getLocation())) return;
    if (!map_.in_roots(definition->getLocation())) { // known from a header, which C++ has with other words
      std::optional<Span> const name = map_.token(function->getLocation(), function->getName());
      if (name && !map_.is_argument_of(function->getLocation(), "REAL_EITHER"))
        facts_.wraps.insert({*name, Use::instead, "symreal_" + function->getNameAsString()});
      return;
    }
    std::string parameters;
    for (ParmVarDecl const *parameter : definition->parameters()) {
      std::string declarator = parameter->getNameAsString();
      PrintingPolicy policy(map_.language());
      policy.Bool = true;
      parameter->getOriginalType().getAsStringInternal(declarator, policy);
      parameters.append(parameters.empty() ? "" : ", ").append(declarator);
    }
    FunctionTypeLoc const type = function->getFunctionTypeLoc();
    if (type && map_.is_argument_of(type.getLParenLoc(), "REAL_PROTOTYPE")) return;
    SourceLocation end = type ? type.getRParenLoc().getLocWithOffset(1) : SourceLocation();
    if (function->isThisDeclarationADefinition())
      for (ParmVarDecl const *parameter : function->parameters())
        end = std::max(end, Lexer::findLocationAfterToken(parameter->getEndLoc(), tok::semi, map_.sources(),
                                                          map_.language(), /*SkipTrailingWhitespaceAndNewLine=*/false));
    std::optional<Span> const span = type ? map_.characters(type.getLParenLoc(), end) : std::nullopt;
    if (!span || map_.text(*span, type.getLParenLoc()).find('#') != std::string::npos)
      report(DiagnosticId::c_source, function->getLocation(),
             "'" + function->getNameAsString() +
                 "' is declared in the style before C89, partly by macros or under conditions");
    else
      facts_.wraps.insert({*span, Use::prototype, with_real(parameters)});
  }

  // File-scope variables of C whose rules differ in C++: constants have external linkage. Tentative definitions: C lets
  // a file define a variable several times, with at most one initialiser. For C++ all but one become declarations. A
  // static one is declared in an unnamed namespace, which gives it the same linkage.
  void tentative_definitions(VarDecl const *variable) {
    if (!variable->isFileVarDecl() || !variable->isFirstDecl()) return;
    std::vector<VarDecl const *> const all = definitions_of(variable, context_);
    bool const is_constant = context_.getBaseElementType(variable->getType()).isConstQualified();
    if (all.size() == 1 && is_constant && variable->getStorageClass() == SC_None) declare_external(variable);
    if (all.size() < 2) return;
    VarDecl const *definition = variable->getDefinition(context_);
    if (!definition) definition = variable->getActingDefinition();
    for (VarDecl const *one : all)
      if (!tentative_definition(one, one == definition))
        report(DiagnosticId::c_source, one->getLocation(),
               "'" + one->getNameAsString() + "' is defined more than once, and here not by a line of its own");
  }

  // Adds `extern` to a constant with external linkage in C.
  bool declare_external(VarDecl const *variable) {
    auto const [file, offset] = map_.sources().getDecomposedExpansionLoc(variable->getBeginLoc());
    std::optional<Span> const all = map_.range(variable->getSourceRange());
    if (!all || all->begin != offset) return false; // within a macro
    std::string_view const text = map_.sources().getBufferData(file);
    if (!text.substr(0, all->begin).ends_with("REAL_EITHER((), extern) ")) // from the rewriting before
      facts_.wraps.insert({{all->file, all->begin, all->begin + 1}, Use::declared, ""});
    return true;
  }

  // Whether the definition stands alone, as `static type name = ...;`, so that the words around it can be changed.
  bool tentative_definition(VarDecl const *variable, bool is_definition) {
    bool const is_static = variable->getStorageClass() == SC_Static;
    SourceLocation const begin = variable->getBeginLoc();
    if (map_.is_argument_of(begin, "REAL_EITHER")) return true; // from the rewriting before
    if (is_definition && !is_static) return true;
    for (Decl const *other : context_.getTranslationUnitDecl()->decls())
      if (other != variable && other->getBeginLoc() == begin && isa<DeclaratorDecl>(other)) return false;
    std::optional<Token> const next = Lexer::findNextToken(variable->getEndLoc(), map_.sources(), map_.language());
    if (!next || next->isNot(tok::semi)) return false;
    if (!is_static) return declare_external(variable);
    std::optional<Span> const first = map_.token(begin, "static"), last = map_.token(next->getLocation(), ";");
    if (!first || !last) return false;
    note(facts_.types, *first, {Fate::converted, is_definition ? opens_definition : opens_declaration});
    note(facts_.types, *last, {Fate::converted, closes});
    return true;
  }

  // C++ requires designators in the order of the members, one name each. Those of arrays compile if they skip nothing;
  // skipped elements are written out.
  void designators(InitListExpr const *list) {
    if (map_.language().CPlusPlus || !map_.in_roots(list->getBeginLoc())) return;
    InitListExpr const *written = list->isSemanticForm() ? list->getSyntacticForm() : list;
    if (!written) return;
    ArrayType const *array = context_.getAsArrayType(list->getType());
    bool is_counted = array != nullptr;
    std::uint64_t next = 0;
    for (Expr const *element : written->inits()) {
      if (auto const *designated = dyn_cast_or_null<DesignatedInitExpr>(element)) {
        DesignatedInitExpr::Designator const *first = designated->getDesignator(0);
        FieldDecl const *field = first->isFieldDesignator() ? first->getFieldDecl() : nullptr;
        Expr::EvalResult index;
        bool in_order = field && field->getFieldIndex() >= next;
        if (first->isArrayDesignator() && designated->getArrayIndex(*first)->EvaluateAsInt(index, context_))
          in_order = fill(*designated, index.Val.getInt().getLimitedValue(), next, is_counted);
        if (designated->size() != 1 || !in_order)
          return report(DiagnosticId::c_source, designated->getBeginLoc(),
                        "C++ has designators in the order of the members, and one at a time");
        if (field) next = field->getFieldIndex();
        element = designated->getInit();
      }
      is_counted = is_counted && element && is_whole(element, array->getElementType());
      ++next;
    }
  }

  // The elements between `next` and the designated one, which becomes the next. False where they cannot be written.
  bool fill(DesignatedInitExpr const &designated, std::uint64_t index, std::uint64_t &next, bool is_counted) {
    constexpr std::uint64_t most = 4096;
    if (index == next) return true;
    if (!is_counted || index < next || index - next > most) return false;
    std::string zeros;
    for (; next < index; ++next) zeros += "{}, ";
    SourceLocation const begin = designated.getBeginLoc();
    if (map_.is_argument_of(begin, "REAL_EITHER")) return true;
    std::optional<Span> const span = map_.range({begin, designated.getEqualOrColonLoc()});
    if (span) facts_.wraps.insert({*span, Use::instead, zeros});
    return span.has_value();
  }
};

class ExpressionsOfC : public SyntaxHandler {
public:
  explicit ExpressionsOfC(SyntaxTable &table) : SyntaxHandler(table) {
    on<CallExpr>(NUMBERS, &ExpressionsOfC::c_call);
    on<CallExpr>(NUMBERS, &ExpressionsOfC::c_arguments);
    on<CallExpr>(NUMBERS, &ExpressionsOfC::c_generic_call);
    on<CallExpr>(NUMBERS, &ExpressionsOfC::c_search);
    on<CallExpr>(NUMBERS, &ExpressionsOfC::kind_asked);
    on<ConditionalOperator>(ANYWHERE, &ExpressionsOfC::c_choice);
  }

private:
  void c_call(CallExpr const *call) {
    if (map_.language().CPlusPlus || call->getNumArgs() == 0 || call->getBuiltinCallee() != 0) return;
    for (Expr const *argument : call->arguments()) // an array of variable extents is taken by its address (c_arrays.h)
      if (argument->getType()->isVariablyModifiedType()) all_.settled.insert(argument);
    if (FunctionDecl const *callee = call->getDirectCallee(); callee && parameters_of_c(callee)) return;
    QualType const function = call->getCallee()->getType()->getPointeeType();
    if (!function.isNull() && function->getAs<FunctionNoProtoType>())
      report(DiagnosticId::c_source, call->getBeginLoc(),
             "a function that is declared without parameters is called with arguments");
  }

  // A mathematical function of C takes a double, and abs an int: C++ has overloads for other arguments. A builtin is
  // C's, and becomes the function of C++.
  void c_arguments(CallExpr const *call) {
    FunctionDecl const *function = call->getDirectCallee();
    if (!function || !function->getIdentifier()) return;
    bool const is_builtin = function->getName().starts_with("__builtin_"); // declared implicitly at its first use
    if (!is_builtin && (map_.language().CPlusPlus || reals_.in_roots(function))) return;
    bool const is_math = is_builtin ? Reals::is_math_name(function->getName()) : reals_.is_math(function);
    bool const is_integral = function->getName() == "abs" || function->getName() == "div";
    // The runtime's functions take a double beside a REAL.
    bool const takes_real = std::any_of(call->arg_begin(), call->arg_end(),
                                        [&](Expr const *one) { return reals_.is_real(one->IgnoreParenImpCasts()); });
    for (unsigned i = 0; i < std::min(call->getNumArgs(), function->getNumParams()); ++i) {
      auto const *cast = dyn_cast<ImplicitCastExpr>(call->getArg(i));
      if (!cast || reals_.is_real(cast->getSubExpr())) continue;
      bool const to_double = Reals::is_double(cast->getType());
      if ((is_math && to_double && cast->getCastKind() == CK_FloatingCast) ||
          (to_double && cast->getCastKind() == CK_IntegralToFloating && !takes_real)) {
        wrap(cast->getSubExpr(), Use::promoted);
        all_.settled.insert(cast);
      } else if (is_integral &&
                 (cast->getCastKind() == CK_IntegralCast || cast->getCastKind() == CK_FloatingToIntegral))
        wrap(cast->getSubExpr(), Use::cast, spelled(cast->getType()));
    }
  }

  // A function of <tgmath.h> is that of its argument's type; the C library's of this name, which C++ finds, takes a
  // double.
  void c_generic_call(CallExpr const *call) {
    FunctionDecl const *function = call->getDirectCallee();
    if (!function || !function->hasAttr<OverloadableAttr>() || reals_.in_roots(function)) return;
    auto const has = [&](auto const &wanted) {
      return llvm::any_of(function->parameters(), [&](ParmVarDecl const *one) { return wanted(one->getType()); });
    };
    bool const is_other = has([](QualType type) { return type->isRealFloatingType() && !Reals::is_double(type); });
    bool const takes_real =
        llvm::any_of(call->arguments(), [&](Expr const *one) { return reals_.is_real(one->IgnoreParenImpCasts()); });
    if (!is_other || takes_real || has([](QualType type) { return type->isAnyComplexType(); })) return;
    SourceLocation const at = call->getCallee()->IgnoreParenImpCasts()->getBeginLoc();
    std::optional<Span> const token = map_.in_roots(at) ? map_.token(at, function->getName()) : std::nullopt;
    if (token && !map_.is_argument_of(at, "REAL_EITHER"))
      facts_.wraps.insert({*token, Use::instead, "::std::" + function->getNameAsString()});
  }

  // The kind of a type, which is that of a class while the program is recorded, and a bool's in C++.
  void kind_asked(CallExpr const *call) {
    if (call->getBuiltinCallee() != Builtin::BI__builtin_classify_type || call->getNumArgs() != 1) return;
    Expr::EvalResult kind;
    bool const is_other = reals_.mentions_real(call->getArg(0)->getType()) || !map_.language().CPlusPlus;
    if (!is_other || !map_.in_roots(call->getBeginLoc()) || call->isValueDependent() ||
        !call->EvaluateAsInt(kind, context_))
      return;
    if (std::optional<Span> const span = map_.range_for(call->getRParenLoc(), call->getSourceRange()))
      facts_.wraps.insert({*span, Use::instead, std::to_string(kind.Val.getInt().getExtValue())});
  }

  // The characters of a literal are const in C++, and so are those behind `x ? name : "none"`.
  void c_choice(ConditionalOperator const *choice) {
    QualType const pointee = choice->getType()->getPointeeType();
    if (map_.language().CPlusPlus) return;
    if (pointee.isNull() || pointee.isConstQualified()) return;
    for (Expr const *arm : {choice->getTrueExpr(), choice->getFalseExpr()})
      if (Expr const *written = arm->IgnoreImpCasts(); isa<StringLiteral>(written->IgnoreParens()))
        wrap(written, Use::cast, spelled(choice->getType()));
      else if (auto const *cast = dyn_cast<ImplicitCastExpr>(arm);
               cast && is_pointer_of_c(cast) && !is_null(cast, map_, map_.language())) {
        all_.settled.insert(cast); // an arm has no context to go by
        wrap(cast->getSubExpr(), Use::cast, spelled(cast->getType()));
      }
  }

  // Casts the result of a search function that in C++ returns a pointer to const for one.
  void c_search(CallExpr const *call) {
    FunctionDecl const *function = call->getDirectCallee();
    if (map_.language().CPlusPlus || !function || reals_.in_roots(function) || !function->getIdentifier()) return;
    if (!library::has(function->getName(), library::SEARCHES)) return;
    Expr const *searched = call->getArg(0);
    QualType const pointee = as_pointer(searched)->getType()->getPointeeType();
    bool const is_literal =
        isa<StringLiteral>(searched->IgnoreParenImpCasts()); // whose characters are const in C++ only
    if (is_literal || (!pointee.isNull() && pointee.isConstQualified()))
      wrap(call, Use::cast, spelled(call->getType()));
  }
};

} // namespace

void add_c(SyntaxTable &table) {
  table.add<DeclarationsOfC>();
  table.add<ExpressionsOfC>();
}

} // namespace symreal::rewrite
