#include "rewrite/unit/choices.h"

#include "engine/support/parallel.h"
#include "engine/support/progress.h"
#include "rewrite/source/walk.h"
#include "rewrite/unit/collect_source.h"

#include <regex>

namespace symreal::rewrite {
namespace {

using namespace clang;

// The names of our types, as the original has them.
std::string in_original(std::string name) {
  static constexpr std::pair<llvm::StringLiteral, llvm::StringLiteral> names[] = {
      {"class ", ""},
      {"symreal::types::RealNumber", "double"},
      {"symreal::types::SymbolicBool", "bool"},
  };
  for (auto const &[ours, original] : names)
    for (std::size_t at; (at = name.find(ours)) != name.npos;) name.replace(at, ours.size(), original.str());
  if (name.find("symreal::") == name.npos) return name;
  static std::regex const integer("symreal::types::SymbolicInt<([a-z ]+)>");
  return std::regex_replace(name, integer, "$1");
}

bool is_about_numbers(std::string const &name) { return name.find("double") != name.npos; }

// A class or function without a name of its own prints with a place.
bool is_nameless(std::string const &name) {
  return name.find("(lambda") != name.npos || name.find("(anonymous") != name.npos ||
         name.find("(unnamed") != name.npos;
}

class Walker : public Walk {
public:
  Walker(ASTContext &context, SourceMap const &map) : context_(context), map_(map), policy_(map.language()) {
    policy_.PrintCanonicalTypes = true;
    policy_.SuppressTagKeyword = true;
  }

  CollectedChoices collected;

  bool shouldVisitTemplateInstantiations() const override { return true; }
  bool TraverseDecl(Decl *declaration) override {
    if (!declaration || map_.is_outside(declaration)) return true;
    auto const *function = dyn_cast<FunctionDecl>(declaration);
    if (!function || is_of_lambda(function)) return Walk::TraverseDecl(declaration);
    if (function->isDependentContext()) return true; // its instantiations are walked
    std::string outer = std::exchange(function_, name_of(function));
    bool const more = Walk::TraverseDecl(declaration);
    function_ = std::move(outer);
    return more;
  }
  bool TraverseStaticAssertDecl(StaticAssertDecl *) override { return true; } // one that fails is an error

  bool VisitCallExpr(CallExpr *call) override {
    FunctionDecl const *function = call->getDirectCallee();
    auto const *name = dyn_cast<DeclRefExpr>(call->getCallee()->IgnoreParenImpCasts());
    if (function) chosen(call->getBeginLoc(), function, name && name->hadMultipleCandidates());
    return true;
  }
  bool VisitCXXConstructExpr(CXXConstructExpr *construction) override {
    CXXConstructorDecl const *constructor = construction->getConstructor();
    if (!constructor->isImplicit() && !constructor->isCopyOrMoveConstructor())
      chosen(construction->getBeginLoc(), constructor, construction->hadMultipleCandidates());
    return true;
  }
  bool VisitIfStmt(IfStmt *statement) override {
    Expr const *condition = statement->getCond();
    bool value = false;
    if (statement->isConstexpr() && is_about_numbers(function_) && !condition->isValueDependent() &&
        condition->EvaluateAsBooleanCondition(value, context_)) {
      add(statement->getIfLoc(), "the condition of this `if constexpr`", value ? "true" : "false");
      collected.asks = true;
    }
    return true;
  }
  // A constant of a template: is_class<double>::value, is_class_v<double>.
  bool VisitDeclRefExpr(DeclRefExpr *reference) override {
    ValueDecl const *constant = reference->getDecl();
    auto const *variable = dyn_cast<VarDecl>(constant);
    bool const is_constant = isa<EnumConstantDecl>(constant) ||
                             (variable && variable->hasGlobalStorage() && variable->getType().isConstQualified());
    if (!is_constant || !reference->getType()->isIntegralOrEnumerationType()) return true;
    // The qualifier as spelled: true_type::value does not show the question.
    NestedNameSpecifier const *qualifier = reference->getQualifier();
    Type const *scope = qualifier ? qualifier->getAsType() : nullptr;
    std::string const name =
        scope ? name_of(QualType(scope, 0)) + "::" + constant->getNameAsString() : name_of(constant);
    if (!is_about_numbers(name) || is_nameless(name)) return true;
    value(reference, "'" + name + "'", name.find("numeric_limits") == name.npos);
    // The arguments of the template may be others in the symbolic program; its name is the same.
    CXXRecordDecl const *record = scope ? scope->getAsCXXRecordDecl() : nullptr;
    std::string const bare = record ? record->getQualifiedNameAsString() + "::" + constant->getNameAsString()
                                    : constant->getQualifiedNameAsString();
    return value(reference, "the value of '" + bare + "'", false);
  }
  bool VisitTypeTraitExpr(TypeTraitExpr *trait) override {
    bool const about = llvm::any_of(trait->getArgs(), [&](TypeSourceInfo const *argument) {
      return is_about_numbers(name_of(argument->getType()));
    });
    return answer(trait, "this trait", about);
  }
  bool VisitRequiresExpr(RequiresExpr *requirement) override { return answer(requirement, "this requirement", false); }
  bool VisitConceptSpecializationExpr(ConceptSpecializationExpr *satisfied) override {
    return answer(satisfied, "this concept", are_about_numbers(satisfied->getTemplateArguments()));
  }
  bool VisitCXXNoexceptExpr(CXXNoexceptExpr *expression) override { return answer(expression, "this noexcept", false); }
  bool VisitVarDecl(VarDecl *variable) override {
    if (is_about_numbers(function_) && !isa<ParmVarDecl>(variable))
      type(variable, variable->getType(), "the type of '" + variable->getNameAsString() + "'");
    return true;
  }
  bool VisitFieldDecl(FieldDecl *field) override {
    std::string const name = name_of(field);
    if (is_about_numbers(name)) type(field, field->getType(), "the type of '" + name + "'");
    return true;
  }
  bool VisitFunctionDecl(FunctionDecl *function) override {
    if (is_about_numbers(function_) && !is_of_lambda(function) && !function->getReturnType()->getContainedAutoType())
      type(function, function->getReturnType(), "the type of what '" + function->getNameAsString() + "' returns");
    return true;
  }

private:
  static bool is_of_lambda(FunctionDecl const *function) {
    auto const *method = dyn_cast<CXXMethodDecl>(function);
    return method && method->getParent()->isLambda();
  }
  std::string name_of(NamedDecl const *declaration) const {
    std::string name;
    llvm::raw_string_ostream out(name);
    declaration->getNameForDiagnostic(out, policy_, /*Qualified=*/true);
    return in_original(std::move(name));
  }

  void add(SourceLocation at, std::string const &what, std::string const &result) {
    if (!map_.in_roots(at)) return;
    Place const place = map_.place(at);
    // Columns move where text is inserted.
    std::string const key = place.file + ":" + std::to_string(place.line) + "|" + function_ + "|" + what;
    Choice &choice = collected.choices[key];
    if (choice.results.empty()) {
      choice.place = place;
      choice.what = what;
    }
    choice.results.insert(result);
  }

  bool value(Expr const *expression, std::string const &what, bool is_question) {
    Expr::EvalResult result;
    if (expression->isValueDependent() || !expression->EvaluateAsInt(result, context_)) return true;
    add(expression->getBeginLoc(), what, llvm::toString(result.Val.getInt(), 10));
    collected.asks = collected.asks || is_question;
    return true;
  }
  bool answer(Expr const *question, char const *what, bool is_about_them) {
    return (!is_about_them && !is_about_numbers(function_)) || value(question, what, true);
  }
  bool are_about_numbers(llvm::ArrayRef<TemplateArgument> arguments) const {
    return llvm::any_of(arguments, [&](TemplateArgument const &argument) {
      return argument.getKind() == TemplateArgument::Type && is_about_numbers(name_of(argument.getAsType()));
    });
  }
  std::string name_of(QualType type) const { return in_original(type.getCanonicalType().getAsString(policy_)); }
  void type(ValueDecl const *declaration, QualType type, std::string const &what) {
    std::string const name = name_of(type);
    // A deduced type may be a class of the runtime.
    if (type->getContainedAutoType() || is_nameless(name) || name.find("symreal") != name.npos) return;
    add(declaration->getLocation(), what, "'" + name + "'");
  }

  // Whether overload resolution may depend on the type of a template argument, or on its conversions.
  static bool is_selective(FunctionTemplateDecl const *declaration) {
    if (declaration->hasAssociatedConstraints()) return true;
    for (NamedDecl const *parameter : *declaration->getTemplateParameters()) {
      auto const *of_type = dyn_cast<TemplateTypeParmDecl>(parameter);
      auto const *of_value = dyn_cast<NonTypeTemplateParmDecl>(parameter);
      if ((of_type && of_type->hasDefaultArgument()) || (of_value && of_value->getType()->isDependentType()))
        return true;
    }
    std::string const signature = declaration->getTemplatedDecl()->getType().getAsString();
    constexpr llvm::StringLiteral words[] = {"::*", "decltype", "typename ", "enable_if", "sizeof"};
    return llvm::any_of(words, [&](llvm::StringRef word) { return llvm::StringRef(signature).contains(word); });
  }
  // A class of a template that has partial specialisations.
  static bool is_specialised(DeclContext const *scope) {
    auto const *record = dyn_cast<ClassTemplateSpecializationDecl>(scope);
    llvm::SmallVector<ClassTemplatePartialSpecializationDecl *> partial;
    if (record) record->getSpecializedTemplate()->getPartialSpecializations(partial);
    return !partial.empty();
  }
  static bool selects(FunctionDecl const *function) {
    unsigned candidates = 0;
    bool any = false;
    for (NamedDecl const *found : function->getDeclContext()->lookup(function->getDeclName())) {
      ++candidates;
      FunctionDecl const *one = found->getAsFunction();
      auto const *of_template = dyn_cast<FunctionTemplateDecl>(found);
      any = any || (of_template && is_selective(of_template)) || (one && one->isVariadic());
    }
    return any && candidates > 1;
  }

  void chosen(SourceLocation at, FunctionDecl const *function, bool overloaded) {
    if (function->isImplicit() || is_of_lambda(function)) return;
    FunctionDecl const *pattern = function;
    if (FunctionDecl const *from = function->getTemplateInstantiationPattern()) pattern = from;
    if (!map_.in_roots(pattern->getLocation())) return;
    std::string const name = name_of(function);
    if (is_nameless(name) || (!overloaded && !is_about_numbers(name) && !is_about_numbers(function_))) return;
    Place const place = map_.place(pattern->getLocation());
    add(at, "the function '" + function->getNameAsString() + "'",
        "that of " + place.file + ":" + std::to_string(place.line));
    collected.asks = collected.asks || selects(pattern) || is_specialised(function->getDeclContext());
  }

  ASTContext &context_;
  SourceMap const &map_;
  PrintingPolicy policy_;
  std::string function_; // the function being walked
};

// Earlier ones are compiled as C++20, which the runtime needs.
bool is_new_enough(std::vector<std::string> const &flags) {
  return std::any_of(flags.begin(), flags.end(), [](llvm::StringRef flag) {
    return flag.starts_with("-std=") &&
           (flag.ends_with("20") || flag.ends_with("2a") || flag.ends_with("23") || flag.ends_with("2b"));
  });
}

Choices read(Compilation const &source, Request const &request, Scope const &scope) {
  Choices choices;
  visit_tree(source, file_system(source, request, own_disk()), scope, [&](ASTContext &context, SourceMap const &map) {
    if (!context.getDiagnostics().hasErrorOccurred()) choices = collect_choices(context, map).choices;
  });
  return choices;
}

Compilation symbolic(Compilation source, std::string const &type_name) {
  for (std::string const &flag : type_name_flags(type_name)) source.flags.push_back(flag);
  source.flags.emplace_back("-DMBD_SYMBOLIC");
  if (!is_new_enough(source.flags))
    source.flags.insert(source.flags.end(), {"-std=gnu++20", "-fno-char8_t", "-DSYMREAL_BEFORE_CXX20"});
  return source;
}

std::string list_of(std::set<std::string> const &results) {
  std::string text;
  for (std::string const &result : results) text += (text.empty() ? "" : ", ") + result;
  return text;
}

} // namespace

CollectedChoices collect_choices(ASTContext &context, SourceMap const &map) {
  if (!map.language().CPlusPlus) return {}; // _Generic is rewritten by C's rules
  Walker walker(context, map);
  walker.TraverseDecl(context.getTranslationUnitDecl());
  return std::move(walker.collected);
}

void compare_choices(Choices const &original, std::vector<Compilation> const &asking, Scope const &scope,
                     Request const &request, Result &result) {
  if (asking.empty()) return; // the copies of all texts are not needed
  Request rewritten = request;
  rewritten.texts.clear();
  for (File const &file : result.files) rewritten.texts.push_back({file.path, file.text});
  std::vector<Choices> read_of(asking.size());
  Progress progress("rewritten sources", asking.size());
  in_parallel(asking.size(), request.jobs, [&](std::size_t k) {
    read_of[k] = read(symbolic(asking[k], result.type_name), rewritten, scope);
    progress.add();
  });
  Choices rewritten_ones;
  for (Choices &one : read_of) merge(rewritten_ones, std::move(one));
  std::set<std::string> told; // places
  for (auto const &[key, choice] : rewritten_ones) {
    auto const found = original.find(key);
    if (found == original.end()) continue; // an earlier choice leads there
    Choice const &before = found->second;
    if (before.results == choice.results || !told.insert(to_string(before.place)).second) continue;
    result.diagnostics.push_back({DiagnosticId::rewriting_mismatch, before.place,
                                  choice.what + " is " + list_of(choice.results) + " in the symbolic program, and " +
                                      list_of(before.results) + " in the original"});
  }
}

} // namespace symreal::rewrite
