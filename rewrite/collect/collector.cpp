#include "rewrite/collect/collector.h"

namespace symreal::rewrite {

void Collector::finish() {
  for (std::size_t k = 0; k < waiting_.size(); ++k) {
    instance_ = waiting_[k].instance;
    std::function<void()> const handler = std::move(waiting_[k].handler); // may add others
    handler();
  }
  waiting_.clear();
  instance_.reset();
  uses_of_views();
}

} // namespace symreal::rewrite
