#include "ros/time.h"
