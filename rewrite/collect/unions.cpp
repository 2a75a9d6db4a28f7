// Unions of numbers and of something else: a store replaces bits of a number, and a read may see those of a node.
#include "rewrite/collect/handlers.h"
#include "rewrite/collect/views.h"

#include <clang/AST/ParentMapContext.h>

namespace symreal::rewrite {
using namespace clang;

namespace {

FieldDecl const *field_of(MemberExpr const *member) { return dyn_cast<FieldDecl>(member->getMemberDecl()); }

// In u.part.low or u.bytes[i], the member for which `is` holds; null if none does.
template <class Is> MemberExpr const *member_in(Expr const *object, Is is) {
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
std::string bits_within(Expr const *part, Expr const *base, ASTContext &context) {
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

class Unions : public Loads {
public:
  Unions(SyntaxTable &table, Views &views) : Loads(table), views_(views) {
    on<MemberExpr>(RUNNING | INSTANCES, &Unions::union_member);
    on<BinaryOperator>(RUNNING, &Unions::assignment);
  }

private:
  // A member of a union that shares its bytes with a number and holds none.
  bool shares_bytes(FieldDecl const *field) const {
    if (!field || !field->getParent()->isUnion() || field->getType()->isDependentType()) return false;
    QualType const type = field->getType();
    if (reals_.mentions_real(type) || type->isPointerType()) return false;
    return reals_.carries_real(context_.getRecordType(field->getParent()));
  }

  // Whether the field is a union member that holds numbers and shares its bytes with something else.
  bool shares_number(FieldDecl const *field) const {
    if (!field || !field->getParent()->isUnion() || field->getType()->isDependentType()) return false;
    auto const fields = field->getParent()->fields();
    return reals_.carries_real(field->getType()) &&
           std::any_of(fields.begin(), fields.end(), [this](FieldDecl const *other) { return shares_bytes(other); });
  }

  // Reading u.bits of `union { double number; uint64_t bits; }` is harmless as long as the number is an ordinary one.
  void union_member(MemberExpr const *member) {
    FieldDecl const *field = field_of(member);
    if (shares_number(field) && Reals::is_double(field->getType()))
      later([this, member] {
        if (!all_.judged.contains(member)) number_of_union(member);
      });
    if (!shares_bytes(field)) return;
    later([this, member, field] {
      if (!all_.judged.contains(member) && !views_.view_of_union(whole_member(member))) bits_of_union(member, field);
    });
  }

  void bits_of_union(MemberExpr const *member, FieldDecl const *field) {
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
  Expr const *whole_member(MemberExpr const *member) const {
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
  void store_to_union(Expr const *left) {
    MemberExpr const *member = member_in(left, [this](FieldDecl const *field) { return shares_bytes(field); });
    bool const is_part = member != nullptr;
    if (is_part) all_.judged.insert(member);
    if (!member) member = member_in(left, [this](FieldDecl const *field) { return shares_number(field); });
    if (!member) return;
    if (ScalarState::has_address(left))
      note(left, Use::part, nullptr, "stored, 0, 0, ");
    else if (Expr const *base = member->getBase()->IgnoreParenImpCasts(); !member->isImplicitAccess())
      note(base, Use::part, left, "stored, " + bits_within(left, base, context_) + ", ");
  }

  // A number in a union is read.
  void number_of_union(Expr const *value) {
    if (member_in(value, [this](FieldDecl const *field) { return shares_number(field); }))
      note(value, Use::part, nullptr, "used, 0, 0, ");
  }

  void assignment(BinaryOperator const *assignment) {
    Expr const *left = assignment->getLHS()->IgnoreParens();
    if (assignment->getOpcode() != BO_Assign || assignment->isTypeDependent() || left->isTypeDependent()) return;
    store_to_union(left);
    for (auto const *member = dyn_cast<MemberExpr>(left); member;
         member = dyn_cast<MemberExpr>(member->getBase()->IgnoreParenImpCasts()))
      all_.judged.insert(member); // the old contents of an overwritten union do not matter
  }

  void read(Expr const *object) override {
    if (!reals_.table_of(object) && object->isGLValue() && Reals::is_double(object->getType())) number_of_union(object);
  }

  Views &views_;
};

} // namespace

void add_unions(SyntaxTable &table, Views &views) { table.add<Unions>(views); }

} // namespace symreal::rewrite
