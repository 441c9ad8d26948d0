#include "rmw/types.h"
