#include "tool/analysis/sweep_table.h"

#include "engine/analysis/growth/growth.h"
#include "engine/graph/statistics.h"
#include "engine/support/number.h"

#include <array>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <nlohmann/json.hpp>

namespace symreal::tool {

namespace {

using Json = nlohmann::ordered_json;

// Names of the figures, in the order of sweep_member.
constexpr std::array<std::string_view, 7> names = {"operations",  "arithmetic",    "work", "span",
                                                   "parallelism", "critical_path", "peak"};

std::vector<Point> points(std::vector<SweepMember> const &members, std::size_t figure) {
  std::vector<Point> result;
  for (SweepMember const &member : members)
    result.push_back({static_cast<double>(member.size), member.figures[figure]});
  return result;
}

std::string percent(double residual) { return fmt::format("{:.2g} %", 100 * residual); }

std::string described(Polynomial const &polynomial, SweepSizes const &sizes) {
  std::string const text = to_string(polynomial, sizes.name);
  if (!polynomial.is_exact) return fmt::format("{}, residual {}", text, percent(polynomial.residual));
  bool const is_all = polynomial.from <= static_cast<double>(sizes.values.front());
  return text + (is_all ? ", exactly" : fmt::format(", exactly from {} = {} on", sizes.name, polynomial.from));
}

std::string cell(double figure) {
  return figure == std::floor(figure) ? fmt::format("{:.0f}", figure) : fmt::format("{:.2f}", figure);
}

Json to_json(Power const &power) {
  return {{"factor", power.factor}, {"exponent", power.exponent}, {"residual", power.residual}};
}

Json to_json(Polynomial const &polynomial) {
  return {{"coefficients", polynomial.coefficient},
          {"from", polynomial.from},
          {"exact", polynomial.is_exact},
          {"residual", polynomial.residual}};
}

} // namespace

std::vector<std::string_view> figure_names() { return {names.begin(), names.end()}; }

SweepMember sweep_member(long size, Graph const &graph, Costs const &costs, Figures const &figures) {
  return {size,
          {static_cast<double>(figures.count), static_cast<double>(statistics(graph).compute.arithmetic()),
           costs.in_unit(figures.levels.work), costs.in_unit(figures.levels.span), figures.levels.parallelism(),
           static_cast<double>(figures.critical_path.size()), static_cast<double>(figures.levelled.peak)}};
}

void print_sweep(std::ostream &out, std::string const &kernel, SweepSizes const &sizes, Costs const &costs,
                 std::vector<SweepMember> const &members) {
  fmt::print(out, "kernel {}: costs: {}, times in {}\n{:>8}", kernel, costs.name, costs.time_unit, sizes.name);
  for (std::string_view name : names) fmt::print(out, "{:>15}", name);
  out << "\n";
  for (SweepMember const &member : members) {
    fmt::print(out, "{:>8}", member.size);
    for (double figure : member.figures) fmt::print(out, "{:>15}", cell(figure));
    out << "\n";
  }
  out << "growth\n";
  for (std::size_t figure = 0; figure < names.size(); ++figure) {
    std::vector<Point> const all = points(members, figure);
    auto const power = fit_power(all);
    auto const polynomial = fit_polynomial(all);
    std::string row = fmt::format("  {:<15}", names[figure]);
    if (power) row += fmt::format("{:<36}", to_string(*power, sizes.name) + ", residual " + percent(power->residual));
    if (polynomial) row += fmt::format("{}{}", power ? "  " : "", described(*polynomial, sizes));
    row.erase(row.find_last_not_of(' ') + 1);
    out << row << "\n";
  }
}

Json to_json(std::string const &kernel, SweepSizes const &sizes, Costs const &costs,
             std::vector<SweepMember> const &members) {
  Json json = {{"kernel", kernel}, {"costs", costs.name}, {"time_unit", costs.time_unit}, {"size", sizes.name}};
  for (SweepMember const &member : members) {
    Json row = {{"size", member.size}};
    for (std::size_t k = 0; k < names.size(); ++k) row[std::string(names[k])] = member.figures[k];
    json["members"].push_back(std::move(row));
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    Json growth = Json::object();
    if (auto const power = fit_power(points(members, k))) growth["power"] = to_json(*power);
    if (auto const polynomial = fit_polynomial(points(members, k))) growth["polynomial"] = to_json(*polynomial);
    json["growth"][std::string(names[k])] = std::move(growth);
  }
  return json;
}

std::string sweep_csv(SweepSizes const &sizes, std::vector<SweepMember> const &members) {
  std::string text = sizes.name;
  for (std::string_view name : names) text += "," + std::string(name);
  text += "\n";
  for (SweepMember const &member : members) {
    text += std::to_string(member.size);
    for (double figure : member.figures) text += "," + shortest(figure);
    text += "\n";
  }
  return text;
}

} // namespace symreal::tool
