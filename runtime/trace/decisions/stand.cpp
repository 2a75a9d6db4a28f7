// Entry of decisions: saves the caller's preserved registers in memory, where they can be read and changed.
#include "runtime/trace/join/process_image.h"

#include <symreal/real_number.h>

#include <cstddef>

using symreal::trace::Stand;

#if defined(__x86_64__) && defined(__ELF__)

static_assert(offsetof(Stand, caller) == 56 && offsetof(Stand, condition) == 48);

// Entry of symreal::detail::decide_on(unsigned long). It wipes its call's stack, which would lie in the frames of later
// calls and differ from process to process.
asm(R"(
  .text
  .p2align 4
  .globl _ZN7symreal6detail9decide_onEm
  .type _ZN7symreal6detail9decide_onEm, @function
_ZN7symreal6detail9decide_onEm:
  .cfi_startproc
  subq $56, %rsp
  .cfi_adjust_cfa_offset 56
  movq %rbx, 0(%rsp)
  movq %rbp, 8(%rsp)
  movq %r12, 16(%rsp)
  movq %r13, 24(%rsp)
  movq %r14, 32(%rsp)
  movq %r15, 40(%rsp)
  movq %rdi, 48(%rsp)
  movq %rsp, %rdi
  call symreal_decide_at@PLT
  movq %rax, %rdx
  leaq -16384(%rsp), %rdi
  movl $2048, %ecx
  xorl %eax, %eax
  rep stosq
  movq %rdx, %rax
  movq 0(%rsp), %rbx
  movq 8(%rsp), %rbp
  movq 16(%rsp), %r12
  movq 24(%rsp), %r13
  movq 32(%rsp), %r14
  movq 40(%rsp), %r15
  addq $56, %rsp
  .cfi_adjust_cfa_offset -56
  ret
  .cfi_endproc
  .size _ZN7symreal6detail9decide_onEm, .-_ZN7symreal6detail9decide_onEm
)");

#else

extern "C" bool symreal_decide_at(Stand *stand) noexcept;

bool symreal::detail::decide_on(std::uint64_t condition) noexcept {
  Stand stand{{}, condition, __builtin_return_address(0)};
  return symreal_decide_at(&stand);
}

#endif
