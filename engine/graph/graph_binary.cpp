#include "engine/graph/graph_binary.h"

#include "engine/graph/validate.h"
#include "engine/support/installation.h"

#include <cereal/archives/binary.hpp>
#include <cereal/cereal.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <type_traits>

namespace symreal {

// Bounded reader of cereal's binary archives: never allocates more than the rest of the file can fill, since a
// truncated or corrupted file may claim any list length.
class BoundedInput : public cereal::InputArchive<BoundedInput, cereal::AllowEmptyClassElision> {
public:
  // `size`: remaining bytes of the stream.
  BoundedInput(std::istream &stream, std::uint64_t size) : InputArchive(this), stream_(stream), left_(size) {}

  void read(void *data, std::size_t size) {
    require(size);
    if (stream_.rdbuf()->sgetn(static_cast<char *>(data), static_cast<std::streamsize>(size)) !=
        static_cast<std::streamsize>(size))
      throw cereal::Exception("it ends early");
    left_ -= size;
  }
  // Throws unless `count` elements of at least a byte each can follow.
  void require(std::uint64_t count) const {
    if (count > left_) throw cereal::Exception("a list is longer than the file");
  }

private:
  std::istream &stream_;
  std::uint64_t left_;
};

template <class T> std::enable_if_t<std::is_arithmetic_v<T>> load(BoundedInput &file, T &value) {
  if constexpr (std::is_same_v<T, bool>) {
    unsigned char byte = 0;
    file.read(&byte, 1);
    value = byte != 0;
  } else {
    file.read(std::addressof(value), sizeof value);
  }
}
template <class T> void load(BoundedInput &file, cereal::BinaryData<T> &bytes) { file.read(bytes.data, bytes.size); }
template <class T> void serialize(BoundedInput &file, cereal::SizeTag<T> &tag) {
  file(tag.size);
  file.require(tag.size);
}
template <class T> void serialize(BoundedInput &file, cereal::NameValuePair<T> &pair) { file(pair.value); }

} // namespace symreal

namespace cereal {
namespace traits::detail {
template <> struct get_output_from_input<symreal::BoundedInput> {
  using type = BinaryOutputArchive;
};
} // namespace traits::detail
} // namespace cereal

namespace symreal {

// Members of each structure, for reading and writing. Nodes are copied bytewise.
template <class Archive> void serialize(Archive &file, Place &x) { file(x.file, x.line, x.column); }
template <class Archive> void serialize(Archive &file, Range &x) { file(x.low, x.high); }
template <class Archive> void serialize(Archive &file, Member &x) { file(x.name, x.extents, x.members); }
template <class Archive> void serialize(Archive &file, Object &x) {
  file(x.label, x.extents, x.first, x.count, x.place, x.range, x.members);
}
template <class Archive> void serialize(Archive &file, StatePair &x) { file(x.state, x.derivative, x.place); }
template <class Archive> void serialize(Archive &file, DerivativeWish &x) { file(x.text, x.place); }
template <class Archive> void serialize(Archive &file, Frozen &x) {
  file(x.name, x.place, x.values, x.is_around, x.is_member, x.stack);
}
template <class Archive> void serialize(Archive &file, Location &x) { file(x.places, x.addresses); }
template <class Archive> void serialize(Archive &file, Guard &x) { file(x.condition, x.location, x.text); }
template <class Archive> void serialize(Archive &file, Table &x) { file(x.name, x.extents, x.values, x.place); }
template <class Archive> void serialize(Archive &file, ExternalValue &x) { file(x.kind, x.count, x.type); }
template <class Archive> void serialize(Archive &file, DerivativeFunction &x) { file(x.name, x.is_returned); }
template <class Archive> void serialize(Archive &file, External &x) {
  file(x.name, x.pure, x.returned, x.parameters, x.place, x.derivatives);
}
template <class Archive> void serialize(Archive &file, OperationCounts &x) { file(x.by_op); }

template <class Archive> static void serialize_nodes(Archive &file, Nodes &nodes) {
  cereal::size_type count = nodes.size();
  file(cereal::make_size_tag(count));
  nodes.resize(count);
  file(cereal::binary_data(nodes.data(), count * sizeof(Node)));
}

template <class Archive> void serialize(Archive &file, Graph &x) {
  file(x.kernel, x.inputs, x.parameters, x.outputs, x.states, x.wishes);
  serialize_nodes(file, x.nodes);
  file(x.results, x.precomputed, x.guards, x.decisions, x.from_instructions, x.tables, x.externals, x.last_effect);
  file(x.locations, x.node_location, x.names, x.node_name, x.node_exact, x.input_values, x.parameter_values, x.frozen,
       x.executed);
}

// Made at each use: a kernel may end before the constructors of static objects have run.
static std::string head() { return "symreal-binary-graph " + std::string(version) + "\n"; }

void write_binary_graph(std::string const &path, Graph const &graph) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  try {
    file.exceptions(std::ios::badbit | std::ios::failbit);
    file << head();
    cereal::BinaryOutputArchive archive(file);
    archive(graph);
    file.close();
  } catch (std::bad_alloc const &) {
    throw;
  } catch (std::exception const &) { // from the stream or the archive
    fail(DiagnosticId::unwritable_output, {path}, "cannot write '" + path + "': " + std::strerror(errno));
  }
}

Graph read_binary_graph(std::string const &path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(DiagnosticId::unreadable_file, {path}, "cannot read '" + path + "': " + std::strerror(errno));
  std::string const wanted = head();
  std::string found(wanted.size(), '\0');
  if (!file.read(found.data(), static_cast<std::streamsize>(found.size())) || found != wanted)
    fail(DiagnosticId::graph_syntax, {path},
         "the recording is not of this version of Symreal, " + std::string(version));
  Graph graph;
  try {
    BoundedInput archive(file, std::filesystem::file_size(path) - wanted.size());
    archive(graph);
  } catch (std::bad_alloc const &) {
    throw;
  } catch (std::exception const &error) {
    fail(DiagnosticId::graph_syntax, {path}, "the recording is not whole: " + std::string(error.what()));
  }
  if (std::string const violation = find_violation(graph); !violation.empty())
    fail(DiagnosticId::graph_syntax, {path}, violation);
  return graph;
}

} // namespace symreal
