static double work[2];
static int count;
double gain = 2;
int order = 3;

double g(double x) { return x; }

#pragma symreal function input(x) output(return)
double f(double x)
{
    count++;
    work[0] = gain * x;
    work[1] = order;
    return work[0] + work[1];
}

int main(void)
{
    gain = 4;
    order = 5;
    return f(1) + g(1) == 0;
}
