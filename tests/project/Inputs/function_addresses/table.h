#ifdef __cplusplus
extern "C" {
#endif
typedef double (*unary)(double);
extern unary const functions[3];
int is_sine(unary f);
#ifdef __cplusplus
}
#endif
