// Records a kernel of inputs/chain with CppADCodeGen and writes it as C to standard output:
//     cppadcodegen KERNEL JOINTS MODEL
// The sources are compiled with a number type in place of double; bench/peers/contenders.py makes these copies, which
// define Number. Times and the number of executed operations are not of its concern.
#include "number.h"

#include "algorithms.cpp"
#include "model.cpp"
#include "spatial.cpp"

#include <chrono>
#include <iostream>

using CppAD::cg::CodeHandler;
typedef CppAD::cg::CG<double> Recorded;

static double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int main(int, char **argv) {
  std::string const kernel = argv[1];
  int const n = std::atoi(argv[2]);
  chain::Model const model(chain::read_links(argv[3], n));
  bool const three = kernel == "rnea" || kernel == "aba";
  std::vector<Number> x(three ? 3 * n : n), y(kernel == "fk" ? 12 : kernel == "crba" ? n * n : n);
  double const begin = now();
  CppAD::Independent(x);
  if (kernel == "fk") chain::forward_kinematics(model, &x[0], &y[0]);
  if (kernel == "rnea") chain::inverse_dynamics(model, &x[0], &x[n], &x[2 * n], &y[0]);
  if (kernel == "crba") chain::mass_matrix(model, &x[0], &y[0]);
  if (kernel == "aba") chain::forward_dynamics(model, &x[0], &x[n], &x[2 * n], &y[0]);
  CppAD::ADFun<Recorded> function(x, y);
  double const recorded = now();
  function.optimize();

  CodeHandler<double> handler;
  std::vector<Recorded> variables(x.size());
  handler.makeVariables(variables);
  std::vector<Recorded> results = function.Forward(0, variables);
  CppAD::cg::LanguageC<double> language("double");
  language.setParameterPrecision(17);
  CppAD::cg::LangCDefaultVariableNameGenerator<double> names;
  std::ostringstream code;
  handler.generateCode(code, language, results, names);
  std::cout << "static void evaluate(double const *x, double *y) {\n  double v["
            << handler.getTemporaryVariableCount() + 1 << "];\n"
            << code.str() << "}\n";
  std::cerr << recorded - begin << " " << now() - recorded << "\n";
}
