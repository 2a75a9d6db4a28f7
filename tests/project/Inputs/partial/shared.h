#include <memory>
struct Inner;
struct Outer {
  Outer();
  ~Outer();
  std::unique_ptr<Inner> inner;
};
inline Inner *spare() {
  extern Inner kept_elsewhere;
  return &kept_elsewhere;
}
struct Vector {
  double x;
};
inline Vector operator*(double factor, Vector const &v) { return {factor * v.x}; }
constexpr double half = 0.5;
inline Vector halved(Vector const &v) { return half * v; }
