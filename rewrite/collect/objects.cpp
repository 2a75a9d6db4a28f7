#include "rewrite/collect/objects.h"
#include "rewrite/model/library.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
using namespace clang;

// Whether the token comes from the body of a macro that is defined outside the roots.
static bool is_library_macro(SourceLocation location, SourceMap const &map) {
  SourceManager const &sources = map.sources();
  if (!sources.isMacroBodyExpansion(location)) return false;
  SourceLocation const spelled = sources.getSpellingLoc(location);
  return sources.getFileEntryRefForID(sources.getFileID(spelled)) && !map.in_roots(spelled);
}

std::string ObjectUses::short_text(Span const &span, SourceLocation at) const {
  constexpr std::size_t longest = 60;
  std::string text = normalised(map_.text(span, at));
  if (text.size() > longest) text.replace(longest, std::string::npos, "...");
  return text;
}

// Wraps the expression in a macro that reports its name and place.
void ObjectUses::note(Expr const *expression, Use use, Expr const *named, std::string const &words) {
  SourceLocation const begin = expression->getBeginLoc();
  if (!map_.in_roots(begin)) return;
  // Whether the bytes of a scalar are also those of a number is another question.
  Expr const *base = Storage::base(expression);
  if (base && (isa<DeclRefExpr>(base) || !ScalarState::is_scalar(expression->getType()))) all_.judged.insert(base);
  std::optional<Span> const span = map_.range(expression->getSourceRange());
  if (!span && is_library_macro(begin, map_)) return; // library code, as in a template
  if (!span) {
    report(DiagnosticId::split_expression, begin,
           "a macro makes a part of this expression: cannot tell whether it uses hidden state", Severity::warning);
    return;
  }
  if (!named) named = expression;
  std::string const name = short_text(map_.range(named->getSourceRange()).value_or(*span), begin);
  facts_.wraps.insert(
      {*span, use, words + in_quotes(name) + ", " + in_quotes(to_string(map_.place(named->getBeginLoc())))});
}

// Whether the expression is part of a variable whose scalars never change. The target of a pointer is not.
bool ObjectUses::is_fixed(Expr const *expression) const {
  Expr const *part = spelled_expression(expression);
  while (!isa<DeclRefExpr>(part)) {
    auto const *member = dyn_cast<MemberExpr>(part);
    auto const *index = dyn_cast<ArraySubscriptExpr>(part);
    auto const *call = dyn_cast<CallExpr>(part);
    Expr const *whole = member  ? member->getBase()
                        : index ? index->getBase()
                        : call  ? Storage::object_of(call)
                                : nullptr;
    if (!whole || (member && (member->isArrow() || isa<VarDecl>(member->getMemberDecl())))) return false;
    part = spelled_expression(whole);
    QualType const type = part->getType();
    if (index && !type->isArrayType()) return false;
    if (type->isRecordType() && Storage::holds_pointer(type) && !Storage::owns_elements(type)) return false;
  }
  auto const *variable = dyn_cast<VarDecl>(cast<DeclRefExpr>(part)->getDecl());
  return variable && scalars_.is_fixed(variable);
}

// The value of a scalar is used, or it gets a new one.
void ObjectUses::scalar(Expr const *expression, Use use) {
  if (expression->isTypeDependent() || !may_outlive(expression)) return;
  if (is_fixed(expression)) return;
  // A macro of a library, such as errno.
  SourceLocation const begin = expression->getBeginLoc();
  if (begin.isMacroID() && !map_.token(begin)) return;
  if (ScalarState::has_address(expression)) return note(expression, use);
  // Once for a member, however often it is used.
  auto const *member = dyn_cast<MemberExpr>(expression->IgnoreParens());
  bool const is_declared_here = member && map_.in_roots(member->getMemberDecl()->getLocation());
  std::optional<Span> const span = map_.range(expression->getSourceRange());
  std::string const name = member ? member->getMemberDecl()->getQualifiedNameAsString()
                           : span ? normalised(map_.text(*span, begin))
                                  : "this";
  report(DiagnosticId::scalar_not_looked_at, is_declared_here ? member->getMemberDecl()->getLocation() : begin,
         "cannot tell whether '" + name + "' is hidden state");
}

void ObjectUses::pointer(Expr const *expression) {
  if (may_outlive(expression) && ScalarState::has_address(expression)) note(expression, Use::written);
}

bool ObjectUses::may_outlive(Expr const *expression) const {
  Home const home = storage_.home(expression);
  if (home != Home::local) return home == Home::elsewhere;
  auto const *base = dyn_cast_or_null<DeclRefExpr>(Storage::base(expression));
  auto const *variable = base ? dyn_cast<VarDecl>(base->getDecl()) : nullptr;
  return variable && surroundings_.contain(variable, base->getLocation());
}

static bool is_parameter(Expr const *expression) {
  auto const *reference = dyn_cast<DeclRefExpr>(expression);
  return reference && isa<ParmVarDecl>(reference->getDecl());
}

// An object, array or view as a whole.
void ObjectUses::object(Expr const *expression, Use use) {
  expression = spelled_expression(expression);
  QualType const type = expression->getType();
  if (expression->isTypeDependent() || type->isPointerType() || Reals::is_double(type)) return;
  if (!expression->isGLValue() && !Storage::is_view(type)) return;
  if (!type->isRecordType() && !type->isArrayType()) return;
  // Text is checked where it is read; an argument such as a function is the caller's choice, like a count.
  if (use == Use::read && (is_string(type) || (is_parameter(expression) && ScalarState::is_opaque(type)))) return;
  if (use == Use::read && is_fixed(expression) && !reals_.carries_real(type)) return;
  if (use == Use::read && scalars_.is_unknown(type)) decides(expression);
  bool const is_pointer = ScalarState::is_smart_pointer(type);
  if ((is_pointer || holds_state(type) || (use != Use::read && is_value(type))) && may_outlive(expression))
    note(expression, use);
  else if (use == Use::read)
    leads(expression);
}

// Whether an object holds a value besides its numbers and elements.
bool ObjectUses::is_value(QualType type) const {
  return ScalarState::has_value_of_its_own(type) || scalars_.is_unknown(type);
}

// Notes a change whose result depends on the old value.
void ObjectUses::changed_value(Expr const *expression) {
  decides(expression);
  object(expression, Use::written);
}

// An object through which others are reached, or a copy of it: a view, an iterator, a std::reference_wrapper, a
// structure of pointers.
void ObjectUses::leads(Expr const *expression) {
  expression = spelled_expression(expression);
  QualType const type = expression->getType();
  if (expression->isTypeDependent() || !expression->isGLValue() || !type->isRecordType()) return;
  auto const *operation = dyn_cast<CXXOperatorCallExpr>(expression);
  if (operation && operation->isInfixBinaryOp()) return; // a stream, or Eigen's comma: the call's own result
  if (Storage::holds_pointer(type) && !is_fixed(expression) && may_outlive(expression)) wrap(expression, Use::leads);
}

// Notes that text, a pointer to an object, or a container decides the kernel's path. An argument is the caller's
// choice.
void ObjectUses::decides(Expr const *expression) {
  expression = spelled_expression(expression);
  if (auto const *copy = dyn_cast<CXXConstructExpr>(expression); // a std::string_view by value
      copy && copy->getNumArgs() == 1 && copy->getConstructor()->isCopyOrMoveConstructor())
    expression = spelled_expression(copy->getArg(0));
  if (expression->isTypeDependent() || !expression->isGLValue() || is_parameter(expression)) return;
  if (!is_fixed(expression) && may_outlive(expression)) note(expression, Use::decides);
}

// Notes that the pointer to the object, if any, decides the kernel's path.
void ObjectUses::decides_by_pointer(Expr const *object) {
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

void Loads::loaded(ImplicitCastExpr const *cast) {
  if (cast->getCastKind() == CK_LValueToRValue && !cast->isTypeDependent()) load(cast->getSubExpr());
}

void Loads::elements(InitListExpr const *list) {
  for (Expr const *element : converted_elements(list))
    if (auto const *cast = dyn_cast_or_null<ImplicitCastExpr>(element);
        cast && cast->getCastKind() == CK_LValueToRValue)
      load(cast->getSubExpr());
}

void Loads::load(Expr const *value) {
  value = value->IgnoreParens();
  if (auto const *choice = dyn_cast<ConditionalOperator>(value)) {
    load(choice->getTrueExpr());
    load(choice->getFalseExpr());
  } else if (auto const *comma = dyn_cast<BinaryOperator>(value)) {
    if (comma->isCommaOp()) load(comma->getRHS());
  } else if (auto const *unary = dyn_cast<UnaryOperator>(value); !unary || !unary->isIncrementDecrementOp())
    read(value); // `++` is noted as such
}

} // namespace symreal::rewrite
