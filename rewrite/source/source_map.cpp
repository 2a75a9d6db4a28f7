#include "rewrite/source/source_map.h"

#include "rewrite/source/spelled_types.h"

namespace symreal::rewrite {

bool is_own_header(llvm::StringRef path) { return path.contains("/include/symreal/"); }

bool Scope::holds(std::string const &real_path) const {
  if (is_own_header(real_path)) return false;
  for (std::string const &root : roots) {
    bool const slash = !root.empty() && root.back() == '/';
    if (real_path.compare(0, root.size(), root) == 0 &&
        (slash || real_path.size() == root.size() || real_path[root.size()] == '/'))
      return !exclude.matches(real_path);
  }
  return false;
}

SourceMap::SourceMap(clang::SourceManager const &sources, clang::LangOptions const &language, Scope const &scope)
    : sources_(sources),
      language_(language),
      scope_(scope) {
  llvm::SmallString<256> here;
  if (!llvm::sys::fs::current_path(here)) here_ = here.str().str();
  auto const directory = sources.getFileManager().getVirtualFileSystem().getCurrentWorkingDirectory();
  directory_ = directory ? *directory : here_;
}

std::string SourceMap::real_path_of(llvm::StringRef name) const {
  llvm::SmallString<256> real;
  return sources_.getFileManager().getVirtualFileSystem().getRealPath(name, real) ? name.str() : real.str().str();
}

std::string const &SourceMap::path(clang::FileID file) const {
  auto const [at, is_new] = paths_.try_emplace(file.getHashValue());
  if (!is_new) return at->second;
  if (clang::OptionalFileEntryRef const entry = sources_.getFileEntryRefForID(file))
    if (std::string real = real_path_of(entry->getName()); scope_.holds(real)) at->second = std::move(real);
  return at->second;
}

bool SourceMap::in_roots(clang::SourceLocation location) const {
  return location.isValid() && !path(sources_.getFileID(sources_.getExpansionLoc(location))).empty();
}

bool SourceMap::is_outside(clang::Decl const *declaration) const {
  return !llvm::isa<clang::TranslationUnitDecl>(declaration) && declaration->getLexicalDeclContext()->isFileContext() &&
         !in_roots(declaration->getLocation()) && !in_roots(declaration->getBeginLoc());
}

std::string SourceMap::display_path(llvm::StringRef name) const {
  if (directory_ == here_) return compiled_name(name);
  auto const [at, is_new] = display_paths_.try_emplace(name.str());
  if (!is_new) return at->second;
  llvm::SmallString<256> path(name);
  llvm::sys::fs::make_absolute(directory_, path);
  llvm::sys::path::remove_dots(path, /*remove_dot_dot=*/true);
  llvm::StringRef shown = path;
  if (shown.consume_front(here_) && !shown.consume_front("/")) shown = path;
  return at->second = shown.str();
}

std::string SourceMap::compiled_name(llvm::StringRef name) const {
  clang::OptionalFileEntryRef const main = sources_.getFileEntryRefForID(sources_.getMainFileID());
  if (!main || !main->getName().starts_with("./")) name.consume_front("./");
  return name.str();
}

// Clang counts a line continuation as part of the token at the beginning of the next line.
static unsigned behind_continuations(llvm::StringRef text, unsigned at) {
  while (text.substr(at).starts_with("\\")) {
    std::size_t const next = text.find_first_not_of(" \t\r", at + 1);
    if (next == text.npos || text[next] != '\n') break;
    at = static_cast<unsigned>(next) + 1;
  }
  return at;
}

std::optional<Span> SourceMap::characters(clang::SourceLocation begin, clang::SourceLocation end) const {
  auto const [file, clang_first] = sources_.getDecomposedLoc(begin);
  auto const [last_file, last] = sources_.getDecomposedLoc(end);
  unsigned const first = behind_continuations(sources_.getBufferData(file), clang_first);
  if (file != last_file || last <= first || path(file).empty()) return std::nullopt;
  return Span{path(file), first, last};
}

std::optional<Span> SourceMap::token(clang::SourceLocation location) const {
  if (location.isInvalid()) return std::nullopt;
  return tokens(location, location);
}

std::optional<Span> SourceMap::tokens(clang::SourceLocation first, clang::SourceLocation last) const {
  return characters(sources_.getSpellingLoc(first), behind(sources_.getSpellingLoc(last)));
}

clang::SourceLocation SourceMap::behind(clang::SourceLocation token) const {
  unsigned const length = clang::Lexer::MeasureTokenLength(sources_.getSpellingLoc(token), sources_, language_);
  return token.getLocWithOffset(static_cast<int>(length));
}

std::optional<Span> SourceMap::token(clang::SourceLocation location, llvm::StringRef spelling) const {
  std::optional<Span> const span = token(location);
  return span && text(*span, location) == spelling ? span : std::nullopt;
}

std::optional<Span> SourceMap::first_character(clang::SourceLocation location) const {
  if (location.isInvalid()) return std::nullopt;
  auto const [file, offset] = sources_.getDecomposedSpellingLoc(location);
  std::string const &name = path(file);
  return name.empty() ? std::nullopt : std::optional(Span{name, offset, offset + 1});
}

std::optional<Span> SourceMap::range(clang::SourceRange range) const {
  if (range.isInvalid()) return std::nullopt;
  clang::CharSourceRange const in_file = written(range);
  if (in_file.isValid()) return characters(in_file.getBegin(), in_file.getEnd());
  clang::SourceLocation begin = range.getBegin(), end = range.getEnd();
  llvm::SmallString<16> scratch;
  if (!begin.isMacroID() || !end.isMacroID()) return std::nullopt;
  // Both ends stand in one argument of a macro of the program, which is spelled with macros itself.
  while (sources_.getFileID(begin) != sources_.getFileID(end) && sources_.isMacroArgExpansion(begin) &&
         sources_.isMacroArgExpansion(end) &&
         sources_.getImmediateExpansionRange(begin).getBegin() == sources_.getImmediateExpansionRange(end).getBegin() &&
         in_roots(sources_.getSpellingLoc(sources_.getImmediateExpansionRange(begin).getBegin()))) {
    begin = sources_.getImmediateSpellingLoc(begin);
    end = sources_.getImmediateSpellingLoc(end);
  }
  if (sources_.getFileID(begin) != sources_.getFileID(end)) {
    std::optional<clang::SourceRange> const words = words_for(begin, end);
    if (!words) return std::nullopt;
    begin = words->getBegin();
    end = words->getEnd();
  }
  for (clang::SourceLocation const side : {begin, end}) // where `...` names one argument here, it names more elsewhere
    if (clang::Lexer::getSpelling(sources_.getSpellingLoc(side), scratch, sources_, language_) == "__VA_ARGS__")
      return std::nullopt;
  return tokens(begin, end);
}

clang::CharSourceRange SourceMap::written(clang::SourceRange range) const {
  return clang::Lexer::makeFileCharRange(clang::CharSourceRange::getTokenRange(range), sources_, language_);
}

// Range of tokens in one file for both ends: a parameter's name stands for an argument, a macro's name for its
// expansion, in the body that contains them.
std::optional<clang::SourceRange> SourceMap::words_for(clang::SourceLocation begin, clang::SourceLocation end) const {
  llvm::SmallVector<clang::SourceLocation, 8> const firsts = standing_for(begin, Side::begin);
  llvm::SmallVector<clang::SourceLocation, 8> const lasts = standing_for(end, Side::end);
  for (clang::SourceLocation const first : firsts)
    for (clang::SourceLocation const last : lasts)
      if (sources_.getFileID(first) == sources_.getFileID(last)) return clang::SourceRange(first, last);
  return std::nullopt;
}

// The location, then that of each parameter or macro whose expansion begins (or ends) with it.
llvm::SmallVector<clang::SourceLocation, 8> SourceMap::standing_for(clang::SourceLocation location, Side side) const {
  llvm::SmallVector<clang::SourceLocation, 8> all = {location};
  while (location.isMacroID() && is_at_edge(location, side)) {
    location = expanded_at(location, side);
    all.push_back(location);
  }
  return all;
}

bool SourceMap::is_at_edge(clang::SourceLocation location, Side side) const {
  return side == Side::begin ? sources_.isAtStartOfImmediateMacroExpansion(location)
                             : sources_.isAtEndOfImmediateMacroExpansion(behind(location));
}

clang::SourceLocation SourceMap::expanded_at(clang::SourceLocation location, Side side) const {
  clang::CharSourceRange const invocation = sources_.getImmediateExpansionRange(location);
  return side == Side::begin ? invocation.getBegin() : invocation.getEnd();
}

std::optional<Span> SourceMap::range_for(clang::SourceLocation user, clang::SourceRange range) const {
  if (user.isInvalid()) return this->range(range);
  for (clang::FileID at = frame(user); !sources_.getSLocEntry(at).isFile(); at = frame(user)) {
    if (is_whole(at, range.getBegin(), Side::begin) && is_whole(at, range.getEnd(), Side::end))
      if (std::optional<Span> const span = range_in(at, range)) return span;
    user = sources_.getSLocEntry(at).getExpansion().getExpansionLocStart(); // a library's macro
  }
  return this->range(range);
}

bool SourceMap::is_shared(clang::SourceRange range) const {
  for (clang::SourceLocation at = range.getBegin(); at.isMacroID();
       at = sources_.getImmediateExpansionRange(at).getBegin())
    if (sources_.isMacroArgExpansion(at)) return true;
  return !is_in_one_place(range);
}

bool SourceMap::is_in_one_place(clang::SourceRange range) const {
  clang::CharSourceRange const in_file = written(range);
  if (in_file.isInvalid()) return false;
  if (!inclusions_) {
    inclusions_.emplace();
    for (unsigned i = 0; i < sources_.local_sloc_entry_size(); ++i)
      if (clang::SrcMgr::SLocEntry const &entry = sources_.getLocalSLocEntry(i); entry.isFile())
        if (clang::OptionalFileEntryRef const file = entry.getFile().getContentCache().OrigEntry)
          ++(*inclusions_)[&file->getFileEntry()];
  }
  clang::OptionalFileEntryRef const file = sources_.getFileEntryRefForID(sources_.getFileID(in_file.getBegin()));
  return !file || inclusions_->lookup(&file->getFileEntry()) <= 1;
}

clang::FileID SourceMap::frame(clang::SourceLocation location) const {
  while (sources_.isMacroArgExpansion(location)) location = sources_.getImmediateSpellingLoc(location);
  return sources_.getFileID(location);
}

// The frame's location for this one, or an invalid one.
clang::SourceLocation SourceMap::climb(clang::FileID frame, clang::SourceLocation location, Side side) const {
  while (location.isMacroID() && sources_.getFileID(location) != frame) {
    if (!sources_.isMacroArgExpansion(location)) return {};
    clang::SourceLocation const written = climb(frame, sources_.getImmediateSpellingLoc(location), side);
    if (written.isValid()) return written;
    location = expanded_at(location, side);
  }
  return sources_.getFileID(location) == frame ? location : clang::SourceLocation();
}

bool SourceMap::is_whole(clang::FileID frame, clang::SourceLocation location, Side side) const {
  while (location.isMacroID() && sources_.getFileID(location) != frame) {
    if (!sources_.isMacroArgExpansion(location)) return false;
    if (clang::SourceLocation const written = sources_.getImmediateSpellingLoc(location);
        climb(frame, written, side).isValid()) {
      location = written;
      continue;
    }
    if (!is_at_edge(location, side)) return false;
    location = expanded_at(location, side);
  }
  return sources_.getFileID(location) == frame;
}

std::optional<Span> SourceMap::range_in(clang::FileID frame, clang::SourceRange range) const {
  if (range.isInvalid()) return std::nullopt;
  if (sources_.getSLocEntry(frame).isFile()) {
    clang::CharSourceRange const in_file = written(range);
    return in_file.isValid() ? characters(in_file.getBegin(), in_file.getEnd()) : std::nullopt;
  }
  clang::SourceLocation const first = climb(frame, range.getBegin(), Side::begin);
  clang::SourceLocation const last = climb(frame, range.getEnd(), Side::end);
  if (first.isInvalid() || last.isInvalid()) return std::nullopt;
  return tokens(first, last);
}

Place SourceMap::presumed(clang::SourceLocation location) const {
  clang::PresumedLoc const presumed = sources_.getPresumedLoc(location);
  if (presumed.isInvalid()) return {};
  return {display_path(presumed.getFilename()), presumed.getLine(), presumed.getColumn()};
}

Place SourceMap::place(clang::SourceLocation location) const { return presumed(sources_.getExpansionLoc(location)); }

std::vector<Note> SourceMap::expansions(clang::SourceLocation location) const {
  std::vector<Note> notes;
  while (location.isValid() && location.isMacroID()) {
    if (sources_.isMacroArgExpansion(location)) {
      location = sources_.getImmediateSpellingLoc(location);
      continue;
    }
    clang::SourceLocation const body = sources_.getSpellingLoc(location);
    if (!sources_.isWrittenInScratchSpace(body)) // pasted together: the macro that pastes follows
      notes.push_back({presumed(body), "in the expansion of macro '" +
                                           clang::Lexer::getImmediateMacroName(location, sources_, language_).str() +
                                           "'"});
    location = sources_.getImmediateExpansionRange(location).getBegin();
  }
  return notes;
}

bool SourceMap::is_argument_of(clang::SourceLocation location, llvm::StringRef macro) const {
  for (; sources_.isMacroArgExpansion(location); location = sources_.getImmediateSpellingLoc(location)) {
    clang::SourceLocation const parameter = sources_.getImmediateExpansionRange(location).getBegin();
    if (clang::Lexer::getImmediateMacroName(parameter, sources_, language_).ends_with(macro)) return true;
  }
  return false;
}

std::string SourceMap::text(Span const &span, clang::SourceLocation inside) const {
  clang::FileID const file = sources_.getFileID(sources_.getSpellingLoc(inside));
  return sources_.getBufferData(file).substr(span.begin, span.end - span.begin).str();
}

llvm::StringRef SourceMap::text_before(clang::SourceLocation location) const {
  auto const [file, offset] = sources_.getDecomposedSpellingLoc(location);
  return sources_.getBufferData(file).take_front(offset);
}

std::string SourceMap::text_in(clang::FileID frame, Span const &span) const {
  clang::SrcMgr::SLocEntry const &entry = sources_.getSLocEntry(frame);
  return text(span, entry.isFile() ? sources_.getLocForStartOfFile(frame) : entry.getExpansion().getSpellingLoc());
}

void SourceMap::collect_files(Facts &facts) const {
  for (unsigned i = 0; i < sources_.local_sloc_entry_size(); ++i) {
    clang::SrcMgr::SLocEntry const &entry = sources_.getLocalSLocEntry(i);
    if (!entry.isFile() || clang::SrcMgr::isSystem(entry.getFile().getFileCharacteristic())) continue;
    if (clang::OptionalFileEntryRef const file = entry.getFile().getContentCache().OrigEntry)
      facts.read.insert(real_path_of(file->getName()));
  }
  for (auto at = sources_.fileinfo_begin(); at != sources_.fileinfo_end(); ++at) {
    std::string const name = at->first.getName().str();
    std::string const real = real_path_of(name);
    if (!scope_.holds(real) || facts.files.count(real) != 0) continue;
    if (std::optional<llvm::StringRef> const text = at->second->getBufferDataIfLoaded())
      find_spelled_types(real, language_, facts.files[real] = {display_path(name), compiled_name(name), text->str()});
  }
}

} // namespace symreal::rewrite
