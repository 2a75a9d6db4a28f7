// Tables of constants for lookups.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

std::string table_name(Language const &language, std::size_t number);
std::string print_tables(Emission const &emission);

} // namespace symreal
