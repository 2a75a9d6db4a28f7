#include "runtime/trace/report/call_stack.h"

#include <unwind.h>

extern "C" char const __ehdr_start; // the linker's name for where this executable is loaded

namespace symreal::trace {

// Walks the stack up to the frame for which `add` returns false.
template <class Add> static void for_each_frame(Add add) {
  _Unwind_Backtrace(
      [](_Unwind_Context *context, void *function) {
        int is_interrupted = 0;
        std::uintptr_t const address = _Unwind_GetIPInfo(context, &is_interrupted);
        return (*static_cast<Add *>(function))(address, is_interrupted != 0) ? _URC_NO_REASON : _URC_END_OF_STACK;
      },
      &add);
}

static constexpr std::size_t most_frames = 48;

static std::uintptr_t relative(std::uintptr_t address) {
  return address - reinterpret_cast<std::uintptr_t>(&__ehdr_start);
}

std::vector<std::uintptr_t> call_stack() {
  std::vector<std::uintptr_t> addresses;
  for_each_frame([&addresses](std::uintptr_t address, bool) {
    addresses.push_back(relative(address));
    return addresses.size() < most_frames;
  });
  return addresses;
}

void for_each_interrupted(void (*add)(std::uintptr_t address, void *data), void *data) {
  std::size_t count = 0;
  for_each_frame([&](std::uintptr_t address, bool is_interrupted) {
    if (count != 0 || is_interrupted) {
      add(relative(address) + (is_interrupted ? 1 : 0), data); // the instruction itself, where no call is
      ++count;
    }
    return count < most_frames;
  });
}

// Readers take one off to get from a return address into the call,
// so the instructions themselves are one more here.
std::vector<std::uintptr_t> interrupted_stack(std::uintptr_t delayed) {
  std::vector<std::uintptr_t> addresses;
  auto function = [](std::uintptr_t at) { return _Unwind_FindEnclosingFunction(reinterpret_cast<void *>(at)); };
  for_each_frame([&](std::uintptr_t address, bool is_interrupted) {
    if (!addresses.empty()) {
      addresses.push_back(relative(address));
    } else if (is_interrupted) {
      if (delayed != 0) addresses.push_back(relative(delayed + 1));
      if (delayed == 0 || function(delayed) != function(address)) addresses.push_back(relative(address + 1));
    }
    return addresses.size() < most_frames;
  });
  return addresses;
}

} // namespace symreal::trace
