static double work;

int main(void)
{
    double x = 1, y;
#pragma symreal input(x)
    work = x * x;
    y = work + x;
#pragma symreal output(y) generate("y.c")
    return y == 0;
}
