// Map from lines of generated code to source lines, as JSON.
#pragma once

#include "engine/emit/language/emitted.h"

#include <string>

namespace symreal::tool {

// {"version": 1, "file": "arm.c", "lines": [{"first": 9, "last": 10, "sources": [[{"file": ..., "line": ..., "column":
// ...}, ...], ...]}, ...]}. Each source is a list of places: the user's own, then inlined ones.
std::string line_map(EmittedFile const &file, Graph const &graph);

} // namespace symreal::tool
