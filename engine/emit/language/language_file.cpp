#include "engine/emit/language/language_file.h"

#include "engine/emit/language/fields.h"
#include "engine/emit/language/toml.h"
#include "engine/ops/operation.h"
#include "engine/support/text.h"

#include <algorithm>
#include <concepts>
#include <fmt/format.h>
#include <set>

namespace symreal {

namespace {

// Owner of what a language refers to.
class Storage {
public:
  std::string_view keep(std::string text) { return *keep_shared(std::move(text)); }
  template <class T> std::span<T const> keep(std::vector<T> all) { return *keep_shared(std::move(all)); }
  void keep(std::shared_ptr<void const> other) { kept_.push_back(std::move(other)); }

private:
  template <class T> std::shared_ptr<T const> keep_shared(T value) {
    auto kept = std::make_shared<T const>(std::move(value));
    kept_.emplace_back(kept);
    return kept;
  }
  std::vector<std::shared_ptr<void const>> kept_;
};

std::vector<std::string_view> words_in(std::string_view text) {
  std::vector<std::string_view> words;
  while (!(text = trimmed(text)).empty()) {
    words.push_back(text.substr(0, text.find(' ')));
    text.remove_prefix(words.back().size());
  }
  return words;
}

// The text between two marks of a file of texts.
struct MarkedText {
  std::string_view kind, name; // "helper", "erf"
  std::string text;
  unsigned line;
};

std::vector<MarkedText> marked_texts(std::string_view text, CommentSyntax const &comment) {
  std::vector<MarkedText> texts;
  std::string const open = std::string(comment.open) + '@';
  for (unsigned number = 1; !text.empty(); ++number) {
    std::string_view const line = text.substr(0, std::min(text.find('\n'), text.size() - 1) + 1);
    text.remove_prefix(line.size());
    if (line.starts_with(open)) {
      std::string_view mark = trimmed(line).substr(open.size());
      if (mark.ends_with(comment.close)) mark.remove_suffix(comment.close.size());
      if (!texts.empty() && texts.back().text.ends_with("\n\n")) texts.back().text.pop_back();
      std::size_t const end = std::min(mark.find(' '), mark.size());
      texts.push_back({mark.substr(0, end), trimmed(mark.substr(end)), {}, number});
    } else if (!texts.empty()) {
      texts.back().text += line;
    }
  }
  return texts;
}

class Reader {
public:
  explicit Reader(std::span<NamedCode const> code) : code_(code), storage_(std::make_shared<Storage>()) {}

  Language read(LanguageFile const &table, LanguageFile const &texts, FindLanguage find_language) {
    for (TomlEntry &entry : read_toml(table.name, table.text)) entries_.push_back({std::move(entry)});
    if (Entry *const like = find("like")) {
      std::string const name = get<std::string>(*like);
      if (name + ".toml" == table.name) fault(*like, "a language cannot be like itself");
      Language const *const start = find_language ? find_language(name) : nullptr;
      if (!start) fault(*like, "there is no such language");
      language_ = *start;
      storage_->keep(start->storage);
    }
    language_.storage = storage_;
    read_fields(language_.comment, "comment."); // the marks of the texts are comments
    add_texts(texts);
    read_fields(language_, "");
    for (Entry const &entry : entries_)
      if (!entry.is_read) fault(entry, fmt::format("there is no key '{}'", entry.path));
    return language_;
  }

private:
  struct Entry : TomlEntry {
    bool is_read = false;
  };
  using List = TomlValue::List;

  [[noreturn]] static void fault(TomlEntry const &entry, std::string const &what) {
    table_fault(entry.file, entry.line, what);
  }

  void add_texts(LanguageFile const &file) {
    std::vector<Helper> helpers;
    auto const add = [&](std::string_view name, std::string text, bool declares) {
      helpers.push_back({storage_->keep(std::string(name)), storage_->keep(std::move(text)), declares});
    };
    for (MarkedText &marked : marked_texts(file.text, language_.comment)) {
      bool const declares = marked.kind.starts_with("declaration");
      if (marked.kind == "text") {
        std::string const path(marked.name);
        if (find(path)) table_fault(file.name, marked.line, fmt::format("'{}' is given twice", path));
        entries_.push_back({{path, {std::move(marked.text)}, file.name, marked.line}});
      } else if (marked.kind == "helper" || marked.kind == "declaration") {
        add(marked.name, std::move(marked.text), declares);
      } else if (marked.kind == "helpers" || marked.kind == "declarations") {
        for (std::string_view rest = marked.text; !rest.empty();) {
          std::string_view const line = rest.substr(0, std::min(rest.find('\n'), rest.size() - 1) + 1);
          add(line.substr(0, line.find_first_of(" ([\n")), std::string(line), declares);
          rest.remove_prefix(line.size());
        }
      } else if (marked.kind == "like") {
        add_like(helpers, marked, file.name);
      } else {
        table_fault(file.name, marked.line, fmt::format("there is no mark @{}", marked.kind));
      }
    }
    if (!helpers.empty()) language_.files.helpers = storage_->keep(std::move(helpers));
  }

  // "c_sin c_cos c_tan": helpers of the text of the first, with another name of the library.
  void add_like(std::vector<Helper> &helpers, MarkedText const &marked, std::string_view file) {
    std::vector<std::string_view> const names = words_in(marked.name);
    auto const model = std::ranges::find(helpers, names.empty() ? "" : names[0], &Helper::name);
    if (model == helpers.end()) table_fault(file, marked.line, "@like names no helper above it");
    Helper const helper = *model;
    auto const stem = [](std::string_view name) { return name.substr(name.find('_') + 1); };
    std::string_view const from = stem(helper.name);
    for (std::string_view const name : std::span(names).subspan(1)) {
      std::string text(helper.text);
      std::string_view const to = stem(name);
      for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
        text.replace(at, from.size(), to);
      helpers.push_back({storage_->keep(std::string(name)), storage_->keep(std::move(text)), helper.declares});
    }
  }

  template <class Fields> void read_fields(Fields &fields, std::string const &path) {
    each_field(fields, [&](std::string_view key, auto &field, std::optional<std::string_view> places) {
      std::string const whole = path + std::string(key);
      if constexpr (requires { each_field(field, [](auto &&...) {}); })
        read_fields(field, whole + ".");
      else if constexpr (std::is_same_v<decltype(field), std::string_view &>)
        read_text(field, whole, places);
      else
        read_field(field, whole);
    });
  }

  void read_text(std::string_view &field, std::string const &path, std::optional<std::string_view> places) {
    Entry *const entry = find(path);
    if (!entry) return;
    field = places ? pattern(*entry, entry->value, *places) : storage_->keep(get<std::string>(*entry));
  }
  template <std::integral T> void read_field(T &field, std::string const &path) {
    using Read = std::conditional_t<std::is_same_v<T, bool>, bool, std::int64_t>;
    if (Entry *const entry = find(path)) field = static_cast<T>(get<Read>(*entry));
  }
  template <class Result, class Argument> void read_field(Result (*&field)(Argument), std::string const &path) {
    Entry *const entry = find(path);
    if (!entry) return;
    auto const found = std::ranges::find(code_, get<std::string>(*entry), &NamedCode::name);
    auto const *const code = found == code_.end() ? nullptr : std::get_if<Result (*)(Argument)>(&found->code);
    if (!code) fault(*entry, fmt::format("there is no function '{}' for '{}'", get<std::string>(*entry), path));
    field = *code;
  }
  // Keywords, in the order in which they are searched; "c": those of C and C++.
  void read_field(std::span<std::string_view const> &field, std::string const &path) {
    Entry *const entry = find(path);
    if (!entry) return;
    if (auto const *const text = std::get_if<std::string>(&entry->value.value); text && *text == "c") {
      field = c_names.keywords;
      return;
    }
    std::vector<std::string_view> words;
    for (TomlValue const &word : get<List>(*entry)) words.push_back(storage_->keep(get<std::string>(*entry, word)));
    std::ranges::sort(words);
    field = storage_->keep(std::move(words));
  }
  void read_field(std::span<Op const> &field, std::string const &path) {
    Entry *const entry = find(path);
    if (!entry) return;
    std::vector<Op> ops;
    for (TomlValue const &name : get<List>(*entry)) ops.push_back(op(*entry, get<std::string>(*entry, name)));
    field = storage_->keep(std::move(ops));
  }
  void read_field(std::span<OperationSpelling const> &field, std::string const &path) {
    read_rows(field, path, [&](Entry const &entry, std::string_view name) {
      List const row = list(entry, 2);
      return OperationSpelling{op(entry, name), pattern(entry, row[0], "x y z"),
                               row.size() < 2 ? 0 : static_cast<int>(get<std::int64_t>(entry, row[1]))};
    });
  }
  void read_field(std::span<Word const> &field, std::string const &path) {
    read_rows(field, path, [&](Entry const &entry, std::string_view name) {
      List const row = list(entry, 2);
      return Word{storage_->keep(std::string(name)), text(entry, row, 0), text(entry, row, 1)};
    });
  }
  void read_field(std::span<BridgeInteger const> &field, std::string const &path) {
    read_rows(field, path, [&](Entry const &entry, std::string_view name) {
      List const row = list(entry, 3);
      return BridgeInteger{storage_->keep(std::string(name)), text(entry, row, 0), text(entry, row, 1),
                           text(entry, row, 2)};
    });
  }
  void read_field(std::span<Companion const> &field, std::string const &path) {
    std::vector<Companion> companions;
    for (Entry const &entry : entries_) {
      if (entry.is_read || !entry.path.starts_with(path + ".")) continue;
      std::string const option = entry.path.substr(path.size() + 1, entry.path.rfind('.') - path.size() - 1);
      read_fields(companions.emplace_back(), path + "." + option + ".");
      if (option != "always") companions.back().option = storage_->keep(option);
    }
    if (!companions.empty()) field = storage_->keep(std::move(companions));
  }
  void read_field(std::span<Helper const> &, std::string const &) {} // add_texts does

  // The entries of a table whose keys are not fields.
  template <class Row, class Read>
  void read_rows(std::span<Row const> &field, std::string const &path, Read const &read) {
    std::vector<Row> rows;
    for (Entry &entry : entries_) {
      if (!entry.path.starts_with(path + ".")) continue;
      entry.is_read = true;
      rows.push_back(read(entry, std::string_view(entry.path).substr(path.size() + 1)));
    }
    if (!rows.empty()) field = storage_->keep(std::move(rows));
  }

  Entry *find(std::string const &path) {
    auto const found = std::ranges::find(entries_, path, &Entry::path);
    if (found == entries_.end()) return nullptr;
    found->is_read = true;
    return &*found;
  }

  template <class T> static T const &get(TomlEntry const &entry, TomlValue const &value) {
    T const *const found = std::get_if<T>(&value.value);
    constexpr std::string_view what = std::is_same_v<T, std::string>    ? "a text"
                                      : std::is_same_v<T, bool>         ? "true or false"
                                      : std::is_same_v<T, std::int64_t> ? "a number"
                                                                        : "a list";
    if (!found) fault(entry, fmt::format("'{}' takes {}", entry.path, what));
    return *found;
  }
  template <class T> static T const &get(TomlEntry const &entry) { return get<T>(entry, entry.value); }

  // A row of up to `most` values; a text is a row of itself.
  static List list(TomlEntry const &entry, std::size_t most) {
    List const *const row = std::get_if<List>(&entry.value.value);
    if (!row) return {entry.value};
    if (row->empty() || row->size() > most) fault(entry, fmt::format("'{}' takes up to {} values", entry.path, most));
    return *row;
  }
  std::string_view text(TomlEntry const &entry, List const &row, std::size_t k) {
    return k < row.size() ? storage_->keep(get<std::string>(entry, row[k])) : std::string_view();
  }
  std::string_view pattern(TomlEntry const &entry, TomlValue const &value, std::string_view places) {
    std::string const &text = get<std::string>(entry, value);
    std::set<std::string, std::less<>> known;
    for (auto const &[word, text_of_word] : words_of(language_)) known.emplace(word);
    for (std::string_view const place : words_in(places))
      if (place.ends_with('*'))
        for (std::string const &name : in_three_cases(std::string(place.substr(0, place.size() - 1))))
          known.insert(name);
      else
        known.emplace(place);
    if (std::string_view const place = unknown_place(text, known); !place.empty())
      fault(entry, fmt::format("the pattern has no place {}: '{}'", place, entry.path));
    return storage_->keep(text);
  }
  static Op op(TomlEntry const &entry, std::string_view name) {
    std::optional<Op> const op = find_operation(name);
    if (!op) fault(entry, fmt::format("there is no operation '{}'", name));
    return *op;
  }

  std::span<NamedCode const> code_;
  Language language_;
  std::shared_ptr<Storage> storage_;
  std::vector<Entry> entries_;
};

} // namespace

Language read_language(LanguageFile const &table, LanguageFile const &texts, std::span<NamedCode const> code,
                       FindLanguage find_language) {
  return Reader(code).read(table, texts, find_language);
}

} // namespace symreal
