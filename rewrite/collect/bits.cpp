// Uses of the bytes of a REAL: casts of pointers, functions that move or look at bytes, assembly. A node must not be
// taken for the bytes of its value; where only the run can tell, it is asked.
#include "rewrite/collect/handlers.h"
#include "rewrite/collect/views.h"
#include "rewrite/model/library.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

// Type behind all pointers, references and arrays.
QualType innermost_type(QualType type) {
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
BuiltinType const *innermost(QualType type) {
  type = innermost_type(type);
  if (auto const *enumeration = type->getAs<EnumType>())
    if (QualType const integer = enumeration->getDecl()->getIntegerType(); !integer.isNull()) type = integer;
  return type->getAs<BuiltinType>();
}

// The pointer operand in (char *)&x + 4.
Expr const *pointed_into(Expr const *pointer) {
  while (true) {
    pointer = pointer->IgnoreParenCasts();
    auto const *sum = dyn_cast<BinaryOperator>(pointer);
    if (!sum || !sum->isAdditiveOp()) return pointer;
    pointer = sum->getLHS()->getType()->isPointerType() ? sum->getLHS() : sum->getRHS();
  }
}

class BytesOfNumbers : public ObjectUses {
public:
  BytesOfNumbers(SyntaxTable &table, Views &views) : ObjectUses(table), views_(views) {
    on<CallExpr>(NUMBERS, &BytesOfNumbers::bytes_of_arguments);
    on<CallExpr>(NUMBERS, &BytesOfNumbers::given_to_free);
    on<AtomicExpr>(NUMBERS | INSTANCES, &BytesOfNumbers::atomic_builtin);
    on<ExplicitCastExpr>(NUMBERS, &BytesOfNumbers::reinterpretation);
    on<CastExpr>(RUNNING, &BytesOfNumbers::pointer_cast);
    on<GCCAsmStmt>(NUMBERS, &BytesOfNumbers::assembly);
    on<CallSite>(INSTANCES, &BytesOfNumbers::instantiated_site);
    on<ExplicitCastExpr>(INSTANCES, &BytesOfNumbers::instantiated_cast);
  }

private:
  // Functions of the library that look at bytes by themselves.
  void bytes_of_arguments(CallExpr const *call) {
    FunctionDecl const *function = call->getDirectCallee();
    if (!function) return;
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
    if (used)
      report(DiagnosticId::reinterpretation, call->getBeginLoc(), "the bytes of a REAL are used as another type");
    if (!name.contains("compare_exchange")) return;
    // Compare-exchange on a number itself compares values in the symbolic program.
    QualType object;
    if (auto const *member = dyn_cast<CXXMemberCallExpr>(call))
      object = argument_of_class(member->getImplicitObjectArgument()->getType());
    else if (call->getNumArgs() > 0)
      object = argument_of_class(Reals::pointee(call->getArg(0)));
    if (reals_.carries_real(object) && !Reals::is_double(object))
      report(DiagnosticId::reinterpretation, call->getBeginLoc(),
             "the bytes of an object that holds REALs are compared");
  }

  void atomic_builtin(AtomicExpr const *call) {
    if (!map_.in_roots(call->getBeginLoc())) return;
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

  // A cast between pointers reinterprets the bytes.
  void reinterpretation(ExplicitCastExpr const *cast) {
    if (cast->isTypeDependent() || cast->getSubExpr()->isTypeDependent()) return;
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
    // (double *)((char *)p + n) is address arithmetic in bytes, as is a structure behind numbers. Integers are checked
    // at run time.
    auto const *sum = dyn_cast<BinaryOperator>(cast->getSubExprAsWritten()->IgnoreParens());
    if (sum && sum->isAdditiveOp() && !(after && is_bytes(after))) {
      for (Expr const *side : {sum->getLHS(), sum->getRHS()}) counting_casts_.insert(side->IgnoreParenImpCasts());
      if (after && after->isInteger()) note(cast->getSubExprAsWritten(), Use::bits);
    }
    if (RecordDecl const *record = innermost_type(cast->getType())->getAsRecordDecl();
        record && record->getDefinition() && before && before->getKind() == BuiltinType::Double &&
        !record->getDefinition()->field_empty() && !reals_.carries_real(innermost_type(cast->getType())))
      views_.view(cast, false);
    if (!before || !after || before->getKind() == after->getKind()) return;
    bool const was_double = before->getKind() == BuiltinType::Double,
               is_double = after->getKind() == BuiltinType::Double;
    if (was_double && !after->isVoidType())
      later([this, cast, is_byte = is_bytes(after), is_integer = after->isInteger()] {
        if (!is_byte || !counting_casts_.contains(cast)) views_.view(cast, is_integer);
      });
    if (is_double && !is_bytes(before))
      report(DiagnosticId::reinterpretation, cast->getBeginLoc(), source.getAsString() + " is read as a REAL");
  }

  // A cast from void *, which may have been the address of a REAL, or from a structure that holds some, to a pointer to
  // integers.
  void pointer_cast(CastExpr const *cast) {
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

  // Inline assembly works on its operands' bytes. A memory operand lacks a conversion that shows a use of its value.
  void assembly(GCCAsmStmt const *assembly) {
    auto const refuse = [&](Expr const *operand) {
      if (reals_.carries_real(operand->getType()))
        report(DiagnosticId::boundary_call, operand->getBeginLoc(), "a REAL is an operand of assembly");
    };
    if (!map_.in_roots(assembly->getBeginLoc())) return;
    for (Expr const *operand : assembly->outputs()) refuse(operand);
    for (Expr const *operand : assembly->inputs()) refuse(operand);
    for (unsigned k = 0; k < assembly->getNumOutputs(); ++k)
      if (Expr const *operand = assembly->getOutputExpr(k); ScalarState::is_scalar(operand->getType()))
        scalar(operand, assembly->isOutputPlusConstraint(k) ? Use::read : Use::written);
    for (Expr const *operand : assembly->inputs())
      if (operand->isGLValue() && ScalarState::is_scalar(operand->getType())) scalar(operand, Use::read);
  }

  // Uses of bytes in an instantiation, which its template does not show.
  void instantiated_site(CallSite const *site) {
    if (auto const *call = dyn_cast<CallExpr>(site->expression)) {
      moved_bytes(call, site->function);
      bytes_of_arguments(call);
    }
    if (reals_.in_roots(site->function)) return;
    for (unsigned i = 0; i < site->arguments.size(); ++i) given_bytes(site->function, i, site->arguments[i]);
  }

  void instantiated_cast(ExplicitCastExpr const *cast) {
    reinterpretation(cast);
    pointer_cast(cast);
  }

  // A cast for free or realloc reads nothing.
  void given_to_free(CallExpr const *call) {
    FunctionDecl const *function = call->getDirectCallee();
    if (function && function->getIdentifier() && (function->getName() == "free" || function->getName() == "realloc") &&
        call->getNumArgs() > 0)
      counting_casts_.insert(call->getArg(0)->IgnoreParenImpCasts());
  }

  Views &views_;
  llvm::SmallPtrSet<Expr const *, 4> counting_casts_; // to bytes, only for address arithmetic or free
};

} // namespace

// Adds a run-time check for symbolic bytes: of one object its own, behind a pointer all that may lie there.
void ObjectUses::looked_into(Expr const *address) {
  auto const *taken = dyn_cast<UnaryOperator>(address->IgnoreParens());
  bool const is_one = taken && taken->getOpcode() == UO_AddrOf && !isa<ArraySubscriptExpr>(taken->getSubExpr());
  bool const is_structure = address->getType()->isPointerType() && address->getType()->getPointeeType()->isRecordType();
  note(address, is_one || is_structure ? Use::bits : Use::view);
}

// The address of an object goes to a function outside the roots that takes any.
void ObjectUses::given_bytes(FunctionDecl const *function, unsigned index, Expr const *argument) {
  if (index >= function->getNumParams() || !function->getParamDecl(index)->getType()->isVoidPointerType()) return;
  QualType const pointee = Reals::pointee(argument);
  if (!pointee.isNull() && !moves_bytes(function) && reals_.carries_real(pointee))
    looked_into(argument->IgnoreParenImpCasts());
}

// An array, called by its own name, that holds state and may outlive the kernel.
bool ObjectUses::is_lasting_array(Expr const *expression) const {
  expression = spelled_expression(expression);
  return expression->getType()->isArrayType() && holds_state(expression->getType()) && may_outlive(expression);
}

// Wraps a byte function. Returns whether the wrap reports all that the function reads and writes.
bool ObjectUses::moved_bytes(CallExpr const *call, FunctionDecl const *function) {
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

void add_bytes(SyntaxTable &table, Views &views) { table.add<BytesOfNumbers>(views); }

} // namespace symreal::rewrite
