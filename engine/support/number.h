// Numbers as text that reads back to the same bits.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace symreal {

// The shortest decimal text that reads back to the same double: "10", "-0", "0.1", "1e+300", "inf", "nan"; of a NaN the
// sign alone.
std::string shortest(double value);
// That reads back to the same float: "0.1" of the float that is 0.10000000149011612.
std::string shortest(float value);

// The inverse; also hexadecimal floating point ("0x1.8p+1"). The whole text must be a number.
std::optional<double> parse_number(std::string_view text);

// The decimal text of a count, at the end of `text`.
void append_number(std::string &text, std::size_t number);

} // namespace symreal
