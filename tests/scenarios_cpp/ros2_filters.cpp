// Scenarios for message_filters of ROS 2; the first argument names one. What is approximate gives what it gave in ROS 1.

#include <cstdio>
#include <functional>
#include <geometry_msgs/msg/point_stamped.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>
#include <map>
#include <memory>
#include <message_filters/cache.hpp>
#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/approximate_time.hpp>
#include <message_filters/synchronizer.hpp>
#include <message_filters/sync_policies/latest_time.h>
#include <message_filters/time_sequencer.h>
#include <message_filters/time_synchronizer.h>
#include <rclcpp/rclcpp.hpp>
#include <string>

namespace
{
typedef geometry_msgs::msg::PointStamped Point;
typedef geometry_msgs::msg::TwistStamped Twist;

void say(const std::string& what)
{
  std::puts(what.c_str());
  std::fflush(stdout);
}

template<class M>
std::string at(const M& message)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.2f", rclcpp::Time(message.header.stamp).seconds());
  return text;
}

template<class M>
std::shared_ptr<M> stamped(double time)
{
  auto message = std::make_shared<M>();
  message->header.stamp = rclcpp::Time(std::llround((100.0 + time) * 1e9));
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

void both(const Point::ConstSharedPtr& point, const Twist::ConstSharedPtr& twist) { say(at(*point) + " with " + at(*twist)); }
void three(const Point::ConstSharedPtr& one, const Twist::ConstSharedPtr& two, const Point::ConstSharedPtr& other)
{
  say(at(*one) + " with " + at(*two) + " and " + at(*other));
}
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
    say("seed " + std::to_string(seed));
    give(sync, seed, in_order);
  }
}

typedef std::map<std::string, std::function<void(rclcpp::Node::SharedPtr)>> Scenarios;

class Hears
{
public:
  explicit Hears(rclcpp::Node::SharedPtr node) : points_(node, "points"), sync_(points_, twists_, 10)
  {
    twists_.subscribe(node.get(), "twists", rmw_qos_profile_sensor_data);
    sync_.registerCallback(&Hears::hear, this);
    sync_.registerCallback(std::bind(&Hears::hear_pointers, this, std::placeholders::_1, std::placeholders::_2));
    say(twists_.getTopic() + " " + points_.getSubscriber()->get_topic_name());
  }
  message_filters::Subscriber<Point> points_;

private:
  void hear(const Point& point, const Twist& twist) { say(at(point) + " with " + at(twist)); }
  void hear_pointers(const Point::ConstSharedPtr& point, Twist::ConstSharedPtr twist) { both(point, twist); }
  message_filters::Subscriber<Twist> twists_;
  message_filters::TimeSynchronizer<Point, Twist> sync_;
};

Scenarios scenarios()
{
  using rclcpp::Duration;
  typedef rclcpp::Node::SharedPtr Node;
  typedef message_filters::Synchronizer<OfThree> Sync;
  Scenarios all;
  all["subscribers"] = [](Node node)
  {
    Hears hears(node);
    auto point = node->create_publisher<Point>("points", 10);
    auto twist = node->create_publisher<Twist>("twists", 10);
    for (int each = 0; each < 6; each++)
    {
      point->publish(*stamped<Point>(each));
      if (each % 2 == 0)
        twist->publish(*stamped<Twist>(each));
      rclcpp::sleep_for(std::chrono::milliseconds(100));
      rclcpp::spin_some(node);
      if (each == 3)
        hears.points_.unsubscribe();
      if (each == 4)
        hears.points_.subscribe();
    }
  };
  all["cache"] = [](Node)
  {
    message_filters::Cache<Point> cache(3);
    cache.registerCallback([](const Point::ConstSharedPtr& point) { say("passed " + at(*point)); });
    for (double time : {1.0, 3.0, 2.0, 5.0})
      cache.add(stamped<Point>(time));
    auto time = [](double seconds) { return rclcpp::Time(std::llround((100.0 + seconds) * 1e9), RCL_ROS_TIME); };
    for (const Point::ConstSharedPtr& each : cache.getInterval(time(2.0), time(4.0)))
      say("between 2 and 4 " + at(*each));
    say(at(*cache.getElemBeforeTime(time(3.0))) + " " + at(*cache.getElemAfterTime(time(3.0))));
    std::printf("%.2f %.2f\n", cache.getOldestTime().seconds(), cache.getLatestTime().seconds());
  };
  all["chain"] = [](Node)
  {
    message_filters::Chain<Point> chain;
    chain.registerCallback([](const Point::ConstSharedPtr& point) { say("passed " + at(*point)); });
    chain.add(stamped<Point>(1));
    auto cache = std::make_shared<message_filters::Cache<Point>>(2);
    message_filters::PassThrough<Point> plain;
    say(std::to_string(chain.addFilter(cache)));
    say(std::to_string(chain.addFilter(&plain)));
    plain.registerCallback([](const Point::ConstSharedPtr& point) { say("second " + at(*point)); });
    chain.add(stamped<Point>(2));
    plain.add(stamped<Point>(3));
    message_filters::PassThrough<Point> input;
    chain.connectInput(input);
    input.add(stamped<Point>(4));
    say(at(*chain.getFilter<message_filters::Cache<Point>>(0)->getElemBeforeTime(rclcpp::Time(200, 0, RCL_ROS_TIME))));
    say(chain.getFilter<message_filters::PassThrough<Point>>(2) ? "one" : "none");
  };
  all["latest"] = [](Node)
  {
    typedef message_filters::sync_policies::LatestTime<Point, Twist> OfLatest;
    message_filters::Synchronizer<OfLatest> sync(OfLatest{});
    sync.registerCallback(both);
    // The first comes each 0.05 s, with a pause, the second each 0.2 s, then as often.
    for (int each = 0; each < 60; each++)
    {
      if (each < 25 || each > 40)
        sync.add<0>(stamped<Point>(each));
      if (each % (each < 30 ? 4 : 1) == 0)
        sync.add<1>(stamped<Twist>(each));
      rclcpp::sleep_for(std::chrono::milliseconds(50));
    }
  };
  all["sequencer"] = [](Node node)
  {
    message_filters::TimeSequencer<Point> sequencer(Duration::from_seconds(0.5), Duration::from_seconds(0.2), 4, node);
    try
    {
      sequencer.add(stamped<Point>(0));
    }
    catch (const std::runtime_error& error)
    {
      say(error.what());  // it compares a time of the system's with one of ROS
    }
  };
  all["approximate_by_chance"] = [](Node) { by_chance([](Sync&, unsigned) {}); };
  all["approximate_within_a_time"] = [](Node)
  { by_chance([](Sync& sync, unsigned) { sync.setMaxIntervalDuration(Duration::from_seconds(0.1)); }); };
  all["approximate_with_bounds"] = [](Node)
  {
    by_chance([](Sync& sync, unsigned seed)
        {
          sync.setInterMessageLowerBound(Duration::from_seconds(0.05));
          sync.setInterMessageLowerBound(1, Duration::from_seconds(0.02 * seed));
        });
  };
  all["approximate_in_a_hurry"] = [](Node) { by_chance([](Sync& sync, unsigned seed) { sync.setAgePenalty(seed); }); };
  all["approximate_out_of_order"] = [](Node) { by_chance([](Sync&, unsigned) {}, false); };
  return all;
}
}  // namespace

int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  auto all = scenarios();
  std::string name = argc > 1 ? argv[1] : "";
  if (!all.count(name))
  {
    for (const auto& each : all)
      std::puts(each.first.c_str());
    return 2;
  }
  all[name](std::make_shared<rclcpp::Node>("scenario"));
  rclcpp::shutdown();
  return 0;
}
