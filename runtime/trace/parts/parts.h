// The parts of a thread's session (trace/session.h), as the rooms below it know them: each by reference, and only those
// whose headers a room can include.
#pragma once

namespace symreal::trace {

class Checkpoint;
class Environment;
class ExploredPath;
class Externals;
class Guards;
class Join;
class Kernel;
class Pool;
class State;
class TextMarks;
class TornNumbers;
struct Conditions;
struct ExternalShapes;
struct TypeNames;

struct Parts {
  Pool &pool;
  TornNumbers &torn_numbers;
  Externals &externals;
  ExternalShapes &external_shapes;
  Kernel &kernel;
  State &state;
  Conditions &conditions;
  Guards &guards;
  Checkpoint &checkpoint;
  Join &join;
  ExploredPath &path;
  TextMarks &text_marks;
  Environment &environment;
  TypeNames &type_names;
};

// Null until the thread first asks. Constant-initialised: numbers with static storage ask before main.
extern constinit thread_local Parts *parts_of_thread;
// Makes the session of the thread. Defined in trace/session.cpp, which sees all rooms and so belongs to none.
Parts *make_parts();

// The parts of this thread's session. The operators of numbers ask as well, who are given nothing but their operands.
inline Parts &session() {
  if (!parts_of_thread) parts_of_thread = make_parts();
  return *parts_of_thread;
}

} // namespace symreal::trace
