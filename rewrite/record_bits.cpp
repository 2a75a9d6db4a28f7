// Uses of the bytes of a REAL: unions, casts of pointers, functions that move bytes. A node must not be taken for the
// bytes of its value; where only the run can tell, it is asked.
#include "rewrite/pragma_text.h"
#include "rewrite/recorder.h"

namespace symreal::rewrite {
using namespace clang;

// Reading u.bits of `union { double number; uint64_t bits; }` is harmless as long as the number is an ordinary one.
void Recorder::union_member(MemberExpr const *member) {
  auto const *field = dyn_cast<FieldDecl>(member->getMemberDecl());
  if (!field || !field->getParent()->isUnion() || field->getType()->isDependentType() || judged_.contains(member))
    return;
  QualType const type = field->getType();
  if (reals_.mentions_real(type) || type->isPointerType()) return;
  if (!reals_.carries_real(context_.getRecordType(field->getParent()))) return;
  Expr const *base = member->getBase()->IgnoreParenImpCasts();
  bool const spelled = !member->isImplicitAccess() && base->getEndLoc() != member->getEndLoc();
  auto const *within = dyn_cast<MemberExpr>(base);
  if (spelled && !(within && !within->getMemberDecl()->getDeclName()))
    note(base, Use::bits);
  else if (!field->isBitField())
    note(member, Use::bits);
  else
    report(DiagnosticId::reinterpretation, member->getMemberLoc(),
           "'" + field->getNameAsString() + "' shares its bytes with a REAL");
}

// What a pointer, a reference or an array leads to at last; null if that is no built-in type.
static BuiltinType const *innermost(QualType type) {
  while (true) {
    if (auto const *array = type->getAsArrayTypeUnsafe())
      type = array->getElementType();
    else if (QualType const pointee = type->getPointeeType(); !pointee.isNull())
      type = pointee;
    else
      return type->getAs<BuiltinType>();
  }
}

// A cast between pointers says what the bytes are taken for.
void Recorder::reinterpretation(ExplicitCastExpr const *cast) {
  Expr const *from = cast->getSubExpr();
  if (cast->getCastKind() == CK_LValueToRValueBitCast &&
      reals_.carries_real(from->getType()) != reals_.carries_real(cast->getType()))
    report(DiagnosticId::reinterpretation, cast->getBeginLoc(), "the bytes of a REAL are used as another type");
  if (cast->getCastKind() != CK_BitCast && cast->getCastKind() != CK_LValueBitCast) return;
  QualType const source = cast->getSubExprAsWritten()->getType();
  BuiltinType const *before = innermost(source), *after = innermost(cast->getType());
  auto const is_bytes = [](BuiltinType const *type) {
    return type->isVoidType() || type->getKind() == BuiltinType::Char_S || type->getKind() == BuiltinType::Char_U ||
           type->getKind() == BuiltinType::UChar;
  };
  // (double *)((char *)p + n) only counts in bytes, and so does a structure behind numbers; the outer cast is visited
  // first. Integers there are looked at in the run.
  auto const *sum = dyn_cast<BinaryOperator>(cast->getSubExprAsWritten()->IgnoreParens());
  if (sum && sum->isAdditiveOp() && !(after && is_bytes(after))) {
    for (Expr const *side : {sum->getLHS(), sum->getRHS()}) counting_casts_.insert(side->IgnoreParenImpCasts());
    if (after && after->isInteger()) note(cast->getSubExprAsWritten(), Use::bits);
  }
  if (!before || !after || before->getKind() == after->getKind()) return;
  bool const was_double = before->getKind() == BuiltinType::Double, is_double = after->getKind() == BuiltinType::Double;
  bool const only_counts = is_bytes(after) && counting_casts_.contains(cast);
  if (was_double && !after->isVoidType() && !only_counts)
    report(DiagnosticId::reinterpretation, cast->getBeginLoc(),
           "the bytes of a REAL are looked at as " + cast->getType().getAsString());
  if (is_double && !is_bytes(before))
    report(DiagnosticId::reinterpretation, cast->getBeginLoc(), source.getAsString() + " is looked at as a REAL");
}

// From void *, which may have been the address of a REAL, or from a structure that holds some, to a pointer to
// integers.
void Recorder::pointer_cast(CastExpr const *cast) {
  if (cast->getCastKind() != CK_BitCast || cast->isTypeDependent()) return;
  Expr const *from = cast->getSubExpr()->IgnoreParenImpCasts();
  QualType const to = cast->getType()->getPointeeType(), given = from->getType()->getPointeeType();
  if (to.isNull() || !to->isIntegerType() || isa<CallExpr>(from)) return;
  bool const holds_numbers = !given.isNull() && given->isRecordType() && reals_.carries_real(given);
  if (from->getType()->isVoidPointerType() || holds_numbers) note(from, Use::bits);
}

void Recorder::moved_bytes(CallExpr const *call, FunctionDecl const *function) {
  if (!function->getDeclName().isIdentifier()) return;
  llvm::StringRef name = function->getName();
  name.consume_front("__builtin_");
  std::string const how = name == "memset"                        ? "set"
                          : name == "memcmp"                      ? "compare"
                          : name == "memcpy" || name == "memmove" ? "move"
                          : name == "fread"                       ? "read"
                          : name == "fwrite"                      ? "write"
                                                                  : "";
  bool const is_file = how == "read" || how == "write";
  if (how.empty() || call->getNumArgs() != (is_file ? 4 : 3)) return;
  bool any = false;
  for (Expr const *argument : {call->getArg(0), call->getArg(is_file ? 0 : 1)}) {
    QualType const pointee = Reals::pointee(argument);
    any = any || (!pointee.isNull() && reals_.carries_real(pointee));
  }
  Expr const *callee = call->getCallee()->IgnoreParenImpCasts();
  std::optional<Span> const span = map_.range(callee->getSourceRange());
  if (!any || !span || !map_.in_roots(callee->getBeginLoc())) return;
  auto const words = [&](unsigned index) {
    Expr const *argument = call->getArg(index)->IgnoreParenImpCasts();
    std::optional<Span> const written = map_.range(argument->getSourceRange());
    return written ? normalised(map_.text(*written, argument->getBeginLoc())) : name.str();
  };
  std::string const what = how == "compare" ? words(0) + "' or '" + words(1) : words(how == "move" ? 1 : 0);
  std::string detail = how + ", " + quoted(what);
  detail.append(", ").append(quoted(to_string(map_.place(call->getBeginLoc()))));
  facts_.wraps.insert({*span, Use::bytes, detail});
}

} // namespace symreal::rewrite
