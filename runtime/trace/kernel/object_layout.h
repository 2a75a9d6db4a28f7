// Reader of layout texts, which list the numbers of a structure (<symreal/object_layout.h>), and the extents that it
// finds.
#pragma once

#include <symreal/object_layout.h>

#include <string>

namespace symreal::trace {

// Visitor for the parts of a structure, in layout order.
class LayoutVisitor {
public:
  virtual ~LayoutVisitor() = default;
  virtual void number(void const volatile *address) = 0;
  virtual void scalar(ScalarObject) {}
  virtual void container(void const volatile *, std::size_t) {}
  virtual void begin_members() {}
  virtual void begin_member(std::string const &) {}
  virtual void end_member(std::vector<std::size_t> const &) {}
  virtual void end_members() {}
};

// Appends the extents of the object.
void visit_layout(void const volatile *object, char const *layout, detail::VisitElements const *containers,
                  LayoutVisitor &visitor, std::vector<std::size_t> *extents);

} // namespace symreal::trace
