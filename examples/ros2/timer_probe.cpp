// One or two timers under an executor of your choice. Prints when each call was
// due and when it came, and then how long it took.
//
// Parameters: period (s); block (s), how long a call of the first timer takes;
// block_call, the number of the call that does, 0 for each; blocks, how long (s)
// the first, the second... call takes; wait (s), before the spin; second_timer
// (bool), with second_period and second_block (s); wall (bool), for timers of
// create_wall_timer; executor (spin, multi); threads; group (default,
// own, reentrant).

#include <atomic>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "rclcpp/rclcpp.hpp"

using rclcpp::CallbackGroupType;
using Seconds = std::chrono::duration<double>;

class TimerProbe : public rclcpp::Node
{
public:
  TimerProbe() : Node("timer_probe")
  {
    double period = declare_parameter("period", 0.5);
    double block = declare_parameter("block", 0.0);
    int block_call = declare_parameter("block_call", 0);
    auto blocks = declare_parameter("blocks", std::vector<double>());
    wall_ = declare_parameter("wall", false);
    std::string group = declare_parameter("group", "default");
    if (group != "default")
    {
      first_group_ = second_group_ = create_callback_group(
          group == "own" ? CallbackGroupType::MutuallyExclusive
                         : CallbackGroupType::Reentrant);
    }
    if (group == "own")
    {
      second_group_ =
          create_callback_group(CallbackGroupType::MutuallyExclusive);
    }

    start_ = now().seconds();
    if (wall_)
      start_ = rclcpp::Clock(RCL_STEADY_TIME).now().seconds();
    std::printf("start,0\n");
    std::fflush(stdout);
    first_timer_ = start("timerCallback", period, first_group_,
        [=](int number)
        {
          if (number <= static_cast<int>(blocks.size()))
            return blocks[number - 1];
          return block_call == 0 || block_call == number ? block : 0.0;
        });
    if (declare_parameter("second_timer", false))
    {
      double second_block = declare_parameter("second_block", 0.0);
      second_timer_ = start("secondCallback",
          declare_parameter("second_period", period), second_group_,
          [=](int) { return second_block; });
    }
  }

private:
  template<typename Duration>
  rclcpp::TimerBase::SharedPtr start(const char* source, double period,
      rclcpp::CallbackGroup::SharedPtr group, Duration duration)
  {
    auto calls = std::make_shared<std::atomic<int>>(0);
    auto callback = [=](const rclcpp::TimerInfo& info)
    {
      int number = ++*calls;
      std::printf("tick,%s,%d,%.6f,%.6f\n", source, number,
          info.expected_call_time.seconds() - start_,
          info.actual_call_time.seconds() - start_);
      std::fflush(stdout);
      auto begun = std::chrono::steady_clock::now();
      std::this_thread::sleep_for(Seconds(duration(number)));
      Seconds took = std::chrono::steady_clock::now() - begun;
      std::printf("done,%s,%d,%.6f\n", source, number, took.count());
      std::fflush(stdout);
    };
    if (wall_)
      return create_wall_timer(Seconds(period), callback, group);
    return create_timer(Seconds(period), callback, group);
  }

  bool wall_;
  double start_;
  rclcpp::CallbackGroup::SharedPtr first_group_, second_group_;
  rclcpp::TimerBase::SharedPtr first_timer_, second_timer_;
};

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<TimerProbe>();
  std::string executor = node->declare_parameter("executor", "spin");
  int threads = node->declare_parameter("threads", 4);
  std::this_thread::sleep_for(Seconds(node->declare_parameter("wait", 0.0)));

  std::unique_ptr<rclcpp::Executor> spinner;
  if (executor == "multi")
  {
    spinner = std::make_unique<rclcpp::executors::MultiThreadedExecutor>(
        rclcpp::ExecutorOptions(), threads);
  }
  else
  {
    spinner = std::make_unique<rclcpp::executors::SingleThreadedExecutor>();
  }
  spinner->add_node(node);
  spinner->spin();
  return 0;
}
