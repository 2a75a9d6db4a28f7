#include "rewrite/collect/boundaries.h"

#include "rewrite/source/references.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Reachable {
public:
  Reachable(ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts)
      : names_(context),
        map_(map),
        reals_(reals),
        facts_(facts) {}

  void start(FunctionDecl const *function) { enter(function, {function->getLocation(), function->getLocation()}); }
  void start(VarDecl const *variable) {
    References references;
    references.TraverseDecl(const_cast<VarDecl *>(variable));
    refer(references, {variable->getLocation(), variable->getLocation()});
  }

  void run() {
    while (!pending_.empty()) {
      auto const [function, called_from] = pending_.back();
      pending_.pop_back();
      References references;
      references.of(function);
      refer(references, called_from);
    }
  }

  bool carries(FunctionDecl const *function) const {
    if (reals_.mentions_real(function->getType())) return true;
    auto const *method = dyn_cast<CXXMethodDecl>(function);
    QualType const object = method ? method->getASTContext().getRecordType(method->getParent()) : QualType();
    return method && reals_.mentions_real(object);
  }

private:
  // The last places on the way to a call: within the roots, since the call may stand in a library's template, and in
  // the source itself, since it may stand in a header.
  struct Way {
    SourceLocation roots;
    SourceLocation source;
  };

  void enter(FunctionDecl const *function, Way const &way) {
    if (!seen_.insert(function).second || function->isDependentContext()) return;
    pending_.emplace_back(function, way);
  }

  void refer(References const &references, Way const &from) {
    for (auto const &[callee, place] : references.functions) refer(callee, place, from);
    for (auto const &[record, place] : references.tables) refer_to_table(record, place, from);
  }

  // A table that is emitted here refers to every virtual function of its class.
  void refer_to_table(CXXRecordDecl const *record, SourceLocation place, Way const &from) {
    if (!record->hasDefinition() || !record->isDynamicClass()) return;
    if (CXXMethodDecl const *key = record->getASTContext().getCurrentKeyFunction(record); key && !key->isDefined())
      return;
    for (CXXMethodDecl const *method : record->methods())
      if (method->isVirtual() && !method->isPureVirtual()) refer(method, place, from);
  }

  void refer(FunctionDecl const *callee, SourceLocation place, Way from) {
    if (map_.in_roots(place)) from.roots = place;
    if (map_.sources().isInMainFile(map_.sources().getExpansionLoc(place))) from.source = place;
    if (callee->isDependentContext() || callee->isDeleted() || callee->getBuiltinID() != 0) return;
    FunctionDecl const *definition = nullptr;
    if (callee->isDefined(definition) && definition->getBody()) {
      enter(definition, from);
      return;
    }
    if (reals_.external(callee)) return;
    // A virtual call goes through the class's table, whose entries are referenced where an object is made.
    if (callee->isPureVirtual()) return;
    if (callee->isDefaulted() || callee->isImplicit() || !reals_.in_roots(callee) || !carries(callee)) return;
    std::string mangled = names_.getName(callee);
    UseFact use{mangled,
                callee->getQualifiedNameAsString(),
                callee->getNumParams(),
                map_.place(callee->getLocation()),
                map_.place(from.roots),
                map_.place(from.source)};
    facts_.uses.try_emplace(std::move(mangled), std::move(use));
  }

  ASTNameGenerator names_;
  SourceMap const &map_;
  Reals const &reals_;
  Facts &facts_;
  std::vector<std::pair<FunctionDecl const *, Way>> pending_;
  llvm::SmallPtrSet<FunctionDecl const *, 32> seen_;
};

// The variables of the source itself, whose initialisers run, and the functions that it instantiates for others:
// `template class Angle<double>;`.
class Objects : public Walk {
public:
  std::vector<VarDecl const *> found;
  std::vector<FunctionDecl const *> instantiated;
  bool TraverseFunctionDecl(FunctionDecl *) override { return true; }
  bool VisitClassTemplateDecl(ClassTemplateDecl *declaration) override {
    for (ClassTemplateSpecializationDecl const *specialization : declaration->specializations())
      instantiate_members(specialization);
    return true;
  }
  bool VisitFunctionTemplateDecl(FunctionTemplateDecl *declaration) override {
    for (FunctionDecl const *function : declaration->specializations()) instantiate(function);
    return true;
  }
  bool VisitVarDecl(VarDecl *variable) override {
    if (variable->hasGlobalStorage() && variable->hasInit() && !variable->getDeclContext()->isDependentContext())
      found.push_back(variable);
    return true;
  }

private:
  void instantiate_members(CXXRecordDecl const *record) {
    for (FunctionDecl const *method : record->methods()) instantiate(method);
    for (Decl const *member : record->decls()) // its classes are instantiated with it
      if (auto const *nested = dyn_cast<CXXRecordDecl>(member); nested && !nested->isInjectedClassName())
        instantiate_members(nested);
  }
  void instantiate(FunctionDecl const *function) {
    if (function->getTemplateSpecializationKind() == TSK_ExplicitInstantiationDefinition && function->isDefined())
      instantiated.push_back(function);
  }
};

} // namespace

void collect_boundaries(ASTContext &context, std::vector<FunctionDecl const *> const &definitions, SourceMap const &map,
                        Reals const &reals, Facts &facts) {
  ASTNameGenerator names(context);
  Reachable reachable(context, map, reals, facts);
  for (FunctionDecl const *function : definitions) {
    if (function->isDependentContext()) continue;
    facts.definitions.insert(names.getName(function));
    if (!function->isInlined() && function->isExternallyVisible() && reachable.carries(function))
      facts.exported.insert(names.getName(function));
    if (!function->isInlined()) reachable.start(function); // an inline one counts at its calls
  }
  for (Decl *declaration : context.getTranslationUnitDecl()->decls()) {
    if (!map.in_roots(declaration->getLocation())) continue;
    Objects objects;
    objects.TraverseDecl(declaration);
    for (VarDecl const *variable : objects.found) reachable.start(variable);
    for (FunctionDecl const *function : objects.instantiated) {
      facts.definitions.insert(names.getName(function));
      if (reachable.carries(function)) facts.exported.insert(names.getName(function));
      reachable.start(function);
    }
  }
  reachable.run();
}

} // namespace symreal::rewrite
