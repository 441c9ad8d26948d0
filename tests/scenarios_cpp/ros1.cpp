// Scenarios for roscpp, one for each run: ~scenario says which. Each line begins with the time since the start, in s, to
// the nearest tenth; what a scenario does happens at times that are far from each other.

#include <boost/bind.hpp>
#include <csignal>
#include <geometry_msgs/Twist.h>
#include <ros/callback_queue.h>
#include <ros/file_log.h>
#include <std_msgs/Header.h>
#include <std_msgs/String.h>

#include "ros1.hpp"

namespace
{
std::string at(const ros::Time& time)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.1f", time.isZero() ? -1.0 : time.toSec() - begun.toSec() + 1e-9);
  return text;
}

// --- timers ---

void timer(ros::NodeHandle& nh, std::map<int, double> blocks)
{
  int number = 0;
  ros::Timer timer = nh.createTimer(ros::Duration(0.5),
      [&](const ros::TimerEvent& event)
      {
        say("tick " + std::to_string(++number) + " expected " + at(event.current_expected) + " real " +
            at(event.current_real) + " last " + at(event.last_expected) + " " + at(event.last_real));
        if (number > 1)
          say("  took " + shown(std::round(event.profile.last_duration.toSec() * 10) / 10));
        if (blocks.count(number))
          work(blocks[number]);
      });
  ros::spin();
}

struct Counter
{
  int count = 0;
  ros::Timer timer;
  void callback(const ros::TimerEvent&) { say("member " + std::to_string(++count)); }
  void constant(const ros::TimerEvent&) const { say("constant"); }
  void bound(const ros::TimerEvent&, int more) { say("bound " + std::to_string(count += more)); }
  void wall(const ros::WallTimerEvent&) { say("wall " + std::to_string(++count)); }
  void steady(const ros::SteadyTimerEvent&) { say("steady " + std::to_string(++count)); }
};

void free_callback(const ros::TimerEvent&) { say("free"); }

// --- topics ---

void hear(const std_msgs::UInt32::ConstPtr& message) { say("heard " + std::to_string(message->data)); }
void hear_reference(const std_msgs::UInt32& message) { say("reference " + std::to_string(message.data)); }
void hear_event(const ros::MessageEvent<std_msgs::UInt32 const>& event)
{
  say("event " + std::to_string(event.getMessage()->data) + " of " + event.getPublisherName());
}

struct Listener
{
  std::string name;
  double takes = 0;
  void hear(const std_msgs::UInt32ConstPtr& message)
  {
    say(name + " " + std::to_string(message->data));
    work(takes);
  }
};

void slow(ros::NodeHandle& nh, unsigned queue_size)
{
  Listener listener{"slow", 0.75};
  ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("slow", 100);
  ros::Subscriber subscriber = nh.subscribe("slow", queue_size, &Listener::hear, &listener);
  ros::Timer once = nh.createTimer(ros::Duration(0.2),
      [&](const ros::TimerEvent&)
      {
        for (unsigned each = 0; each < 8; each++)
          publisher.publish(number(each));
        work(0.2);
      },
      true);
  ros::Timer timer = nh.createTimer(ros::Duration(1.0), [](const ros::TimerEvent&) { say("beside"); });
  ros::spin();
}

void (*at_init)(int);
void interrupted(int) {}

Scenarios scenarios()
{
  using ros::Duration;
  using ros::NodeHandle;
  using ros::TimerEvent;
  Scenarios all;

  all["timer"] = [](NodeHandle& nh) { timer(nh, {}); };
  all["timer_blocks_0.7"] = [](NodeHandle& nh) { timer(nh, {{2, 0.7}}); };
  all["timer_blocks_1.2"] = [](NodeHandle& nh) { timer(nh, {{2, 1.2}}); };
  all["timer_blocks_1.7"] = [](NodeHandle& nh) { timer(nh, {{2, 1.7}}); };
  all["timer_blocks_twice"] = [](NodeHandle& nh) { timer(nh, {{1, 0.7}, {2, 0.7}}); };
  all["timer_one_shot"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.5), free_callback, true);
    ros::Timer other = nh.createTimer(Duration(0.8), [&](const TimerEvent&)
        { say(shown(timer.hasStarted()) + shown(timer.hasPending())); });
    ros::spin();
  };
  all["timer_one_shot_again"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.3), free_callback, true);
    ros::Timer other = nh.createTimer(Duration(1.0), [&](const TimerEvent&)
        {
          say("start");
          timer.stop();
          timer.start();
        });
    ros::spin();
  };
  all["timer_one_shot_only_started"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.3), free_callback, true);
    ros::Timer other = nh.createTimer(Duration(1.0), [&](const TimerEvent&) { timer.start(); });
    ros::spin();
  };
  all["timer_stops_itself"] = [](NodeHandle& nh)
  {
    int count = 0;
    ros::Timer timer;
    timer = nh.createTimer(Duration(0.4), [&](const TimerEvent&)
        {
          say("tick");
          if (++count == 2)
            timer.stop();
        });
    ros::spin();
  };
  all["timer_starts_again"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.4), free_callback);
    ros::Timer stops = nh.createTimer(Duration(1.0), [&](const TimerEvent&) { say("stop"); timer.stop(); }, true);
    ros::Timer starts = nh.createTimer(Duration(1.7), [&](const TimerEvent&) { say("start"); timer.start(); }, true);
    ros::spin();
  };
  all["timer_set_period"] = [](NodeHandle& nh)
  {
    int count = 0;
    ros::Timer timer;
    timer = nh.createTimer(Duration(0.5), [&](const TimerEvent& event)
        {
          say("tick expected " + at(event.current_expected));
          if (++count == 2)
            timer.setPeriod(Duration(0.8));
        });
    ros::spin();
  };
  all["timer_set_period_without_reset"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(1.0), free_callback);
    ros::Timer other = nh.createTimer(Duration(1.3), [&](const TimerEvent&) { timer.setPeriod(Duration(0.6), false); },
        true);
    ros::spin();
  };
  all["timer_set_shorter_than_elapsed"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(1.0), free_callback);
    ros::Timer other = nh.createTimer(Duration(1.7), [&](const TimerEvent&) { timer.setPeriod(Duration(0.4), false); },
        true);
    ros::spin();
  };
  all["timer_set_period_from_beside"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(1.0), free_callback);
    ros::Timer other = nh.createTimer(Duration(1.3), [&](const TimerEvent&) { timer.setPeriod(Duration(0.5)); }, true);
    ros::spin();
  };
  all["timer_not_started"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.4), free_callback, false, false);
    say(shown(timer.hasStarted()) + shown(timer.isValid()));
    ros::Timer other = nh.createTimer(Duration(1.0), [&](const TimerEvent&) { timer.start(); }, true);
    ros::spin();
  };
  all["timer_dropped"] = [](NodeHandle& nh)
  {
    nh.createTimer(Duration(0.3), free_callback);
    ros::Timer copy;
    {
      ros::Timer timer = nh.createTimer(Duration(0.7), free_callback);
      copy = timer;
    }
    ros::spin();
  };
  all["timer_of_a_member"] = [](NodeHandle& nh)
  {
    Counter counter;
    ros::Timer one = nh.createTimer(Duration(0.5), &Counter::callback, &counter);
    ros::Timer two = nh.createTimer(Duration(0.7), &Counter::constant, &counter);
    ros::Timer three = nh.createTimer(Duration(0.9), boost::bind(&Counter::bound, &counter, _1, 10));
    ros::Timer four = nh.createTimer(Duration(1.1), std::bind(&Counter::bound, &counter, std::placeholders::_1, 5));
    ros::spin();
  };
  all["timer_of_an_object_that_goes"] = [](NodeHandle& nh)
  {
    boost::shared_ptr<Counter> counter(new Counter);
    ros::Timer timer = nh.createTimer(Duration(0.4), &Counter::callback, counter);
    ros::Timer other = nh.createTimer(Duration(1.0), [&](const TimerEvent&) { counter.reset(); }, true);
    ros::spin();
  };
  all["timer_wall_and_steady"] = [](NodeHandle& nh)
  {
    Counter wall, steady;
    ros::WallTimer one = nh.createWallTimer(ros::WallDuration(0.5), &Counter::wall, &wall);
    ros::SteadyTimer two = nh.createSteadyTimer(ros::WallDuration(0.7), &Counter::steady, &steady);
    ros::spin();
  };
  all["two_timers_one_blocks"] = [](NodeHandle& nh)
  {
    int count = 0;
    ros::Timer one = nh.createTimer(Duration(0.5), [&](const TimerEvent&)
        {
          say("a");
          if (++count == 2)
            work(1.2);
        });
    ros::Timer two = nh.createTimer(Duration(0.35), [](const TimerEvent&) { say("b"); });
    ros::spin();
  };
  all["timer_in_a_callback"] = [](NodeHandle& nh)
  {
    ros::Timer inner;
    ros::Timer outer = nh.createTimer(Duration(0.5), [&](const TimerEvent&)
        { inner = nh.createTimer(Duration(0.3), free_callback); }, true);
    ros::spin();
  };
  all["timer_with_options"] = [](NodeHandle& nh)
  {
    ros::CallbackQueue queue;
    ros::TimerOptions options(Duration(0.5), free_callback, &queue, false, true);
    ros::Timer timer = nh.createTimer(options);
    ros::Timer other = nh.createTimer(Duration(1.2), [&](const TimerEvent&)
        {
          say("look");
          queue.callAvailable();
        });
    ros::spin();
  };
  all["timer_that_throws"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.5), [](const TimerEvent&)
        {
          try
          {
            std::stoi("none");
          }
          catch (const std::invalid_argument& error)
          {
            say(std::string("caught ") + error.what());
          }
          throw std::runtime_error("not caught");
        });
    ros::spin();
  };
  all["handle_shut_down"] = [](NodeHandle& nh)
  {
    NodeHandle other;
    ros::Timer timer = other.createTimer(Duration(0.4), free_callback);
    ros::Timer ends = nh.createTimer(Duration(1.0), [&](const TimerEvent&)
        {
          other.shutdown();
          say(shown(other.ok()) + shown(nh.ok()));
        });
    ros::spin();
  };

  // --- spinning ---

  all["spin_late"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.5), [](const TimerEvent& event)
        { say("tick expected " + at(event.current_expected)); });
    work(1.3);
    ros::spin();
  };
  all["spin_once"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.5), free_callback);
    for (int pass = 0; ros::ok() && pass < 4; pass++)
    {
      work(0.7);
      say("look");
      ros::spinOnce();
    }
  };
  all["spin_once_makes_what_waits"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10);
    ros::Subscriber subscriber = nh.subscribe<std_msgs::UInt32>("topic", 10,
        [&](const std_msgs::UInt32ConstPtr& message)
        {
          say("heard " + std::to_string(message->data));
          publisher.publish(number(message->data + 1));
          work(0.2);
        });
    publisher.publish(number(1));
    for (int pass = 0; pass < 3; pass++)
    {
      work(0.3);
      ros::spinOnce();
      say("pass");
    }
  };
  all["call_one"] = [](NodeHandle& nh)
  {
    ros::Timer one = nh.createTimer(Duration(0.4), [](const TimerEvent&) { say("one"); });
    ros::Timer two = nh.createTimer(Duration(0.5), [](const TimerEvent&) { say("two"); });
    for (int pass = 0; ros::ok() && pass < 5; pass++)
    {
      work(0.7);
      say("result " + std::to_string(ros::getGlobalCallbackQueue()->callOne()));
    }
  };
  all["call_available_with_timeout"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.8), free_callback);
    for (int pass = 0; ros::ok() && pass < 6; pass++)
    {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.3));
      say("pass");
    }
  };
  all["shutdown_in_a_callback"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.5), [&](const TimerEvent&)
        {
          say("down " + shown(ros::ok()));
          ros::shutdown();
          begun = ros::WallTime::now();  // that takes a while
          say("still here " + shown(ros::ok()) + shown(ros::isShuttingDown()));
        });
    ros::spin();
    ROS_INFO("nobody sees this");
    say("after");
  };
  all["shutdown_before_the_next_call"] = [](NodeHandle& nh)
  {
    auto callback = [](const char* name)
    {
      return [=](const TimerEvent&)
      {
        say(name);
        ros::shutdown();
        begun = ros::WallTime::now();
      };
    };
    ros::Timer one = nh.createTimer(Duration(0.1), callback("one")), two = nh.createTimer(Duration(0.2), callback("two"));
    work(0.5);
    ros::spinOnce();
    say("after");
  };
  all["ends_by_itself"] = [](NodeHandle&) { say("nothing to do"); };

  // --- rates ---

  auto rate = [](double hz, std::vector<double> passes)
  {
    return [=](NodeHandle&)
    {
      ros::Rate rate(hz);
      for (double pass : passes)
      {
        work(pass);
        bool in_time = rate.sleep();
        say("pass " + shown(in_time) + " cycle " + shown(std::round(rate.cycleTime().toSec() * 10) / 10));
      }
    };
  };
  all["rate"] = rate(2, {0, 0, 0.2, 0.2, 0});
  all["rate_0.7"] = rate(2, {0, 0.7, 0, 0, 0});
  all["rate_0.9_each"] = rate(2, {0.8, 0.8, 0.8, 0.8});
  all["rate_1.2"] = rate(2, {0, 1.2, 0, 0.2, 0});
  all["rate_1.7"] = rate(2, {0, 1.7, 0, 0.2, 0});
  all["rate_reset"] = [](NodeHandle&)
  {
    ros::Rate rate(Duration(0.5));
    work(1.3);
    rate.reset();
    for (int pass = 0; pass < 3; pass++)
      say("pass " + shown(rate.sleep()) + " of " + shown(rate.expectedCycleTime()));
  };
  all["wall_rate"] = [](NodeHandle&)
  {
    ros::WallRate rate(2);
    for (int pass = 0; pass < 3; pass++)
      say("pass " + shown(rate.sleep()));
  };
  all["rate_of_nothing"] = [](NodeHandle&)
  {
    try
    {
      ros::Rate rate(0);
    }
    catch (const std::runtime_error& error)
    {
      say(error.what());
    }
  };
  all["rate_and_spin_once"] = [](NodeHandle& nh)
  {
    ros::Timer timer = nh.createTimer(Duration(0.3), free_callback);
    ros::Rate rate(2);
    for (int pass = 0; pass < 4; pass++)
    {
      rate.sleep();
      work(0.05);
      say("pass");
      ros::spinOnce();
    }
  };
  all["sleep_until"] = [](NodeHandle&)
  {
    ros::Time::sleepUntil(ros::Time::now() + Duration(0.7));
    say("up");
    Duration(0.4).sleep();
    say("up");
    Duration(0).sleep();
    say("up");
  };

  // --- values ---

  all["times"] = [](NodeHandle&)
  {
    say(shown(Duration(1.5)) + " " + shown(Duration(-0.25)) + " " + shown(Duration(1, 1500000000)));
    say(shown(ros::Time(2.5) - ros::Time(3.25)) + " " + shown(ros::Time(2.5) + Duration(0.6)));
    say(shown(Duration(1.0) * 2.5) + " " + shown(Duration(3.0) + Duration(0.5) - Duration(5.0)));
    say(shown(Duration(-0.25).sec) + " " + shown(Duration(-0.25).nsec) + " " + shown(Duration(2.25).toNSec()));
    say(shown(ros::Time().isZero()) + shown(Duration(1) < Duration(1.5)) + shown(ros::Time(1) == ros::Time(1, 0)));
    for (double wrong : {-1.0, 1e11})
    {
      try
      {
        ros::Time time(wrong);
      }
      catch (const std::runtime_error& error)
      {
        say(error.what());
      }
    }
    try
    {
      say(shown(ros::Time(1.0) - Duration(2.0)));
    }
    catch (const std::runtime_error& error)
    {
      say(error.what());
    }
  };
  all["names"] = [](NodeHandle& nh)
  {
    NodeHandle plain, inner("inner"), deeper(inner, "deeper"), global("/global");
    for (NodeHandle* each : {&nh, &plain, &inner, &deeper, &global})
      say(each->getNamespace() + " " + each->resolveName("name") + " " + each->resolveName("/name"));
    say(ros::this_node::getName() + " " + ros::this_node::getNamespace());
    say(ros::names::resolve("name") + " " + ros::names::resolve("~name") + " " + ros::names::append("a", "b/"));
    say(nh.resolveName("from") + " " + plain.resolveName("from"));
    for (const char* wrong : {"1st", "a-b", "~private"})
    {
      try
      {
        say(nh.resolveName(wrong));
      }
      catch (const ros::InvalidNameException& error)
      {
        say(error.what());
      }
    }
  };
  all["parameters"] = [](NodeHandle& nh)
  {
    int whole = -1;
    double real = -1;
    bool flag = false;
    std::string text;
    std::vector<double> list;
    for (const char* name : {"whole", "real", "flag", "text", "missing"})
    {
      std::string line = name;
      line += nh.hasParam(name) ? " there" : " not there";
      line += nh.getParam(name, whole) ? " whole " + std::to_string(whole) : "";
      line += nh.getParam(name, real) ? " real " + shown(real) : "";
      line += nh.getParam(name, flag) ? " flag " + shown(flag) : "";
      line += nh.getParam(name, text) ? " text " + text : "";
      say(line);
    }
    nh.setParam("list", std::vector<double>{1, 2.5});
    bool there = nh.getParam("list", list);
    say(shown(there) + " " + std::to_string(list.size()) + " " + shown(nh.getParam("list", whole)));
    nh.setParam("group/one", 1);
    nh.setParam("group/two", std::string("2"));
    std::map<std::string, int> group;
    say(shown(nh.getParam("group", group)));
    say(shown(nh.deleteParam("group/two")));
    say(shown(nh.getParam("group", group)));
    say(shown(nh.param("missing", 7)) + nh.param<std::string>("missing", "otherwise") + shown(nh.param("whole", 2.5)));
    std::string found;
    nh.setParam("/above", true);
    there = nh.searchParam("above", found);
    say(shown(there) + found + shown(nh.searchParam("nowhere", found)));
    bool read;
    nh.param("flag", read, false);
    ros::param::set("~own", 4);
    there = ros::param::get("~own", whole);
    say(shown(read) + shown(there) + shown(whole) + shown(ros::param::has("/above")));
  };
  all["log"] = [](NodeHandle&)
  {
    ROS_DEBUG("hidden");
    ROSCPP_LOG_DEBUG("hidden, too");
    for (int pass = 0; pass < 3; pass++)
    {
      ROS_INFO("info %d %s", pass, "text");
      ROS_INFO_STREAM("stream " << pass << " " << 0.5);
      ROS_INFO_ONCE("once");
      ROS_INFO_COND(pass == 1, "second pass");
      ROS_INFO_STREAM_COND(pass == 2, "third " << "pass");
      ROS_INFO_NAMED("name", "named");
      ROS_INFO_THROTTLE(0.9, "throttled");
      ROS_INFO_STREAM_THROTTLE(0.9, "throttled " << "stream");
      ROS_INFO_DELAYED_THROTTLE(0.9, "delayed");
      work(0.6);
    }
    ROS_INFO("two\nlines");
    if (ros::console::set_logger_level(ROSCONSOLE_DEFAULT_NAME, ros::console::levels::Debug))
      ros::console::notifyLoggerLevelsChanged();
    ROS_DEBUG_STREAM("shown now");
  };

  // --- topics ---

  all["publish"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10);
    say(publisher.getTopic() + " " + shown(publisher.getNumSubscribers()) + shown(static_cast<bool>(publisher)));
    ros::Subscriber one = nh.subscribe("topic", 10, hear);
    ros::Subscriber two = nh.subscribe("topic", 10, hear_reference);
    ros::Subscriber three = nh.subscribe("topic", 10, hear_event);
    ros::Subscriber four = nh.subscribe<std_msgs::UInt32>("topic", 10, boost::bind(&hear, _1));
    ros::Subscriber five = nh.subscribe<std_msgs::UInt32>(
        "topic", 10, [&](const std_msgs::UInt32ConstPtr& message) { say("lambda " + std::to_string(message->data)); });
    say(shown(publisher.getNumSubscribers()) + shown(one.getNumPublishers()) + one.getTopic());
    unsigned count = 0;
    ros::Timer timer = nh.createTimer(Duration(0.5), [&](const TimerEvent&) { publisher.publish(number(++count)); });
    ros::spin();
  };
  all["publish_before_subscribing"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10);
    publisher.publish(number(1));
    ros::Subscriber subscriber = nh.subscribe("topic", 10, hear);
    publisher.publish(number(2));
    ros::spin();
  };
  all["latched"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10, true);
    say(shown(publisher.isLatched()));
    publisher.publish(number(1));
    publisher.publish(number(2));
    ros::Subscriber one = nh.subscribe("topic", 10, hear);
    ros::Subscriber two;
    ros::Timer timer = nh.createTimer(Duration(0.5), [&](const TimerEvent&)
        { two = nh.subscribe("topic", 10, hear_reference); }, true);
    ros::spin();
  };
  all["slow_queue_1"] = [](NodeHandle& nh) { slow(nh, 1); };
  all["slow_queue_3"] = [](NodeHandle& nh) { slow(nh, 3); };
  all["slow_queue_0"] = [](NodeHandle& nh) { slow(nh, 0); };
  all["subscriber_ends"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10);
    ros::Subscriber subscriber = nh.subscribe<std_msgs::UInt32>("topic", 10,
        [&](const std_msgs::UInt32ConstPtr& message)
        {
          say("heard " + std::to_string(message->data));
          if (message->data == 2)
            subscriber.shutdown();
        });
    for (unsigned each = 1; each < 5; each++)
      publisher.publish(number(each));
    ros::spin();
  };
  all["message_waits_for_a_timer"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10);
    ros::Subscriber subscriber = nh.subscribe("topic", 10, hear);
    ros::Timer timer = nh.createTimer(Duration(0.5), [&](const TimerEvent&)
        {
          publisher.publish(number(1));
          work(0.3);
          say("published");
        });
    ros::spin();
  };
  all["wait_for_message"] = [](NodeHandle& nh)
  {
    auto none = ros::topic::waitForMessage<std_msgs::UInt32>("nobody", nh, Duration(0.5));
    say(none ? "one" : "none");
  };
  all["printed"] = [](NodeHandle&)
  {
    geometry_msgs::Twist twist;
    twist.linear.x = 0.5;
    std::cout << twist;
    std_msgs::Header header;
    header.frame_id = "map";
    header.stamp = ros::Time(1, 5);
    std::cout << header << std::flush;
    std_msgs::String one, two;
    one.data = "text";
    say(shown(one == two) + shown(one.data.empty()));
  };
  // main has set its own handler after ros::init.
  all["handler_of_ctrl_c"] = [](NodeHandle&)
  {
    say(at_init == SIG_DFL ? "none after init" : "one after init");
    say(std::signal(SIGINT, interrupted) == interrupted ? "kept by the first handle" : "replaced by the first handle");
    NodeHandle other;
    say(std::signal(SIGINT, SIG_DFL) == interrupted ? "kept by the second" : "replaced by the second");
  };
  return all;
}
}  // namespace

int main(int argc, char** argv)
{
  return run(argc, argv, [] { at_init = std::signal(SIGINT, interrupted); });
}
