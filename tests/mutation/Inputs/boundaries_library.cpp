struct Spring {
  double stiffness;
  bool is_stiff() const;
};
bool Spring::is_stiff() const { return stiffness > 5; }
