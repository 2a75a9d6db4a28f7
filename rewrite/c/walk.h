// Base of the walks that rewrite constructs of C that C++ does not allow.
#pragma once

#include "rewrite/source/source_map.h"
#include "rewrite/source/walk.h"
#include "rewrite/text/source_text.h"

namespace symreal::rewrite {

// A type without its variable's declarator; the next step leads to the return type of a function type.
inline clang::TypeLoc without_declarator(clang::TypeLoc type) {
  while (type) {
    if (auto const pointer = type.getAs<clang::PointerTypeLoc>())
      type = pointer.getPointeeLoc();
    else if (auto const array = type.getAs<clang::ArrayTypeLoc>())
      type = array.getElementLoc();
    else if (auto const parentheses = type.getAs<clang::ParenTypeLoc>())
      type = parentheses.getInnerLoc();
    else
      break;
  }
  return type;
}

class CWalk : public Walk {
public:
  CWalk(clang::ASTContext &context, SourceMap const &map, Facts &facts)
      : context_(context),
        sources_(context.getSourceManager()),
        map_(map),
        facts_(facts) {}

  bool TraverseDecl(clang::Decl *declaration) override {
    bool const is_outside =
        declaration &&
        !clang::isa<clang::TranslationUnitDecl, clang::NamespaceDecl, clang::LinkageSpecDecl>(declaration) &&
        declaration->getLexicalDeclContext()->isFileContext() && !map_.in_roots(declaration->getLocation());
    return is_outside || Walk::TraverseDecl(declaration);
  }

protected:
  void report(clang::SourceLocation location, std::string message) {
    facts_.diagnostics.push_back(
        {DiagnosticId::c_source, map_.place(location), std::move(message), map_.expansions(location)});
  }

  // False if a macro spells the characters to be changed.
  bool insert(std::optional<Span> const &span, Use use, std::string words) {
    if (span) facts_.wraps.insert({*span, use, std::move(words)});
    return span.has_value();
  }

  // Whether an earlier rewriting has put the location into text that only C reads.
  bool is_rewritten(clang::SourceLocation location) const {
    return map_.is_argument_of(location, "REAL_EITHER") || map_.is_argument_of(location, "REAL_ONLY");
  }

  std::string printed(clang::QualType type) const {
    clang::PrintingPolicy policy(context_.getLangOpts());
    policy.Bool = true;
    return with_real(type.getAsString(policy));
  }

  // The next raw token; `unknown` at the end of a macro.
  clang::Token next_token(clang::SourceLocation token) const {
    clang::Token none;
    none.startToken();
    if (token.isInvalid()) return none;
    auto const next = clang::Lexer::findNextToken(sources_.getSpellingLoc(token), sources_, context_.getLangOpts());
    return next.value_or(none);
  }

  clang::ASTContext &context_;
  clang::SourceManager const &sources_;
  SourceMap const &map_;
  Facts &facts_;
};

} // namespace symreal::rewrite
