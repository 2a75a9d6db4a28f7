#ifdef __cplusplus
extern "C" {
#endif
double scale(double x);
#ifdef __cplusplus
}
double offset(double x);
#endif
