// Uses of the bytes of a REAL: unions, casts of pointers, functions that move bytes. A node must not be taken for the
// bytes of its value; where only the run can tell, it is asked.
#include "rewrite/collect/collector.h"
#include "rewrite/model/library.h"
#include "rewrite/text/pragma_text.h"

#include <clang/AST/ParentMapContext.h>

namespace symreal::rewrite {
using namespace clang;

// The address of an object goes to a function outside the roots that takes any.
void Collector::given_bytes(FunctionDecl const *function, unsigned index, Expr const *argument) {
  if (index >= function->getNumParams() || !function->getParamDecl(index)->getType()->isVoidPointerType()) return;
  QualType const pointee = Reals::pointee(argument);
  if (!pointee.isNull() && !moves_bytes(function) && reals_.carries_real(pointee))
    looked_into(argument->IgnoreParenImpCasts());
}

// Functions of the library that look at bytes by themselves.
void Collector::bytes_of_arguments(CallExpr const *call, FunctionDecl const *function) {
  auto const *method = dyn_cast<CXXMethodDecl>(function);
  NamedDecl const *outermost = method ? static_cast<NamedDecl const *>(method->getParent()) : function;
  if (!function->getDeclName().isIdentifier() || !outermost->isInStdNamespace()) return;
  llvm::StringRef const name = function->getName();
  auto const argument_of_class = [](QualType type) {
    auto const *record = type.isNull() ? nullptr : type.getNonReferenceType()->getAsCXXRecordDecl();
    auto const *special = dyn_cast_or_null<ClassTemplateSpecializationDecl>(record);
    return special && special->getTemplateArgs().size() > 0 &&
                   special->getTemplateArgs()[0].getKind() == TemplateArgument::Type
               ? special->getTemplateArgs()[0].getAsType()
               : QualType();
  };
  bool used = false;
  if (name == "bit_cast" && call->getNumArgs() == 1 && reals_.carries_real(call->getArg(0)->getType()) &&
      !reals_.carries_real(call->getType()))
    note(call->getArg(0)->IgnoreParenImpCasts(), Use::bits);
  if ((name == "as_bytes" || name == "as_writable_bytes") && call->getNumArgs() == 1)
    used = reals_.carries_real(argument_of_class(call->getArg(0)->getType()));
  if (used) report(DiagnosticId::reinterpretation, call->getBeginLoc(), "the bytes of a REAL are used as another type");
  if (!name.contains("compare_exchange")) return;
  // Compare-exchange on a number itself compares values in the symbolic program.
  QualType object;
  if (auto const *member = dyn_cast<CXXMemberCallExpr>(call))
    object = argument_of_class(member->getImplicitObjectArgument()->getType());
  else if (call->getNumArgs() > 0)
    object = argument_of_class(Reals::pointee(call->getArg(0)));
  if (reals_.carries_real(object) && !Reals::is_double(object))
    report(DiagnosticId::reinterpretation, call->getBeginLoc(), "the bytes of an object that holds REALs are compared");
}

void Collector::atomic_builtin(AtomicExpr const *call) {
  if (call->getOp() == AtomicExpr::AO__atomic_compare_exchange && reals_.carries_real(Reals::pointee(call->getPtr())))
    report(DiagnosticId::reinterpretation, call->getBeginLoc(), "the bytes of a REAL are compared");
  auto const *address = dyn_cast<UnaryOperator>(call->getPtr()->IgnoreParenImpCasts());
  bool const is_named = address && address->getOpcode() == UO_AddrOf;
  if (!is_named || !ScalarState::is_scalar(address->getSubExpr()->getType())) return;
  bool const stores = call->getOp() == AtomicExpr::AO__atomic_store ||
                      call->getOp() == AtomicExpr::AO__atomic_store_n ||
                      call->getOp() == AtomicExpr::AO__c11_atomic_store;
  scalar(address->getSubExpr(), stores ? Use::written : Use::read);
}

static FieldDecl const *field_of(MemberExpr const *member) { return dyn_cast<FieldDecl>(member->getMemberDecl()); }

// A member of a union that shares its bytes with a number and holds none.
bool Collector::shares_bytes(FieldDecl const *field) const {
  if (!field || !field->getParent()->isUnion() || field->getType()->isDependentType()) return false;
  QualType const type = field->getType();
  if (reals_.mentions_real(type) || type->isPointerType()) return false;
  return reals_.carries_real(context_.getRecordType(field->getParent()));
}

// Whether the field is a union member that holds numbers and shares its bytes with something else.
bool Collector::shares_number(FieldDecl const *field) const {
  if (!field || !field->getParent()->isUnion() || field->getType()->isDependentType()) return false;
  auto const fields = field->getParent()->fields();
  return reals_.carries_real(field->getType()) &&
         std::any_of(fields.begin(), fields.end(), [this](FieldDecl const *other) { return shares_bytes(other); });
}

// In u.part.low or u.bytes[i], the member for which `is` holds; null if none does.
template <class Is> static MemberExpr const *member_in(Expr const *object, Is is) {
  while (true) {
    object = object->IgnoreParenImpCasts();
    if (auto const *element = dyn_cast<ArraySubscriptExpr>(object)) {
      object = element->getBase()->IgnoreParenImpCasts();
      if (!object->getType()->isArrayType()) return nullptr;
    } else if (auto const *member = dyn_cast<MemberExpr>(object)) {
      if (is(field_of(member))) return member;
      if (member->isArrow()) return nullptr;
      object = member->getBase();
    } else {
      return nullptr;
    }
  }
}

// Bits of `base`: those that `part`, a member of a member of it, names.
static std::string bits_within(Expr const *part, Expr const *base, ASTContext &context) {
  std::uint64_t first = 0, count = 0;
  for (part = part->IgnoreParenImpCasts(); part != base;
       part = cast<MemberExpr>(part)->getBase()->IgnoreParenImpCasts()) {
    FieldDecl const *field = field_of(cast<MemberExpr>(part));
    if (count == 0)
      count = field->isBitField() ? field->getBitWidthValue(context) : context.getTypeSize(field->getType());
    first += context.getFieldOffset(field);
  }
  return std::to_string(first) + ", " + std::to_string(count);
}

// Reading u.bits of `union { double number; uint64_t bits; }` is harmless as long as the number is an ordinary one.
void Collector::union_member(MemberExpr const *member) {
  FieldDecl const *field = field_of(member);
  if (shares_number(field) && Reals::is_double(field->getType()))
    later([this, member] {
      if (!judged_.contains(member)) number_of_union(member);
    });
  if (!shares_bytes(field)) return;
  later([this, member, field] {
    if (!judged_.contains(member) && !view_of_union(whole_member(member))) bits_of_union(member, field);
  });
}

void Collector::bits_of_union(MemberExpr const *member, FieldDecl const *field) {
  Expr const *base = member->getBase()->IgnoreParenImpCasts();
  bool const spelled = !member->isImplicitAccess() && base->getEndLoc() != member->getEndLoc();
  auto const *within = dyn_cast<MemberExpr>(base);
  if (spelled && !(within && !within->getMemberDecl()->getDeclName()))
    note(base, Use::part, nullptr, "read, " + bits_within(whole_member(member), base, context_) + ", ");
  else if (!field->isBitField())
    note(member, Use::bits);
  else
    report(DiagnosticId::reinterpretation, member->getMemberLoc(),
           "'" + field->getNameAsString() + "' shares its bytes with a REAL");
}

// Outermost member of the union: u.part in u.part.low.
Expr const *Collector::whole_member(MemberExpr const *member) const {
  for (Expr const *part = member;;) {
    DynTypedNodeList const parents = context_.getParents(*part);
    auto const *outer = parents.empty() ? nullptr : parents[0].get<Expr>();
    auto const *further = dyn_cast_or_null<MemberExpr>(outer);
    if (further && field_of(further) && !further->isArrow())
      member = further;
    else if (!outer || !isa<ParenExpr>(outer))
      return member;
    part = outer;
  }
}

// Notes a store to a union: a store of a number replaces all of its bits, of another member perhaps a part.
void Collector::store_to_union(Expr const *left) {
  MemberExpr const *member = member_in(left, [this](FieldDecl const *field) { return shares_bytes(field); });
  bool const is_part = member != nullptr;
  if (is_part) judged_.insert(member);
  if (!member) member = member_in(left, [this](FieldDecl const *field) { return shares_number(field); });
  if (!member) return;
  if (ScalarState::has_address(left))
    note(left, Use::part, nullptr, "stored, 0, 0, ");
  else if (Expr const *base = member->getBase()->IgnoreParenImpCasts(); !member->isImplicitAccess())
    note(base, Use::part, left, "stored, " + bits_within(left, base, context_) + ", ");
}

// A number in a union is read.
void Collector::number_of_union(Expr const *value) {
  if (member_in(value, [this](FieldDecl const *field) { return shares_number(field); }))
    note(value, Use::part, nullptr, "used, 0, 0, ");
}

// Type behind all pointers, references and arrays.
static QualType innermost_type(QualType type) {
  while (true) {
    if (auto const *array = type->getAsArrayTypeUnsafe())
      type = array->getElementType();
    else if (QualType const pointee = type->getPointeeType(); !pointee.isNull())
      type = pointee;
    else
      return type;
  }
}

// The innermost type as a built-in type: the integer of an enumeration, null for a class.
static BuiltinType const *innermost(QualType type) {
  type = innermost_type(type);
  if (auto const *enumeration = type->getAs<EnumType>())
    if (QualType const integer = enumeration->getDecl()->getIntegerType(); !integer.isNull()) type = integer;
  return type->getAs<BuiltinType>();
}

// A cast between pointers reinterprets the bytes.
void Collector::reinterpretation(ExplicitCastExpr const *cast) {
  Expr const *from = cast->getSubExpr();
  if (cast->getCastKind() == CK_LValueToRValueBitCast && reals_.carries_real(from->getType()) &&
      !reals_.carries_real(cast->getType()))
    note(from->IgnoreParenImpCasts(), Use::bits);
  if (cast->getCastKind() != CK_BitCast && cast->getCastKind() != CK_LValueBitCast) return;
  QualType const source = cast->getSubExprAsWritten()->getType();
  BuiltinType const *before = innermost(source), *after = innermost(cast->getType());
  auto const is_bytes = [](BuiltinType const *type) {
    return type->isVoidType() || type->getKind() == BuiltinType::Char_S || type->getKind() == BuiltinType::Char_U ||
           type->getKind() == BuiltinType::UChar;
  };
  // (double *)((char *)p + n) is address arithmetic in bytes, as is a structure behind numbers. Integers are checked at
  // run time.
  auto const *sum = dyn_cast<BinaryOperator>(cast->getSubExprAsWritten()->IgnoreParens());
  if (sum && sum->isAdditiveOp() && !(after && is_bytes(after))) {
    for (Expr const *side : {sum->getLHS(), sum->getRHS()}) counting_casts_.insert(side->IgnoreParenImpCasts());
    if (after && after->isInteger()) note(cast->getSubExprAsWritten(), Use::bits);
  }
  if (RecordDecl const *record = innermost_type(cast->getType())->getAsRecordDecl();
      record && record->getDefinition() && before && before->getKind() == BuiltinType::Double &&
      !record->getDefinition()->field_empty() && !reals_.carries_real(innermost_type(cast->getType())))
    view(cast, false);
  if (!before || !after || before->getKind() == after->getKind()) return;
  bool const was_double = before->getKind() == BuiltinType::Double, is_double = after->getKind() == BuiltinType::Double;
  if (was_double && !after->isVoidType())
    later([this, cast, is_byte = is_bytes(after), is_integer = after->isInteger()] {
      if (!is_byte || !counting_casts_.contains(cast)) view(cast, is_integer);
    });
  if (is_double && !is_bytes(before))
    report(DiagnosticId::reinterpretation, cast->getBeginLoc(), source.getAsString() + " is read as a REAL");
}

// A cast from void *, which may have been the address of a REAL, or from a structure that holds some, to a pointer to
// integers.
void Collector::pointer_cast(CastExpr const *cast) {
  if (Expr const *pointer = cast->getSubExpr()->IgnoreParenImpCasts();
      cast->getCastKind() == CK_PointerToIntegral && ScalarState::has_address(pointer))
    decides(pointer);
  if (cast->getCastKind() != CK_BitCast || cast->isTypeDependent()) return;
  Expr const *from = cast->getSubExpr()->IgnoreParenImpCasts();
  QualType const to = cast->getType()->getPointeeType(), given = from->getType()->getPointeeType();
  if (to.isNull() || !to->isIntegralOrEnumerationType() || isa<CallExpr>(from)) return;
  bool const holds_numbers = !given.isNull() && given->isRecordType() && reals_.carries_real(given);
  if (from->getType()->isVoidPointerType() || holds_numbers) note(from, Use::bits);
}

// The pointer operand in (char *)&x + 4.
static Expr const *pointed_into(Expr const *pointer) {
  while (true) {
    pointer = pointer->IgnoreParenCasts();
    auto const *sum = dyn_cast<BinaryOperator>(pointer);
    if (!sum || !sum->isAdditiveOp()) return pointer;
    pointer = sum->getLHS()->getType()->isPointerType() ? sum->getLHS() : sum->getRHS();
  }
}

// An array, called by its own name, that holds state and may outlive the kernel.
bool Collector::is_lasting_array(Expr const *expression) const {
  expression = spelled_expression(expression);
  return expression->getType()->isArrayType() && holds_state(expression->getType()) && may_outlive(expression);
}

// Wraps a byte function. Returns whether the wrap reports all that the function reads and writes.
bool Collector::moved_bytes(CallExpr const *call, FunctionDecl const *function) {
  if (!function->getDeclName().isIdentifier()) return false;
  llvm::StringRef name = function->getName();
  name.consume_front("__builtin_");
  std::string how = name == "memset"                        ? "set"
                    : name == "memcmp"                      ? "compare"
                    : name == "memcpy" || name == "memmove" ? "move"
                    : name == "fread"                       ? "read"
                    : name == "fwrite"                      ? "write"
                                                            : "";
  bool const is_file = how == "read" || how == "write";
  if (how.empty() || call->getNumArgs() != (is_file ? 4 : 3)) return false;
  bool any = false;
  for (Expr const *argument : {call->getArg(0), call->getArg(is_file ? 0 : 1)}) {
    QualType const pointee = Reals::pointee(argument);
    any = any || is_lasting_array(argument) || (!pointee.isNull() && holds_state(pointee) && !is_character(pointee));
  }
  auto const *taken = dyn_cast<UnaryOperator>(pointed_into(call->getArg(0)));
  bool const is_number = taken && taken->getOpcode() == UO_AddrOf && Reals::is_double(taken->getSubExpr()->getType());
  if (bool const stores = how == "set" || how == "move"; stores && is_number)
    how += "_number";
  else if (stores && !any)
    how += "_bytes";
  for (unsigned index : {0u, 1u})
    if (QualType const pointee = Reals::pointee(pointed_into(call->getArg(index)));
        !is_file && how != "compare" && (index == 0 || how.starts_with("move")))
      any = any || (!pointee.isNull() && (reals_.carries_real(pointee) ||
                                          (index == 1 && pointee->isRecordType() && Storage::holds_pointer(pointee))));
  Expr const *callee = call->getCallee()->IgnoreParenImpCasts();
  std::optional<Span> const span = map_.range(callee->getSourceRange());
  if (!any || !span || !map_.in_roots(callee->getBeginLoc())) return false;
  // A structure without numbers as the target.
  QualType const target = Reals::pointee(call->getArg(0));
  if (how == "move" && !target.isNull() && target->isRecordType() && !reals_.carries_real(target)) how = "into";
  auto const words = [&](unsigned index) {
    Expr const *argument = call->getArg(index)->IgnoreParenImpCasts();
    std::optional<Span> const written = map_.range(argument->getSourceRange());
    return written ? normalised(map_.text(*written, argument->getBeginLoc())) : name.str();
  };
  // A move checks its source; a move of a number its target as well.
  std::string const what = how == "compare" ? words(0) + "' or '" + words(1)
                                            : words(how == "move" || how == "into" || how == "move_bytes" ? 1 : 0);
  std::string detail = how + ", " + in_quotes(what);
  detail.append(", ").append(in_quotes(to_string(map_.place(call->getBeginLoc()))));
  facts_.wraps.insert({*span, Use::bytes, detail});
  return !llvm::StringRef(how).ends_with("_bytes");
}

// Inline assembly works on its operands' bytes. A memory operand lacks a conversion that shows a use of its value.
void Collector::assembly(GCCAsmStmt const *assembly) {
  auto const refuse = [&](Expr const *operand) {
    if (reals_.carries_real(operand->getType()))
      report(DiagnosticId::boundary_call, operand->getBeginLoc(), "a REAL is an operand of assembly");
  };
  for (Expr const *operand : assembly->outputs()) refuse(operand);
  for (Expr const *operand : assembly->inputs()) refuse(operand);
  for (unsigned k = 0; k < assembly->getNumOutputs(); ++k)
    if (Expr const *operand = assembly->getOutputExpr(k); ScalarState::is_scalar(operand->getType()))
      scalar(operand, assembly->isOutputPlusConstraint(k) ? Use::read : Use::written);
  for (Expr const *operand : assembly->inputs())
    if (operand->isGLValue() && ScalarState::is_scalar(operand->getType())) scalar(operand, Use::read);
}

} // namespace symreal::rewrite
