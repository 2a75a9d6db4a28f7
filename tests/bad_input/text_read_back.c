/* Text of a symbolic value that the kernel reads again is that of one run. */
// RUN: %same %s && rm -f %t.c
// RUN: not %symreal generate %s -o %t.c --kernel=parsed --run-args=parsed 2>&1 | FileCheck %s
// RUN: not %symreal generate %s -o %t.c --kernel=looked --run-args=looked 2>&1 | FileCheck %s --check-prefix=LOOKED
// RUN: not %symreal generate %s -o %t.c --kernel=filed --run-args=filed 2>&1 | FileCheck %s --check-prefix=FILED
// RUN: not ls %t.c
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#pragma symreal function input(x) output(return)
double parsed(double x)
{
    char b[40], copy[40];
    double y, z = 0;
    sprintf(b, "%.3f", x);
    // CHECK: text_read_back.c:[[@LINE+1]]:14: error: 'b' is read, which holds the text of x [SYM143]
    y = atof(b);
    // CHECK: text_read_back.c:[[@LINE+1]]:12: error: 'b' is read, which holds the text of x [SYM143]
    sscanf(b, "%lf", &z);
    strcpy(copy, b);
    // CHECK: text_read_back.c:[[@LINE+1]]:17: error: 'copy' is read, which holds the text of x [SYM143]
    y += strtod(copy, NULL);
    sprintf(copy, "<%s>", b);
    // CHECK: text_read_back.c:[[@LINE+1]]:16: error: 'copy' is read, which holds the text of x [SYM143]
    if (strcmp(copy, "<5.300>") == 0) y += 1;
    sprintf(b, "%d", (int)x);
    // CHECK: text_read_back.c:[[@LINE+1]]:15: error: 'b + 0' is read, which holds the text of {{.*}} [SYM143]
    y += atoi(b + 0);
    return y + z + x;
}

#pragma symreal function input(x) output(return)
double looked(double x)
{
    char b[40], c[40];
    double y = x;
    // LOOKED: text_read_back.c:[[@LINE+1]]:13: error: the length that is used here is that of the text of x * x [SYM143]
    int n = sprintf(b, "%g", x * x);
    y += n;
    // LOOKED: text_read_back.c:[[@LINE+1]]:9: error: 'b[0]' is read, which holds the text of x * x [SYM143]
    if (b[0] == '-') y = -y;
    // LOOKED: text_read_back.c:[[@LINE+1]]:10: error: the length that is used here is that of the text of x [SYM143]
    y += snprintf(NULL, 0, "%g", x);
    strcpy(c, b);
    // LOOKED: text_read_back.c:[[@LINE+1]]:9: error: '*c' is read, which holds the text of x * x [SYM143]
    if (*c == '+') y = -y;
    // LOOKED: text_read_back.c:[[@LINE+1]]:17: error: 'b' is read, which holds the text of x * x [SYM143]
    y += strlen(b);
    return y;
}

#pragma symreal function input(x) output(return)
double filed(double x)
{
    char line[40];
    double y = 0, z = 0;
    FILE *file = tmpfile();
    fprintf(file, "%.2f\n%.2f\n", x, 2 * x);
    rewind(file);
    // FILED: text_read_back.c:[[@LINE+1]]:16: error: 'file' is read, which holds the text of {{.*}}x{{.*}} [SYM143]
    if (fscanf(file, "%lf", &y) != 1) return 0;
    // FILED: text_read_back.c:[[@LINE+1]]:25: error: 'file' is read, which holds the text of {{.*}}x{{.*}} [SYM143]
    if (fgets(line, 40, file)) z = x;
    fclose(file);
    return y + z;
}

int main(int count, char **names)
{
    if (count > 1 && strcmp(names[1], "parsed") == 0) printf("%g\n", parsed(5.3));
    if (count > 1 && strcmp(names[1], "looked") == 0) printf("%g\n", looked(5.3));
    if (count > 1 && strcmp(names[1], "filed") == 0) printf("%g\n", filed(5.3));
    return 0;
}
