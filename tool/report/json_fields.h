// Fields of a struct in JSON. One description names them, in order, and serves both directions:
//
//   template <class Fields> void describe(Fields &fields, Described<Fields, LeftState> &left) {
//     fields("name", left.name, "samples", left.samples);
//   }
#pragma once

#include "engine/support/number.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace symreal::tool {

// Numbers that JSON lacks are strings: "nan", "inf", "-inf".
inline nlohmann::ordered_json number_json(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(shortest(value));
}

inline double number_of(nlohmann::ordered_json const &json) {
  if (!json.is_string()) return json.get<double>();
  std::optional<double> const value = parse_number(json.get<std::string>());
  if (!value) throw std::invalid_argument("no number");
  return *value;
}

inline nlohmann::ordered_json numbers_json(std::vector<double> const &values) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (double value : values) json.push_back(number_json(value));
  return json;
}

inline std::vector<double> numbers_of(nlohmann::ordered_json const &json) {
  std::vector<double> values;
  for (nlohmann::ordered_json const &one : json) values.push_back(number_of(one));
  return values;
}

// The struct that a description visits.
template <class Fields, class T> using Described = std::conditional_t<Fields::reads, T, T const>;

class WrittenFields {
  using Json = nlohmann::ordered_json;

public:
  static constexpr bool reads = false;
  explicit WrittenFields(Json &json) : json_(json) {}

  template <class T, class... More> void operator()(char const *key, T const &field, More const &...more) {
    json_[key] = field;
    if constexpr (sizeof...(more) != 0) (*this)(more...);
  }
  void numbers(char const *key, double field) { json_[key] = number_json(field); }
  void numbers(char const *key, std::vector<double> const &field) { json_[key] = numbers_json(field); }
  // A field in another form.
  template <class T, class Write, class Read>
  void mapped(char const *key, T const &field, Write const &write, Read const &) {
    json_[key] = write(field);
  }
  // A field that is absent if it has its usual value.
  template <class T> void unless(T const &usual, char const *key, T const &field) {
    if (field != usual) json_[key] = field;
  }
  // A field that is always written, and keeps its value if it is absent.
  template <class T> void lenient(char const *key, T const &field) { json_[key] = field; }
  // A member that follows from fields, and is not read.
  template <class T> void derived(char const *key, T const &value) { json_[key] = value; }
  // Whether the fields that depend on this member follow.
  bool has(char const *, bool is_given) const { return is_given; }

  template <class Visit> void object(char const *key, Visit const &visit) {
    WrittenFields inner(json_[key] = Json::object());
    visit(inner);
  }
  // Elements, each with its number.
  template <class T, class Visit> void rows(char const *key, std::vector<T> const &all, Visit const &visit) {
    Json &rows = json_[key] = Json::array();
    for (std::size_t k = 0; k < all.size(); ++k) {
      WrittenFields row(rows.emplace_back(Json::object()));
      visit(row, all[k], k);
    }
  }
  // The elements that are kept; `visit` describes the number as well.
  template <class T, class Keep, class Visit>
  void sparse(char const *key, std::vector<T> const &all, Keep const &keep, Visit const &visit) {
    Json &rows = json_[key] = Json::array();
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (!keep(all[k])) continue;
      WrittenFields row(rows.emplace_back(Json::object()));
      std::size_t number = k;
      visit(row, [&]() -> T const & { return all[k]; }, number);
    }
  }

private:
  Json &json_;
};

// Throws what nlohmann::json throws for a member that is missing or of another type, std::invalid_argument for others.
class ReadFields {
  using Json = nlohmann::ordered_json;

public:
  static constexpr bool reads = true;
  explicit ReadFields(Json const &json) : json_(json) {}

  template <class T, class... More> void operator()(char const *key, T &field, More &&...more) {
    json_.at(key).get_to(field);
    if constexpr (sizeof...(more) != 0) (*this)(more...);
  }
  void numbers(char const *key, double &field) { field = number_of(json_.at(key)); }
  void numbers(char const *key, std::vector<double> &field) { field = numbers_of(json_.at(key)); }
  template <class T, class Write, class Read> void mapped(char const *key, T &field, Write const &, Read const &read) {
    field = read(json_.at(key));
  }
  template <class T> void unless(T const &, char const *key, T &field) { lenient(key, field); }
  template <class T> void lenient(char const *key, T &field) {
    if (json_.contains(key)) json_[key].get_to(field);
  }
  template <class T> void derived(char const *, T const &) {}
  bool has(char const *key, bool) const { return json_.contains(key); }

  template <class Visit> void object(char const *key, Visit const &visit) {
    ReadFields inner(json_.at(key));
    visit(inner);
  }
  template <class T, class Visit> void rows(char const *key, std::vector<T> &all, Visit const &visit) {
    for (Json const &one : json_.at(key)) {
      ReadFields row(one);
      visit(row, all.emplace_back(), all.size() - 1);
    }
  }
  template <class T, class Keep, class Visit>
  void sparse(char const *key, std::vector<T> &all, Keep const &, Visit const &visit) {
    for (Json const &one : json_.at(key)) {
      ReadFields row(one);
      std::size_t number = 0;
      visit(row, [&]() -> T & { return all.at(number); }, number);
    }
  }

private:
  Json const &json_;
};

// Rows whose elements are described.
template <class Fields, class All> void described_rows(Fields &fields, char const *key, All &all) {
  fields.rows(key, all, [](auto &row, auto &one, std::size_t) { describe(row, one); });
}

} // namespace symreal::tool
