// Reads the text that says where the numbers of a structure lie (<symreal/object_layout.h>).
#pragma once

#include <symreal/object_layout.h>

#include <string>

namespace symreal::trace {

// What is told of a structure, in the order of its layout.
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

// The extents of the object are appended.
void visit_layout(void const volatile *object, char const *layout, detail::VisitElements const *containers,
                  LayoutVisitor &visitor, std::vector<std::size_t> *extents);

} // namespace symreal::trace
