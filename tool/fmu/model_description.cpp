#include "tool/fmu/model_description.h"

#include "engine/support/number.h"
#include "engine/support/version.h"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace symreal::tool {

namespace {

using Role = UnitVariable::Role;

std::string escaped(std::string const &text) {
  std::string result;
  for (char const c : text) switch (c) {
    case '&': result += "&amp;"; break;
    case '<': result += "&lt;"; break;
    case '>': result += "&gt;"; break;
    case '"': result += "&quot;"; break;
    default: result += c;
    }
  return result;
}

// A double in the syntax of XML Schema.
std::string number(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "INF" : "-INF";
  return shortest(value);
}

std::string attributes(UnitVariable const &variable) {
  std::string const start = number(variable.start);
  switch (variable.role) {
  case Role::time: return R"(causality="independent" variability="continuous")";
  case Role::input: return fmt::format(R"(causality="input" variability="continuous" start="{}")", start);
  case Role::state:
    return fmt::format(R"(causality="output" variability="continuous" initial="exact" start="{}")", start);
  case Role::parameter: return fmt::format(R"(causality="parameter" variability="tunable" start="{}")", start);
  case Role::output: return R"(causality="output" variability="continuous" initial="calculated")";
  case Role::derivative: break;
  }
  return fmt::format(R"(causality="local" variability="continuous" initial="calculated" derivative="{}")",
                     variable.state);
}

// Entry of an unknown. `with_parameters`: its dependencies include parameters, which vary only in initialization.
std::string unknown(std::string const &element, std::vector<UnitVariable> const &variables, std::size_t k,
                    bool with_parameters) {
  std::vector<std::size_t> known;
  for (std::size_t const at : variables[k].dependencies)
    if (with_parameters || variables[at].role != Role::parameter) known.push_back(at);
  return fmt::format("    <{} valueReference=\"{}\" dependencies=\"{}\"/>\n", element, k, fmt::join(known, " "));
}

std::string structure(std::vector<UnitVariable> const &variables) {
  std::string outputs, initial, by_state;
  for (std::size_t k = 0; k < variables.size(); ++k) {
    Role const role = variables[k].role;
    if (role == Role::output || role == Role::state) outputs += unknown("Output", variables, k, false);
    if (role == Role::output || role == Role::derivative) initial += unknown("InitialUnknown", variables, k, true);
  }
  // Lists derivatives in the order of the states, as the unit's functions pass them.
  for (std::size_t state = 0; state < variables.size(); ++state)
    for (std::size_t k = 0; k < variables.size(); ++k)
      if (variables[k].role == Role::derivative && variables[k].state == state)
        by_state += unknown("ContinuousStateDerivative", variables, k, false);
  return outputs + by_state + initial;
}

} // namespace

std::string model_description(UnitNames const &names, std::vector<UnitVariable> const &variables) {
  std::string list;
  for (std::size_t k = 0; k < variables.size(); ++k)
    list += fmt::format("    <Float64 name=\"{}\" valueReference=\"{}\" {}/>\n", escaped(variables[k].name), k,
                        attributes(variables[k]));
  return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="3.0" modelName="{0}" instantiationToken="{1}" generationTool="Symreal {2}">
  <ModelExchange modelIdentifier="{3}" canGetAndSetFMUState="true"/>
  <CoSimulation modelIdentifier="{3}" canGetAndSetFMUState="true" canHandleVariableCommunicationStepSize="true"/>
  <LogCategories>
    <Category name="logStatusDiscard" description="a guard of the generated code does not hold"/>
    <Category name="logStatusError"/>
  </LogCategories>
  <ModelVariables>
{4}  </ModelVariables>
  <ModelStructure>
{5}  </ModelStructure>
</fmiModelDescription>
)",
                     escaped(names.model), names.token, version, names.identifier, list, structure(variables));
}

std::string build_description(std::string const &identifier, std::vector<std::string> const &sources,
                              std::string const &compiler_options) {
  std::string files;
  for (std::string const &source : sources) files += fmt::format("      <SourceFile name=\"{}\"/>\n", source);
  return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<fmiBuildDescription fmiVersion="3.0">
  <BuildConfiguration modelIdentifier="{}">
    <SourceFileSet language="C99" compilerOptions="{}">
{}    </SourceFileSet>
    <Library name="m"/>
  </BuildConfiguration>
</fmiBuildDescription>
)",
                     identifier, compiler_options, files);
}

} // namespace symreal::tool
