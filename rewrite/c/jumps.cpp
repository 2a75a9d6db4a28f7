#include "rewrite/c/constructs.h"
#include "rewrite/c/walk.h"

#include <vector>

namespace symreal::rewrite {
namespace {

using namespace clang;

// The labels of a statement that a jump from outside may lead to.
class Labels : public Walk {
public:
  bool TraverseSwitchStmt(SwitchStmt *choice) override {
    ++switches_;
    bool const more = Walk::TraverseSwitchStmt(choice);
    --switches_;
    return more;
  }
  bool VisitSwitchCase(SwitchCase *) override {
    has_case = has_case || switches_ == 0;
    return true;
  }
  bool VisitLabelStmt(LabelStmt *label) override {
    labels.push_back(label->getDecl());
    return true;
  }

  bool has_case = false;
  std::vector<LabelDecl const *> labels;

private:
  unsigned switches_ = 0;
};

// Splitting of declarations that a jump skips: `int n = f(), m = 2;` becomes `int n; initialised(n) = f(); int m;
// initialised(m) = 2;`. The words are inserted, so that other rules still apply to the initialisers. An array of REALs
// gets a class of its own: g++ regards one of a class with constructors as initialised.
class Jumps : public CWalk {
public:
  using CWalk::CWalk;

  bool TraverseFunctionDecl(FunctionDecl *function) override {
    if (!map_.in_roots(function->getLocation()) || !function->doesThisDeclarationHaveABody()) return true;
    gotos_.clear();
    collect_gotos(function->getBody());
    return CWalk::TraverseFunctionDecl(function);
  }

  bool VisitCompoundStmt(CompoundStmt *block) override {
    Labels behind; // labels behind the current statement; the walk goes from the last one up
    std::vector<Stmt *> const statements(block->body_begin(), block->body_end());
    for (std::size_t k = statements.size(); k-- > 0;) {
      auto const *declaration = dyn_cast<DeclStmt>(statements[k]);
      if (declaration && is_passed(*declaration, *block, behind)) split(*declaration);
      behind.TraverseStmt(statements[k]);
    }
    return true;
  }

private:
  void collect_gotos(Stmt const *statement) {
    if (auto const *jump = dyn_cast_or_null<GotoStmt>(statement)) gotos_[jump->getLabel()].push_back(jump);
    if (statement)
      for (Stmt const *child : statement->children()) collect_gotos(child);
  }

  bool is_passed(DeclStmt const &declaration, CompoundStmt const &block, Labels const &behind) {
    if (behind.has_case) return true;
    for (LabelDecl const *label : behind.labels)
      for (GotoStmt const *jump : gotos_[label])
        if (sources_.isBeforeInTranslationUnit(jump->getBeginLoc(), declaration.getBeginLoc()) ||
            sources_.isBeforeInTranslationUnit(block.getEndLoc(), jump->getBeginLoc()))
          return true;
    return false;
  }

  void split(DeclStmt const &declaration) {
    std::vector<VarDecl const *> variables;
    for (Decl const *one : declaration.decls())
      if (auto const *variable = dyn_cast<VarDecl>(one)) variables.push_back(variable);
    auto const is_initialised = [](VarDecl const *one) { return one->hasLocalStorage() && one->hasInit(); };
    auto const first = std::find_if(variables.begin(), variables.end(), is_initialised);
    bool const has_array = std::any_of(variables.begin(), variables.end(), [&](VarDecl const *one) {
      return one->hasLocalStorage() && one->getType()->isArrayType() &&
             Reals::is_double(context_.getBaseElementType(one->getType()));
    });
    if (has_array) return declare_anew(declaration, variables, first == variables.end());
    if (first == variables.end()) return;
    std::vector<Wrap> words;
    bool possible = unlock(declaration, variables, words);
    for (auto one = first; one != variables.end() && possible; ++one) {
      if (one != first) possible = separate(**(one - 1), **one, words);
      if (is_initialised(*one)) possible = possible && assign(**one, words);
    }
    if (possible)
      facts_.wraps.insert(words.begin(), words.end());
    else
      report((*first)->getLocation(), "a jump passes the initialisation of '" + (*first)->getNameAsString() +
                                          "', which is spelled in parts or has a type without a name");
  }

  // A declaration of a single array keeps its initialiser.
  void declare_anew(DeclStmt const &declaration, std::vector<VarDecl const *> const &variables, bool no_initialiser) {
    std::string words;
    for (VarDecl const *variable : variables) {
      std::string const name = variable->getNameAsString();
      QualType const type = context_.getUnqualifiedArrayType(variable->getType());
      bool const is_array = type->isArrayType() && Reals::is_double(context_.getBaseElementType(type));
      PrintingPolicy const policy(context_.getLangOpts());
      words.append(words.empty() ? "" : "; ");
      words += is_array ? "::symreal::SymrealArray<" + with_real(type.getAsString(policy)) + "> " + name
                        : declared(variable->getType(), name, policy);
    }
    SourceLocation const begin = declaration.getBeginLoc();
    if (map_.is_argument_of(begin, "REAL_EITHER")) return;
    VarDecl const &last = *variables.back();
    SourceLocation end = last.getEndLoc();
    bool is_possible = std::distance(declaration.decl_begin(), declaration.decl_end()) == std::ssize(variables);
    if (!no_initialiser) {
      end = last.getTypeSourceInfo()->getTypeLoc().getEndLoc();
      words += "; ::symreal::symreal_initialised(" + last.getNameAsString() + ".elements)";
      is_possible = variables.size() == 1 && !last.isStaticLocal();
    }
    std::optional<Span> const span = is_possible ? map_.range({begin, end}) : std::optional<Span>();
    if (span)
      facts_.wraps.insert({*span, Use::instead, words});
    else
      report(begin, "a jump passes the declaration of an array of REALs");
  }
  static std::string declared(QualType type, std::string name, PrintingPolicy const &policy) {
    type.getAsStringInternal(name, policy);
    return with_real(name);
  }

  // Objects that get their value later are not const.
  bool unlock(DeclStmt const &declaration, std::vector<VarDecl const *> const &variables, std::vector<Wrap> &words) {
    SourceLocation const begin = sources_.getExpansionLoc(declaration.getBeginLoc());
    SourceLocation from = begin; // the type may be a macro, such as REAL
    bool const any_pointer = std::any_of(variables.begin(), variables.end(),
                                         [](VarDecl const *one) { return one->getType()->isPointerType(); });
    for (VarDecl const *variable : variables) {
      QualType const type = context_.getBaseElementType(variable->getType());
      if (!type.isConstQualified()) continue;
      if (type->isPointerType()) {
        if (!remove_const(from, variable->getLocation(), true, words)) return false;
      } else if (any_pointer || !remove_const(begin, variables[0]->getLocation(), false, words))
        return false;
      from = variable->getLocation();
    }
    return true;
  }

  // `behind_star`: removes the pointer's own const, not its pointee's.
  bool remove_const(SourceLocation from, SourceLocation name, bool behind_star, std::vector<Wrap> &words) {
    std::vector<SourceLocation> found;
    for (SourceLocation at = from; at.isValid() && sources_.isBeforeInTranslationUnit(at, name);) {
      Token token;
      if (at.isMacroID() || Lexer::getRawToken(at, token, sources_, context_.getLangOpts(), true)) return false;
      if (token.is(tok::star) && behind_star) found.clear();
      if (token.is(tok::raw_identifier) && token.getRawIdentifier() == "const") found.push_back(token.getLocation());
      at = token.getEndLoc();
    }
    for (SourceLocation const at : found) {
      if (map_.text_before(at).ends_with("REAL_EITHER((")) continue; // from the rewriting before
      std::optional<Span> const token = map_.token(at);
      if (!token) return false;
      words.push_back({*token, Use::instead, ""});
    }
    return !found.empty();
  }

  // `,` between two declarators.
  bool separate(VarDecl const &before, VarDecl const &variable, std::vector<Wrap> &words) {
    std::optional<Token> const comma = next_token(before.getEndLoc());
    std::string const type = specifier(variable);
    if (comma && is_ours(*comma, "REAL_EITHER")) return true;
    if (!comma || comma->isNot(tok::comma) || type.empty()) return false;
    std::optional<Span> const span = map_.token(comma->getLocation());
    if (span) words.push_back({*span, Use::instead, "; " + type});
    return span.has_value();
  }

  // The type as text, without the declarator; empty for a type without a name.
  std::string specifier(VarDecl const &variable) const {
    TypeLoc const type = without_declarator(variable.getTypeSourceInfo()->getTypeLoc());
    if (type.getAs<FunctionTypeLoc>()) return {};
    QualType named = type.getType();
    if (!variable.getType()->isPointerType()) named = named.getUnqualifiedType();
    if (TagDecl const *tag = named->getAsTagDecl(); tag && !tag->getIdentifier() && !named->getAs<TypedefType>())
      return {};
    return printed(named);
  }

  bool assign(VarDecl const &variable, std::vector<Wrap> &words) const {
    SourceLocation const end =
        std::max(variable.getLocation(), variable.getTypeSourceInfo()->getTypeLoc().getEndLoc(),
                 [&](SourceLocation a, SourceLocation b) { return sources_.isBeforeInTranslationUnit(a, b); });
    std::optional<Token> const equals = next_token(end);
    if (equals && is_ours(*equals, "REAL_ONLY")) return true;
    if (!equals || equals->isNot(tok::equal)) return false;
    std::optional<Span> const span = map_.token(equals->getLocation());
    std::string const name = variable.getNameAsString();
    if (span) words.push_back({*span, Use::before, "; ::symreal::symreal_initialised(" + name + ")"});
    return span.has_value();
  }

  // Whether the token is one of Symreal's macros, from an earlier rewriting.
  static bool is_ours(Token const &token, llvm::StringRef macro) {
    return token.is(tok::raw_identifier) && token.getRawIdentifier().ends_with(macro);
  }
  std::optional<Token> next_token(SourceLocation end) const {
    if (end.isMacroID()) return std::nullopt;
    return Lexer::findNextToken(end, sources_, context_.getLangOpts());
  }

  llvm::DenseMap<LabelDecl const *, std::vector<GotoStmt const *>> gotos_;
};

} // namespace

void collect_c_jumps(ASTContext &context, SourceMap const &map, Facts &facts) {
  if (!map.language().CPlusPlus) Jumps(context, map, facts).TraverseDecl(context.getTranslationUnitDecl());
}

} // namespace symreal::rewrite
