#include "engine/analysis/costs/measuring.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

namespace symreal {

namespace {

constexpr std::string_view head = R"(#define _POSIX_C_SOURCE 199309L
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

)";

constexpr std::string_view integer_functions =
#define INTEGER_FUNCTION(type, name, parameters, ...)                                                                  \
  "static inline " #type " " #name #parameters " { " #__VA_ARGS__ " }\n"
#include <symreal/integer_functions.def>
#undef INTEGER_FUNCTION
    ;

// Parallel chains x[0] .. x[chains - 1]; y and w are the other operands.
constexpr int chains = 8;

constexpr std::string_view tail = R"(
static double nanoseconds(void (*run)(double, double, double, double, int), double s, double w, int links) {
  struct timespec begin, end;
  clock_gettime(CLOCK_MONOTONIC, &begin);
  run(s, s * 0.75, w, 0.0, links);
  clock_gettime(CLOCK_MONOTONIC, &end);
  return (double)(end.tv_sec - begin.tv_sec) * 1e9 + (double)(end.tv_nsec - begin.tv_nsec);
}
static int ascending(void const *a, void const *b) {
  double const x = *(double const *)a, y = *(double const *)b;
  return (x > y) - (x < y);
}
int main(int count, char **words) {
  enum { rows = sizeof table / sizeof *table, links = 4000 };
  int const rounds = count > 1 ? atoi(words[1]) : 1;
  double *const time = malloc(sizeof(double) * 2 * rows * (size_t)rounds);
  if (rounds < 1 || !time) return 1;
  for (int round = 0; round < rounds; ++round)
    for (int row = 0; row < rows; ++row) {
      time[(2 * row) * rounds + round] = nanoseconds(table[row].one, table[row].sample, 3.0, links) / links;
      time[(2 * row + 1) * rounds + round] = nanoseconds(table[row].many, table[row].sample, 3.0, links) / links / CHAINS;
    }
  for (int row = 0; row < rows; ++row) {
    for (int which = 0; which < 2; ++which) qsort(time + (2 * row + which) * rounds, (size_t)rounds, sizeof *time, ascending);
    printf("%s %.4f %.4f\n", table[row].name, time[2 * row * rounds + rounds / 2], time[(2 * row + 1) * rounds + rounds / 2]);
  }
  return 0;
}
)";

double sample(Domain domain) {
  switch (domain) {
  case Domain::unit: return 0.4;
  case Domain::above_one: return 1.7;
  case Domain::integer: return 5;
  case Domain::any:
  case Domain::positive: break;
  }
  return 0.7;
}

// C expression of the operation; nullopt if it exists only in graphs.
std::optional<std::string> spelled(OperationInfo const &row, std::array<std::string, 3> const &operand) {
  std::string list = operand[0];
  for (unsigned k = 1; k < row.arity; ++k) list += ", " + operand[k];
  switch (row.form) {
  case Form::infix: return fmt::format("({} {} {})", operand[0], row.c, operand[1]);
  case Form::prefix:
  case Form::cast: return fmt::format("({}({}))", row.c, operand[0]);
  case Form::call:
  case Form::local: return fmt::format("{}({})", row.c, list);
  case Form::select: return fmt::format("({} ? {} : {})", operand[0], operand[1], operand[2]);
  case Form::external: break;
  }
  return {};
}

// C expression from x to a number, through 64-bit integers if the operation takes or returns them.
std::optional<std::string> link(OperationInfo const &row, std::string const &x) {
  std::array<std::string, 3> operand = {x, "y", "w"};
  for (std::size_t k = 0; k < row.arity; ++k)
    if (takes_wide(row.op, k)) operand[k] = k == 0 ? "wide_int(" + x + ")" : fmt::format("({}u)", 2 * k + 1);
  if (row.form == Form::select) operand[0] = "(" + x + " != 0.0)";
  // The dependent arm is the one taken.
  if (row.form == Form::select) operand[1] = takes_wide(row.op, 1) ? "wide_int(" + x + ")" : x;
  std::optional<std::string> const text = spelled(row, operand);
  if (!text) return {};
  return row.has(flag::WIDE) ? "(double)(int64_t)" + *text : "(double)" + *text;
}

std::string function(std::string const &name, int count, std::string_view link_of_x) {
  auto const at = [&](int k) {
    std::string text;
    for (char const c : link_of_x) text += c == '$' ? fmt::format("x{}", k) : std::string(1, c);
    return text;
  };
  std::string text = fmt::format("static void {}(double s, double y, double w, double z, int links) {{\n", name);
  for (int k = 0; k < count; ++k) text += fmt::format("  double x{} = s;\n", k);
  text += "  for (int i = 0; i < links; ++i) {\n";
  for (int k = 0; k < count; ++k) text += fmt::format("    x{} = s + z * {};\n", k, at(k));
  text += "  }\n  sink = 0.0";
  for (int k = 0; k < count; ++k) text += fmt::format(" + x{}", k);
  return text + ";\n  (void)y;\n  (void)w;\n}\n";
}

struct MeasuredLink {
  std::string name, link;
  double sample;
};

// Rows of the program; the links that are subtracted come first.
std::vector<MeasuredLink> measured() {
  std::vector<MeasuredLink> rows = {{"-", "$", 0.7}, {"-wide", "(double)(int64_t)wide_int($)", 5}};
  for (OperationInfo const &row : operations())
    if (auto text = link(row, "$")) rows.push_back({std::string(row.name), *text, sample(row.domain)});
  return rows;
}

struct Times {
  double latency, throughput;
};

// Times of an operation without those of its link, at least a tenth of a nanosecond, the limit of the measurement.
Times without(Times const &all, Times const &link) {
  auto const less = [](double a, double b) { return std::round(std::max(a - b, 0.1) * 100) / 100; };
  return {less(all.latency, link.latency), less(all.throughput, link.throughput)};
}

// Whether the operation maps 64-bit integers to one, so that its link converts both ways.
bool is_wide_link(OperationInfo const &row) { return row.has(flag::WIDE) && row.has(flag::TAKES_WIDE); }

Times scaled(Times const &times, int factor) { return {times.latency * factor, times.throughput * factor}; }

} // namespace

std::string measuring_program() {
  std::string text = std::string(head) + std::string(integer_functions) +
                     fmt::format("enum {{ CHAINS = {} }};\nstatic volatile double sink;\n", chains);
  std::string table = "static struct { char const *name; void (*one)(double, double, double, double, int), "
                      "(*many)(double, double, double, double, int); double sample; } const table[] = {\n";
  std::size_t number = 0;
  for (MeasuredLink const &row : measured()) {
    text += function(fmt::format("one_{}", number), 1, row.link);
    text += function(fmt::format("many_{}", number), chains, row.link);
    table += fmt::format("  {{\"{}\", one_{}, many_{}, {}}},\n", row.name, number, number, row.sample);
    ++number;
  }
  return text + table + "};\n" + std::string(tail);
}

std::string cost_file_text(std::string_view output, std::string const &compiler,
                           std::optional<ThreadCosts> const &threads) {
  std::map<std::string, Times> times;
  std::istringstream lines{std::string(output)};
  for (auto [name, one] = std::pair(std::string(), Times{}); lines >> name >> one.latency >> one.throughput;)
    times[name] = one;
  if (!times.contains("-") || !times.contains("-wide") || !times.contains("add")) return {};
  Times const addition = without(times["add"], times["-"]);
  nlohmann::ordered_json json = {{"symreal-costs", 1}, {"compiler", compiler}, {"flags", measuring_flags}};
  nlohmann::ordered_json estimated = nlohmann::ordered_json::array();
  for (OperationInfo const &row : operations()) {
    std::string const name(row.name);
    bool const is_measured = times.contains(name);
    Times const cost = row.cost == 0 ? Times{0, 0}
                       : is_measured ? without(times[name], times[is_wide_link(row) ? "-wide" : "-"])
                                     : scaled(addition, row.cost);
    json["nanoseconds"][name] = {{"latency", cost.latency}, {"throughput", cost.throughput}};
    if (!is_measured && row.cost != 0) estimated.push_back(name);
  }
  json["estimated"] = estimated;
  if (threads) json["threads"] = to_json(*threads);
  return json.dump(2) + "\n";
}

} // namespace symreal
