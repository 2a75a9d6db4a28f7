#include "pump.h"

#include <stdio.h>

int main(int argc, char **argv)
{
    struct pump pump = {3, 4};
    double valve[2] = {0.5, 0.25};
    int i;
    (void)argv;
    for (i = 0; i < 4; i++) {
        if (i == 2) ambient = 1.5;
        printf("%.17g %.17g\n", stroke(&pump, valve, argc + 1), pump.volume);
    }
    return 0;
}
