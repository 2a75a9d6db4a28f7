// Where things of a syntax tree stand in the files of the roots: the bridge from Clang's locations to spans and places.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace symreal::rewrite {

// Which files may be rewritten: those below the roots (real paths) that nothing excludes, other than Symreal's headers.
struct Scope {
  std::vector<std::string> roots;
  Exclusion exclude;
  bool holds(std::string const &real_path) const;
};

// A header of Symreal itself?
bool is_own_header(llvm::StringRef path);

class SourceMap {
public:
  SourceMap(clang::SourceManager const &sources, clang::LangOptions const &language, Scope const &scope);

  // Does the location, seen through macros to where it is expanded, lie within the roots?
  bool in_roots(clang::SourceLocation location) const;
  // A declaration at file level that neither stands nor begins there: a walk need not enter it.
  bool is_outside(clang::Decl const *declaration) const;

  // The token as it is spelled; nothing when that is outside the roots or was pasted together.
  std::optional<Span> token(clang::SourceLocation location) const;
  // The same where it is spelled so: what a macro pastes or names otherwise stands nowhere.
  std::optional<Span> token(clang::SourceLocation location, llvm::StringRef spelling) const;

  // The first character of the token, as it is spelled.
  std::optional<Span> first_character(clang::SourceLocation location) const;

  // The characters of an expression: where it is written, or inside the one macro body that holds all of it. Nothing
  // when it straddles a macro's edge or lies outside the roots.
  std::optional<Span> range(clang::SourceRange range) const;

  // The same as `user`, which takes the expression, spells it: in the body of a macro an argument is its parameter's
  // name, and what becomes of that leaves the argument's other uses alone.
  std::optional<Span> range_for(clang::SourceLocation user, clang::SourceRange range) const;

  // May these characters be compiled more than once in this source, with other types each time: in a macro's body or
  // argument, in a file that is included again?
  bool is_shared(clang::SourceRange range) const;
  // Do these characters stand in a row, in a file that is included once? They may be a part of a macro's argument.
  bool is_in_one_place(clang::SourceRange range) const;

  // Where a token is written: a file, or the expansion of the macro whose body holds it.
  clang::FileID frame(clang::SourceLocation location) const;

  // The characters of an expression as its frame spells it: in a macro's body an argument is its parameter's name.
  // Nothing when the frame holds only a part of the expression.
  std::optional<Span> range_in(clang::FileID frame, clang::SourceRange range) const;

  std::optional<Span> characters(clang::SourceLocation begin, clang::SourceLocation end) const;

  // As a compiler would print it, seen through macros.
  Place place(clang::SourceLocation location) const;

  // The macros in whose bodies it is written, the innermost first.
  std::vector<Note> expansions(clang::SourceLocation location) const;

  // Does the token stand in a call of one of our macros, from the rewriting before? By the end of the macro's name.
  bool is_argument_of(clang::SourceLocation location, llvm::StringRef macro) const;

  std::string text(Span const &span, clang::SourceLocation inside) const;
  std::string text_in(clang::FileID frame, Span const &span) const;

  // Adds the files of the roots that were read.
  void collect_files(Facts &facts) const;

  clang::SourceManager const &sources() const { return sources_; }
  clang::LangOptions const &language() const { return language_; }

private:
  std::string real_path_of(llvm::StringRef name) const;
  // As a message names a file: where the compiler's directory is not that of this process, below the latter's if it is
  // there, else from the root.
  std::string display_path(llvm::StringRef name) const;
  // Clang names what a source in the current directory includes "./header.h", gcc (and so __FILE__) "header.h".
  std::string compiled_name(llvm::StringRef name) const;
  Place presumed(clang::SourceLocation location) const;
  enum class Side { begin, end };
  std::optional<clang::SourceRange> words_for(clang::SourceLocation begin, clang::SourceLocation end) const;
  llvm::SmallVector<clang::SourceLocation, 8> standing_for(clang::SourceLocation location, Side side) const;
  clang::SourceLocation climb(clang::FileID frame, clang::SourceLocation location, Side side) const;
  // Where the frame has a parameter for it: is that the whole of the argument, rather than one of `...`?
  bool is_whole(clang::FileID frame, clang::SourceLocation location, Side side) const;
  // The real path of a file within the roots, else empty.
  std::string const &path(clang::FileID file) const;

  clang::SourceManager const &sources_;
  clang::LangOptions const &language_;
  Scope const &scope_;
  std::string here_, directory_; // of this process and of the compiler
  mutable std::unordered_map<unsigned, std::string> paths_;
  mutable std::unordered_map<std::string, std::string> display_paths_;
  mutable std::optional<llvm::DenseMap<clang::FileEntry const *, unsigned>> inclusions_;
};

} // namespace symreal::rewrite
