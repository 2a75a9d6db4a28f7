// The tables of constants that the functions read.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

std::string table_name(Language const &language, std::size_t number);
std::string print_tables(Emission const &emission);

} // namespace symreal
