#include "rewrite/facts/fact_bytes.h"

#include "rewrite/facts/bytes.h"
#include "rewrite/facts/members.h"

namespace symreal::rewrite {

namespace {

template <class T> std::string written(T &object) {
  Write write;
  write(object);
  return write.result();
}

} // namespace

std::string to_bytes(Facts facts) { return written(facts); }
std::string to_bytes(ConfiguredKernel kernel) { return written(kernel); }
std::string to_bytes(ConfiguredExternal external) { return written(external); }

std::optional<Facts> facts_of_bytes(std::string_view bytes) {
  Read read(bytes);
  Facts facts;
  read(facts);
  return read.is_complete() ? std::optional(std::move(facts)) : std::nullopt;
}

} // namespace symreal::rewrite
