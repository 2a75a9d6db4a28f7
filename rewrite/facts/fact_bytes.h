// Facts as bytes, to be kept from run to run, and back.
#pragma once

#include "rewrite/facts/facts.h"

#include <optional>
#include <string>
#include <string_view>

namespace symreal::rewrite {

std::string to_bytes(Facts facts);

// Nullopt if the bytes are not those of facts, as far as that can be detected.
std::optional<Facts> facts_of_bytes(std::string_view bytes);

// Serialises a configured kernel, only for comparing two of them.
std::string to_bytes(ConfiguredKernel kernel);
std::string to_bytes(ConfiguredExternal external);

} // namespace symreal::rewrite
