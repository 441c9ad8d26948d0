// Says what becomes of odd timers, and when, as "said,SECONDS,WHAT".
//
// Parameters: ~kind (one_shot; exception, in a timer beside another one;
// period; rate, a loop beside a timer; rate_spin_once, one that calls
// ros::spinOnce()); ~period (s) of the timer.

#include <cstdio>
#include <stdexcept>
#include <string>

#include "ros/ros.h"

ros::WallTime start;
int calls = 0;
bool raises = false;

void say(const std::string& what)
{
  double now = (ros::WallTime::now() - start).toSec();
  std::printf("said,%.3f,%s\n", now, what.c_str());
  std::fflush(stdout);
}

void timerCallback(const ros::TimerEvent&)
{
  calls++;
  if (raises && calls == 2)
  {
    say("callback raises");
    throw std::runtime_error("in a callback");
  }
}

void otherCallback(const ros::TimerEvent&)
{
  say("other timer");
}

int main(int argc, char* argv[])
{
  ros::init(argc, argv, "claims_probe");
  ros::NodeHandle nh("~");
  std::string kind = nh.param("kind", std::string("one_shot"));
  raises = kind == "exception";
  ros::Duration period(nh.param("period", 0.5));
  start = ros::WallTime::now();
  ros::Timer timer =
      nh.createTimer(period, timerCallback, kind == "one_shot");
  ros::Timer other;
  if (raises)
    other = nh.createTimer(ros::Duration(0.4), otherCallback);

  if (kind.rfind("rate", 0) == 0)
  {
    ros::Rate rate(2.0);
    while (ros::ok())
    {
      if (kind == "rate_spin_once")
        ros::spinOnce();
      rate.sleep();
    }
  }
  else
  {
    ros::spin();
  }
  say("calls: " + std::to_string(calls));
  return 0;
}
