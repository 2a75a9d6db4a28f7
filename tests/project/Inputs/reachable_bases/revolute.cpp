#include "joint.h"
Revolute::~Revolute() {}
double Revolute::at(double q) const { return q * q; }
