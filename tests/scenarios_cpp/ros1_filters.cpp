// Scenarios for message_filters of ROS 1, one for each run: ~scenario says which.

#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <message_filters/cache.h>
#include <message_filters/chain.h>
#include <message_filters/pass_through.h>
#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/approximate_time.h>
#include <message_filters/sync_policies/exact_time.h>
#include <message_filters/synchronizer.h>
#include <message_filters/time_sequencer.h>
#include <message_filters/time_synchronizer.h>

#include "ros1.hpp"

namespace
{
typedef geometry_msgs::PointStamped Point;
typedef geometry_msgs::TwistStamped Twist;

void print(const std::string& what)
{
  std::puts(what.c_str());
  std::fflush(stdout);
}

template<class M>
std::string at(const M& message)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.2f", message.header.stamp.toSec());
  return text;
}

template<class M>
boost::shared_ptr<M> stamped(double time)
{
  boost::shared_ptr<M> message(new M);
  message->header.stamp = ros::Time(100.0 + time);
  return message;
}

// Numbers by chance, and always the same.
struct Chance
{
  unsigned state;
  unsigned operator()(unsigned below)
  {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) % below;
  }
};

void both(const Point::ConstPtr& point, const Twist::ConstPtr& twist) { print(at(*point) + " with " + at(*twist)); }
void three(const Point::ConstPtr& one, const Twist::ConstPtr& two, const Point::ConstPtr& other)
{
  print(at(*one) + " with " + at(*two) + " and " + at(*other));
}
void dropped(const Point::ConstPtr& point, const Twist::ConstPtr& twist)
{
  print("dropped " + (point ? at(*point) : "none") + " and " + (twist ? at(*twist) : "none"));
}

struct Sink
{
  std::string name;
  void both(const Point::ConstPtr& point, const Twist::ConstPtr& twist) { print(name + ": " + at(*point) + " " + at(*twist)); }
  void one(const Point::ConstPtr& point) { print(name + ": " + at(*point)); }
  void event(const ros::MessageEvent<Point const>& event) { print(name + ": event " + at(*event.getMessage())); }
};

typedef message_filters::sync_policies::ApproximateTime<Point, Twist> OfTwo;
typedef message_filters::sync_policies::ApproximateTime<Point, Twist, Point> OfThree;

// Give three topics messages by chance: their periods are alike, their stamps are not.
void give(message_filters::Synchronizer<OfThree>& sync, unsigned seed, bool in_order)
{
  Chance chance{seed};
  double times[3] = {0, 0, 0};
  for (int each = 0; each < 60; each++)
  {
    unsigned topic = chance(3);
    times[topic] += 0.01 * (in_order ? chance(20) : chance(24) - 4.0);
    if (topic == 0)
      sync.add<0>(stamped<Point>(times[0]));
    else if (topic == 1)
      sync.add<1>(stamped<Twist>(times[1]));
    else
      sync.add<2>(stamped<Point>(times[2]));
  }
}

void by_chance(std::function<void(message_filters::Synchronizer<OfThree>&, unsigned)> set, bool in_order = true)
{
  for (unsigned seed = 1; seed < 6; seed++)
  {
    message_filters::Synchronizer<OfThree> sync(OfThree(seed == 1 ? 2 : 5 + seed));
    sync.registerCallback(three);
    set(sync, seed);
    print("seed " + std::to_string(seed));
    give(sync, seed, in_order);
  }
}

Scenarios scenarios()
{
  using ros::NodeHandle;
  Scenarios all;
  all["subscribers"] = [](NodeHandle& nh)
  {
    message_filters::Subscriber<Point> points(nh, "points", 10);
    message_filters::Subscriber<Twist> twists(nh, "twists", 10);
    message_filters::TimeSynchronizer<Point, Twist> sync(points, twists, 10);
    sync.registerCallback(boost::bind(&both, _1, _2));
    points.registerCallback([](const Point::ConstPtr& point) { print("point " + at(*point)); });
    ros::Publisher point = nh.advertise<Point>("points", 10), twist = nh.advertise<Twist>("twists", 10);
    for (int each = 0; each < 6; each++)
    {
      point.publish(stamped<Point>(each));
      if (each % 2 == 0)
        twist.publish(stamped<Twist>(each));
      ros::Duration(0.1).sleep();
      ros::spinOnce();
      if (each == 3)
        points.unsubscribe();
      if (each == 4)
        points.subscribe();
    }
    print(points.getTopic() + " " + twists.getTopic());
  };
  all["exact"] = [](NodeHandle&)
  {
    message_filters::sync_policies::ExactTime<Point, Twist> policy(3);
    message_filters::Synchronizer<message_filters::sync_policies::ExactTime<Point, Twist>> sync(
        static_cast<const message_filters::sync_policies::ExactTime<Point, Twist>&>(policy));
    sync.registerCallback(both);
    sync.registerDropCallback(dropped);
    for (double time : {1.0, 2.0, 3.0, 4.0, 5.0})
      sync.add<0>(stamped<Point>(time));
    for (double time : {2.5, 4.0, 4.0, 3.0, 5.0, 6.0, 7.0, 8.0, 9.0})
      sync.add<1>(stamped<Twist>(time));
    sync.add<0>(stamped<Point>(8.0));
  };
  all["exact_without_a_limit"] = [](NodeHandle&)
  {
    message_filters::TimeSynchronizer<Point, Twist> sync(0u);
    sync.registerCallback(both);
    for (int each = 0; each < 50; each++)
      sync.add<0>(stamped<Point>(each));
    sync.add1(stamped<Twist>(3));
  };
  all["callbacks"] = [](NodeHandle&)
  {
    message_filters::TimeSynchronizer<Point, Twist> sync(10);
    Sink sink{"sink"}, other{"other"};
    sync.registerCallback(&Sink::both, &sink);
    message_filters::Connection connection = sync.registerCallback(boost::bind(&Sink::both, &other, _1, _2));
    sync.registerCallback(both);
    sync.add<0>(stamped<Point>(1));
    sync.add<1>(stamped<Twist>(1));
    connection.disconnect();
    sync.add<0>(stamped<Point>(2));
    sync.add<1>(stamped<Twist>(2));
  };
  all["passed_through"] = [](NodeHandle&)
  {
    message_filters::PassThrough<Point> first;
    message_filters::PassThrough<Point> second(first);
    Sink sink{"sink"}, other{"other"};
    first.registerCallback(&Sink::one, &sink);
    second.registerCallback(&Sink::event, &other);
    first.add(stamped<Point>(1));
    second.add(stamped<Point>(2));
  };
  all["cache"] = [](NodeHandle&)
  {
    message_filters::PassThrough<Point> in;
    message_filters::Cache<Point> cache(in, 4);
    Sink sink{"sink"};
    cache.registerCallback(&Sink::one, &sink);
    print(at(Point()) + " " + std::to_string(cache.getLatestTime().toSec()));
    for (double time : {1.0, 3.0, 2.0, 5.0, 4.0, 4.5})
      in.add(stamped<Point>(time));
    auto tell = [](const std::string& what, const std::vector<Point::ConstPtr>& found)
    {
      std::string line = what;
      for (const Point::ConstPtr& each : found)
        line += " " + at(*each);
      print(line);
    };
    auto time = [](double seconds) { return ros::Time(100.0 + seconds); };
    tell("all", cache.getInterval(time(0), time(9)));
    tell("from 3 to 4.5", cache.getInterval(time(3), time(4.5)));
    tell("around 3.5 to 4.2", cache.getSurroundingInterval(time(3.5), time(4.2)));
    tell("around 0 to 9", cache.getSurroundingInterval(time(0), time(9)));
    tell("before 4", {cache.getElemBeforeTime(time(4))});
    tell("after 4", {cache.getElemAfterTime(time(4))});
    print(cache.getElemBeforeTime(time(0)) ? "one" : "none");
    print(cache.getElemAfterTime(time(9)) ? "one" : "none");
    print(std::to_string(cache.getOldestTime().toSec()) + " " + std::to_string(cache.getLatestTime().toSec()));
  };
  all["chain"] = [](NodeHandle&)
  {
    message_filters::Chain<Point> chain;
    chain.registerCallback([](const Point::ConstPtr& point) { print("passed " + at(*point)); });
    chain.add(stamped<Point>(1));
    auto cache = boost::make_shared<message_filters::Cache<Point>>(2);
    message_filters::PassThrough<Point> plain;
    print(std::to_string(chain.addFilter(cache)));
    print(std::to_string(chain.addFilter(&plain)));
    plain.registerCallback([](const Point::ConstPtr& point) { print("second " + at(*point)); });
    chain.add(stamped<Point>(2));
    plain.add(stamped<Point>(3));
    message_filters::PassThrough<Point> input;
    chain.connectInput(input);
    input.add(stamped<Point>(4));
    print(at(*chain.getFilter<message_filters::Cache<Point>>(0)->getElemBeforeTime(ros::Time(200))));
    print(chain.getFilter<message_filters::PassThrough<Point>>(2) ? "one" : "none");
  };
  all["sequencer"] = [](NodeHandle& nh)
  {
    message_filters::PassThrough<Point> input;
    message_filters::TimeSequencer<Point> sequencer(input, ros::Duration(0.5), ros::Duration(0.2), 4, nh);
    ros::Time begun = ros::Time::now();
    sequencer.registerCallback([=](const Point::ConstPtr& point)
        { std::printf("passed %.2f of %g\n", (point->header.stamp - begun).toSec(), point->point.x); });
    int number = 0;
    auto give = [&](double stamp)
    {
      Point::Ptr point(new Point);
      point->header.stamp = begun + ros::Duration(stamp);
      point->point.x = number++;
      input.add(point);
    };
    for (double stamp : {0.35, 0.05, 0.25, 0.25})
      give(stamp);
    ros::Timer late = nh.createTimer(ros::Duration(1.1), [&](const ros::TimerEvent&)
        {
          print("too late, or too many");
          for (double stamp : {0.1, 0.95, 0.95, 1.05, 1.15, 1.25})
            give(stamp);
        }, true);
    ros::spin();
  };
  all["approximate"] = [](NodeHandle&)
  {
    message_filters::Synchronizer<OfTwo> sync(OfTwo(10));
    sync.registerCallback(both);
    for (int each = 0; each < 8; each++)
    {
      sync.add<0>(stamped<Point>(0.5 * each));
      sync.add<1>(stamped<Twist>(0.5 * each + 0.1));
    }
    for (int each = 0; each < 8; each++)
      sync.add<0>(stamped<Point>(5 + 0.5 * each));
    sync.add<1>(stamped<Twist>(6.7));
    sync.add<1>(stamped<Twist>(7.9));
  };
  all["approximate_by_chance"] = [](NodeHandle&) { by_chance([](message_filters::Synchronizer<OfThree>&, unsigned) {}); };
  all["approximate_within_a_time"] = [](NodeHandle&)
  {
    by_chance([](message_filters::Synchronizer<OfThree>& sync, unsigned)
        { sync.setMaxIntervalDuration(ros::Duration(0.1)); });
  };
  all["approximate_with_bounds"] = [](NodeHandle&)
  {
    by_chance([](message_filters::Synchronizer<OfThree>& sync, unsigned seed)
        {
          sync.setInterMessageLowerBound(ros::Duration(0.05));
          sync.setInterMessageLowerBound(1, ros::Duration(0.02 * seed));
        });
  };
  all["approximate_in_a_hurry"] = [](NodeHandle&)
  {
    by_chance([](message_filters::Synchronizer<OfThree>& sync, unsigned seed) { sync.setAgePenalty(seed); });
  };
  all["approximate_out_of_order"] = [](NodeHandle&)
  {
    by_chance([](message_filters::Synchronizer<OfThree>&, unsigned) {}, false);
  };
  return all;
}
}  // namespace

int main(int argc, char** argv) { return run(argc, argv); }
