// Sinks that run a kernel again on inputs of the client's choice (verify/replay.h): the replay, the same annotations on
// ordinary doubles; and the original, its own text annotated by <symreal/original.h>, which reports changes of memory
// that outlives the kernel as well.
#include "runtime/memory/own_memory.h"
#include "runtime/replay/replay_protocol.h"
#include "runtime/replay/replay_server.h"
#include "runtime/replay/unnamed_state.h"
#include "runtime/trace/outside/call_dispatch.h"
#include "runtime/trace/outside/world.h"
#include "runtime/trace/report/call_stack.h"
#include "runtime/trace/sinks.h"
#include "runtime/wire/request.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>

namespace symreal::trace {

namespace {

using memory::Known;
using memory::MemoryImage;

class Replay final : public Sink {
public:
  void begin(std::string const &name, void const *) override {
    (void)replay::replay_begin(name, {.refuse_calls = refuse_calls});
  }
  void begin_object(Kind kind, std::string const &, Place const &) override { kind_ = kind; }
  void element(void *number, bool) override {
    auto *real = static_cast<double *>(number);
    switch (kind_) {
    case Kind::input: make_writable(real); return replay::replay_input(real);
    case Kind::parameter: make_writable(real); return replay::replay_parameter(real);
    case Kind::output: return replay::replay_output(*real);
    case Kind::constant:
    case Kind::scratch: return;
    }
  }
  void end_object(std::vector<std::size_t>) override {}
  void set_range(double, double) override {}
  void end(std::string const &, std::string const &, Place const &) override { replay::replay_end(); }
  Graph const &interface() const override { return interface_; }

private:
  Kind kind_ = Kind::input;
  Graph interface_;
};

replay::Outside outside_of(Effect::Kind kind) {
  if (kind == Effect::Kind::reads) return replay::Outside::result;
  return kind == Effect::Kind::changes ? replay::Outside::lasts : replay::Outside::passes;
}

class Original final : public Sink {
public:
  void begin(std::string const &name, void const *frame) override {
    if (is_again_) return;
    is_wanted_ = replay::replay_begin(name, {[&] { image_ = MemoryImage::capture(frame); },
                                             [this] { return image_.changes({}); }, call_stack, refuse_calls});
    if (is_wanted_ && replay::replay_watches_world()) watch_world();
    static char const *const changeable = wire::requested(wire::Entry::changeable);
    examines_ = is_wanted_ && changeable && replay::replay_examines();
    if (examines_) replay::begin_examination(image_, changeable);
  }
  void begin_object(Kind kind, std::string const &, Place const &) override {
    kind_ = kind;
    if (is_wanted_ && kind == Kind::output) replay::replay_leave();
    replay::look_up_items(true);
  }
  void element(void *number, bool) override {
    if (!is_wanted_) return;
    auto *real = static_cast<double *>(number);
    switch (kind_) {
    case Kind::input: input(real); return examine();
    case Kind::parameter:
      parameters_.push_back(real);
      give(real, replay::replay_parameter);
      return examine();
    case Kind::output:
      if (!is_again_) outputs_.push_back(real);
      return replay::replay_output(*real);
    case Kind::constant:
    case Kind::scratch: return;
    }
  }
  void bytes(void const *begin, std::size_t size) override {
    (kind_ == Kind::scratch ? scratch_ : constant_).push_back({static_cast<char const *>(begin), size});
  }
  void holder(void const *begin, std::size_t size) override {
    (kind_ == Kind::output ? holders_ : named_holders_).push_back({static_cast<char const *>(begin), size});
  }
  void handed_over(void const *begin, std::size_t size) override {
    auto const *bytes = static_cast<char const *>(begin);
    holders_.push_back({bytes, size});
    returned_.assign(bytes, size);
  }
  // Called again, the kernel finds its arguments as they were.
  void own(void const *begin, std::size_t size) override {
    auto *bytes = static_cast<char *>(const_cast<void *>(begin));
    std::string &kept = own_[bytes];
    if (is_again_) return void(kept.copy(bytes, size));
    kept.assign(bytes, size);
    holders_.push_back({bytes, size});
  }
  // The image has them: a system call would fail while accesses are watched.
  std::vector<memory::StaticObject> static_objects() const override {
    std::vector<memory::StaticObject> found;
    for (memory::Change const &one : image_.objects())
      if (one.region == memory::Region::static_object) found.push_back({one.name, one.object, one.size, false});
    return found;
  }
  void chosen(void const *begin, std::size_t size) override {
    chosen_.push_back({static_cast<char const *>(begin), size});
  }
  void end_object(std::vector<std::size_t>) override { replay::look_up_items(false); }
  void set_range(double, double) override {}
  void end(std::string const &, std::string const &output_file, Place const &) override {
    if (!is_wanted_) return;
    replay::end_examined(image_, [this] { return named(); });
    bool const is_function = output_file.empty();
    if (replay::replay_watches_world())
      for (Effect const &effect : effects_on_world(/*discard=*/true))
        replay::replay_effect(outside_of(effect.kind), effect.what);
    if (!is_again_) {
      std::vector<memory::Change> left = image_.changes(known());
      std::erase_if(left, [this](memory::Change const &change) { return is_returned(change); });
      replay::replay_left(left);
      for (double const *one : inputs_) replay::replay_link(output_at(one));
    }
    if (!is_function || !replay::replay_again()) replay::replay_end();
    is_again_ = true;
    spoil_outputs();
    if (replay::replay_changes_formats()) change_formats();
    session().kernel.run_again();
    replay::replay_end(); // this machine cannot
  }
  Graph const &interface() const override { return interface_; }

private:
  void examine() {
    if (!examines_ || !replay::replay_is_fed()) return;
    examines_ = false;
    replay::examine_state(image_);
  }

  void give(double *number, void (*feed)(double *)) {
    make_writable(number);
    feed(number);
    image_.update(number, sizeof *number); // the caller's own doing
  }

  // A repeated call finds in its state the values that it has left there.
  void input(double *number) {
    double kept = *number;
    if (is_again_ && output_at(number) >= 0) return replay::replay_input(&kept);
    if (!is_again_) inputs_.push_back(number);
    give(number, replay::replay_input);
  }

  // A caller may have anything in its outputs.
  void spoil_outputs() {
    for (double *one : outputs_) {
      auto const *at = reinterpret_cast<char const *>(one);
      auto const holds = [at](Known const &part) { return part.begin <= at && at < part.begin + part.size; };
      bool const is_state = std::find(inputs_.begin(), inputs_.end(), one) != inputs_.end() ||
                            std::any_of(scratch_.begin(), scratch_.end(), holds) ||
                            std::any_of(constant_.begin(), constant_.end(), holds);
      if (is_state || !image_.before(one)) continue; // or a local variable, which is gone
      make_writable(one);
      *one = replay::spoilt_output;
    }
  }

  // Whether the change is the caller's unnamed room for a returned structure of C.
  bool is_returned(memory::Change const &change) const {
    std::string_view const bytes(change.object + change.first, change.end - change.first);
    return change.region == memory::Region::stack && returned_.find(bytes) != returned_.npos;
  }

  // Index of the output that is the same number, or -1.
  int output_at(double const *number) const {
    auto const found = std::find(outputs_.begin(), outputs_.end(), number);
    return found == outputs_.end() ? -1 : static_cast<int>(found - outputs_.begin());
  }

  std::vector<Known> known() const {
    std::vector<Known> result = holders_;
    for (double const *one : outputs_) result.push_back({reinterpret_cast<char const *>(one), sizeof *one});
    for (Known const &one : scratch_)
      for (Known const &owned : image_.owned(one)) result.push_back(owned);
    return result;
  }

  // Bytes that the clauses name (verify/unnamed_state.h).
  replay::Named named() const {
    replay::Named result{named_holders_, known()};
    auto const add = [&](auto const &owners) {
      for (Known const &one : owners)
        for (Known const &owned : image_.owned(one)) result.read.push_back(owned);
    };
    add(constant_);
    add(chosen_);
    add(scratch_);
    add(replay::fixed_owners(image_));
    for (auto const *numbers : {&inputs_, &parameters_})
      for (double const *one : *numbers) result.read.push_back({reinterpret_cast<char const *>(one), sizeof *one});
    for (auto const &[begin, bytes] : own_) {
      result.read.push_back({begin, bytes.size()});
      result.written.push_back({begin, bytes.size()});
    }
    for (Known const &one : holders_) result.read.push_back(one);
    for (memory::Change const &one : image_.initialised()) result.written.push_back({one.object, one.size});
    if (!returned_.empty()) // the room for it, which no name leads to
      for (memory::Change const &one : image_.objects())
        if (one.region == memory::Region::stack) result.written.push_back({one.object, one.size});
    return result;
  }

  bool is_wanted_ = false, is_again_ = false, examines_ = false;
  Kind kind_ = Kind::input;
  MemoryImage image_;
  std::vector<double const *> inputs_, parameters_;
  std::vector<double *> outputs_;
  std::vector<Known> holders_, scratch_, constant_;
  std::vector<Known> chosen_;
  std::vector<Known> named_holders_;  // other than outputs
  std::map<char *, std::string> own_; // with their bytes before
  std::string returned_;              // the bytes of a structure
  Graph interface_;
};

} // namespace

std::unique_ptr<Sink> make_replay() { return std::make_unique<Replay>(); }
std::unique_ptr<Sink> make_original() { return std::make_unique<Original>(); }

} // namespace symreal::trace
