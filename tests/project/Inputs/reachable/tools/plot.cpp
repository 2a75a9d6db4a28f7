#include "../lib/model.h"

int main() { return power(1.0, 2.0) > 0; }
