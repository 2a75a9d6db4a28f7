// Kernels and external functions that the request configures instead of pragmas. Their words are those of the pragmas
// and are processed in the same way from there on.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/model/scalar_state.h"
#include "rewrite/pragma/pragma_handler.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <vector>

namespace symreal::rewrite {

// Adds the request's externals to those of this source's pragmas.
void index_configured_externals(Request const &request, clang::ASTContext &context, PragmaIndex &index, Facts &facts);

// Attaches the request's kernels to the definitions that they name.
void attach_configured_kernels(Request const &request, std::vector<clang::FunctionDecl const *> const &definitions,
                               SourceMap const &map, Reals const &reals, ScalarState const &scalars, Facts &facts);

// Qualified name of the kernel's function, without types: one of Facts::kernel_functions if the kernel matters to a
// source.
std::string configured_name(ConfiguredKernel const &kernel);

// Reports entries that match no function or several, once all sources are read.
void report_configured(Request const &request, Facts &facts);

} // namespace symreal::rewrite
