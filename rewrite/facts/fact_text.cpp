#include "rewrite/facts/members.h"

#include <algorithm>
#include <concepts>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace symreal::rewrite {
namespace {

using Json = nlohmann::ordered_json;

// The names of `#__VA_ARGS__`.
std::vector<std::string> names_of(std::string_view list) {
  std::vector<std::string> names;
  while (!list.empty()) {
    std::size_t const comma = std::min(list.find(','), list.size());
    names.emplace_back(list.substr(0, comma));
    list.remove_prefix(std::min(list.find_first_not_of(", ", comma), list.size()));
  }
  return names;
}

class WriteText {
public:
  template <class T> static Json of(T &object) {
    WriteText write;
    visit(write, object);
    return std::move(write.json_);
  }

  template <class... T> void members(char const *list, T &...values) {
    std::vector<std::string> const names = names_of(list);
    std::size_t at = 0;
    (member(names[at++], values), ...);
  }

private:
  template <class T> void member(std::string const &name, T &object) {
    static T const made{};
    Json const json = value(object), as_made = value(const_cast<T &>(made));
    if (json != as_made) json_[name] = json;
  }

  static Json value(Use &use) { return std::string(info(use).name); }
  static Json value(Clause &clause) { return name_of(clause); }
  static Json value(std::string &text) { return text; }
  template <class T> static Json value(T &object) {
    if constexpr (std::same_as<T, bool>)
      return object;
    else if constexpr (std::integral<T> || std::is_enum_v<T>)
      return static_cast<std::uint64_t>(object);
    else
      return of(object);
  }
  template <class T> static Json value(std::optional<T> &object) { return object ? value(*object) : Json(); }
  template <class A, class B> static Json value(std::pair<A, B> &pair) {
    return Json::array({value(pair.first), value(pair.second)});
  }
  template <class T> static Json value(std::vector<T> &all) { return elements(all); }
  template <class T> static Json value(std::set<T> &all) { return elements(all); }
  template <class K, class V> static Json value(std::map<K, V> &all) {
    Json list = Json::array();
    for (auto &[key, mapped] : all) list.push_back(Json::array({value(const_cast<K &>(key)), value(mapped)}));
    return list;
  }
  static Json value(std::vector<bool> &bits) {
    Json runs = Json::array();
    bool holds = false;
    for (std::size_t at = 0; at < bits.size(); holds = !holds) {
      std::size_t run = 0;
      while (at + run < bits.size() && bits[at + run] == holds) ++run;
      runs.push_back(run);
      at += run;
    }
    return runs;
  }
  template <class All> static Json elements(All &all) {
    Json list = Json::array();
    for (auto &one : all) list.push_back(value(const_cast<std::remove_cvref_t<decltype(one)> &>(one)));
    return list;
  }

  Json json_ = Json::object();
};

// Errors of the library carry their reason and place (json.exception.*).
class ReadText {
public:
  explicit ReadText(Json const &json) : json_(json) {}

  template <class... T> void members(char const *list, T &...values) {
    std::vector<std::string> const names = names_of(list);
    for (auto const &[name, ignored] : json_.items())
      if (std::find(names.begin(), names.end(), name) == names.end())
        throw std::invalid_argument("no fact has a member '" + name + "' here; there are: " + list);
    std::size_t at = 0;
    (member(names[at++], values), ...);
  }

private:
  template <class T> void member(std::string const &name, T &object) {
    if (auto const found = json_.find(name); found != json_.end()) value(*found, object);
  }

  static void value(Json const &json, Use &use) {
    std::optional<Use> const found = find_use(json.get<std::string>());
    if (!found) throw std::invalid_argument("no use is called " + json.dump());
    use = *found;
  }
  static void value(Json const &json, Clause &clause) {
    std::optional<Clause> const found = find_clause(json.get<std::string>());
    if (!found) throw std::invalid_argument("no clause is called " + json.dump());
    clause = *found;
  }
  static void value(Json const &json, std::string &text) { text = json.get<std::string>(); }
  template <class T> static void value(Json const &json, T &object) {
    if constexpr (std::integral<T>)
      object = json.get<T>();
    else if constexpr (std::is_enum_v<T>)
      object = static_cast<T>(json.get<std::uint64_t>());
    else {
      ReadText read(json);
      visit(read, object);
    }
  }
  template <class T> static void value(Json const &json, std::optional<T> &object) {
    if (!json.is_null()) value(json, object.emplace());
  }
  template <class A, class B> static void value(Json const &json, std::pair<A, B> &pair) {
    value(json.at(0), pair.first);
    value(json.at(1), pair.second);
  }
  template <class T> static void value(Json const &json, std::vector<T> &all) {
    for (Json const &one : json) value(one, all.emplace_back());
  }
  template <class T> static void value(Json const &json, std::set<T> &all) {
    for (Json const &one : json) {
      T element{};
      value(one, element);
      all.insert(std::move(element));
    }
  }
  template <class K, class V> static void value(Json const &json, std::map<K, V> &all) {
    for (Json const &one : json) {
      std::pair<K, V> entry{};
      value(one, entry);
      all.insert(std::move(entry));
    }
  }
  static void value(Json const &json, std::vector<bool> &bits) {
    bool holds = false;
    for (Json const &run : json) {
      bits.insert(bits.end(), run.get<std::size_t>(), holds);
      holds = !holds;
    }
  }

  Json const &json_;
};

} // namespace

std::string to_text(Facts facts) {
  return WriteText::of(facts).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Facts facts_of_text(std::string const &text) {
  try {
    Json const json = Json::parse(text, nullptr, /*allow_exceptions=*/true, /*ignore_comments=*/true);
    Facts facts;
    ReadText read(json);
    visit(read, facts);
    return facts;
  } catch (Json::exception const &problem) {
    throw std::invalid_argument(problem.what());
  }
}

} // namespace symreal::rewrite
