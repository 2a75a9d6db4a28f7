static int met = 0;
struct Shape {
  virtual ~Shape() = default;
  virtual double area(double x) const { return x; }
};
struct Disc : Shape {
  double area(double x) const override { return scaled(x) * 3.0; }
  static double scaled(double x) {
    ++met;
    return x * x;
  }
};
double twice(Shape const &shape, double x) { return shape.area(x) * 2; }
