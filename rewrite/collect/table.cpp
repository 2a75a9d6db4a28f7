#include "rewrite/collect/handlers.h"

namespace symreal::rewrite {

SyntaxTable::SyntaxTable(Collection all) : all_(std::move(all)) {
  Views &views = add_views(*this);
  add_types(*this);
  add_bytes(*this, views);
  add_unions(*this, views);
  add_library_calls(*this);
  add_calls(*this);
  add_argument_lists(*this);
  add_truths(*this);
  add_literals(*this);
  add_names_of_functions(*this);
  add_conversions(*this);
  add_instantiated(*this);
  add_constants(*this);
  add_c(*this);
  add_c_types(*this);
  add_c_widths(*this);
  add_named_numbers(*this);
  add_text(*this);
  add_state_of_calls(*this);
  add_state(*this);
}

SyntaxTable::~SyntaxTable() = default;

void SyntaxTable::finish() {
  all_.at = {};
  for (std::vector<Collection::Waiting> *waiting : {&all_.soon, &all_.later}) {
    for (std::size_t k = 0; k < waiting->size(); ++k) {
      all_.instance = (*waiting)[k].instance;
      std::function<void()> const action = std::move((*waiting)[k].action); // may put off others
      action();
    }
    waiting->clear();
  }
  all_.instance.reset();
  for (auto const &handler : handlers_) handler->finish();
}

} // namespace symreal::rewrite
