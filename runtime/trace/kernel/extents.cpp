#include "symreal/extents.h"

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

} // namespace symreal
