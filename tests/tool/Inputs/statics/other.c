static double kept[2], last;
double next(double x)
{
    kept[0] = x * x;
    kept[1] = kept[0] + x;
    last = kept[1];
    return kept[1] + last;
}
