// Events that the recording reports to the driver (runtime/wire/event.def): the file `events` is rewritten at each
// kernel's begin and end and at exit. A program started by hand has no such file and prints its diagnostics.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "runtime/memory/heap_blocks.h"
#include "runtime/wire/event.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace symreal::trace {

namespace events = wire::events;

// The place that the rewriter has written into the program: "file:line:column".
Place written_place(std::string_view place);

void add_line(std::string line);
template <class Event> void event(Event const &one) {
  memory::OwnWork const own;
  add_line(wire::line_of(one));
}
void report(Diagnostic const &diagnostic);
void report_here(DiagnosticId id, std::string const &message);
// Reports from a signal handler: at the interrupted instruction, or at `delayed` if the signal was delivered late.
// Repetitions are counted.
void report_interrupted(DiagnosticId id, std::string const &message, std::uintptr_t delayed = 0);
// A decision on a symbolic value at the caller's place; repetitions are counted.
void report_decision(std::string const &condition);
// A decision whose outcome a pragma accepts: the driver warns of it.
void report_carried(std::string const &condition);
// A condition at the caller's place that needs no decision: the driver remarks on it.
void report_settled(std::string const &condition);
bool anything_wrong();
// Keeps the events of a process that executes an arm for another one (decisions/join.h) instead of writing them.
void keep_events(bool are_kept);
// Number of events so far, except settled conditions.
std::size_t told();
bool has_told(std::string_view event);

void flush_events();
// After an error that leaves nothing sensible to go on with: writes the events and ends the process.
[[noreturn]] void give_up();

// Directory of the recording, as the request names it; empty in a program started by hand.
std::string const &record_directory();

// Installs handlers that write fatal signals down while the program records itself: the file `crash` in the directory
// of the recording then holds "SIGNAL address,address,...", hexadecimal, relative to the load base, innermost first. A
// handler that the program, or a sanitizer, has installed stays.
void watch_for_crashes();

} // namespace symreal::trace
