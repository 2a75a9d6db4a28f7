typedef struct {
  double at[2];
  struct {
    double angle, rate;
  } turn[2];
} pose;

#include <stdio.h>

#pragma symreal function input(p, by) output(return)
pose turned(pose p, double by)
{
    pose q;
    q.at[0] = p.at[1] * by;
    q.at[1] = p.at[0] - by;
    q.turn[0].angle = p.turn[1].angle + by;
    q.turn[0].rate = p.turn[0].rate;
    q.turn[1].angle = p.turn[0].angle * p.turn[1].rate;
    q.turn[1].rate = 2;
    return q;
}

int main(void)
{
    pose p = {{1, 2}, {{3, 4}, {5, 6}}};
    int i;
    for (i = 0; i < 3; i++) {
        p = turned(p, i + 0.5);
        printf("%g %g %g %g %g %g\n", p.at[0], p.at[1], p.turn[0].angle, p.turn[0].rate, p.turn[1].angle, p.turn[1].rate);
    }
    return 0;
}
