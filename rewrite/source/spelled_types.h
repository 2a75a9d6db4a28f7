// What a file spells, found by the lexer alone, so that code which is never compiled is seen too.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// Fills FileFact::spelled and FileFact::conditions from its text. A comment `symreal: keep` keeps the types of its
// line.
void find_spelled_types(std::string const &path, clang::LangOptions const &language, FileFact &file);

// Tells the facts about text that the preprocessor takes away.
std::unique_ptr<clang::PPCallbacks> make_skipped_text_collector(SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
