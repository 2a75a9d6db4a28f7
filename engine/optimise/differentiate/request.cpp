#include "engine/optimise/differentiate/request.h"

#include "engine/graph/names.h"
#include "engine/support/text.h"

#include <algorithm>

namespace symreal {

namespace {

constexpr std::array<std::string_view, 5> kinds = {"jacobian", "gradient", "hessian", "jvp", "vjp"};

// Reports a bad request. An option has no location, so it takes `object`, the location of the faulty object.
[[noreturn]] void refuse(DerivativeWish const &wish, std::string const &why,
                         DiagnosticId id = DiagnosticId::bad_derivative, Place const &object = {}) {
  bool const is_option = wish.place.file.empty();
  fail(id, is_option ? object : wish.place,
       (is_option ? "--differentiate '" + wish.text + "'" : wish.text) + ": " + why);
}

// Parses "q" or "[q, qd]".
std::vector<std::string> names_of(std::string const &item) {
  if (item.starts_with('[') && item.ends_with(']')) return items_of(std::string_view(item).substr(1, item.size() - 2));
  return {item};
}

// The flag that an item names, as in jacobian(y, x, sparse); else null. An input of that name in second place wins.
bool *word_of(DerivativeRequest &request, std::string const &item) {
  if (item == "sparse") return &request.is_sparse;
  if (item == "symmetric") return &request.is_symmetric;
  return item == "weighted" ? &request.is_weighted : nullptr;
}

void read_words(DerivativeRequest &request, std::span<std::string const> items, DerivativeWish const &wish) {
  for (std::string const &item : items) {
    bool *const word = word_of(request, item);
    if (!word)
      refuse(wish, "'" + item +
                       "' is not one of sparse, symmetric and weighted; several objects stand in brackets, as in "
                       "[q, qd]");
    if (*word) refuse(wish, "'" + item + "' stands there twice");
    *word = true;
  }
  bool const is_hessian = request.kind == DerivativeKind::hessian;
  if (request.is_sparse && !request.is_matrix()) refuse(wish, "'sparse' is of jacobian and hessian");
  if (request.is_symmetric && !is_hessian) refuse(wish, "'symmetric' is of hessian");
  if (request.is_weighted && !is_hessian) refuse(wish, "'weighted' is of hessian");
}

std::string joined(std::string text, std::vector<std::string> const &names) {
  for (std::string const &name : names) text += "_" + name;
  return text;
}

struct NamedSlots {
  std::vector<std::string> names;
  std::vector<std::uint32_t> slots;
};

// Index of the object with this name; the count of the objects if absent.
std::size_t find(std::string const &name, std::vector<Object> const &objects, std::vector<std::string> const &known) {
  std::size_t k = 0;
  while (k < objects.size() && objects[k].label != name && known[k] != name &&
         objects[k].label.substr(0, objects[k].label.find('[')) != name)
    ++k;
  return k;
}

bool has(std::vector<Object> const &objects, std::string const &name) {
  return find(name, objects, identifiers(objects)) != objects.size();
}

NamedSlots find(std::vector<std::string> const &wanted, std::vector<Object> const &objects, DerivativeWish const &wish,
                std::string const &what) {
  std::vector<std::string> const known = identifiers(objects);
  NamedSlots found;
  for (std::string const &name : wanted) {
    std::size_t const k = find(name, objects, known);
    if (k == objects.size()) {
      std::string all;
      for (std::string const &other : known) all += (all.empty() ? "" : ", ") + other;
      refuse(wish, "'" + name + "' is not an " + what + " of the kernel, which has " + (all.empty() ? "none" : all));
    }
    if (std::ranges::find(found.names, known[k]) != found.names.end())
      refuse(wish, "'" + name + "' stands there twice");
    found.names.push_back(known[k]);
    for (std::uint32_t element = 0; element < objects[k].count; ++element)
      found.slots.push_back(objects[k].first + element);
  }
  return found;
}

} // namespace

std::vector<std::size_t> DerivativeRequest::extents() const {
  std::size_t const rows = output_slots.size(), columns = input_slots.size();
  switch (kind) {
  case DerivativeKind::jacobian: return {rows, columns};
  case DerivativeKind::hessian: return {columns, columns};
  case DerivativeKind::jvp: return {rows};
  case DerivativeKind::gradient:
  case DerivativeKind::vjp: break;
  }
  return {columns};
}

std::size_t DerivativeRequest::seed_count() const {
  if (kind == DerivativeKind::jvp) return input_slots.size();
  return kind == DerivativeKind::vjp || is_weighted ? output_slots.size() : 0;
}

std::string DerivativeRequest::seed_label() const {
  return kind == DerivativeKind::jvp ? joined("direction", inputs) : joined("weights", outputs);
}

DerivativeRequest read_request(DerivativeWish const &wish, Graph const &graph) {
  std::string_view const whole = trimmed(wish.text);
  std::size_t const open = whole.find('(');
  auto const kind = std::ranges::find(kinds, trimmed(whole.substr(0, open)));
  if (open == whole.npos || !whole.ends_with(')') || kind == kinds.end())
    refuse(wish, "this is not one of jacobian(y, x), gradient(y), hessian(y, x), jvp(y, x) and vjp(y, x)");
  std::vector<std::string> const items = items_of(whole.substr(open + 1, whole.size() - open - 2));
  NamedSlots const outputs = find(names_of(items[0]), graph.outputs, wish, "output");
  NamedSlots inputs;
  DerivativeRequest request;
  request.kind = static_cast<DerivativeKind>(kind - kinds.begin());
  std::size_t const words = items.size() > 1 && (!word_of(request, items[1]) || has(graph.inputs, items[1])) ? 2 : 1;
  read_words(request, std::span(items).subspan(words), wish);
  if (words == 2) {
    inputs = find(names_of(items[1]), graph.inputs, wish, "input");
  } else {
    inputs.names = identifiers(graph.inputs);
    for (std::uint32_t slot = 0; slot < graph.input_count(); ++slot) inputs.slots.push_back(slot);
  }
  if (inputs.slots.empty()) refuse(wish, "the kernel has no inputs");
  request.outputs = outputs.names, request.output_slots = outputs.slots;
  request.inputs = inputs.names, request.input_slots = inputs.slots;
  for (Object const &object : graph.outputs)
    if (object.first <= outputs.slots[0] && outputs.slots[0] - object.first < object.count)
      request.place = object.place;
  request.name = joined(std::string(*kind), outputs.names);
  if (words == 2) request.name = joined(request.name, inputs.names);
  bool const is_scalar =
      request.kind == DerivativeKind::gradient || (request.kind == DerivativeKind::hessian && !request.is_weighted);
  if (is_scalar && outputs.slots.size() != 1)
    refuse(wish, "what is named has " + std::to_string(outputs.slots.size()) + " numbers", DiagnosticId::not_a_scalar,
           request.place);
  return request;
}

} // namespace symreal
