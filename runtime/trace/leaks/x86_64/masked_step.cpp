#include "runtime/trace/leaks/x86_64/masked_step.h"

namespace symreal::trace::x86_64 {

std::uint64_t *MaskedStep::place(SavedState const &state, Operand const &operand, unsigned lane) {
  return operand.in_memory ? reinterpret_cast<std::uint64_t *>(operand.address) + lane
                           : state.lane(operand.vector, lane);
}

void MaskedStep::substitute(Instruction const &instruction, Operand const &operand, unsigned lane, std::uint64_t *place,
                            std::uint64_t value) {
  bool const is_overwritten = !operand.in_memory && operand.vector == instruction.destination;
  if (!is_overwritten) changed_[count_++] = {operand, lane, *place};
  *place = value;
}

void MaskedStep::begin(SavedState &state) {
  state.mask_invalid();
  state.single_step(true);
  is_pending_ = true;
}

void MaskedStep::finish(SavedState &state, bool unmask) {
  is_pending_ = false;
  state.single_step(false);
  for (; count_ != 0; --count_) {
    Changed const &changed = changed_[count_ - 1];
    *place(state, changed.operand, changed.lane) = changed.original;
  }
  if (unmask) state.unmask_invalid();
}

} // namespace symreal::trace::x86_64
