namespace motor {
void torque(double const *current, double *torque, int phases) {
  *torque = 0;
  for (int i = 0; i < phases; ++i) *torque += current[i] * current[(i + 1) % phases];
}
} // namespace motor
