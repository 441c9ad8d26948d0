// A stand-in for rclcpp on the run's clock.
#ifndef ROSSPIN_RCLCPP_RCLCPP_HPP
#define ROSSPIN_RCLCPP_RCLCPP_HPP

#include <cinttypes>
#include <csignal>
#include <iomanip>
#include <iostream>
#include <memory>

#include "rclcpp/parameter_client.hpp"
#include "rclcpp/parameter_event_handler.hpp"
#include "rclcpp/wait_set.hpp"
#include "rcutils/cmdline_parser.h"
#include "rcutils/logging_macros.h"

#endif
