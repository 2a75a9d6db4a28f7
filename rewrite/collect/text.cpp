// Text that is made of REALs, and text that is read: the text of a symbolic value must not be read back, since it
// belongs to one run. Text that only leaves the program is unrestricted.
#include "rewrite/collect/handlers.h"
#include "rewrite/collect/objects.h"
#include "rewrite/model/library.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

FunctionDecl const *callee_of(CallExpr const *call) {
  if (FunctionDecl const *function = call->getDirectCallee()) return function;
  auto const *names = dyn_cast<UnresolvedLookupExpr>(call->getCallee()->IgnoreParenImpCasts());
  if (!names || names->getNumDecls() == 0) return nullptr;
  return dyn_cast<FunctionDecl>((*names->decls_begin())->getUnderlyingDecl());
}

CallExpr const *formatting_call(Expr const *expression) {
  auto const *call = expression ? dyn_cast<CallExpr>(expression->IgnoreParenImpCasts()) : nullptr;
  FunctionDecl const *function = call ? callee_of(call) : nullptr;
  if (!function) return nullptr;
  TextUse const use = text_use(function);
  return use == TextUse::memory || use == TextUse::outside ? call : nullptr;
}

// Whether the variable has other uses than as a text's position: buffer + length, size - length, buffer[length] = 0.
bool is_used(VarDecl const *variable, Stmt const *within) {
  if (!within) return false;
  if (auto const *name = dyn_cast<DeclRefExpr>(within)) return name->getDecl() == variable;
  auto const any = [variable](Stmt const *part) { return is_used(variable, part); };
  if (auto const *expression = dyn_cast<Expr>(within))
    if (CallExpr const *call =
            expression == expression->IgnoreParenImpCasts() ? formatting_call(expression) : nullptr) {
      unsigned const placed = callee_of(call)->getNumParams();
      for (unsigned i = placed; i < call->getNumArgs(); ++i)
        if (any(call->getArg(i))) return true;
      return false;
    }
  if (auto const *assignment = dyn_cast<BinaryOperator>(within); assignment && assignment->isAssignmentOp()) {
    Expr const *target = assignment->getLHS()->IgnoreParens();
    auto const *element = dyn_cast<ArraySubscriptExpr>(target);
    auto const *name = dyn_cast<DeclRefExpr>(target);
    bool const is_placed = (element && is_character(element->getType())) || (name && name->getDecl() == variable);
    return any(assignment->getRHS()) || (!is_placed && any(target));
  }
  return llvm::any_of(within->children(), any);
}

// Text operand of strcpy, strdup, fputs, fwrite and their like.
Expr const *spelled_text(CallExpr const *call) {
  bool const has_target = callee_of(call)->getName().contains("str") && call->getNumArgs() > 1;
  return call->getArg(has_target ? 1 : 0)->IgnoreParenImpCasts();
}

bool is_standard_output(Expr const *stream) {
  auto const *name = dyn_cast<DeclRefExpr>(stream->IgnoreParenImpCasts());
  return name && name->getDecl()->getDeclName().isIdentifier() &&
         (name->getDecl()->getName() == "stdout" || name->getDecl()->getName() == "stderr");
}

class TextOfNumbers : public ObjectUses {
public:
  explicit TextOfNumbers(SyntaxTable &table) : ObjectUses(table) {
    on<Stmt>(ANYWHERE, &TextOfNumbers::discarded);
    on<CallExpr>(RUNNING, &TextOfNumbers::text_of_call);
    on<CXXRewrittenBinaryOperator>(RUNNING, &TextOfNumbers::text_comparison);
    on<ImplicitCastExpr>(RUNNING, &TextOfNumbers::characters);
    on<CXXForRangeStmt>(RUNNING, &TextOfNumbers::characters_of);
    on<NamedDecl>(ANYWHERE, &TextOfNumbers::kept);
    on<CXXConstructExpr>(NUMBERS, &TextOfNumbers::kept);
  }

private:
  void kept(NamedDecl const *declaration) {
    if (auto const *object = dyn_cast<ValueDecl>(declaration)) keeps_text(object->getType());
  }
  void kept(CXXConstructExpr const *construction) { keeps_text(construction->getType()); }

  // Collects the calls in a statement whose value is unused.
  void discarded(Stmt const *statement) {
    FunctionDecl const *const function = at_.function;
    auto const discard = [&](Stmt const *part) {
      auto const *expression = dyn_cast_or_null<Expr>(part);
      if (!expression) return;
      expression = expression->IgnoreImplicit()->IgnoreParens();
      discarded_.insert(expression);
      // length += sprintf(text + length, ...)
      auto const *assignment = dyn_cast<BinaryOperator>(expression);
      if (!assignment || !assignment->isAssignmentOp() || !function) return;
      CallExpr const *call = formatting_call(assignment->getRHS());
      auto const *name = dyn_cast<DeclRefExpr>(assignment->getLHS()->IgnoreParens());
      auto const *variable = call && name ? dyn_cast<VarDecl>(name->getDecl()) : nullptr;
      if (variable && variable->hasLocalStorage() && !is_used(variable, function->getBody())) discarded_.insert(call);
    };
    if (isa<CompoundStmt, IfStmt, WhileStmt, DoStmt, ForStmt, SwitchCase, LabelStmt, CXXForRangeStmt>(statement)) {
      auto const *loop = dyn_cast<ForStmt>(statement);
      Expr const *condition = nullptr;
      if (loop) condition = loop->getCond();
      if (auto const *choice = dyn_cast<IfStmt>(statement)) condition = choice->getCond();
      if (auto const *one = dyn_cast<WhileStmt>(statement)) condition = one->getCond();
      if (auto const *one = dyn_cast<DoStmt>(statement)) condition = one->getCond();
      for (Stmt const *part : statement->children())
        if (part != condition) discard(part);
    } else if (auto const *cast = dyn_cast<CastExpr>(statement)) {
      if (cast->getCastKind() == CK_ToVoid) discard(cast->getSubExpr());
    } else if (auto const *comma = dyn_cast<BinaryOperator>(statement)) {
      if (comma->isCommaOp()) discard(comma->getLHS());
    } else if (auto const *declarations = dyn_cast<DeclStmt>(statement)) {
      for (Decl const *declaration : declarations->decls()) {
        auto const *variable = dyn_cast<VarDecl>(declaration);
        CallExpr const *call = variable && variable->hasLocalStorage() ? formatting_call(variable->getInit()) : nullptr;
        if (call && function && !is_used(variable, function->getBody())) discarded_.insert(call);
      }
    }
  }

  void keeps_text(QualType type) {
    if (!type->isDependentType() && rewrite::keeps_text(type)) facts_.makes_text = true;
  }

  // Text is read, by `reader`. `only_looks`: takes the object only, whose characters may be read later.
  void reads_text(SourceLocation reader, Expr const *text, bool only_looks = false) {
    text = text->IgnoreParenImpCasts();
    SourceLocation const begin = text->getBeginLoc();
    if (!map_.in_roots(begin)) return;
    std::optional<Span> span = map_.range_for(reader, text->getSourceRange());
    if (!span) return; // in the body of a library's macro
    if (!only_looks && !is_source(text->getType()) && !is_character(text->getType())) decides(text);
    facts_.wraps.insert({*span, Use::text,
                         (only_looks ? "nullptr" : in_quotes(short_text(*span, begin))) + ", " +
                             in_quotes(to_string(map_.place(begin)))});
  }

  void formatted(CallExpr const *call, FunctionDecl const *function) {
    bool const is_list = function->getName().starts_with("v"); // the list of another call
    bool has_number = is_list, has_text = false;
    for (unsigned i = function->isVariadic() ? function->getNumParams() : 0; i < call->getNumArgs(); ++i) {
      Expr const *argument = call->getArg(i);
      has_text = has_text || is_text(argument->IgnoreImpCasts()->getType());
      has_number = has_number || argument->isTypeDependent() || reals_.is_real(argument) || may_be_truth(argument);
    }
    bool const is_used = !discarded_.contains(call);
    bool leaves_program = false;
    if (text_use(function) == TextUse::outside) {
      Expr const *stream = function->getName().ends_with("puts")    ? call->getArg(1)
                           : function->getName() == "fwrite"        ? call->getArg(3)
                           : function->getName().contains("fprint") ? call->getArg(0)
                                                                    : nullptr;
      bool const leaves =
          function->getName().ends_with("printf") && !stream && !function->getName().contains("dprintf");
      leaves_program = leaves || (stream && is_standard_output(stream));
    }
    if (!function->isVariadic() && !is_list && !has_number) has_text = is_text(spelled_text(call)->getType());
    if (!has_number && !has_text) return;
    Expr const *callee = call->getCallee()->IgnoreParenImpCasts();
    std::optional<Span> const span = map_.range(callee->getSourceRange());
    if (!span || !map_.in_roots(callee->getBeginLoc())) return;
    facts_.makes_text |= has_number && (is_used || !leaves_program);
    llvm::StringRef name = function->getName();
    name.consume_front("__builtin_");
    facts_.wraps.insert({*span, Use::formatting,
                         "print_" + name.str() + ", " + (is_used ? "true" : "false") + ", " +
                             in_quotes(to_string(map_.place(call->getBeginLoc())))});
  }

  // A call of a variadic function of the program, which may make text of its arguments.
  void shows(CallExpr const *call, FunctionDecl const *function) {
    if (!function->isVariadic() || isa<CXXMethodDecl>(function)) return;
    auto const *name = dyn_cast<DeclRefExpr>(call->getCallee()->IgnoreParenImpCasts());
    if (!name || name->hadMultipleCandidates() || function->getPrimaryTemplate()) return;
    for (unsigned i = function->getNumParams(); i < call->getNumArgs(); ++i)
      if (reals_.is_real(call->getArg(i)) || may_be_truth(call->getArg(i)))
        if (std::optional<Span> const span = map_.range(name->getSourceRange())) {
          facts_.wraps.insert({*span, Use::shown, ""});
          return;
        }
  }

  void text_of_call(CallExpr const *call) {
    FunctionDecl const *function = callee_of(call);
    if (!function) return;
    if (reals_.in_roots(Reals::pattern(function))) return shows(call, function);
    SourceLocation const end = call->getRParenLoc();
    auto const *method = dyn_cast<CXXMethodDecl>(function);
    auto const *operation = dyn_cast<CXXOperatorCallExpr>(call);
    auto const each = [&](unsigned first, unsigned last = ~0u) {
      for (unsigned i = first; i < std::min(last, call->getNumArgs()); ++i)
        if (Expr const *argument = call->getArg(i)->IgnoreParenImpCasts();
            !argument->isTypeDependent() && !isa<StringLiteral>(argument) && is_text(argument->getType()))
          reads_text(end, argument);
    };
    if (operation) {
      OverloadedOperatorKind const kind = operation->getOperator();
      bool const is_extraction = kind == OO_GreaterGreater && is_text(call->getArg(0)->getType()) &&
                                 !isa<CXXOperatorCallExpr>(call->getArg(0)->IgnoreParenImpCasts());
      if (is_extraction) reads_text(end, call->getArg(0));
      if (operation->isComparisonOp() &&
          (is_string(call->getArg(0)->getType()) || is_string(call->getArg(1)->getType())))
        each(0);
      if (kind == OO_Subscript && method && compares_keys(method)) each(1);
      if (kind == OO_Call && method && method->getParent()->getDeclName().isIdentifier() &&
          method->getParent()->getName() == "hash")
        each(1);
    } else if (auto const *member = dyn_cast<CXXMemberCallExpr>(call); member && method) {
      Expr const *object = member->getImplicitObjectArgument();
      auto const *self = dyn_cast<CXXThisExpr>(object->IgnoreParenImpCasts());
      if (reads_its_text(method)) {
        if (!self || !self->isImplicit()) reads_text(end, object);
        if (is_string(object->getType())) each(0); // a stream has its text go there
      } else if (compares_keys(method))
        each(0);
      else if (!self && is_string(object->getType()) && method->getDeclName().isIdentifier() &&
               (method->getName() == "c_str" || method->getName() == "data"))
        reads_text(end, object, true);
    } else if (TextUse const use = text_use(function); use == TextUse::reader) {
      auto const source = llvm::find_if(call->arguments(), [](Expr const *argument) {
        return !argument->isTypeDependent() && is_source(argument->IgnoreParenImpCasts()->getType());
      });
      if (source != call->arguments().end())
        reads_text(end, *source);
      else
        each(0, function->isVariadic() ? function->getNumParams() : call->getNumArgs());
    } else if (use != TextUse::none)
      later([this, call, function] { formatted(call, function); });
    else if (function->isInStdNamespace() && function->getIdentifier() && function->getName() == "to_string" &&
             call->getNumArgs() == 1 &&
             (call->getArg(0)->isTypeDependent() || reals_.is_real(call->getArg(0)) || may_be_truth(call->getArg(0))))
      facts_.makes_text = true;
  }

  // `!=` and its like, which C++20 makes of others.
  void text_comparison(CXXRewrittenBinaryOperator const *comparison) {
    if (comparison->isTypeDependent()) return;
    Expr const *left = comparison->getLHS()->IgnoreParenImpCasts(),
               *right = comparison->getRHS()->IgnoreParenImpCasts();
    if (!is_string(left->getType()) && !is_string(right->getType())) return;
    for (Expr const *side : {left, right})
      if (!isa<StringLiteral>(side) && is_text(side->getType())) reads_text({}, side);
  }

  // A character whose value is used.
  void characters(ImplicitCastExpr const *load) {
    Expr const *value = load->getSubExpr()->IgnoreParens();
    if (load->getCastKind() != CK_LValueToRValue || load->isTypeDependent() || value->isTypeDependent() ||
        !is_character(value->getType()))
      return;
    if (auto const *call = dyn_cast<CallExpr>(value)) { // s[0], s.at(0), s.front()
      auto const *member = dyn_cast<CXXMemberCallExpr>(call);
      if (!member && !isa<CXXOperatorCallExpr>(call)) return;
      Expr const *object = member ? member->getImplicitObjectArgument() : call->getArg(0);
      if (is_string(object->getType()) && !isa<CXXThisExpr>(object->IgnoreParenImpCasts())) reads_text({}, object);
      return;
    }
    auto const *target = dyn_cast<UnaryOperator>(value);
    if (!isa<ArraySubscriptExpr>(value) && !(target && target->getOpcode() == UO_Deref)) return;
    if (auto const *element = dyn_cast<ArraySubscriptExpr>(value))
      if (isa<StringLiteral>(element->getBase()->IgnoreParenImpCasts())) return;
    Expr const *pointer =
        (target ? target->getSubExpr() : cast<ArraySubscriptExpr>(value)->getBase())->IgnoreParenImpCasts();
    if (pointer->isGLValue() && pointer->getType()->isPointerType()) scalar(pointer, Use::read);
    reads_text({}, value);
  }

  void characters_of(CXXForRangeStmt const *loop) {
    Expr const *range = loop->getRangeInit();
    if (range && !range->isTypeDependent() && is_text(range->getType()) && !range->getType()->isPointerType())
      reads_text({}, range);
  }

  llvm::SmallPtrSet<Expr const *, 32> discarded_; // calls whose value is unused
};

} // namespace

void add_text(SyntaxTable &table) { table.add<TextOfNumbers>(); }

} // namespace symreal::rewrite
