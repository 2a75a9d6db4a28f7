// Of a recording of instructions: whether what they read and write besides annotated objects is judged.
#pragma once

namespace symreal::trace {

bool watches_memory();

} // namespace symreal::trace
