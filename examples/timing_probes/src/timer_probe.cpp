// Prints every field of every TimerEvent, in the columns of examples/recordings.
//
// Parameters: ~period (s); ~block (s), how long a callback of the first timer
// takes; ~block_call, the number of the call that does, 0 for every call;
// ~block_calls, how many calls from that one on do; ~blocks, how long (s) the
// first, the second... call takes, with commas between; ~second_timer (bool),
// one of the same period that takes no time; ~wait (s), how long main sleeps
// before it spins; ~threads, 1 for ros::spin, more for an AsyncSpinner.

#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "ros/ros.h"

class Probe
{
public:
  Probe(const std::string& source, double block, int block_call,
      int block_calls, const std::string& blocks)
    : source_(source), block_(block), block_call_(block_call),
      block_calls_(block_calls)
  {
    std::istringstream words(blocks);
    for (std::string word; std::getline(words, word, ',');)
      blocks_.push_back(std::stod(word));
  }

  void callback(const ros::TimerEvent& event)
  {
    number_++;
    char row[200];
    if (number_ == 1)
      std::snprintf(row, sizeof row, "%s,%d,,,%.6f,%.6f,", source_.c_str(),
          number_, event.current_expected.toSec(), event.current_real.toSec());
    else
      std::snprintf(row, sizeof row, "%s,%d,%.6f,%.6f,%.6f,%.6f,%.6f",
          source_.c_str(), number_, event.last_expected.toSec(),
          event.last_real.toSec(), event.current_expected.toSec(),
          event.current_real.toSec(), event.profile.last_duration.toSec());
    std::puts(row);
    std::fflush(stdout);
    int since = number_ - block_call_;
    if (number_ <= static_cast<int>(blocks_.size()))
      ros::WallDuration(blocks_[number_ - 1]).sleep();
    else if (block_call_ == 0 || (since >= 0 && since < block_calls_))
      ros::WallDuration(block_).sleep();
  }

private:
  std::string source_;
  double block_;
  int block_call_;
  int block_calls_;
  std::vector<double> blocks_;
  int number_ = 0;
};

int main(int argc, char* argv[])
{
  ros::init(argc, argv, "timer_probe");
  ros::NodeHandle nh("~");
  ros::Duration period(nh.param("period", 0.5));
  Probe first("timerCallback", nh.param("block", 0.0),
      nh.param("block_call", 0), nh.param("block_calls", 1),
      nh.param("blocks", std::string()));
  Probe second("secondCallback", 0.0, 0, 1, "");
  ros::Timer second_timer;

  std::printf("start,%.6f\n", ros::Time::now().toSec());
  std::fflush(stdout);
  ros::Timer first_timer = nh.createTimer(period, &Probe::callback, &first);
  if (nh.param("second_timer", false))
    second_timer = nh.createTimer(period, &Probe::callback, &second);

  ros::WallDuration(nh.param("wait", 0.0)).sleep();
  int threads = nh.param("threads", 1);
  if (threads == 1)
  {
    ros::spin();
  }
  else
  {
    ros::AsyncSpinner spinner(threads);
    spinner.start();
    ros::waitForShutdown();
  }
  return 0;
}
