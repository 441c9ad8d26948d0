// What the scenarios for roscpp share. Each line that they print begins with the time since the start, in s, to the nearest
// tenth.

#pragma once

#include <cstdio>
#include <functional>
#include <map>
#include <ros/ros.h>
#include <sstream>
#include <std_msgs/UInt32.h>
#include <string>

namespace
{
ros::WallTime begun;

void say(const std::string& what)
{
  std::printf("%.1f %s\n", (ros::WallTime::now() - begun).toSec() + 1e-9, what.c_str());
  std::fflush(stdout);
}

void work(double seconds) { ros::WallDuration(seconds).sleep(); }

template<class T>
std::string shown(const T& value)
{
  std::stringstream stream;
  stream << value;
  return stream.str();
}

std_msgs::UInt32 number(unsigned value)
{
  std_msgs::UInt32 message;
  message.data = value;
  return message;
}

typedef std::map<std::string, std::function<void(ros::NodeHandle&)>> Scenarios;

Scenarios scenarios();

// Runs the scenario that ~scenario names; prints the names of all if there is none.
int run(int argc, char** argv, const std::function<void()>& prepare = [] {})
{
  ros::init(argc, argv, "scenario");
  prepare();
  ros::NodeHandle nh("~");
  begun = ros::WallTime::now();
  Scenarios all = scenarios();
  auto found = all.find(nh.param<std::string>("scenario", ""));
  if (found == all.end())
  {
    for (const auto& each : all)
      std::puts(each.first.c_str());
    return 2;
  }
  found->second(nh);
  return 0;
}
}  // namespace
