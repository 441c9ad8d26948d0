#include "ros/console.h"
