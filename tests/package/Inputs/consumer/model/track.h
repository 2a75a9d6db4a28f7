#pragma once
inline constexpr double offset = 0.5;
double track(double position, double rate);
