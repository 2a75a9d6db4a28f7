// What ended the program, for the driver: a signal, and where the program stood. Written to the file `crash` of the
// directory of the recording: "SIGNAL address,address,...", hexadecimal, relative to the load base, innermost first.
#pragma once

namespace symreal::trace {

// While the program records itself: signals that would end it are written down first. A handler that the program, or a
// sanitizer, has installed stays.
void watch_for_crashes();

} // namespace symreal::trace
