#include "engine/emit/print/angles.h"

#include "engine/emit/print/module.h"

#include <fmt/format.h>

namespace symreal {

namespace {

class AnglesPrinter {
public:
  AnglesPrinter(Emission const &emission, CodeText &out)
      : angles_(emission.plan.angles),
        language_(emission.language),
        syntax_(emission.language.angles),
        input_(name_of(Array::input)),
        function_(angles_function(emission)),
        out_(out) {}

  void print() {
    for (Array const array : {Array::sine, Array::cosine}) declare(std::string(name_of(array)), angles_.size());
    if (std::size_t const count = angles_.inputs.size(); count != 0) call(count, inputs(), 0);
    if (std::size_t const count = angles_.computed.results.size(); count != 0) {
      declare(computed_angles, count);
      out_.statement(
          2, fill(language_, language_.functions.call,
                  {{"name", function_},
                   {"group", ""},
                   {"arguments", fmt::format("{}, {}, {}", input_, name_of(Array::constants), computed_angles)}}));
      call(count, computed_angles, angles_.inputs.size());
    }
  }

private:
  void declare(std::string const &array, std::size_t count) {
    out_.statement(2, fill(language_, language_.statements.array, {{"name", array}, {"count", std::to_string(count)}}));
  }

  std::string from(std::string const &array, std::size_t first) const {
    if (first == 0) return array;
    return fill(language_, syntax_.from, {{"array", array}, {"first", std::to_string(first)}});
  }

  void call(std::size_t count, std::string const &angles, std::size_t first) {
    out_.statement(2, fill(language_, syntax_.call,
                           {{"count", std::to_string(count)},
                            {"angles", angles},
                            {"sine", from(std::string(name_of(Array::sine)), first)},
                            {"cosine", from(std::string(name_of(Array::cosine)), first)}}));
  }

  // A subarray of `input` if the angles are contiguous, else a local array of them.
  std::string inputs() {
    std::vector<std::uint32_t> const &slots = angles_.inputs;
    if (slots.back() - slots.front() + 1 == slots.size()) return from(input_, slots.front());
    std::vector<std::string> elements;
    for (std::uint32_t const slot : slots) elements.push_back(element(language_, input_, slot));
    out_.lines("  " + fill(language_, syntax_.begin, {{"name", "angle"}, {"count", std::to_string(slots.size())}}) +
               lines_of(language_, elements) + std::string(syntax_.end) + "\n");
    return "angle";
  }

  Angles const &angles_;
  Language const &language_;
  AnglesSyntax const &syntax_;
  std::string input_, function_;
  CodeText &out_;
};

} // namespace

std::string angles_function(Emission const &emission) { return emission.name("compute_angles"); }

void print_angles(Emission const &emission, CodeText &out) {
  if (emission.plan.angles.size() != 0) AnglesPrinter(emission, out).print();
}

} // namespace symreal
