double next(double x);
int main(void)
{
    double x = 2, y;
#pragma symreal input(x)
    y = next(x);
#pragma symreal output(y) generate("y.c")
    return y > 3;
}
