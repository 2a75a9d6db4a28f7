// Map from Clang's locations to spans and places in the files of the roots.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace symreal::rewrite {

// Scope of rewriting: files below the roots (real paths) that are not excluded, without Symreal's headers.
struct Scope {
  std::vector<std::string> roots;
  Exclusion exclude;
  bool holds(std::string const &real_path) const;
};

// Whether the path is a header of Symreal itself.
bool is_own_header(llvm::StringRef path);

class SourceMap {
public:
  SourceMap(clang::SourceManager const &sources, clang::LangOptions const &language, Scope const &scope);

  // Whether the location, seen through macros to its expansion, lies within the roots.
  bool in_roots(clang::SourceLocation location) const;
  // Whether a declaration at file level lies outside, so that a walk need not enter it.
  bool is_outside(clang::Decl const *declaration) const;

  // The token as it is spelled; nullopt if that is outside the roots or was pasted together.
  std::optional<Span> token(clang::SourceLocation location) const;
  // The token if it has this spelling; nullopt for one that a macro pastes or names otherwise.
  std::optional<Span> token(clang::SourceLocation location, llvm::StringRef spelling) const;

  // The first character of the token, as it is spelled.
  std::optional<Span> first_character(clang::SourceLocation location) const;

  // The characters of an expression: in a file, or inside the one macro body that holds all of it. Nullopt if it
  // straddles a macro's edge or lies outside the roots.
  std::optional<Span> range(clang::SourceRange range) const;

  // The characters as seen from `user`, which takes the expression: in the body of a macro an argument is its
  // parameter's name, and an edit there leaves the argument's other uses alone.
  std::optional<Span> range_for(clang::SourceLocation user, clang::SourceRange range) const;

  // Whether these characters may be compiled more than once in this source, with other types each time: in a macro's
  // body or argument, or in a file that is included again.
  bool is_shared(clang::SourceRange range) const;
  // Whether these characters are contiguous, in a file that is included once. They may be a part of a macro's argument.
  bool is_in_one_place(clang::SourceRange range) const;

  // Frame of a token: its file, or the expansion of the macro whose body holds it.
  clang::FileID frame(clang::SourceLocation location) const;

  // The characters of an expression as its frame spells it: in a macro's body an argument is its parameter's name.
  // Nullopt if the frame holds only a part of the expression.
  std::optional<Span> range_in(clang::FileID frame, clang::SourceRange range) const;

  std::optional<Span> characters(clang::SourceLocation begin, clang::SourceLocation end) const;

  // Place as a compiler would print it, seen through macros.
  Place place(clang::SourceLocation location) const;

  // The macros whose bodies contain the location, the innermost first.
  std::vector<Note> expansions(clang::SourceLocation location) const;

  // Whether the token stands in a call of a Symreal macro from an earlier rewriting, given the end of the macro's name.
  bool is_argument_of(clang::SourceLocation location, llvm::StringRef macro) const;

  std::string text(Span const &span, clang::SourceLocation inside) const;
  // The file's text before the token, as it is spelled.
  llvm::StringRef text_before(clang::SourceLocation location) const;
  std::string text_in(clang::FileID frame, Span const &span) const;

  // Adds the files of the roots that were read.
  void collect_files(Facts &facts) const;

  clang::SourceManager const &sources() const { return sources_; }
  clang::LangOptions const &language() const { return language_; }

private:
  std::string real_path_of(llvm::StringRef name) const;
  // Name of a file in messages. If the compiler's directory differs from that of this process: relative to the latter
  // for files below it, else absolute.
  std::string display_path(llvm::StringRef name) const;
  // Name of a file in gcc, and so in __FILE__: "header.h" beside the source, which Clang calls "./header.h".
  std::string compiled_name(llvm::StringRef name) const;
  Place presumed(clang::SourceLocation location) const;
  enum class Side { begin, end };
  // The characters of the tokens from the first to the last, where that is in one file.
  std::optional<Span> tokens(clang::SourceLocation first, clang::SourceLocation last) const;
  // End of the token.
  clang::SourceLocation behind(clang::SourceLocation token) const;
  // The same range in a file; invalid if no file holds all of it.
  clang::CharSourceRange written(clang::SourceRange range) const;
  // Whether the innermost expansion around the location begins, or ends, with it.
  bool is_at_edge(clang::SourceLocation location, Side side) const;
  // Begin or end of the innermost invocation around the location.
  clang::SourceLocation expanded_at(clang::SourceLocation location, Side side) const;
  std::optional<clang::SourceRange> words_for(clang::SourceLocation begin, clang::SourceLocation end) const;
  llvm::SmallVector<clang::SourceLocation, 8> standing_for(clang::SourceLocation location, Side side) const;
  clang::SourceLocation climb(clang::FileID frame, clang::SourceLocation location, Side side) const;
  // Whether the frame's parameter stands for all of the argument, rather than for one of `...`.
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
