#define N 6
#define T 5
#define value 7
static double offset(double x) { return x + value; }
