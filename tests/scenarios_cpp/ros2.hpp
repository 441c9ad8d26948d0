// What the scenarios for rclcpp share. Each line that they print begins with the time since the start, in s, to the nearest
// tenth.

#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <thread>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int32.hpp"

using namespace std::chrono_literals;
using rclcpp::Node;
using std_msgs::msg::UInt32;

namespace
{
std::chrono::steady_clock::time_point begun;

void say(const std::string& what)
{
  double now = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  std::printf("%.1f %s\n", now + 1e-9, what.c_str());
  std::fflush(stdout);
}

void work(std::chrono::milliseconds time) { std::this_thread::sleep_for(time); }

template<class T>
std::string shown(const T& value)
{
  std::stringstream stream;
  stream << value;
  return stream.str();
}

// What an exception says, on one line.
template<class Function>
void attempt(Function function)
{
  try
  {
    function();
    say("nothing thrown");
  }
  catch (const std::exception& error)
  {
    std::string text = error.what();
    say("thrown: " + text.substr(0, text.find('\n')));
  }
}

UInt32 number(unsigned value)
{
  UInt32 message;
  message.data = value;
  return message;
}

typedef std::shared_ptr<Node> Shared;
typedef std::function<void(const Shared&)> Scenario;

std::map<std::string, Scenario> scenarios();
}  // namespace

int main(int argc, char* argv[])
{
  auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  begun = std::chrono::steady_clock::now();
  auto node = std::make_shared<Node>("s");
  auto all = scenarios();
  if (words.size() < 2)
  {
    for (const auto& each : all)
      std::printf("%s\n", each.first.c_str());
    return 0;
  }
  all.at(words[1])(node);
  return 0;
}
