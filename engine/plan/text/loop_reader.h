// Reader of the loops of a function. Internal to plan_text.h.
#pragma once

#include "engine/plan/text/lines.h"

namespace symreal {

class LoopReader {
public:
  // Reads the line `loops`, after its first word. `shared`: lines of the plan's graph that the bodies of loops share.
  LoopReader(Plan const &plan, PlanFunction &function, std::string const &shared, std::string const &file_name,
             Line &line);

  // Reads a line, of which `head` is the first word, and the lines of a body; false if it is of another kind.
  bool read(std::string const &head, Line &line, Lines &lines);
  // Checks what can be wrong only where all lines are read.
  void finish(Line const &line);

private:
  void read_step(Line &line);
  void read_nest(Line &line);
  void read_leaf(Line &line);
  void read_body(Line const &line, Lines &lines);
  void read_store(Line &line);
  void read_mirror(Line &line);
  void require_body(Line const &line) const;

  Plan const &plan_;
  PlanFunction &function_;
  reroll::LoopFunction &loops_;
  std::string const &shared_, &file_name_;
  std::vector<std::pair<std::size_t, std::string>> carried_; // leaf of the step, and its node in the body to come
  bool has_body_ = false;
};

} // namespace symreal
