// A stand-in for rclcpp on the run's clock.
#ifndef ROSSPIN_RCLCPP_RCLCPP_HPP
#define ROSSPIN_RCLCPP_RCLCPP_HPP

#include <csignal>
#include <iomanip>
#include <iostream>
#include <memory>

#include "rclcpp/executors.hpp"
#include "rcutils/cmdline_parser.h"
#include "rcutils/logging_macros.h"

#endif
