// Prints when each pass of a ros::Rate loop begins, in the columns of
// examples/recordings.
//
// Parameters: ~period (s); ~block (s), how long a pass takes; ~block_call, the
// number of the pass that does, 0 for every pass.

#include <cstdio>

#include "ros/ros.h"

int main(int argc, char* argv[])
{
  ros::init(argc, argv, "rate_probe");
  ros::NodeHandle nh("~");
  ros::Duration period(nh.param("period", 0.5));
  ros::WallDuration block(nh.param("block", 0.0));
  int block_call = nh.param("block_call", 0);
  ros::Time last_expected, last_real;
  double last_duration = 0.0;

  ros::Rate rate(period);
  ros::Time start = ros::Time::now();
  std::printf("start,%.6f\n", start.toSec());
  for (int number = 1; ros::ok(); number++)
  {
    ros::Time real = ros::Time::now();
    ros::Time expected = start + period * (number - 1);
    if (number == 1)
      std::printf(
          "Rate,%d,,,%.6f,%.6f,\n", number, expected.toSec(), real.toSec());
    else
      std::printf("Rate,%d,%.6f,%.6f,%.6f,%.6f,%.6f\n", number,
          last_expected.toSec(), last_real.toSec(), expected.toSec(),
          real.toSec(), last_duration);
    std::fflush(stdout);
    if (block_call == 0 || block_call == number)
      block.sleep();
    last_expected = expected;
    last_real = real;
    last_duration = (ros::Time::now() - real).toSec();
    rate.sleep();
  }
  return 0;
}
