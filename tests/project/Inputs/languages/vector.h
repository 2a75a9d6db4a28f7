// For both languages, as it says itself.
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

typedef struct vector { double x, y; } vector;
vector rotated(vector v);

#ifdef __cplusplus
}
static inline vector operator+(vector v, vector w) { v.x += w.x; v.y += w.y; return v; }
static inline vector operator-(vector v) { v.x = -v.x; v.y = -v.y; return v; }
static inline vector operator-(vector v, vector w) { return v + -w; }
#endif
