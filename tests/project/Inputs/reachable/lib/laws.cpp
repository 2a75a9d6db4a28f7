#include "model.h"

Law::~Law() = default;
double Spring::at(double x) const { return -k * x; }
