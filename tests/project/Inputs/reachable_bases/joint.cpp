#include "joint.h"
Joint::~Joint() {}
