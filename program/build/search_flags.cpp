#include "program/build/search_flags.h"

#include "rewrite/request/driver_options.h"

namespace symreal::program {

std::vector<std::string>
search_flags(std::vector<std::string> const &flags,
             std::function<std::optional<std::string>(std::string const &name)> const &counterpart,
             std::vector<std::string> &searched) {
  std::vector<std::string> words;
  for (rewrite::DriverOption const &option : rewrite::driver_options(flags))
    if (option.about == rewrite::About::headers) {
      words.insert(words.end(), {option.name, counterpart(option.value).value_or(option.value)});
    } else if (option.about == rewrite::About::directories) {
      searched.push_back(option.value);
      if (auto const found = counterpart(option.value)) words.insert(words.end(), {option.name, *found});
      words.insert(words.end(), {option.name, option.value});
    } else
      rewrite::append(words, option, flags);
  return words;
}

} // namespace symreal::program
