#include "rewrite/pragma/pragma_items.h"

#include "rewrite/facts/facts.h"
#include "rewrite/model/object_layout.h"
#include "rewrite/model/storage.h"
#include "rewrite/source/walk.h"
#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

// The variable that the item's first name refers to, looking down the left edge of the expression.
ValueDecl const *base_of(Expr const *expression) {
  while (true) {
    expression = expression->IgnoreParenImpCasts();
    if (auto const *index = dyn_cast<ArraySubscriptExpr>(expression))
      expression = index->getBase();
    else if (auto const *member = dyn_cast<MemberExpr>(expression); member && !member->isImplicitAccess())
      expression = member->getBase();
    else if (auto const *call = dyn_cast<CXXOperatorCallExpr>(expression); call && call->getNumArgs() > 0)
      expression = call->getArg(0);
    else
      break;
  }
  if (auto const *reference = dyn_cast<DeclRefExpr>(expression)) return reference->getDecl();
  if (auto const *member = dyn_cast<MemberExpr>(expression)) return member->getMemberDecl();
  return nullptr;
}

// A parameter `double a[3][3]` is a pointer, but its declaration says how much it points to.
void take_declared_extents(ItemFact &item, ValueDecl const *declaration) {
  auto const *parameter = dyn_cast<ParmVarDecl>(declaration);
  if (!parameter || !item.base_is_name || !item.sections.empty()) return;
  auto const *decayed = parameter->getType()->getAs<DecayedType>();
  auto const *array = decayed ? dyn_cast<ConstantArrayType>(decayed->getOriginalType()) : nullptr;
  for (; array; array = dyn_cast<ConstantArrayType>(array->getElementType())) {
    item.expression += "[(0)+symreal_i[" + std::to_string(item.sections.size()) + "]]";
    item.sections.push_back({"0", std::to_string(array->getSize().getZExtValue())});
    item.section_on_base = true;
  }
}

std::string replaced(std::string text, std::string const &from, std::string const &to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

// Index of section k in an item's expression.
std::string index_of(Section const &section, std::size_t k) {
  return "(" + section.low + ")+symreal_i[" + std::to_string(k) + "]";
}

// A part of the expression as the user writes it, with [low:length].
std::string written(std::string text, std::vector<Section> const &sections) {
  for (std::size_t k = 0; k < sections.size(); ++k)
    text = replaced(std::move(text), "[" + index_of(sections[k], k) + "]",
                    "[" + sections[k].low + ":" + sections[k].length + "]");
  return text;
}

// The elements that one pair of brackets names, where declarations tell.
struct Elements {
  std::optional<std::int64_t> first, count;
  bool are_within(std::int64_t all) const {
    return *count == 0 || (*first >= 0 && *count > 0 && *first <= all - *count);
  }
};

Elements elements(std::string const &index, std::vector<Section> const &sections, LookUp look_up) {
  for (std::size_t k = 0; k < sections.size(); ++k)
    if (index == index_of(sections[k], k))
      return {constant_of(sections[k].low, look_up), constant_of(sections[k].length, look_up)};
  return {constant_of(index, look_up), 1};
}

class Bounds {
public:
  Bounds(ItemFact &item, LookUp look_up, Facts &facts) : item_(item), look_up_(look_up), facts_(facts) {}

  // Processes indices from left to right: tests inserted before a bracket shift later ones by `shift_`.
  void note(std::vector<ItemIndex> const &indices) {
    std::string tested = item_.expression;
    for (ItemIndex const &index : indices) {
      if (index.is_unbounded) continue;
      std::string const object = item_.expression.substr(index.object, index.open - index.object);
      std::string const inner = item_.expression.substr(index.open + 1, index.close - index.open - 1);
      Elements const named = elements(inner, item_.sections, look_up_);
      if (index.count && named.first && named.count) {
        if (named.are_within(*index.count)) continue;
        refuse(written(object, item_.sections), *index.count);
      }
      test(tested, index, object, inner); // refused ones, too: the original does not rely on them
    }
    if (tested != item_.expression) item_.tested = tested;
  }

private:
  void refuse(std::string const &object, std::int64_t count) {
    add_diagnostic(facts_, {DiagnosticId::section_beyond, item_.place, beyond_message(item_.label, object, count)});
  }

  // Earlier tests stand before this bracket, in the object or in front of it.
  void test(std::string &tested, ItemIndex const &index, std::string const &object, std::string const &inner) {
    std::string const name = in_quotes(written(object, item_.sections));
    std::size_t const behind = item_.expression.size() - index.close; // with the bracket
    std::size_t const close = tested.size() - behind, open = close - inner.size() - 1;
    if (index.count) {
      tested.replace(open + 1, inner.size(),
                     "SYMREAL_INDEX(" + std::to_string(*index.count) + ", " + name + ", " + inner + ")");
      return;
    }
    std::size_t const begin = index.object; // indices within an object follow the object itself
    std::string const now = tested.substr(begin, open - begin);
    tested.replace(begin, close + 1 - begin, "SYMREAL_ELEMENT(" + name + ", (" + inner + "), " + now + ")");
  }

  ItemFact &item_;
  LookUp look_up_;
  Facts &facts_;
};

// Static variables of each file, once each, in the order of their definitions.
class Statics : public Walk {
public:
  Statics(ASTContext &context, SourceMap const &map, ScalarState const &scalars)
      : map_(map),
        scalars_(scalars),
        names_(context) {}

  bool shouldVisitTemplateInstantiations() const override { return true; }
  bool TraverseDecl(Decl *declaration) override {
    return !declaration || map_.is_outside(declaration) || Walk::TraverseDecl(declaration);
  }

  bool VisitVarDecl(VarDecl *variable) override {
    if (!variable->hasGlobalStorage() || variable->isThisDeclarationADefinition() == VarDecl::DeclarationOnly ||
        variable->isTemplated() || !map_.in_roots(variable->getLocation()))
      return true;
    std::optional<Span> const span = map_.token(variable->getLocation());
    if (!span) return true;
    std::string const name = names_.getName(variable);
    if (met_.insert(span->file + " " + name).second)
      by_file[span->file] += (by_file[span->file].empty() ? "" : " ") + name;
    if (is_changeable(variable))
      changeable.insert(name);
    else if (QualType const type = variable->getType(); type->isReferenceType() || Storage::holds_pointer(type))
      changeable.insert("*" + name);
    return true;
  }

  std::map<std::string, std::string> by_file; // by real path, separated by blanks
  std::set<std::string> changeable;           // with a star, one that only leads to what may change

private:
  bool is_changeable(VarDecl const *variable) const {
    QualType const type = variable->getType();
    bool const is_constant = variable->getASTContext().getBaseElementType(type).isConstQualified();
    if (type->isReferenceType() || type->isDependentType()) return false;
    return !is_constant && !scalars_.is_fixed(variable);
  }

  SourceMap const &map_;
  ScalarState const &scalars_;
  ASTNameGenerator names_;
  std::set<std::string> met_;
};

} // namespace

Base kind_of(ValueDecl const *declaration, ASTContext const &context) {
  QualType const type = declaration->getType();
  if (type->isReferenceType()) return Base::object; // the object behind it need not be const
  if (auto const *pointer = type->getAs<PointerType>()) {
    if (!context.getBaseElementType(pointer->getPointeeType()).isConstQualified()) return Base::pointer;
    return type.isConstQualified() ? Base::const_pointer_to_const : Base::pointer_to_const;
  }
  bool const is_const = context.getBaseElementType(type).isConstQualified();
  // The caller gives a parameter its value, so the compiler does not know it.
  bool const may_be_known = isa<VarDecl>(declaration) && !isa<ParmVarDecl>(declaration);
  return is_const && may_be_known ? Base::const_object : Base::object;
}

void note_declaration(ItemFact &item, ValueDecl const *declaration) {
  if (!item.base_is_name) return;
  item.base_kind = kind_of(declaration, declaration->getASTContext());
  take_declared_extents(item, declaration);
}

bool takes_numbers(ClauseFact const &clause) { return info(clause.clause).has(trait::GIVEN | trait::RESULTS); }

void note_layout(ClauseFact const &clause, ItemFact &item, ItemType const &type, ASTContext const &context,
                 Reals const &reals, Facts &facts) {
  if (!takes_numbers(clause)) return;
  DescribedObject const object = describe_object(type.type, type.is_packed, context, reals);
  item.layout = object.layout;
  if (!object.refusal.empty())
    add_diagnostic(facts, {DiagnosticId::pragma_item, item.place,
                           "'" + item.label + "' " + object.refusal + ": name the numbers that are meant"});
  item.left_out = object.pointers;
  item.kept = object.others;
}

void note_bounds(ClauseFact const &clause, ItemFact &item, std::vector<ItemIndex> const &indices, LookUp look_up,
                 Facts &facts) {
  bool const names_objects = info(clause.clause).has(trait::OBJECTS) || clause.clause == Clause::implicit;
  if ((!names_objects && clause.clause != Clause::table) || item.expression.starts_with('&')) return;
  Bounds(item, look_up, facts).note(indices);
}

void note_item(Stmt const *statement, ASTContext const &context, Reals const &reals, ScalarState const &scalars,
               PragmaIndex const &index, Facts &facts) {
  auto const *expression = dyn_cast<Expr>(statement);
  auto const *cast = expression ? dyn_cast<CStyleCastExpr>(expression->IgnoreImplicit()) : nullptr;
  if (!cast) return;
  auto const at = index.statements.find(cast->getLParenLoc().getRawEncoding());
  if (at == index.statements.end()) return;
  ClauseFact &clause = facts.pragmas[at->second.pragma].clauses[at->second.clause];
  ItemFact &item = clause.items[at->second.item];
  if (item.seen) return;
  Expr const *what = cast->getSubExpr()->IgnoreParenImpCasts();
  item.seen = true;
  item.type = what->getType().getAsString();
  ValueDecl const *const base = base_of(what);
  if (base) note_declaration(item, base);
  bool const has_extents = !item.sections.empty() && what->getType()->isPointerType();
  CXXRecordDecl const *record = what->isTypeDependent() ? nullptr : what->getType()->getAsCXXRecordDecl();
  bool const is_sequence = record && record->hasDefinition() && !element_of(record).isNull();
  item.carries_real = what->isTypeDependent() || (has_extents || is_sequence ? reals.mentions_real(what->getType())
                                                                             : reals.carries_real(what->getType()));
  item.holds_scalar = scalars.holds(has_extents ? what->getType()->getPointeeType() : what->getType());
  note_layout(clause, item, type_of_item(what), context, reals, facts);
  auto const find = [base](std::string const &name) {
    return base && base->getIdentifier() && base->getName() == name ? base : nullptr;
  };
  note_bounds(clause, item, type_of_item(item.expression, context, nullptr, find).indices, find, facts);
}

void note_statics(ASTContext &context, SourceMap const &map, ScalarState const &scalars, Facts &facts) {
  Statics statics(context, map, scalars);
  statics.TraverseDecl(context.getTranslationUnitDecl());
  facts.changeable = std::move(statics.changeable);
  for (auto &[span, pragma] : facts.pragmas)
    for (ClauseFact &clause : pragma.clauses)
      for (ItemFact &item : clause.items) {
        if (!means_file(clause.clause, item) || !item.type.empty()) continue;
        item.type = "file";
        item.expression = in_quotes(statics.by_file[span.file]);
      }
}

} // namespace symreal::rewrite
