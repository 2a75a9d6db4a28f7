/* Hands the swing-up to Ipopt: symreal generate swing_up.c -o swing_up_code.c has made what is called here. */
#include "swing_up_code.h"

#include <IpStdCInterface.h>

#include <math.h>
#include <stdio.h>

enum { STATES = 4, POINT = STATES + 1, LAST = input_weights_cost_defect - POINT, VARIABLES = input_weights_cost_defect,
       DEFECTS = output_gradient_cost - output_defect };

/* All of it at once: compilers and Ipopt alike are quick enough. */
static double const *evaluate(double const *z, double factor, double const *multipliers) {
  static double input[input_count], output[output_count];
  for (int k = 0; k < VARIABLES; k++) input[k] = z[k];
  input[input_weights_cost_defect] = factor;
  for (int k = 0; k < DEFECTS; k++) input[input_weights_cost_defect + 1 + k] = multipliers ? multipliers[k] : 0.0;
  compute(input, input, output);
  return output;
}

static void copy(double const *from, int count, Number *to) {
  for (int k = 0; k < count; k++) to[k] = from[k];
}

static void copy_places(int const *row, int const *column, int count, Index *rows, Index *columns) {
  for (int k = 0; k < count; k++) rows[k] = row[k], columns[k] = column[k];
}

static Bool value(Index n, Number *z, Bool is_new, Number *cost, UserDataPtr data) {
  (void)n, (void)is_new, (void)data;
  *cost = evaluate(z, 0.0, NULL)[output_cost];
  return TRUE;
}

static Bool gradient(Index n, Number *z, Bool is_new, Number *slopes, UserDataPtr data) {
  (void)is_new, (void)data;
  copy(evaluate(z, 0.0, NULL) + output_gradient_cost, n, slopes);
  return TRUE;
}

static Bool constraints(Index n, Number *z, Bool is_new, Index m, Number *defects, UserDataPtr data) {
  (void)n, (void)is_new, (void)data;
  copy(evaluate(z, 0.0, NULL) + output_defect, m, defects);
  return TRUE;
}

static Bool jacobian(Index n, Number *z, Bool is_new, Index m, Index count, Index *rows, Index *columns,
                     Number *values, UserDataPtr data) {
  (void)n, (void)is_new, (void)m, (void)data;
  if (values)
    copy(evaluate(z, 0.0, NULL) + output_jacobian_defect_z, count, values);
  else
    copy_places(jacobian_defect_z_row, jacobian_defect_z_column, count, rows, columns);
  return TRUE;
}

static Bool hessian(Index n, Number *z, Bool is_new, Number factor, Index m, Number *multipliers,
                    Bool are_new, Index count, Index *rows, Index *columns, Number *values, UserDataPtr data) {
  (void)n, (void)is_new, (void)m, (void)are_new, (void)data;
  if (values)
    copy(evaluate(z, factor, multipliers) + output_hessian_cost_defect_z, count, values);
  else
    copy_places(hessian_cost_defect_z_row, hessian_cost_defect_z_column, count, rows, columns);
  return TRUE;
}

int main(void) {
  double low[VARIABLES], high[VARIABLES], zero[DEFECTS] = {0.0}, z[VARIABLES], defects[DEFECTS], cost = 0.0;
  double const first[STATES] = {0.0, 0.0, 0.0, 0.0}, last[STATES] = {1.0, 3.14159265358979, 0.0, 0.0};
  double const most[POINT] = {2.0, 10.0, 20.0, 40.0, 20.0};
  for (int k = 0; k < VARIABLES; k++) {
    int const part = k % POINT;
    low[k] = -most[part], high[k] = most[part];
    if (k < STATES) low[k] = high[k] = first[part];
    if (k >= LAST && part < STATES) low[k] = high[k] = last[part];
    z[k] = part < 2 ? last[part] * k / VARIABLES : 0.0; /* on a straight way */
  }
  IpoptProblem problem = CreateIpoptProblem(VARIABLES, low, high, DEFECTS, zero, zero, jacobian_defect_z_nonzeros,
                                            hessian_cost_defect_z_nonzeros, 0, value, constraints, gradient, jacobian,
                                            hessian);
  AddIpoptStrOption(problem, "derivative_test", "second-order");
  AddIpoptStrOption(problem, "sb", "yes");
  enum ApplicationReturnStatus const status = IpoptSolve(problem, z, defects, &cost, NULL, NULL, NULL, NULL);
  FreeIpoptProblem(problem);
  double violation = 0.0;
  for (int k = 0; k < DEFECTS; k++) violation = fmax(violation, fabs(defects[k]));
  printf("status %d, objective %.6f, violation below 1e-8: %s\n", (int)status, cost, violation < 1e-8 ? "yes" : "no");
  return status == Solve_Succeeded ? 0 : 1;
}
