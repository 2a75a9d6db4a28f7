double gain(int n);
