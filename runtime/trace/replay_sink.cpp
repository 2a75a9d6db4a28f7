// Replay: the same annotations on ordinary doubles, fed and read by the client of verify/replay_server.h.
#include "runtime/memory/own_memory.h"
#include "runtime/replay/replay_server.h"
#include "runtime/trace/sinks.h"

namespace symreal::trace {

namespace {

class Replay final : public Sink {
public:
  void begin(std::string const &name, void const *) override { (void)replay::replay_begin(name); }
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

} // namespace

std::unique_ptr<Sink> make_replay() { return std::make_unique<Replay>(); }

} // namespace symreal::trace
