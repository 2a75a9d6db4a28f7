#include "rewrite/c/constructs.h"
#include "rewrite/c/walk.h"
#include "rewrite/facts/facts.h"
#include "rewrite/model/library.h"

#include <vector>

namespace symreal::rewrite {
namespace {

using namespace clang;

class Names : public CWalk {
public:
  using CWalk::CWalk;

  bool VisitNamedDecl(NamedDecl *declaration) override {
    rename(*declaration, declaration->getLocation());
    return true;
  }
  // Symbolic mode has a declaration of its own.
  bool VisitFunctionDecl(FunctionDecl *function) override {
    SourceLocation const at = function->getLocation();
    if (!Reals::is_declared_math(function) || !map_.in_roots(at) || is_rewritten(at)) return true;
    if (!insert(map_.token(at, function->getName()), Use::of_library, function->getNameAsString()))
      report(at, "a macro makes '" + function->getNameAsString() + "', which is a function of the C library");
    return true;
  }
  bool VisitDeclRefExpr(DeclRefExpr *use) override {
    rename(*use->getDecl(), use->getLocation());
    return true;
  }
  bool VisitTypedefTypeLoc(TypedefTypeLoc use) override {
    rename(*use.getTypedefNameDecl(), use.getNameLoc());
    return true;
  }

  bool VisitTagDecl(TagDecl *tag) override {
    rename_tag(*tag, tag->getLocation());
    return true;
  }
  bool VisitTagTypeLoc(TagTypeLoc use) override {
    rename_tag(*use.getDecl(), use.getNameLoc());
    return true;
  }

private:
  void rename(NamedDecl const &declaration, SourceLocation at) {
    if (!declaration.getIdentifier() || !is_library_name(declaration.getName()) || !is_own(declaration)) return;
    std::string const name = declaration.getNameAsString();
    bool const is_known_outside = isa<FunctionDecl, VarDecl>(declaration) && declaration.hasExternalFormalLinkage();
    std::optional<Span> const token = map_.in_roots(at) ? map_.token(at, name) : std::nullopt;
    if (is_known_outside && is_defined(declaration)) facts_.definitions.insert(definition_of(name));
    if (!is_known_outside && token) facts_.definitions.insert(definition_of(name, token->file));
    if (!map_.in_roots(at) || map_.is_argument_of(at, "REAL_NAME")) return;
    if (!insert(token, Use::own_name, name))
      report(at, "a macro makes '" + name + "', which is a name of the C library too");
  }

  // Whether the name is declared at file scope, and by no header of a library.
  bool is_own(NamedDecl const &declaration) {
    if (!isa<FunctionDecl, VarDecl, TypedefNameDecl, EnumConstantDecl>(declaration)) return false;
    DeclContext const *context = declaration.getDeclContext()->getRedeclContext();
    if (!context->isTranslationUnit()) return false;
    for (Decl const *one : declaration.redecls())
      if (!one->isImplicit() && !map_.in_roots(one->getLocation())) {
        if (auto const *function = dyn_cast<FunctionDecl>(&declaration); function && is_defined(declaration))
          defines_library(*function);
        return false;
      }
    return true;
  }
  static bool is_defined(NamedDecl const &declaration) {
    if (auto const *function = dyn_cast<FunctionDecl>(&declaration)) return function->isDefined();
    auto const *variable = dyn_cast<VarDecl>(&declaration);
    return variable && variable->hasDefinition() != VarDecl::DeclarationOnly;
  }
  void defines_library(FunctionDecl const &function) {
    if (!function.doesThisDeclarationHaveABody() || !defined_.insert(&function).second) return;
    auto const is_double = [](QualType type) { return type->isSpecificBuiltinType(BuiltinType::Double); };
    if (is_double(function.getReturnType()) ||
        std::any_of(function.param_begin(), function.param_end(),
                    [&](ParmVarDecl const *one) { return is_double(one->getType()); }))
      report(function.getLocation(), "'" + function.getNameAsString() +
                                         "' is a function of the C library, which a header declares and the program "
                                         "defines itself");
  }

  void rename_tag(TagDecl const &tag, SourceLocation at) {
    if (!tag.getIdentifier() || !map_.in_roots(at) || is_rewritten(at)) return;
    for (NamedDecl const *other : tag.getDeclContext()->getRedeclContext()->lookup(tag.getDeclName())) {
      auto const *type = dyn_cast<TypedefNameDecl>(other);
      if (!type) continue;
      TagDecl const *named = type->getUnderlyingType()->getAsTagDecl();
      if (named && named->getCanonicalDecl() == tag.getCanonicalDecl()) continue;
      if (!insert(map_.token(at, tag.getName()), Use::instead, "symreal_tag_" + tag.getNameAsString()))
        report(at, "a macro makes '" + tag.getNameAsString() + "', which is a tag and the name of another type");
      return;
    }
  }

  llvm::SmallPtrSet<FunctionDecl const *, 4> defined_;
};

// C tells a tag from other names by the word before it, and a name declared within a structure is visible behind it. In
// C++ a tag hides a variable, function or type of the same name further out, and a structure is a scope. A structure
// without members has size 0 in C, and 1 in C++.
class Scopes : public CWalk {
public:
  using CWalk::CWalk;

  bool TraverseFunctionDecl(FunctionDecl *function) override {
    Entered const here(*this, function->getBody()); // whose names are in one block with those of the parameters
    return CWalk::TraverseFunctionDecl(function);
  }
  bool TraverseCompoundStmt(CompoundStmt *block) override {
    if (!blocks_.empty() && blocks_.back().block == block) return CWalk::TraverseCompoundStmt(block);
    Entered const here(*this, block);
    return CWalk::TraverseCompoundStmt(block);
  }
  bool TraverseForStmt(ForStmt *loop) override {
    Entered const here(*this, loop);
    return CWalk::TraverseForStmt(loop);
  }
  bool TraverseRecordDecl(RecordDecl *record) override {
    Entered const here(*this, nullptr);
    records_.push_back(record);
    bool const more = CWalk::TraverseRecordDecl(record);
    records_.pop_back();
    return more;
  }

  bool VisitRecordDecl(RecordDecl *record) override {
    bool const is_empty = std::all_of(record->field_begin(), record->field_end(),
                                      [](FieldDecl const *field) { return field->isUnnamedBitField(); });
    if (record->isThisDeclarationADefinition() && !record->isInvalidDecl() && is_empty)
      report(record->getLocation(), "a structure without members has another size in C++");
    return true;
  }
  bool VisitTagDecl(TagDecl *tag) override {
    if (!tag->getIdentifier() || blocks_.empty()) return true;
    // A structure has entered its own block already.
    std::size_t const depth = blocks_.size() - (isa<RecordDecl>(tag) ? 2 : 1);
    if (depth < blocks_.size()) blocks_[depth].tags.insert(tag->getName());
    return true;
  }
  bool VisitValueDecl(ValueDecl *declaration) override { return ordinary(declaration); }
  bool VisitTypedefNameDecl(TypedefNameDecl *declaration) override { return ordinary(declaration); }

  bool VisitDeclRefExpr(DeclRefExpr *use) override {
    look_up(use->getDecl(), use->getLocation());
    if (auto const *enumerator = dyn_cast<EnumConstantDecl>(use->getDecl()))
      leave(enumerator, cast<EnumDecl>(enumerator->getDeclContext()), use->getLocation());
    return true;
  }
  bool VisitTypedefTypeLoc(TypedefTypeLoc use) override {
    look_up(use.getTypedefNameDecl(), use.getNameLoc());
    return true;
  }
  bool VisitTagTypeLoc(TagTypeLoc use) override {
    leave(use.getDecl(), use.getDecl(), use.getNameLoc());
    return true;
  }

private:
  struct Block {
    Stmt const *block;
    llvm::StringSet<> ordinary, tags;
  };
  class Entered {
  public:
    Entered(Scopes &scopes, Stmt const *block) : scopes_(scopes) { scopes_.blocks_.push_back({block, {}, {}}); }
    ~Entered() { scopes_.blocks_.pop_back(); }
    Entered(Entered const &) = delete;
    Entered &operator=(Entered const &) = delete;

  private:
    Scopes &scopes_;
  };

  bool ordinary(NamedDecl const *declaration) {
    if (declaration->getIdentifier() && !blocks_.empty() && !isa<FieldDecl>(declaration))
      blocks_.back().ordinary.insert(declaration->getName());
    return true;
  }

  void look_up(NamedDecl const *declaration, SourceLocation use) {
    if (!declaration->getIdentifier()) return;
    for (auto block = blocks_.rbegin(); block != blocks_.rend(); ++block) {
      if (block->ordinary.contains(declaration->getName())) return;
      if (block->tags.contains(declaration->getName()))
        return report(use, "'" + declaration->getName().str() + "' is a tag here in C++, which hides the other name");
    }
  }

  // Reports a use of a name that a structure declares, outside of it: in C++ it is a member, or another declaration.
  void leave(NamedDecl const *declaration, TagDecl const *tag, SourceLocation use) {
    auto const *record = dyn_cast<RecordDecl>(tag->getLexicalDeclContext());
    if (!record || !declaration->getIdentifier()) return;
    for (RecordDecl const *outer : records_)
      if (outer->getCanonicalDecl() == record->getCanonicalDecl()) return;
    for (NamedDecl const *other : context_.getTranslationUnitDecl()->lookup(declaration->getDeclName()))
      if (other->getCanonicalDecl() != declaration->getCanonicalDecl())
        return report(use, "'" + declaration->getName().str() + "' is declared in a structure, and is another in C++");
    std::string words;
    for (auto const *outer = record; outer; outer = dyn_cast<RecordDecl>(outer->getLexicalDeclContext())) {
      TypedefNameDecl const *alias = outer->getTypedefNameForAnonDecl();
      if (outer->isAnonymousStructOrUnion()) continue; // its names are those of the structure around it
      if (!alias && !outer->getIdentifier())
        return report(use, "'" + declaration->getName().str() + "' is declared in a structure without a name");
      words.insert(0, (alias ? alias->getName() : outer->getName()).str() + "::");
    }
    if (!map_.in_roots(use)) return;
    if (std::optional<Span> const token = map_.token(use, declaration->getName()))
      facts_.wraps.insert({*token, Use::before, words});
  }

  std::vector<Block> blocks_;
  std::vector<RecordDecl const *> records_;
};

} // namespace

void collect_c_names(ASTContext &context, SourceMap const &map, Facts &facts) {
  if (!map.language().CPlusPlus) Names(context, map, facts).TraverseDecl(context.getTranslationUnitDecl());
}

void collect_c_declarations(ASTContext &context, SourceMap const &map, Facts &facts) {
  if (!map.language().CPlusPlus) Scopes(context, map, facts).TraverseDecl(context.getTranslationUnitDecl());
}

} // namespace symreal::rewrite
