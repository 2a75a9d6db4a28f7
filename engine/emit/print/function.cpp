#include "engine/emit/print/function.h"

#include "engine/emit/print/body.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace symreal {

void append_function(Language const &language, std::string_view pattern, FunctionHead const &head,
                     std::vector<Parameter> const &parameters, CodeText &&text, CodeText &out) {
  FunctionSyntax const &syntax = language.functions;
  std::string list;
  for (Parameter const &parameter : parameters)
    list += (list.empty() ? "" : ", ") + fill(language, parameter.pattern, {{"name", parameter.name}});
  Filling fill_head;
  fill_head.set("result", std::string(head.may_fail ? syntax.status : syntax.no_result))
      .set_name("name", head.name)
      .set("target", head.target)
      .set("pure", std::string(head.is_pure ? syntax.pure : ""))
      .set("apart", std::string(head.is_apart ? syntax.apart : ""))
      .set("beside", std::string(head.is_side_by_side ? syntax.beside : ""))
      .set("parameters", list);
  out.statement(0, fill_head(with_words(language, pattern)));
  for (Parameter const &parameter : parameters)
    if (!parameter.is_used) out.statement(2, fill(language, syntax.unused, {{"name", parameter.name}}));
  out.append(std::move(text));
  out.statement(0, fill_head(with_words(language, syntax.end)));
}

namespace {

FunctionNames names_of(Emission const &emission, FunctionKind kind) {
  FunctionInfo const &function = info(kind);
  std::string const name(function.name);
  FunctionNames names{
      emission.name(function.is_helper ? "compute_" + name : name), {}, {}, std::string(name_of(function.fills))};
  for (Array const array : function.reads) names.inputs.emplace_back(name_of(array));
  names.part_inputs = names.inputs;
  if (kind == FunctionKind::compute && emission.plan.angles.size() != 0)
    for (Array const array : {Array::sine, Array::cosine}) names.part_inputs.emplace_back(name_of(array));
  return names;
}

class AnglesPrinter {
public:
  AnglesPrinter(Emission const &emission, CodeText &out)
      : angles_(emission.plan.angles),
        language_(emission.language),
        syntax_(emission.language.angles),
        input_(name_of(Array::input)),
        helper_(names_of(emission, FunctionKind::angles)),
        out_(out) {}

  void print() {
    for (Array const array : {Array::sine, Array::cosine}) declare(std::string(name_of(array)), angles_.size());
    if (std::size_t const count = angles_.inputs.size(); count != 0) call(count, inputs(), 0);
    if (angles_.computed == 0) return;
    declare(helper_.target, angles_.computed);
    std::string const inputs = fmt::format("{}", fmt::join(helper_.inputs, ", "));
    out_.statement(2, fill(language_, language_.functions.call,
                           {{"name", helper_.name}, {"group", ""}, {"arguments", inputs + ", " + helper_.target}}));
    call(angles_.computed, helper_.target, angles_.inputs.size());
  }

private:
  void declare(std::string const &array, std::size_t count) {
    out_.statement(2, fill(language_, language_.statements.array, {{"name", array}, {"count", std::to_string(count)}}));
  }

  std::string from(std::string const &array, std::size_t first) const {
    if (first == 0) return array;
    return fill(language_, syntax_.from, {{"array", array}, {"first", std::to_string(first)}});
  }

  void call(std::size_t count, std::string const &angles, std::size_t first) {
    out_.statement(2, fill(language_, syntax_.call,
                           {{"count", std::to_string(count)},
                            {"angles", angles},
                            {"sine", from(std::string(name_of(Array::sine)), first)},
                            {"cosine", from(std::string(name_of(Array::cosine)), first)}}));
  }

  // A subarray of `input` if the angles are contiguous, else a local array of them.
  std::string inputs() {
    std::vector<std::uint32_t> const &slots = angles_.inputs;
    if (slots.back() - slots.front() + 1 == slots.size()) return from(input_, slots.front());
    std::vector<std::string> elements;
    for (std::uint32_t const slot : slots) elements.push_back(element(language_, input_, slot));
    out_.lines("  " + fill(language_, syntax_.begin, {{"name", "angle"}, {"count", std::to_string(slots.size())}}) +
               lines_of(language_, elements) + std::string(syntax_.end) + "\n");
    return "angle";
  }

  Angles const &angles_;
  Language const &language_;
  AnglesSyntax const &syntax_;
  std::string input_;
  FunctionNames helper_;
  CodeText &out_;
};

} // namespace

void print_angles(Emission const &emission, CodeText &out) {
  if (emission.plan.angles.size() != 0) AnglesPrinter(emission, out).print();
}

namespace {

class FunctionPrinter {
public:
  FunctionPrinter(Emission &emission, PlanFunction const &function, FunctionNames const &names)
      : emission_(emission),
        graph_(emission.graph()),
        language_(emission.language),
        syntax_(emission.language.functions),
        body_(function),
        names_(names),
        threads_(emission.plan.threads),
        printer_(emission, body_, names.target) {}

  CodeText print() {
    bool const may_fail = !body_.checks.empty();
    CodeText out(language_), last(language_);
    if (names_.has_angles()) {
      print_angles(emission_, last);
      printer_.note_array(name_of(Array::input));
      if (emission_.plan.angles.computed != 0) printer_.note_array(name_of(Array::constants));
    }
    if (printer_.chunk_count() == 1) {
      printer_.begin(last);
      printer_.statements(0, last);
    } else {
      last.statement(
          2, fill(language_, language_.statements.array,
                  {{"name", "v"}, {"count", std::to_string(std::max<std::size_t>(printer_.spill_count(), 1))}}));
      printer_.begin(last);
      if (may_fail && !is_shared()) last.statement(2, syntax_.failed);
      for (std::size_t chunk = 0; chunk < printer_.chunk_count(); ++chunk) {
        begin_part(chunk, last);
        CodeText text(language_);
        bool const checks = printer_.statements(chunk, text);
        if (chunk == 0) out.reserve(text.size() * printer_.chunk_count() * 3 / 2); // avoids copies as the text grows
        print_part(chunk, std::move(text), checks, out, last);
        end_part(chunk, last);
      }
      if (is_shared()) printer_.checks(last);
      for (std::size_t group = 0; printer_.result_groups() > 1 && group < printer_.result_groups(); ++group) {
        CodeText text(language_);
        printer_.results(group, text);
        print_part(printer_.chunk_count() + group, std::move(text), false, out, last);
      }
      end_group(part_count(), out);
      for (std::string const &input : names_.inputs) printer_.note_array(input); // passed on by the calls
      if (syntax_.parts_store) printer_.note_array(names_.target);
    }
    last.statement(2, fill(language_, syntax_.results,
                           {{"name", names_.target}, {"count", std::to_string(body_.results.size())}}));
    if (printer_.result_groups() == 1) printer_.results(0, last);
    if (may_fail) last.statement(2, syntax_.success);
    last.statement(2, fill(language_, syntax_.finish, {{"name", names_.target}}));
    std::string_view const output =
        info(body_.kind).is_helper && !syntax_.local_output.empty() ? syntax_.local_output : syntax_.output;
    append(out, info(body_.kind).is_helper ? syntax_.local_head : syntax_.head, output, may_fail, names_.name,
           names_.target, std::move(last));
    return out;
  }

private:
  std::string group(std::size_t chunk) const {
    return syntax_.group_size == 0 ? "" : fmt::format("{}_part_{}", names_.name, chunk / syntax_.group_size + 1);
  }
  std::string with_output(std::string const &inputs, std::string const &output) const {
    return syntax_.output_first ? output + ", " + inputs : inputs + ", " + output;
  }
  std::size_t part_count() const {
    return printer_.chunk_count() + (printer_.result_groups() == 1 ? 0 : printer_.result_groups());
  }
  // Ends a group after this many parts.
  void end_group(std::size_t parts, CodeText &out) const {
    if (syntax_.group_size == 0) return;
    out.statement(0, fill(language_, syntax_.group_end, {{"name", group(parts - 1)}}));
    out.lines("\n");
  }

  bool is_shared() const { return !printer_.parts().empty(); }
  std::uint32_t stage(std::size_t chunk) const { return body_.parts[printer_.parts()[chunk]].stage; }
  // Whether another part runs concurrently.
  bool is_shared(std::size_t chunk) const {
    return is_shared() && std::ranges::count(body_.parts, stage(chunk), &ThreadPart::stage) > 1;
  }
  void begin_part(std::size_t chunk, CodeText &calls) const {
    if (!is_shared(chunk)) return;
    bool const is_first = chunk == 0 || stage(chunk - 1) != stage(chunk);
    if (is_first) calls.lines(around_part(language_.parallel.stage_begin));
    if (is_first || printer_.parts()[chunk - 1] != printer_.parts()[chunk])
      calls.lines(around_part(language_.parallel.part_begin));
  }
  void end_part(std::size_t chunk, CodeText &calls) const {
    if (!is_shared(chunk)) return;
    bool const is_last = chunk + 1 == printer_.chunk_count() || stage(chunk + 1) != stage(chunk);
    if (is_last || printer_.parts()[chunk + 1] != printer_.parts()[chunk])
      calls.lines(around_part(language_.parallel.part_end));
    if (is_last) calls.lines(around_part(language_.parallel.stage_end));
  }
  std::string around_part(std::string_view lines) const {
    return fill(language_, lines, {{"threads", std::to_string(threads_)}});
  }

  // Prints a part: a chunk, or a group of results that no chunk stores.
  void print_part(std::size_t part, CodeText text, bool checks, CodeText &out, CodeText &calls) {
    if (syntax_.group_size != 0 && part % syntax_.group_size == 0) {
      if (part != 0) end_group(part, out);
      out.statement(0, fill(language_, syntax_.group_begin, {{"name", group(part)}}));
    }
    if (checks) text.statement(2, syntax_.success);
    text.statement(2, fill(language_, syntax_.local_finish, {{"name", "v"}}));
    std::string const name = language_.names.spelled(fmt::format("{}_{}", names_.name, part + 1));
    bool const stores = printer_.arrays().contains(names_.target);
    append(out, syntax_.local_head, syntax_.local_output.empty() ? syntax_.output : syntax_.local_output, checks, name,
           "v", std::move(text));
    if (part + 1 < part_count() || syntax_.group_size == 0) out.lines("\n");
    std::string const arguments =
        with_output(fmt::format("{}", fmt::join(names_.part_inputs, ", ")), stores ? names_.target + ", v" : "v");
    bool const is_shared = part < printer_.chunk_count() && this->is_shared(part);
    for (std::string_view rest = checks ? syntax_.checked_call : syntax_.call; !rest.empty();) { // line by line
      std::size_t const end = std::min(rest.find('\n'), rest.size());
      calls.statement(
          is_shared ? language_.parallel.indent : 2,
          fill(language_, rest.substr(0, end), {{"name", name}, {"group", group(part)}, {"arguments", arguments}}));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }

  // Declares the locals in one statement, if the language requires that.
  void print_locals(bool is_part, CodeText &out) {
    std::vector<std::string> names = printer_.take_variables();
    if (!is_part && printer_.chunk_count() > 1) names.insert(names.begin(), "v");
    if (!is_part && syntax_.output.empty()) names.insert(names.begin(), names_.target);
    out.statement(2, fill(language_, names.empty() ? syntax_.no_locals : syntax_.locals,
                          {{"names", fmt::format("{}", fmt::join(names, ", "))}}));
  }

  // Adds the declarations that precede the statements.
  void append(CodeText &out, std::string_view head, std::string_view output, bool may_fail, std::string const &name,
              std::string const &last, CodeText text) {
    bool const is_part = name != names_.name;
    ArrayNames const used = printer_.take_arrays();
    std::vector<std::string> const &inputs = is_part ? names_.part_inputs : names_.inputs;
    bool const stores = is_part && used.contains(names_.target);
    std::vector<Parameter> parameters, outputs;
    CodeText whole(language_);
    for (std::string const &input : inputs) {
      parameters.push_back({syntax_.input, input, used.contains(input)});
      whole.statement(2, fill(language_, syntax_.input_declaration, {{"name", input}}));
    }
    if (stores) {
      outputs.push_back({syntax_.output, names_.target});
      whole.statement(2, fill(language_, syntax_.output_declaration, {{"name", names_.target}}));
    }
    outputs.push_back({output, last, used.contains(last)});
    whole.statement(2, fill(language_, syntax_.output_declaration, {{"name", last}}));
    if (!output.empty())
      parameters.insert(syntax_.output_first ? parameters.begin() : parameters.end(), outputs.begin(), outputs.end());
    if (may_fail) whole.statement(2, syntax_.status_declaration);
    print_locals(is_part, whole);
    whole.append(printer_.take_declarations());
    whole.append(std::move(text));
    bool const is_apart = is_part && body_.variables.size() > syntax_.most_statements && !syntax_.apart.empty();
    emission_.uses.apart |= is_apart;
    append_function(
        language_, head,
        {.name = name, .target = last, .may_fail = may_fail, .is_pure = graph_.externals.empty(), .is_apart = is_apart},
        parameters, std::move(whole), out);
  }

  Emission &emission_;
  Graph const &graph_;
  Language const &language_;
  FunctionSyntax const &syntax_;
  PlanFunction const &body_;
  FunctionNames const &names_;
  unsigned threads_;
  BodyPrinter printer_;
};

} // namespace

CodeText print_function(Emission &emission, PlanFunction const &function) {
  FunctionNames const names = names_of(emission, function.kind);
  if (function.loops) return print_loops(emission, function, names);
  CodeText out(emission.language);
  if (!function.lanes) return FunctionPrinter(emission, function, names).print();
  VectorSyntax const &vectors = emission.language.vectors;
  out.lines(vectors.begin);
  out.append(print_lanes(emission, function, names));
  out.lines(vectors.otherwise);
  out.append(FunctionPrinter(emission, function, names).print());
  out.lines(vectors.end);
  return out;
}

} // namespace symreal
