#include "rewrite/unit/reach.h"

#include "rewrite/model/storage.h"
#include "rewrite/source/source_map.h"
#include "rewrite/source/walk.h"
#include "rewrite/unit/collect_source.h"

#include <clang/Index/USRGeneration.h>

#include <algorithm>
#include <set>

namespace symreal::rewrite {
namespace {

using namespace clang;
using Key = std::string; // the same in all sources

// References from the body of one function.
struct Body {
  ReachedFunction function;
  std::set<Key> callees;
  std::map<std::string, ReachedState> state; // by place
  std::vector<Note> not_followed;
};

struct Known {
  std::map<Key, Body> bodies;
  std::map<Key, std::string> declared;     // functions outside of the system's headers
  std::map<Key, std::set<Key>> overriders; // of a virtual function, directly
};

Key key_of(Decl const *declaration) {
  llvm::SmallString<128> key;
  index::generateUSRForDecl(declaration, key);
  return key.str().str();
}

class Calls : public Walk {
public:
  Calls(SourceMap const &map, Known &known) : map_(map), known_(known) {}

  bool shouldVisitTemplateInstantiations() const override { return true; }
  bool shouldVisitImplicitCode() const override { return true; }

  bool TraverseFunctionDecl(FunctionDecl *f) override {
    return within(f, [&] { return Walk::TraverseFunctionDecl(f); });
  }
  bool TraverseCXXMethodDecl(CXXMethodDecl *f) override {
    return within(f, [&] { return Walk::TraverseCXXMethodDecl(f); });
  }
  bool TraverseCXXConstructorDecl(CXXConstructorDecl *f) override {
    return within(f, [&] { return Walk::TraverseCXXConstructorDecl(f); });
  }
  bool TraverseCXXDestructorDecl(CXXDestructorDecl *f) override {
    return within(f, [&] { return Walk::TraverseCXXDestructorDecl(f); });
  }
  bool TraverseCXXConversionDecl(CXXConversionDecl *f) override {
    return within(f, [&] { return Walk::TraverseCXXConversionDecl(f); });
  }

  bool VisitCXXMethodDecl(CXXMethodDecl *method) override {
    for (CXXMethodDecl const *overridden : method->overridden_methods())
      known_.overriders[key_of(overridden->getCanonicalDecl())].insert(key_of(method->getCanonicalDecl()));
    return true;
  }

  bool VisitCallExpr(CallExpr *call) override {
    if (!body_) return true;
    if (FunctionDecl const *function = call->getDirectCallee()) {
      calls(function);
    } else if (!call->isTypeDependent() && !isa<CXXPseudoDestructorExpr>(call->getCallee()->IgnoreParens()) &&
               !is_system(call->getBeginLoc())) {
      body_->not_followed.push_back(
          {map_.place(call->getBeginLoc()), "a call through '" + text(call->getCallee()) + "'"});
    }
    return true;
  }
  bool VisitCXXConstructExpr(CXXConstructExpr *construction) override {
    if (body_) calls(construction->getConstructor());
    return true;
  }
  // A function that is named without being called escapes, and may be called.
  bool VisitDeclRefExpr(DeclRefExpr *name) override {
    if (!body_) return true;
    if (auto const *function = dyn_cast<FunctionDecl>(name->getDecl())) calls(function);
    if (auto const *variable = dyn_cast<VarDecl>(name->getDecl())) state(variable);
    return true;
  }
  bool VisitMemberExpr(MemberExpr *member) override {
    if (auto const *variable = dyn_cast<VarDecl>(member->getMemberDecl()); variable && body_) state(variable);
    return true;
  }
  bool VisitBinaryOperator(BinaryOperator *operation) override {
    if (operation->isAssignmentOp()) written(operation->getLHS());
    return true;
  }
  bool VisitUnaryOperator(UnaryOperator *operation) override {
    if (operation->isIncrementDecrementOp()) written(operation->getSubExpr());
    if (operation->getOpcode() == UO_AddrOf) passed_on(operation->getSubExpr());
    return true;
  }
  bool VisitImplicitCastExpr(ImplicitCastExpr *cast) override {
    if (cast->getCastKind() == CK_ArrayToPointerDecay && !elements_.contains(cast)) passed_on(cast->getSubExpr());
    return true;
  }
  bool VisitArraySubscriptExpr(ArraySubscriptExpr *element) override {
    elements_.insert(element->getBase()->IgnoreParens());
    return true;
  }

private:
  template <class Traverse> bool within(FunctionDecl *function, Traverse const &traverse) {
    if (function->isDependentContext()) return true; // its instantiations are walked
    Body *const outer = body_;
    if (function->doesThisDeclarationHaveABody() && !isa_and_nonnull<CXXRecordDecl>(lambda_of(function))) {
      body_ = &known_.bodies[key_of(function->getCanonicalDecl())];
      body_->function = {function->getQualifiedNameAsString(), map_.place(function->getBeginLoc()),
                         map_.place(function->getEndLoc())};
    }
    bool const done = traverse();
    body_ = outer;
    return done;
  }

  // The class of a lambda, whose body belongs to the function around it.
  static CXXRecordDecl const *lambda_of(FunctionDecl const *function) {
    auto const *record = dyn_cast<CXXRecordDecl>(function->getDeclContext());
    return record && record->isLambda() ? record : nullptr;
  }

  bool is_system(SourceLocation location) const {
    return location.isInvalid() || map_.sources().isInSystemHeader(map_.sources().getExpansionLoc(location));
  }

  void calls(FunctionDecl const *function) {
    Key const key = key_of(function->getCanonicalDecl());
    body_->callees.insert(key);
    if (!is_system(function->getLocation()) && function->getBuiltinID() == 0 && !function->isImplicit() &&
        !function->isDefaulted() && !lambda_of(function))
      known_.declared.try_emplace(key, function->getQualifiedNameAsString());
  }

  ReachedState *state(VarDecl const *variable) {
    if (!variable->hasGlobalStorage() || variable->isConstexpr() ||
        variable->getType().isConstant(variable->getASTContext()) || is_system(variable->getLocation()))
      return nullptr;
    VarDecl const *definition = variable->getDefinition();
    ReachedState found{variable->getNameAsString(), map_.place((definition ? definition : variable)->getLocation())};
    return &body_->state.try_emplace(to_string(found.place), std::move(found)).first->second;
  }

  ReachedState *state_under(Expr const *expression) {
    if (!body_) return nullptr;
    Expr const *base = Storage::base(expression);
    if (auto const *name = dyn_cast_or_null<DeclRefExpr>(base))
      if (auto const *variable = dyn_cast<VarDecl>(name->getDecl())) return state(variable);
    return nullptr;
  }
  void written(Expr const *target) {
    if (ReachedState *found = state_under(target)) found->is_written = true;
  }
  void passed_on(Expr const *object) {
    if (ReachedState *found = state_under(object)) found->is_passed_on = true;
  }

  std::string text(Expr const *expression) const {
    CharSourceRange const range = Lexer::getAsCharRange(map_.sources().getExpansionRange(expression->getSourceRange()),
                                                        map_.sources(), map_.language());
    return Lexer::getSourceText(range, map_.sources(), map_.language()).str();
  }

  SourceMap const &map_;
  Known &known_;
  Body *body_ = nullptr;
  llvm::SmallPtrSet<Expr const *, 32> elements_; // arrays of which one element is taken
};

void read(Compilation const &source, Known &known) {
  FileSystem const disk = own_disk();
  if (!source.directory.empty() && disk->setCurrentWorkingDirectory(source.directory)) return;
  visit_tree(source, disk, Scope(), [&](ASTContext &context, SourceMap const &map) {
    Calls(map, known).TraverseDecl(context.getTranslationUnitDecl());
  });
}

bool is_named(std::string const &qualified, std::string const &name) {
  return qualified == name || (qualified.ends_with(name) && qualified[qualified.size() - name.size() - 1] == ':');
}

bool earlier(Place const &one, Place const &other) {
  return std::tie(one.file, one.line, one.column) < std::tie(other.file, other.line, other.column);
}

} // namespace

Reach reach_of(std::string const &function, Request const &request) {
  Known known;
  for (Compilation const &source : compilations_of(request)) read(source, known);
  std::vector<Key> reached;
  std::set<Key> met;
  auto const add = [&](Key const &key) {
    if (met.insert(key).second) reached.push_back(key);
  };
  for (auto const &[key, body] : known.bodies)
    if (is_named(body.function.name, function)) add(key);
  if (reached.empty()) fail(DiagnosticId::unknown_kernel, {}, "no source defines a function '" + function + "'");

  Reach result;
  std::map<std::string, ReachedState> state;
  for (std::size_t k = 0; k < reached.size(); ++k) {
    if (auto const overriders = known.overriders.find(reached[k]); overriders != known.overriders.end())
      for (Key const &one : overriders->second) add(one);
    auto const found = known.bodies.find(reached[k]);
    if (found == known.bodies.end()) {
      if (auto const declared = known.declared.find(reached[k]); declared != known.declared.end())
        result.undefined.push_back(declared->second);
      continue;
    }
    Body const &body = found->second;
    result.functions.push_back(body.function);
    result.not_followed.insert(result.not_followed.end(), body.not_followed.begin(), body.not_followed.end());
    for (auto const &[place, one] : body.state) {
      ReachedState &all = state.try_emplace(place, one).first->second;
      all.is_written |= one.is_written;
      all.is_passed_on |= one.is_passed_on;
    }
    for (Key const &callee : body.callees) add(callee);
  }
  for (auto &[place, one] : state) result.state.push_back(std::move(one));
  std::sort(result.state.begin(), result.state.end(),
            [](ReachedState const &a, ReachedState const &b) { return earlier(a.place, b.place); });
  std::sort(result.functions.begin(), result.functions.end(),
            [](ReachedFunction const &a, ReachedFunction const &b) { return earlier(a.begin, b.begin); });
  std::sort(result.not_followed.begin(), result.not_followed.end(),
            [](Note const &a, Note const &b) { return earlier(a.place, b.place); });
  std::sort(result.undefined.begin(), result.undefined.end());
  result.undefined.erase(std::unique(result.undefined.begin(), result.undefined.end()), result.undefined.end());
  return result;
}

} // namespace symreal::rewrite
