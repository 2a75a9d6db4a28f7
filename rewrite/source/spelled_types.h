// Search for spelled types by the lexer alone, so that code which is never compiled is included.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// Fills FileFact::spelled and FileFact::conditions from the file's text. A comment `symreal: keep` keeps the types of
// its line.
void find_spelled_types(std::string const &path, clang::LangOptions const &language, FileFact &file);

// Callbacks that note the text removed by the preprocessor.
std::unique_ptr<clang::PPCallbacks> make_skipped_text_collector(SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
