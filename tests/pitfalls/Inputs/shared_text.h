/* A template of C: the numbers are BASE, the names begin with PREFIX. */
#define JOINED(one, other) one##_##other
#define NAMED(one, other) JOINED(one, other)
#define NAME(other) NAMED(PREFIX, other)

static void NAME(third)(double x, BASE *y)
{
    BASE *copy = malloc(sizeof *copy);
    if (copy == NULL) return;
    *copy = x / 3;
    *y = *copy;
    *y += sin(*copy) - x;
    free(copy);
}

#undef JOINED
#undef NAMED
#undef NAME
