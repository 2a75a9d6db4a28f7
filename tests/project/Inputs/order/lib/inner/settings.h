#define OFFSET 5
static char const *const where = __FILE__;
