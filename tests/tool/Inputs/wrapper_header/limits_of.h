#pragma once
constexpr double least = 0.5;
