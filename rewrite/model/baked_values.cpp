#include "rewrite/model/library.h"
#include "rewrite/model/object_layout.h"
#include "rewrite/model/scalar_state.h"
#include "rewrite/model/signature.h"
#include "rewrite/source/walk.h"

#include <algorithm>
#include <set>

namespace symreal::rewrite {
namespace {

using namespace clang;

bool is_double(QualType type) { return type->isSpecificBuiltinType(BuiltinType::Double); }

bool is_function_pointer(QualType type) {
  return type->isFunctionPointerType() || type->isMemberPointerType() ||
         is_std_class(type->getAsCXXRecordDecl(), "function");
}

// Element type of a container indexed by number; null for maps, whose operator[] creates elements.
QualType element_in(CXXRecordDecl const *record) {
  if (is_std_class(record, "map") || is_std_class(record, "unordered_map")) return {};
  return record && record->hasDefinition() ? element_of(record->getDefinition()) : QualType();
}

// Whether the record is a container of containers of numbers, or a matrix, whose extents its size does not determine.
bool has_inner_extents(CXXRecordDecl const *record) {
  QualType const element = element_in(record);
  if (element.isNull()) return false;
  auto const *inner = element.getNonReferenceType()->getAsCXXRecordDecl();
  if (!inner)
    return is_double(element.getNonReferenceType().getCanonicalType().getUnqualifiedType()) &&
           !record->isInStdNamespace();
  for (QualType next = element; inner && !is_std_class(inner, "complex"); inner = next->getAsCXXRecordDecl()) {
    next = element_in(inner);
    if (next.isNull()) return false;
    next = next.getNonReferenceType();
    if (is_double(next.getCanonicalType().getUnqualifiedType())) return true;
  }
  return inner != nullptr;
}

// Whether the record is a standard library type whose state is unknown beyond whether it holds something.
bool is_opaque(CXXRecordDecl const *record) {
  constexpr llvm::StringLiteral names[] = {"optional", "variant", "any",  "map",        "unordered_map",
                                           "multimap", "set",     "list", "shared_ptr", "unique_ptr"};
  return llvm::any_of(names, [record](llvm::StringRef name) { return is_std_class(record, name); });
}

// Whether the type is a pointer to constant numbers, whose address means nothing in another program.
bool leads_to_constants(QualType type) {
  QualType const to = type->getPointeeType();
  if (to.isNull() || !to.isConstQualified() || to->isAnyCharacterType()) return false;
  return to->isArithmeticType() || (type->isPointerType() && (to->isRecordType() || to->isPointerType()));
}

// Whether the record is a class that is not rewritten, with unknown contents.
bool is_value_of_library(CXXRecordDecl const *record, ASTContext const &context) {
  SourceManager const &sources = context.getSourceManager();
  if (!record->hasDefinition() || !sources.isInSystemHeader(sources.getExpansionLoc(record->getLocation())))
    return false;
  return ScalarState::is_copied(record->getDefinition());
}

// Reason why a parameter that no clause names cannot be compared; empty if it can be, or need not.
std::string obstacle_of(QualType type, ASTContext const &context) {
  QualType const plain = type.getNonReferenceType();
  CXXRecordDecl const *record = plain->getAsCXXRecordDecl();
  bool const has_one_value = is_std_class(record, "type_info") || is_std_class(record, "atomic");
  if (is_opaque(record) || has_one_value || (record && is_value_of_library(record, context)))
    return "it is a " + record->getQualifiedNameAsString();
  if (QualType const to = plain->getPointeeType(); !to.isNull() && to.isConstQualified() && to->isAnyCharacterType())
    return "it is text of wide characters";
  if (plain->isUnionType()) return "it is a union";
  return type->isDependentType() && !type->isReferenceType() ? "its type depends on the template" : "";
}

// Collects the names mentioned by the kernel's function and by its callees, as far as this source has them.
class Mentioned : public Walk {
public:
  explicit Mentioned(FunctionDecl const *function) : context_(function->getASTContext()), kernel_(function) {
    follow(function);
    for (std::size_t k = 0; k < functions_.size() && k < most_functions; ++k) {
      now_ = functions_[k];
      TraverseStmt(now_->getBody());
    }
  }

  bool VisitMemberExpr(MemberExpr *member) override {
    if (auto const *field = dyn_cast<FieldDecl>(member->getMemberDecl())) {
      fields_.insert(field->getCanonicalDecl());
      bool const is_own = isa<CXXThisExpr>(member->getBase()->IgnoreParenImpCasts());
      if (is_own && now_ == kernel_ && field->getIdentifier()) own_fields.insert(field);
    }
    return true;
  }
  bool VisitDeclRefExpr(DeclRefExpr *reference) override {
    auto const *variable = dyn_cast<VarDecl>(reference->getDecl());
    if (variable && variable->hasGlobalStorage() && !variable->isLocalVarDecl() &&
        is_function_pointer(variable->getType()) && !variable->getType().isConstQualified())
      called_variables.insert(variable);
    return true;
  }
  // Whether two arguments are one object, or how far apart they lie.
  bool VisitBinaryOperator(BinaryOperator *operation) override {
    Expr const *left = operation->getLHS(), *right = operation->getRHS();
    bool const are_pointers = left->getType()->isPointerType() && right->getType()->isPointerType();
    if (now_ != kernel_ || !are_pointers || (!operation->isComparisonOp() && operation->getOpcode() != BO_Sub))
      return true;
    for (Expr const *side : {left, right})
      if (side->isNullPointerConstant(context_, Expr::NPC_ValueDependentIsNotNull)) return true;
    bool const are_arguments = is_argument(left) && is_argument(right);
    if (are_arguments && operation->isComparisonOp())
      comparisons.insert(words(left) + " " + operation->getOpcodeStr().str() + " " + words(right));
    relate(parameter_of(left), parameter_of(right), are_arguments && operation->isEqualityOp());
    return true;
  }
  bool VisitUnaryOperator(UnaryOperator *operation) override {
    if (operation->isIncrementDecrementOp())
      if (auto const *stepped = parameter_of(operation->getSubExpr())) stepped_.insert(stepped);
    return true;
  }
  bool VisitCompoundAssignOperator(CompoundAssignOperator *operation) override {
    if (auto const *stepped = parameter_of(operation->getLHS())) stepped_.insert(stepped);
    return true;
  }
  bool VisitCallExpr(CallExpr *call) override {
    if (auto const *callee = call->getDirectCallee()) {
      follow(callee);
      if (callee->isInStdNamespace()) range(call->arguments());
    }
    if (!isa<CXXOperatorCallExpr>(call))
      for (Expr const *argument : call->arguments()) sized(argument);
    return true;
  }
  bool VisitCXXConstructExpr(CXXConstructExpr *made) override {
    follow(made->getConstructor());
    if (made->getConstructor()->isInStdNamespace()) range(made->arguments());
    for (Expr const *argument : made->arguments()) sized(argument);
    return true;
  }
  // A loop through a container, or a call that is given it, may go by its extent.
  bool VisitCXXForRangeStmt(CXXForRangeStmt *loop) override {
    sized(loop->getRangeInit());
    return true;
  }
  bool VisitCXXMemberCallExpr(CXXMemberCallExpr *call) override {
    CXXMethodDecl const *method = call->getMethodDecl();
    if (method && method->getIdentifier() && method->getName() != "data" && method->getName() != "at")
      sized(call->getImplicitObjectArgument());
    auto const *member = dyn_cast<MemberExpr>(call->getCallee()->IgnoreParens());
    if (!method || !member || !method->isVirtual() || member->hasQualifier() || method->hasAttr<FinalAttr>() ||
        method->getParent()->hasAttr<FinalAttr>())
      return true;
    Expr const *object = member->getBase()->IgnoreParenImpCasts();
    if (isa<CXXThisExpr>(object)) virtual_on.insert("*this");
    auto const *reference = dyn_cast<DeclRefExpr>(object);
    auto const *parameter = reference && now_ == kernel_ ? dyn_cast<ParmVarDecl>(reference->getDecl()) : nullptr;
    if (parameter && (member->isArrow() || parameter->getType()->isReferenceType()))
      virtual_on.insert((member->isArrow() ? "*" : "") + parameter->getNameAsString());
    return true;
  }

  bool has(FieldDecl const *field) const { return fields_.contains(field->getCanonicalDecl()); }

  // Pointer parameters that end a range which another one begins, or that are compared with one by distance.
  std::set<ParmVarDecl const *> ends() const {
    std::set<ParmVarDecl const *> all = ends_;
    for (auto const &[one, other] : equal_)
      if (stepped_.contains(one) || stepped_.contains(other)) all.insert(one);
    return all;
  }

  std::set<FieldDecl const *> own_fields; // of the kernel's own object, in its own text
  std::set<VarDecl const *> called_variables;
  std::set<std::string> virtual_on;  // objects with virtual calls by the kernel
  std::set<std::string> comparisons; // of pointers
  std::set<std::string> sized_by;    // parameters by whose extents it may go

private:
  ParmVarDecl const *parameter_of(Expr const *expression) const {
    auto const *reference = dyn_cast<DeclRefExpr>(expression->IgnoreParenImpCasts());
    auto const *parameter = reference && now_ == kernel_ ? dyn_cast<ParmVarDecl>(reference->getDecl()) : nullptr;
    return parameter && parameter->getType()->isPointerType() ? parameter : nullptr;
  }
  void relate(ParmVarDecl const *one, ParmVarDecl const *other, bool are_equated) {
    if (are_equated && one && other) return void(equal_.insert({one, other}));
    if (one) ends_.insert(one);
    if (other) ends_.insert(other);
  }
  // Neighbours among the arguments of a function of the standard library.
  template <class Arguments> void range(Arguments arguments) {
    ParmVarDecl const *before = nullptr;
    for (Expr const *argument : arguments) {
      ParmVarDecl const *now = parameter_of(argument);
      if (before && now) ends_.insert(now);
      before = now;
    }
  }

  void sized(Expr const *expression) {
    auto const *reference = expression ? dyn_cast<DeclRefExpr>(expression->IgnoreParenImpCasts()) : nullptr;
    if (reference && now_ == kernel_ && isa<ParmVarDecl>(reference->getDecl()))
      sized_by.insert(reference->getDecl()->getNameAsString());
  }
  // A parameter that is a pointer, or the address of one that is a reference.
  static Expr const *named(Expr const *expression) {
    expression = expression->IgnoreParenImpCasts();
    auto const *address = dyn_cast<UnaryOperator>(expression);
    return address && address->getOpcode() == UO_AddrOf ? address->getSubExpr()->IgnoreParenImpCasts() : expression;
  }
  static bool is_argument(Expr const *expression) {
    auto const *reference = dyn_cast<DeclRefExpr>(named(expression));
    auto const *parameter = reference ? dyn_cast<ParmVarDecl>(reference->getDecl()) : nullptr;
    bool const is_address = isa<UnaryOperator>(expression->IgnoreParenImpCasts());
    return parameter && is_address == parameter->getType()->isReferenceType();
  }
  static std::string words(Expr const *expression) {
    bool const is_address = isa<UnaryOperator>(expression->IgnoreParenImpCasts());
    return (is_address ? "&" : "") + cast<DeclRefExpr>(named(expression))->getDecl()->getNameAsString();
  }

  static constexpr std::size_t most_functions = 2000;

  void follow(FunctionDecl const *function) {
    FunctionDecl const *definition = nullptr;
    if (function->hasBody(definition) && definition->getBody() && known_.insert(definition).second)
      functions_.push_back(definition);
  }

  ASTContext &context_;
  FunctionDecl const *kernel_, *now_ = nullptr;
  std::set<FieldDecl const *> fields_;
  std::set<ParmVarDecl const *> ends_, stepped_;
  std::set<std::pair<ParmVarDecl const *, ParmVarDecl const *>> equal_;
  std::set<FunctionDecl const *> known_;
  std::vector<FunctionDecl const *> functions_;
};

class Shapes {
public:
  Shapes(FunctionDecl const *function, Mentioned const &mentioned)
      : function_(function),
        context_(function->getASTContext()),
        mentioned_(mentioned) {}

  // Names of the pointers to constants that an object of the type contains and the kernel reads.
  std::vector<std::string> pointers_to_constants(QualType type) const {
    std::vector<std::string> found;
    RecordDecl const *record = context_.getBaseElementType(type.getNonReferenceType())->getAsRecordDecl();
    if (!record || !record->getDefinition()) return found;
    for (FieldDecl const *field : record->getDefinition()->fields()) {
      if (!mentioned_.has(field)) continue;
      if (leads_to_constants(context_.getBaseElementType(field->getType())))
        found.push_back(field->getNameAsString());
      else
        llvm::append_range(found, pointers_to_constants(field->getType()));
    }
    return found;
  }

  // Empty where there is nothing to compare.
  std::string of(QualType type, bool is_object) const {
    std::string reason;
    std::string const text = shape(type, is_object, reason);
    return reason.empty() ? text : "?" + reason;
  }

private:
  std::string shape(QualType type, bool is_object, std::string &reason) const {
    type = type.getNonReferenceType().getCanonicalType().getUnqualifiedType();
    if (type->isDependentType()) return "@";
    if (auto const *array = context_.getAsConstantArrayType(type)) {
      std::string const inner = shape(array->getElementType(), is_object, reason);
      return inner.empty() ? "" : "[" + std::to_string(array->getSize().getZExtValue()) + "]" + inner;
    }
    if (is_double(type)) return is_object ? "" : "d";
    if (type->isSpecificBuiltinType(BuiltinType::LongDouble)) return "l";
    if (type->isRealFloatingType()) return "d";
    if (type->isIntegralOrEnumerationType()) return context_.getTypeSize(type) <= 64 ? "i" : "";
    if (is_function_pointer(type)) return "f";
    if (type->isPointerType() || type->isNullPtrType()) return "p";
    if (RecordDecl const *record = type->getAsRecordDecl()) return of_record(record, is_object, reason);
    return "";
  }

  std::string of_record(RecordDecl const *record, bool is_object, std::string &reason) const {
    record = record->getDefinition();
    if (!record) return "";
    if (auto const *derived = dyn_cast<CXXRecordDecl>(record)) {
      if (is_std_class(derived, "complex")) return is_object ? "" : "@";
      if (QualType const element = element_of(derived); !element.isNull()) {
        if (is_object && has_inner_extents(derived)) return "z";
        bool const is_number = is_double(element.getNonReferenceType().getCanonicalType().getUnqualifiedType());
        return is_number && is_object ? "" : "@";
      }
      if (derived->isInStdNamespace() && !is_std_class(derived, "pair")) {
        if (!is_object) reason = "it is a " + derived->getQualifiedNameAsString();
        return "";
      }
    }
    if (record->isUnion()) {
      if (!is_object) reason = "it is a union";
      return "";
    }
    std::string list;
    members(record, is_object, list, reason);
    return list.empty() ? "" : "{" + list + "}";
  }

  bool may_name(FieldDecl const *field, CXXRecordDecl const *record) const {
    if (!record || field->getAccess() == AS_public || field->getAccess() == AS_none) return true;
    auto const *method = dyn_cast<CXXMethodDecl>(function_);
    return method && (method->getParent()->getCanonicalDecl() == record->getCanonicalDecl() ||
                      (field->getAccess() == AS_protected && method->getParent()->isDerivedFrom(record)));
  }

  void members(RecordDecl const *record, bool is_object, std::string &list, std::string &reason) const {
    auto const *derived = dyn_cast<CXXRecordDecl>(record);
    if (derived)
      for (CXXBaseSpecifier const &base : derived->bases())
        if (auto const *shared = base.getType()->getAsCXXRecordDecl(); shared && shared->hasDefinition())
          members(shared->getDefinition(), is_object, list, reason);
    for (FieldDecl const *field : record->fields()) {
      RecordDecl const *unnamed = field->getIdentifier() ? nullptr : field->getType()->getAsRecordDecl();
      if (unnamed) {
        if (!unnamed->isUnion()) members(unnamed->getDefinition(), is_object, list, reason);
        continue;
      }
      if (!field->getIdentifier() || (!mentioned_.has(field) && is_object)) continue;
      std::string const what = shape(field->getType(), is_object, reason);
      if (what.empty()) continue;
      if (!may_name(field, derived)) {
        if (!mentioned_.has(field)) continue; // nor can the kernel's text
        if (is_object && what != "p") list += field->getNameAsString() + ":x;";
        if (!is_object) reason = "its member '" + field->getNameAsString() + "' is private";
        continue;
      }
      list += field->getNameAsString() + ":" + (field->isBitField() ? "b" : what) + ";";
    }
  }

  FunctionDecl const *function_;
  ASTContext const &context_;
  Mentioned const &mentioned_;
};

} // namespace

std::vector<Baked> baked_values(FunctionDecl const *function, std::vector<BakedItem> const &items, Place const &place) {
  Mentioned const mentioned(function);
  Shapes const shapes(function, mentioned);
  std::vector<Baked> found;
  auto const add = [&](Baked one) {
    bool const is_known = std::any_of(found.begin(), found.end(), [&](Baked const &other) {
      return other.expression == one.expression && other.shape == one.shape;
    });
    if (!one.shape.empty() && !is_known) found.push_back(std::move(one));
  };
  auto const names_elements = [&items](std::string const &pointer) {
    return std::any_of(items.begin(), items.end(), [&](BakedItem const &one) {
      return (one.expression == pointer && !one.sections.empty()) || one.expression == "*" + pointer;
    });
  };
  // Is a pointer of the item left without a clause for the constants that it leads to?
  auto const leaves_constants = [&](BakedItem const &item) {
    if (!item.is_constant) return false;
    if (item.sections.empty() && leads_to_constants(item.type)) return !names_elements(item.expression);
    return llvm::any_of(shapes.pointers_to_constants(item.type), [&](std::string const &member) {
      return llvm::none_of(items, [&](BakedItem const &one) {
        return !one.sections.empty() && llvm::StringRef(one.expression).ends_with(member);
      });
    });
  };
  for (BakedItem const &item : items)
    if (!item.type.isNull() && leaves_constants(item))
      add({item.label,
           item.expression,
           {},
           "?it leads to constants: name those as well, as in constant(p[0:n])",
           false,
           item.place});
    else if (!item.type.isNull())
      add({item.label, item.expression, item.sections, shapes.of(item.type, !item.is_constant), !item.is_constant,
           item.place});
  for (ParmVarDecl const *parameter : function->parameters()) {
    std::string const name = parameter->getNameAsString();
    QualType const type = parameter->getType();
    bool const is_item = std::any_of(items.begin(), items.end(), [&](BakedItem const &one) {
      return one.expression == name || one.expression == "*" + name || one.expression.starts_with(name + "[");
    });
    bool const has_sections = std::any_of(items.begin(), items.end(), [&](BakedItem const &one) {
      return !one.sections.empty() && one.expression == name;
    });
    bool const is_container = !element_in(type.getNonReferenceType()->getAsCXXRecordDecl()).isNull();
    bool const is_constant = std::any_of(items.begin(), items.end(), [&](BakedItem const &one) {
      return one.is_constant && !one.sections.empty() && one.expression == name;
    });
    if (is_constant && type->isPointerType()) add({name, name, {}, "p", false, place});
    if (is_item && has_sections && is_container && mentioned.sized_by.contains(name))
      add({name, name, {}, "z", false, place});
    if (name.empty() || !parameter->isReferenced() || is_item) continue;
    QualType const plain = type.getNonReferenceType();
    CXXRecordDecl const *record = plain->getAsCXXRecordDecl();
    bool const is_string = is_std_class(record, "basic_string") || is_std_class(record, "basic_string_view");
    std::string const obstacle = obstacle_of(type, function->getASTContext());
    if (is_function_pointer(plain) || plain->isFunctionType() || is_string)
      add({name, name, {}, is_string ? "@" : "f", false, place});
    else if (is_constant_text(type))
      add({name, name, {}, "s", false, place});
    else if (!element_in(record).isNull())
      add({name, name, {}, "z", false, place});
    else if (!obstacle.empty())
      add({name, name, {}, "?" + obstacle, false, place});
    else if (!type->isReferenceType())
      add({name, name, {}, shapes.of(type, type->isRecordType()), false, place});
  }
  for (ParmVarDecl const *end : mentioned.ends())
    for (ParmVarDecl const *begin : function->parameters()) {
      bool const is_one_kind = begin != end && !begin->getName().empty() && begin->getType()->isPointerType() &&
                               function->getASTContext().hasSameUnqualifiedType(begin->getType()->getPointeeType(),
                                                                                end->getType()->getPointeeType());
      std::string const distance = end->getNameAsString() + " - " + begin->getNameAsString();
      if (is_one_kind) add({distance, "(unsigned long long)(" + distance + ")", {}, "o", false, place});
    }
  for (FieldDecl const *field : mentioned.own_fields)
    if (QualType const type = field->getType(); is_function_pointer(type) || type->isPointerType())
      add({field->getNameAsString(),
           field->getNameAsString(),
           {},
           is_function_pointer(type) ? "f" : "p",
           false,
           place});
  for (VarDecl const *variable : mentioned.called_variables)
    add({variable->getNameAsString(), variable->getQualifiedNameAsString(), {}, "f", false, place});
  if (function->isVariadic())
    add({"...", "...", {}, "?the kernel may read any of the variable arguments", false, place});
  if (function->isTemplated()) add({"the arguments of the template", "__PRETTY_FUNCTION__", {}, "s", false, place});
  for (std::string const &comparison : mentioned.comparisons) add({comparison, comparison, {}, "c", false, place});
  for (std::string const &object : mentioned.virtual_on) add({object, object, {}, "t", false, place});
  return found;
}

} // namespace symreal::rewrite
