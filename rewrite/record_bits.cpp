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
  bool const sets = name == "memset";
  if ((!sets && name != "memcpy" && name != "memmove") || call->getNumArgs() != 3) return;
  bool any = false;
  for (Expr const *argument : {call->getArg(0), call->getArg(1)}) {
    Expr const *given = argument->IgnoreParenImpCasts();
    QualType const type = given->getType();
    QualType const pointee =
        type->isArrayType() ? QualType(type->getAsArrayTypeUnsafe()->getElementType()) : type->getPointeeType();
    any = any || (!pointee.isNull() && reals_.carries_real(pointee));
  }
  Expr const *callee = call->getCallee()->IgnoreParenImpCasts();
  std::optional<Span> const span = map_.range(callee->getSourceRange());
  if (!any || !span || !map_.in_roots(callee->getBeginLoc())) return;
  Expr const *what = call->getArg(sets ? 0 : 1)->IgnoreParenImpCasts();
  std::optional<Span> const words = map_.range(what->getSourceRange());
  std::string detail =
      (sets ? "set, " : "move, ") + quoted(words ? normalised(map_.text(*words, what->getBeginLoc())) : name.str());
  detail.append(", ").append(quoted(to_string(map_.place(call->getBeginLoc()))));
  facts_.wraps.insert({*span, Use::bytes, detail});
}

} // namespace symreal::rewrite
