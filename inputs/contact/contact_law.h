/* A numeric contact law, compiled apart from the dynamics that use it. */
#ifndef CONTACT_LAW_H
#define CONTACT_LAW_H

#ifdef __cplusplus
extern "C" {
#endif

/* The force of the ground y = 0 on a point: a stiff spring with damping, and friction that slides or creeps. */
void contact_force(double stiffness, double const position[2], double const velocity[2], double force[2]);

/* Where a point last touched down. */
struct anchor {
  double x;
  double holds; /* 1 while it touches, else 0 */
};

/* The same with friction that holds the point where it touched down, which the library remembers for each point. */
struct anchor sticking_force(int point, double stiffness, double const position[2], double const velocity[2],
                             double force[2]);

#ifdef __cplusplus
}
#endif

#endif
