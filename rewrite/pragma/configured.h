// What the request says instead of pragmas: kernels whose functions are named, and external functions. Their words are
// those of the pragmas and go the same way from there on.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/model/scalar_state.h"
#include "rewrite/pragma/pragma_handler.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <vector>

namespace symreal::rewrite {

// Puts the request's externals beside those that pragmas of this source name.
void index_configured_externals(Request const &request, clang::ASTContext &context, PragmaIndex &index, Facts &facts);

// Attaches the request's kernels to those of the definitions that they name.
void attach_configured_kernels(Request const &request, std::vector<clang::FunctionDecl const *> const &definitions,
                               SourceMap const &map, Reals const &reals, ScalarState const &scalars, Facts &facts);

// The qualified name of the function that it asks for, without types: one of Facts::kernel_functions where the kernel
// matters to a source at all.
std::string configured_name(ConfiguredKernel const &kernel);

// What no source defines or declares, or more than one function answers to; once all sources are read.
void report_configured(Request const &request, Facts &facts);

} // namespace symreal::rewrite
