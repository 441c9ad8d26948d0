// A Rate loop in main, where nobody spins. Prints when each pass was due by the
// grid and when it began, then how long it took, and when sleep() returns false.
//
// Parameters: period (s); block (s), how long a pass takes; block_call, the
// number of the pass that does, 0 for each; blocks, how long (s) the first, the
// second... pass takes.

#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>
#include <vector>

#include "rclcpp/rclcpp.hpp"

using Seconds = std::chrono::duration<double>;

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("rate_probe");
  double period = node->declare_parameter("period", 0.5);
  double block = node->declare_parameter("block", 0.0);
  int block_call = node->declare_parameter("block_call", 0);
  auto blocks = node->declare_parameter("blocks", std::vector<double>());

  std::printf("start,0\n");
  std::fflush(stdout);
  auto start = std::chrono::steady_clock::now();
  auto since_start = [&start]
  {
    return Seconds(std::chrono::steady_clock::now() - start).count();
  };
  rclcpp::Rate rate(1.0 / period);
  for (int number = 1; rclcpp::ok(); number++)
  {
    double begun = since_start();
    std::printf(
        "tick,Rate,%d,%.6f,%.6f\n", number, (number - 1) * period, begun);
    std::fflush(stdout);
    if (number <= static_cast<int>(blocks.size()))
      std::this_thread::sleep_for(Seconds(blocks[number - 1]));
    else if (block_call == 0 || block_call == number)
      std::this_thread::sleep_for(Seconds(block));
    std::printf("done,Rate,%d,%.6f\n", number, since_start() - begun);
    if (!rate.sleep())
      std::printf("said,%.3f,sleep() returns false\n", since_start());
    std::fflush(stdout);
  }
  return 0;
}
