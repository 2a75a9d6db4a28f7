// File-scope variables of C whose rules differ in C++.
//
// Constants have external linkage. Tentative definitions: C lets a file define a variable several times, with at most
// one initialiser. For C++ all but one become declarations. A static one is declared in an unnamed namespace, which
// gives it the same linkage.
#include "rewrite/collect/collector.h"

namespace symreal::rewrite {
using namespace clang;

namespace {

constexpr char const *opens_declaration = "SYMREAL_REAL_EITHER((static), extern \"C++\" { namespace { extern)";
constexpr char const *opens_definition = "SYMREAL_REAL_EITHER((static), extern \"C++\" { namespace {)";
constexpr char const *closes = "; SYMREAL_REAL_EITHER((), }})";

std::vector<VarDecl const *> definitions_of(VarDecl const *variable, ASTContext &context) {
  std::vector<VarDecl const *> found;
  for (VarDecl const *one : variable->redecls())
    if (one->isThisDeclarationADefinition(context) != VarDecl::DeclarationOnly) found.push_back(one);
  return found;
}

} // namespace

void Collector::tentative_definitions(VarDecl const *variable) {
  if (!variable->isFileVarDecl() || !variable->isFirstDecl()) return;
  std::vector<VarDecl const *> const all = definitions_of(variable, context_);
  bool const is_constant = context_.getBaseElementType(variable->getType()).isConstQualified();
  if (all.size() == 1 && is_constant && variable->getStorageClass() == SC_None) declare_external(variable);
  if (all.size() < 2) return;
  VarDecl const *definition = variable->getDefinition(context_);
  if (!definition) definition = variable->getActingDefinition();
  for (VarDecl const *one : all)
    if (!tentative_definition(one, one == definition))
      report(DiagnosticId::c_source, one->getLocation(),
             "'" + one->getNameAsString() + "' is defined more than once, and here not by a line of its own");
}

// Adds `extern` to a constant with external linkage in C.
bool Collector::declare_external(VarDecl const *variable) {
  auto const [file, offset] = map_.sources().getDecomposedExpansionLoc(variable->getBeginLoc());
  std::optional<Span> const all = map_.range(variable->getSourceRange());
  if (!all || all->begin != offset) return false; // within a macro
  std::string_view const text = map_.sources().getBufferData(file);
  if (!text.substr(0, all->begin).ends_with("REAL_EITHER((), extern) ")) // from the rewriting before
    facts_.wraps.insert({{all->file, all->begin, all->begin + 1}, Use::declared, ""});
  return true;
}

// Whether the definition stands alone, as `static type name = ...;`, so that the words around it can be changed.
bool Collector::tentative_definition(VarDecl const *variable, bool is_definition) {
  bool const is_static = variable->getStorageClass() == SC_Static;
  SourceLocation const begin = variable->getBeginLoc();
  if (map_.is_argument_of(begin, "REAL_EITHER")) return true; // from the rewriting before
  if (is_definition && !is_static) return true;
  for (Decl const *other : context_.getTranslationUnitDecl()->decls())
    if (other != variable && other->getBeginLoc() == begin && isa<DeclaratorDecl>(other)) return false;
  std::optional<Token> const next = Lexer::findNextToken(variable->getEndLoc(), map_.sources(), map_.language());
  if (!next || next->isNot(tok::semi)) return false;
  if (!is_static) return declare_external(variable);
  std::optional<Span> const first = map_.token(begin, "static"), last = map_.token(next->getLocation(), ";");
  if (!first || !last) return false;
  facts_.types.insert({*first, is_definition ? opens_definition : opens_declaration});
  facts_.types.insert({*last, closes});
  return true;
}

} // namespace symreal::rewrite
