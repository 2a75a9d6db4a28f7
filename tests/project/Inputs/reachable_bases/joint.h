#pragma once
class Joint {
public:
  virtual ~Joint() = 0;
  virtual double at(double q) const = 0;
};
class Revolute : public Joint {
public:
  ~Revolute() override;
  double at(double q) const override;
};
