#ifdef __cplusplus
extern "C"
#endif
    double
    drag(double v);
