#pragma once
struct Circle { double radius; };
inline double area(Circle const &circle) { return 3.14 * circle.radius * circle.radius; }
