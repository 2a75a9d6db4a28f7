#include "program/search_flags.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace symreal::program {

std::vector<std::string>
search_flags(std::vector<std::string> const &flags,
             std::function<std::optional<std::string>(std::string const &name)> const &counterpart,
             std::vector<std::string> &searched) {
  static constexpr std::string_view searching[] = {"-iquote", "-isystem", "-idirafter", "-I"};
  std::vector<std::string> words;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    std::string const &flag = flags[i];
    bool const has_operand = i + 1 < flags.size();
    auto const option = std::find_if(std::begin(searching), std::end(searching),
                                     [&](std::string_view one) { return flag.starts_with(one); });
    if ((flag == "-include" || flag == "-imacros") && has_operand) {
      words.insert(words.end(), {flag, counterpart(flags[i + 1]).value_or(flags[i + 1])});
      ++i;
    } else if (option == std::end(searching)) {
      words.push_back(flag);
    } else {
      bool const apart = flag == *option && has_operand;
      searched.push_back(apart ? flags[++i] : flag.substr(option->size()));
      if (auto const found = counterpart(searched.back())) words.insert(words.end(), {std::string(*option), *found});
      words.insert(words.end(), {std::string(*option), searched.back()});
    }
  }
  return words;
}

} // namespace symreal::program
