// References between the functions and variables of sources, and what a linker makes of them.
#include "rewrite/collect/walks.h"
#include "rewrite/source/walk.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

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
class StartedObjects : public Walk {
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

// The variables of a source, and the functions that it instantiates for others.
class Objects : public Walk {
public:
  std::vector<VarDecl const *> variables;
  std::vector<FunctionDecl const *> instantiated;

  bool shouldVisitTemplateInstantiations() const override { return true; }
  bool VisitVarDecl(VarDecl *variable) override {
    if (variable->hasGlobalStorage() && !variable->isStaticLocal() && variable->isThisDeclarationADefinition() &&
        !variable->getDeclContext()->isDependentContext() && !variable->getType()->isDependentType())
      variables.push_back(variable);
    return true;
  }
  bool VisitFunctionDecl(FunctionDecl *function) override {
    if (function->getTemplateSpecializationKind() == TSK_ExplicitInstantiationDefinition && function->isDefined())
      instantiated.push_back(function);
    return true;
  }
};

// Runs when the program starts, or is refused where its table is not constant.
bool runs_at_start(VarDecl const *variable) {
  ASTContext const &context = variable->getASTContext();
  if (!context.getLangOpts().CPlusPlus || !variable->hasInit()) return false;
  return !variable->hasConstantInitialization() || variable->needsDestruction(context) != QualType::DK_none;
}

class Links {
public:
  Links(ASTContext &context, SourceMap const &map, Facts &facts) : names_(context), map_(map), facts_(facts) {}

  void function(FunctionDecl const *definition) {
    if (definition->isDependentContext()) return;
    if (definition->hasAttr<ConstructorAttr>() || definition->hasAttr<UsedAttr>()) collect("", definition);
    bool const is_for_others = definition->getTemplateSpecializationKind() == TSK_ExplicitInstantiationDefinition;
    if (definition->isExternallyVisible() && (is_for_others || !definition->isInlined()))
      collect(names_.getName(definition), definition);
  }
  void variable(VarDecl const *definition) {
    if (definition->isExternallyVisible() && !definition->isInline()) collect(names_.getName(definition), definition);
    if (runs_at_start(definition) || definition->hasAttr<UsedAttr>()) collect("", definition);
  }

private:
  void collect(std::string const &symbol, Decl const *definition) {
    needs_ = &facts_.links[symbol];
    seen_.clear();
    enter(definition);
    while (!pending_.empty()) {
      Decl const *const next = pending_.back();
      pending_.pop_back();
      for (Decl const *needed : references_of(next)) refer(needed);
    }
  }

  void enter(Decl const *definition) {
    if (seen_.insert(definition).second) pending_.push_back(definition);
  }

  void refer(Decl const *declaration) {
    if (auto const *function = dyn_cast<FunctionDecl>(declaration)) {
      if (function->isDependentContext() || function->isDeleted()) return;
      FunctionDecl const *definition = nullptr;
      bool const is_here = function->isDefined(definition) && definition->getBody();
      if (is_here) enter(definition);
      if (!is_here || function->getTemplateSpecializationKind() == TSK_ExplicitInstantiationDeclaration) need(function);
    } else if (auto const *variable = dyn_cast<VarDecl>(declaration)) {
      VarDecl const *definition = variable->getDefinition();
      if (!definition) definition = variable->getActingDefinition();
      definition ? enter(definition) : need(variable);
    }
  }

  void need(NamedDecl const *declaration) {
    SourceManager const &sources = map_.sources();
    if (!declaration->isExternallyVisible() || sources.isInSystemHeader(declaration->getLocation())) return;
    if (auto const *method = dyn_cast<CXXMethodDecl>(declaration))
      if ((method->isPureVirtual() && !isa<CXXDestructorDecl>(method)) || method->isImplicit() || method->isDefaulted())
        return; // a destructor that is pure virtual is called by those of the classes derived from it
    std::string symbol = names_.getName(declaration);
    facts_.linked_words.try_emplace(symbol, word_of(declaration));
    needs_->insert(std::move(symbol));
  }

  // A word that any definition of it has.
  static std::string word_of(NamedDecl const *declaration) {
    if (isa<CXXConstructorDecl, CXXDestructorDecl, CXXConversionDecl>(declaration))
      return cast<CXXMethodDecl>(declaration)->getParent()->getNameAsString();
    return declaration->getIdentifier() ? declaration->getName().str() : "operator";
  }

  std::vector<Decl const *> const &references_of(Decl const *definition) {
    auto const [at, is_new] = references_.try_emplace(definition);
    if (!is_new) return at->second;
    References found;
    std::vector<Decl const *> all;
    if (auto const *function = dyn_cast<FunctionDecl>(definition)) {
      found.of(function);
      members(function, all);
    } else
      found.TraverseDecl(const_cast<Decl *>(definition));
    for (auto const &[function, place] : found.functions) all.push_back(function);
    all.insert(all.end(), found.variables.begin(), found.variables.end());
    for (auto const &[record, place] : found.tables) table(record, all);
    for (std::size_t k = 0; k < all.size(); ++k)
      if (auto const *destructor = dyn_cast<CXXDestructorDecl>(all[k])) implicit_destructor(destructor, all);
    return at->second = std::move(all);
  }

  // References without a node in the syntax tree: a destructor destroys the members and bases, and the definition of a
  // class's key function brings the table of its virtual functions.
  static void members(FunctionDecl const *function, std::vector<Decl const *> &all) {
    auto const *method = dyn_cast<CXXMethodDecl>(function);
    if (!method) return;
    CXXRecordDecl const *record = method->getParent();
    if (isa<CXXConstructorDecl, CXXDestructorDecl>(method)) parts(record, all);
    if (record->isDynamicClass() && method->isVirtual())
      if (CXXMethodDecl const *key = record->getASTContext().getCurrentKeyFunction(record);
          key && key->getCanonicalDecl() == method->getCanonicalDecl())
        virtuals(record, all);
  }
  static void implicit_destructor(CXXDestructorDecl const *destructor, std::vector<Decl const *> &all) {
    FunctionDecl const *definition = nullptr;
    if (!(destructor->isDefined(definition) && definition->getBody())) parts(destructor->getParent(), all);
  }
  static void parts(CXXRecordDecl const *record, std::vector<Decl const *> &all) {
    if (!record->hasDefinition()) return;
    auto const destroyed = [&](QualType type) {
      auto const *part = type->getBaseElementTypeUnsafe()->getAsCXXRecordDecl();
      if (!part || !part->hasDefinition()) return;
      CXXDestructorDecl const *destructor = part->getDestructor();
      if (!destructor || part->hasTrivialDestructor()) return;
      all.push_back(destructor);
    };
    for (FieldDecl const *field : record->fields()) destroyed(field->getType());
    for (CXXBaseSpecifier const &base : record->bases()) destroyed(base.getType());
  }
  static void table(CXXRecordDecl const *record, std::vector<Decl const *> &all) {
    if (!record->hasDefinition() || !record->isDynamicClass()) return;
    if (CXXMethodDecl const *key = record->getASTContext().getCurrentKeyFunction(record); key && !key->isDefined())
      all.push_back(key); // the table is where this is defined
    else
      virtuals(record, all);
  }
  static void virtuals(CXXRecordDecl const *record, std::vector<Decl const *> &all) {
    for (CXXMethodDecl const *method : record->methods())
      if (method->isVirtual() && !method->isPureVirtual()) all.push_back(method);
  }

  ASTNameGenerator names_;
  SourceMap const &map_;
  Facts &facts_;
  std::set<std::string> *needs_ = nullptr;
  std::vector<Decl const *> pending_;
  llvm::SmallPtrSet<Decl const *, 32> seen_;
  std::map<Decl const *, std::vector<Decl const *>> references_;
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
    StartedObjects objects;
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

void collect_links(ASTContext &context, std::vector<FunctionDecl const *> const &definitions, SourceMap const &map,
                   Facts &facts) {
  Links links(context, map, facts);
  for (FunctionDecl const *function : definitions) links.function(function);
  for (Decl *declaration : context.getTranslationUnitDecl()->decls()) {
    if (!map.in_roots(declaration->getLocation())) continue;
    Objects objects;
    objects.TraverseDecl(declaration);
    for (VarDecl const *variable : objects.variables) links.variable(variable);
    for (FunctionDecl const *function : objects.instantiated) links.function(function);
  }
}

} // namespace symreal::rewrite
