#include "ros/message.h"
