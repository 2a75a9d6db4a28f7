#include "runtime/trace/kernel/object_layout.h"

#include "engine/diagnostics/diagnostic.h"
#include "runtime/memory/own_memory.h"
#include "runtime/trace/kernel/kernel.h"

#include <symreal/extents.h>

#include <cstdlib>
#include <cstring>
#include <vector>

namespace symreal {

struct Extents::Parts {
  std::vector<std::size_t> extents;
  std::vector<ScalarObject> variables; // that are among them
};

Extents::Extents() : parts_(new Parts) {}
Extents::~Extents() { delete parts_; }

void Extents::push_back(std::size_t extent) noexcept { parts_->extents.push_back(extent); }
void Extents::append(Extents const &inner) noexcept {
  parts_->extents.insert(parts_->extents.end(), inner.parts_->extents.begin(), inner.parts_->extents.end());
}
std::size_t const *Extents::data() const noexcept { return parts_->extents.data(); }
std::size_t Extents::size() const noexcept { return parts_->extents.size(); }

void Extents::add_variable(ScalarObject variable) noexcept { parts_->variables.push_back(variable); }
ScalarObject const *Extents::begin_variables() const noexcept { return parts_->variables.data(); }
ScalarObject const *Extents::end_variables() const noexcept { return begin_variables() + parts_->variables.size(); }

void Extents::each(void *context, void (*visit)(void *context, std::size_t const *index)) const {
  std::vector<std::size_t> const &shape = parts_->extents;
  std::vector<std::size_t> index(shape.size(), 0);
  std::size_t count = 1;
  for (std::size_t extent : shape) count *= extent;
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t rest = k;
    for (std::size_t dimension = shape.size(); dimension-- > 0; rest /= shape[dimension])
      index[dimension] = rest % shape[dimension];
    visit(context, index.data());
  }
}

namespace trace {

namespace {

// The text is parsed again for each object: it is short, and lists the parts in the order of the visits.
class Layout {
public:
  Layout(detail::VisitElements const *containers, LayoutVisitor &visitor)
      : containers_(containers),
        visitor_(visitor) {}

  // Both return where the shape ends.
  char const *visit(char const *text, char const volatile *object, std::vector<std::size_t> *extents) {
    switch (*text) {
    case '[': return visit_array(text, object, extents);
    case 'd': visitor_.number(object); return text + 1;
    case 'i': return visit_scalar(text, object, ScalarObject::Kind::integer);
    case 'u': return visit_scalar(text, object, ScalarObject::Kind::natural);
    case 'f': return visit_scalar(text, object, ScalarObject::Kind::floating);
    case 'p': return visit_scalar(text, object, ScalarObject::Kind::pointer);
    case 't': return visit_scalar(text, object, ScalarObject::Kind::target);
    case 'o': return visit_scalar(text, object, ScalarObject::Kind::object);
    case '{': return visit_members(text + 1, object);
    case '@': return visit_container(text + 1, object, extents);
    }
    internal_failure("a layout is well-formed", __FILE__, __LINE__);
  }

  static char const *measure(char const *text, std::size_t &size) {
    std::size_t count = 0;
    switch (*text) {
    case '[': {
      char const *end = measure(number(text + 1, count) + 1, size);
      size *= count;
      return end;
    }
    case 'd': size = sizeof(double); return text + 1;
    case '{':
      for (++text; *text != '}'; ++text) text = measure(number(std::strchr(text, '+') + 1, count) + 1, size);
      return number(text + 1, size);
    case '@': {
      std::size_t element = 0;
      return measure(number(number(text + 1, count) + 1, size) + 1, element);
    }
    default: return number(text + 1, size);
    }
  }

private:
  char const *visit_scalar(char const *text, char const volatile *object, ScalarObject::Kind kind) {
    std::size_t bytes = 0;
    char const *end = number(text + 1, bytes);
    visitor_.scalar({const_cast<char const *>(object), static_cast<unsigned char>(bytes), kind});
    return end;
  }

  static char const *number(char const *text, std::size_t &value) {
    char *end = nullptr;
    value = std::strtoul(text, &end, 10);
    return end;
  }

  char const *visit_array(char const *text, char const volatile *object, std::vector<std::size_t> *extents) {
    std::size_t count = 0, size = 0;
    char const *element = number(text + 1, count) + 1;
    char const *end = measure(element, size);
    if (extents) extents->push_back(count);
    for (std::size_t k = 0; k < count; ++k) visit(element, object + k * size, k == 0 ? extents : nullptr);
    return end;
  }

  char const *visit_members(char const *text, char const volatile *object) {
    visitor_.begin_members();
    for (; *text != '}'; ++text) { // behind the `;`
      char const *plus = std::strchr(text, '+');
      visitor_.begin_member({text, plus});
      std::size_t offset = 0;
      char const *shape = number(plus + 1, offset) + 1;
      std::vector<std::size_t> extents;
      text = visit(shape, object + offset, &extents);
      visitor_.end_member(extents);
    }
    visitor_.end_members();
    std::size_t size = 0;
    return number(text + 1, size);
  }

  char const *visit_container(char const *text, char const volatile *object, std::vector<std::size_t> *extents) {
    std::size_t index = 0, size = 0;
    text = number(number(text, index) + 1, size) + 1;
    visitor_.container(object, size);
    struct Each {
      Layout &layout;
      char const *shape;
      std::vector<std::size_t> inner, *wanted;
    } each{*this, text, {}, nullptr};
    each.wanted = extents ? &each.inner : nullptr;
    std::size_t own[2] = {0, 0};
    std::size_t const rank = containers_[index](
        object,
        [](void *context, void const volatile *element) {
          Each &here = *static_cast<Each *>(context);
          here.layout.visit(here.shape, static_cast<char const volatile *>(element), here.wanted);
          here.wanted = nullptr; // the first has the shape of all
        },
        &each, own);
    if (extents) {
      extents->insert(extents->end(), own, own + rank);
      extents->insert(extents->end(), each.inner.begin(), each.inner.end());
    }
    return measure(text, size);
  }

  detail::VisitElements const *containers_;
  LayoutVisitor &visitor_;
};

// Visitor of symbolic and replay programs.
class ToSink final : public LayoutVisitor {
public:
  ToSink(Sink &sink, bool is_temporary) : sink_(sink), is_temporary_(is_temporary) {}
  void number(void const volatile *address) override { sink_.element(const_cast<void *>(address), is_temporary_); }
  void scalar(ScalarObject scalar) override { sink_.scalar(scalar); }
  void container(void const volatile *object, std::size_t size) override {
    sink_.holder(const_cast<void const *>(object), size);
  }
  void begin_members() override { sink_.begin_members(); }
  void begin_member(std::string const &name) override { sink_.begin_member(name); }
  void end_member(std::vector<std::size_t> const &extents) override { sink_.end_member(extents); }
  void end_members() override { sink_.end_members(); }

private:
  Sink &sink_;
  bool is_temporary_;
};

} // namespace

void visit_layout(void const volatile *object, char const *layout, detail::VisitElements const *containers,
                  LayoutVisitor &visitor, std::vector<std::size_t> *extents) {
  Layout(containers, visitor).visit(layout, static_cast<char const volatile *>(object), extents);
}

} // namespace trace

void detail::walk_layout(void const volatile *object, char const *layout, VisitElements const *containers,
                         bool is_temporary, Extents *extents) noexcept {
  trace::Pause const pause; // how a container finds its elements is not the kernel's doing
  trace::ToSink visitor(trace::session().kernel.sink(), is_temporary);
  std::vector<std::size_t> found;
  trace::visit_layout(object, layout, containers, visitor, extents ? &found : nullptr);
  if (extents)
    for (std::size_t extent : found) extents->push_back(extent);
}

} // namespace symreal
