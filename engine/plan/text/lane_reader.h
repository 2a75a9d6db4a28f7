// Reader of the vectors of function compute. Internal to plan_text.h.
#pragma once

#include "engine/plan/text/lines.h"

namespace symreal {

class LaneReader {
public:
  // Reads the line `lanes`, after its first word.
  LaneReader(Plan const &plan, PlanFunction &function, NodeNames const &names, Line &line);

  // Reads a line, of which `head` is the first word; false if it is of another kind.
  bool read(std::string const &head, Line &line);
  // Proves that the lanes hold their nodes.
  void finish(Line const &line) const;

private:
  void read_vector(Line &line);
  void read_load(Line &line, lanes::Vector &vector) const;
  NodeId read_lane(Line &line, lanes::Vector const &vector, lanes::VectorId id, std::uint32_t lane);
  lanes::VectorId read_vector_use(Line &line, lanes::VectorId before) const;
  void read_item(Line &line);
  void read_vector_store(Line &line);

  Plan const &plan_;
  Graph const &graph_;
  NodeNames const &names_;
  lanes::LaneFunction &lanes_;
};

} // namespace symreal
