#include "track.h"

int main() { return track(1, 2) > 0 ? 0 : 1; }
