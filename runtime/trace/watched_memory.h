// Whether a recording of instructions judges the reads and writes of memory other than annotated objects.
#pragma once

namespace symreal::trace {

bool watches_memory();

} // namespace symreal::trace
