"""Random kernels in C and C++: see ../run.py."""
