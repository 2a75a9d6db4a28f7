// Records a model with CppADCodeGen, differentiates it, and writes both as C to standard output:
//     record DERIVATIVE X Z Y [JOINTS MODEL]
// bench/derivatives/makers.py writes recorded.h: copies of the sources with Number in place of double.
#include <cppad/cg.hpp>

typedef CppAD::cg::CG<double> Recorded;
typedef CppAD::AD<Recorded> Dual;

// Takes numbers as double does.
struct Number : Dual {
  Number() {}
  Number(int value) : Dual(Recorded(value)) {}
  Number(double value) : Dual(Recorded(value)) {}
  Number(Dual const &other) : Dual(other) {}
};

static Dual const &dual(Number const &number) { return number; } // Dual(number) would look for another constructor

inline Number fmax(Number const &a, Number const &b) { return CppAD::CondExpGt(dual(a), dual(b), dual(a), dual(b)); }
inline Number lgamma(Number const &constant) {
  return std::lgamma(CppAD::Value(CppAD::Var2Par(dual(constant))).getValue());
}

#include "recorded.h"

#include <chrono>
#include <iostream>

static double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

typedef std::vector<Recorded> Vector;

static Vector unit(std::size_t size, std::size_t at) {
  Vector vector(size, Recorded(0));
  vector[at] = Recorded(1);
  return vector;
}

// By the first `columns` inputs, row by row, in as few sweeps as there can be.
static Vector jacobian(CppAD::ADFun<Recorded> &function, std::size_t columns) {
  std::size_t const n = function.Domain(), m = function.Range();
  Vector result(m * columns);
  for (std::size_t j = 0; columns < m && j < columns; j++) {
    Vector const column = function.Forward(1, unit(n, j));
    for (std::size_t i = 0; i < m; i++) result[i * columns + j] = column[i];
  }
  for (std::size_t i = 0; columns >= m && i < m; i++) {
    Vector const row = function.Reverse(1, unit(m, i));
    for (std::size_t j = 0; j < columns; j++) result[i * columns + j] = row[j];
  }
  return result;
}

static Vector hessian(CppAD::ADFun<Recorded> &function, std::size_t columns) {
  std::size_t const n = function.Domain();
  Vector result(columns * columns);
  for (std::size_t j = 0; j < columns; j++) {
    function.Forward(1, unit(n, j));
    Vector const both = function.Reverse(2, Vector(1, Recorded(1)));
    for (std::size_t i = 0; i < columns; i++) result[i * columns + j] = both[2 * i + 1];
  }
  return result;
}

int main(int, char **argv) {
  int const columns = std::atoi(argv[2]), others = std::atoi(argv[3]), outputs = std::atoi(argv[4]);
  Prepared const prepared(argv + 5);
  std::vector<Dual> independent(columns + others), dependent(outputs);
  double const begin = now();
  for (Dual &each : independent) each = Recorded(0.5);
  CppAD::Independent(independent);
  std::vector<Number> x(independent.begin(), independent.end()), y(outputs);
  evaluate(prepared, &x[0], &x[0] + columns, &y[0]);
  for (int i = 0; i < outputs; i++) dependent[i] = dual(y[i]);
  CppAD::ADFun<Recorded> function(independent, dependent);
  function.optimize();

  CppAD::cg::CodeHandler<double> handler;
  Vector variables(independent.size());
  handler.makeVariables(variables);
  Vector results = function.Forward(0, variables);
  Vector const derivative =
      std::string(argv[1]) == "hessian" ? hessian(function, columns) : jacobian(function, columns);
  results.insert(results.end(), derivative.begin(), derivative.end());
  CppAD::cg::LanguageC<double> language("double");
  language.setParameterPrecision(17);
  CppAD::cg::LangCDefaultVariableNameGenerator<double> names;
  std::ostringstream code;
  handler.generateCode(code, language, results, names);
  std::cout << "#include <math.h>\nstatic void evaluate(double const *x, double *y) {\n  double v["
            << handler.getTemporaryVariableCount() + 1 << "];\n"
            << code.str() << "}\n";
  std::cerr << now() - begin << "\n";
}
