// Report of a signal that ended the program, for the driver: the file `crash` in the directory of the recording holds
// "SIGNAL address,address,...", hexadecimal, relative to the load base, innermost first.
#pragma once

namespace symreal::trace {

// Installs handlers that write fatal signals down while the program records itself. A handler that the program, or a
// sanitizer, has installed stays.
void watch_for_crashes();

} // namespace symreal::trace
