// Facts as bytes, to be kept from run to run, and back.
#pragma once

#include "rewrite/facts/facts.h"

#include <optional>
#include <string>
#include <string_view>

namespace symreal::rewrite {

std::string to_bytes(Facts facts);

// Nothing where the bytes are not those of facts, as far as that can be seen.
std::optional<Facts> facts_of_bytes(std::string_view bytes);

// The same for what a configured kernel is made of: one way only, to tell two of them apart.
std::string to_bytes(ConfiguredKernel kernel);
std::string to_bytes(ConfiguredExternal external);

} // namespace symreal::rewrite
