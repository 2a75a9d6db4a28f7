#include "runtime/trace/decisions/arrival.h"

#include "runtime/trace/decisions/policy.h"
#include "runtime/trace/nodes/externals.h"
#include "runtime/trace/report/call_stack.h"
#include "runtime/trace/report/events.h"

#include <symreal/text.h>

#include <cfenv>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

// Defined here because text/ depends on this folder.
__thread bool symreal::detail::has_text = false;

namespace symreal::trace {
namespace {

unsigned modes_of_arithmetic() {
  unsigned modes = static_cast<unsigned>(std::fegetround());
#ifdef __SSE__
  constexpr unsigned flags = 0x3f;
  modes |= (_mm_getcsr() & ~flags) << 16;
#endif
  return modes;
}

} // namespace

PartingPoint PartingPoint::now() {
  return {static_cast<NodeId>(Pool::current().nodes().size()), Guards::current().recorded().size(), trace::told(),
          Externals::current().last_effect(), detail::has_text};
}

std::optional<Arrival> Arrival::here(PartingPoint const &since, Stand *stand, bool is_hypothetical) {
  std::optional<Arrival> arrival = Arrival::since(since, is_hypothetical);
  if (!arrival) return arrival;
  arrival->image = ProcessImage::capture(stand);
  arrival->stack = call_stack();
  return arrival;
}

std::optional<Arrival> Arrival::at_end(PartingPoint const &since, std::vector<RealNumber> const &results,
                                       std::size_t interface, bool is_hypothetical) {
  std::optional<Arrival> arrival = Arrival::since(since, is_hypothetical);
  if (!arrival) return arrival;
  arrival->facts.interface = interface;
  arrival->image = ProcessImage::of_results(results);
  return arrival;
}

std::optional<Arrival> Arrival::since(PartingPoint const &parted, bool is_hypothetical) {
  bool const has_effect = Externals::current().last_effect().to_bits() != parted.last_effect.to_bits();
  bool const has_text = detail::has_text != parted.has_text;
  if (has_effect || has_text || told() != parted.told || !State::current().is_journal_complete()) return std::nullopt;
  Arrival arrival;
  arrival.facts = {Externals::current().tables().size(), Externals::current().functions().size(),
                   static_cast<int>(decisions()), modes_of_arithmetic()};
  arrival.nodes = Pool::current().rows_from(parted.nodes);
  std::vector<Guards::Recorded> const &guards = Guards::current().recorded();
  arrival.guards.assign(guards.begin() + static_cast<std::ptrdiff_t>(parted.guards), guards.end());
  arrival.notes = State::current().journal();
  arrival.arm = current_arm();
  arrival.is_hypothetical = is_hypothetical;
  return arrival;
}

void write_guards(std::vector<Guards::Recorded> const &guards, MessageWriter &writer) {
  writer.put(guards.size());
  for (Guards::Recorded const &guard : guards) {
    writer.put(guard.needed);
    writer.put_all(std::vector(guard.arms.begin(), guard.arms.end()));
    writer.put_all(guard.text);
    writer.put(guard.reason);
    writer.put_all(guard.stack);
  }
}

std::vector<Guards::Recorded> read_guards(MessageReader &reader) {
  std::vector<Guards::Recorded> guards(reader.get<std::size_t>());
  for (Guards::Recorded &guard : guards) {
    guard.needed = reader.get<NodeId>();
    auto const arms = reader.get_all<std::vector<NodeId>>();
    guard.arms = {arms.begin(), arms.end()};
    guard.text = reader.get_all<std::string>();
    guard.reason = reader.get<Guards::Reason>();
    guard.stack = reader.get_all<std::vector<std::uintptr_t>>();
  }
  return guards;
}

void Arrival::write(MessageWriter &writer) const {
  writer.put(facts);
  image.write(writer);
  writer.put_all(nodes);
  write_guards(guards, writer);
  writer.put_all(notes);
  writer.put_all(stack);
  writer.put(arm);
  writer.put(is_hypothetical);
}

Arrival Arrival::read(MessageReader &reader) {
  Arrival arrival;
  arrival.facts = reader.get<Facts>();
  arrival.image = ProcessImage::read(reader);
  arrival.nodes = reader.get_all<std::vector<Pool::Row>>();
  arrival.guards = read_guards(reader);
  arrival.notes = reader.get_all<std::vector<StateNote>>();
  arrival.stack = reader.get_all<std::vector<std::uintptr_t>>();
  arrival.arm = reader.get<RealNumber>();
  arrival.is_hypothetical = reader.get<bool>();
  return arrival;
}

} // namespace symreal::trace
