// Scenarios for rclcpp, one for each run: timers, rates and executors. The first argument names one.

#include <future>

#include "ros2.hpp"

namespace
{
std::map<std::string, Scenario> scenarios()
{
  std::map<std::string, Scenario> all;

  // --- timers ---

  all["timer"] = [](const Shared& node)
  {
    int count = 0;
    auto timer = node->create_wall_timer(500ms, [&] { say("tick " + std::to_string(++count)); });
    rclcpp::spin(node);
  };
  all["timer_spun_late"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(500ms, [] { say("tick"); });
    work(1200ms);
    rclcpp::spin(node);
  };
  all["timer_spin_some"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(500ms, [] { say("tick"); });
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_node(node);
    while (rclcpp::ok())
    {
      executor.spin_some();
      rclcpp::sleep_for(300ms);
    }
  };
  all["timer_blocks"] = [](const Shared& node)
  {
    int count = 0;
    auto timer = node->create_timer(500ms,
        [&]
        {
          say("tick " + std::to_string(++count));
          if (count == 2)
            work(1300ms);
        });
    rclcpp::spin(node);
  };
  all["timer_cancel"] = [](const Shared& node)
  {
    rclcpp::TimerBase::SharedPtr timer;
    int count = 0;
    timer = node->create_wall_timer(400ms,
        [&]
        {
          say("tick");
          if (++count == 2)
            timer->cancel();
          say(shown(timer->is_canceled()));
        });
    rclcpp::spin(node);
  };
  all["timer_cancel_and_reset"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(400ms, [] { say("tick"); });
    auto stop = node->create_wall_timer(1s, [&] { timer->is_canceled() ? timer->reset() : timer->cancel(); });
    rclcpp::spin(node);
  };
  all["timer_reset_again_and_again"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(500ms, [] { say("tick"); });
    auto other = node->create_wall_timer(300ms, [&] { timer->reset(); });
    rclcpp::spin(node);
  };
  all["timer_dropped"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(300ms, [] { say("tick"); });
    auto other = node->create_wall_timer(1s, [&] { timer.reset(); });
    rclcpp::spin(node);
  };
  all["timer_not_kept"] = [](const Shared& node)
  {
    node->create_wall_timer(300ms, [] { say("tick"); });
    rclcpp::spin(node);
    say("ended");
  };
  all["timer_one_shot"] = [](const Shared& node)
  {
    rclcpp::TimerBase::SharedPtr timer = node->create_wall_timer(700ms,
        [&]
        {
          say("once");
          timer->cancel();
        });
    rclcpp::spin(node);
  };
  all["timer_takes_itself"] = [](const Shared& node)
  {
    int count = 0;
    auto timer = node->create_wall_timer(300ms,
        [&](rclcpp::TimerBase& timer)
        {
          say("tick");
          if (++count == 3)
            timer.cancel();
        });
    rclcpp::spin(node);
  };
  all["timer_takes_info"] = [](const Shared& node)
  {
    auto start = node->now();
    auto timer = node->create_timer(500ms,
        [&](const rclcpp::TimerInfo& info)
        {
          say(shown((info.expected_call_time - start).seconds()) + " " +
              shown((info.actual_call_time - start).seconds()));
          work(700ms);
        });
    rclcpp::spin(node);
  };
  all["timer_time_until_trigger"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(500ms, [] {});
    work(200ms);
    say(std::to_string(timer->time_until_trigger().count() / 1000000) + shown(timer->is_ready()));
    work(400ms);
    say(std::to_string(timer->time_until_trigger().count() / 1000000) + shown(timer->is_ready()));
    timer->cancel();
    say(shown(timer->time_until_trigger() == std::chrono::nanoseconds::max()) + shown(timer->is_ready()));
  };
  all["timer_autostart"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(500ms, [] { say("tick"); }, nullptr, false);
    auto other = node->create_wall_timer(1200ms, [&] { timer->reset(); });
    rclcpp::spin(node);
  };
  all["timer_made_in_a_callback"] = [](const Shared& node)
  {
    rclcpp::TimerBase::SharedPtr made;
    auto timer = node->create_wall_timer(1s,
        [&]
        {
          say("outer");
          made = node->create_wall_timer(300ms, [] { say("inner"); });
        });
    rclcpp::spin(node);
  };
  all["timer_negative"] = [](const Shared& node)
  { attempt([&] { node->create_wall_timer(-1ms, [] {}); }); };
  all["timers_due_together"] = [](const Shared& node)
  {
    auto one = node->create_wall_timer(500ms, [] { say("one"); });
    auto two = node->create_wall_timer(500ms, [] { say("two"); });
    auto three = node->create_wall_timer(1s, [] { say("three"); });
    rclcpp::spin(node);
  };
  all["timers_slow"] = [](const Shared& node)
  {
    auto one = node->create_wall_timer(500ms, [] { say("one"), work(800ms); });
    auto two = node->create_wall_timer(700ms, [] { say("two"), work(800ms); });
    rclcpp::spin(node);
  };
  all["timers_cancelled_while_due"] = [](const Shared& node)
  {
    rclcpp::TimerBase::SharedPtr one = node->create_wall_timer(500ms, [] { say("one"); });
    auto two = node->create_wall_timer(500ms, [&] { say("two"), one->cancel(); });
    rclcpp::spin(node);
  };

  // --- rates and clocks ---

  all["rate"] = [](const Shared&)
  {
    rclcpp::Rate rate(2.0);
    while (rclcpp::ok())
    {
      say("pass");
      rate.sleep();
    }
  };
  all["rate_blocks"] = [](const Shared&)
  {
    rclcpp::WallRate rate(500ms);
    for (int pass = 1; rclcpp::ok(); pass++)
    {
      say("pass");
      if (pass == 2)
        work(1200ms);
      if (!rate.sleep())
        say("late");
    }
  };
  all["rate_runs_timers"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(200ms, [] { say("tick"); });
    rclcpp::Rate rate(2);
    while (rclcpp::ok())
    {
      rclcpp::spin_some(node);
      rate.sleep();
    }
  };
  all["rate_reset"] = [](const Shared&)
  {
    rclcpp::Rate rate(1);
    work(700ms);
    rate.reset();
    rate.sleep();
    say("slept");
    say(std::to_string(rate.period().count()) + shown(rate.is_steady()));
  };
  all["rate_of_nothing"] = [](const Shared&)
  {
    attempt([] { rclcpp::Rate rate(0.0); });
    attempt([] { rclcpp::Rate rate(rclcpp::Duration(0, 0)); });
  };
  all["clock_sleeps"] = [](const Shared& node)
  {
    auto clock = node->get_clock();
    say(shown(clock->sleep_for(300ms)));
    say(shown(clock->sleep_until(clock->now() + rclcpp::Duration(0, 400000000))));
    say(shown(clock->sleep_until(clock->now() - rclcpp::Duration(1, 0))));
    attempt([&] { clock->sleep_until(rclcpp::Time(5, 0, RCL_STEADY_TIME)); });
  };
  all["times"] = [](const Shared&)
  {
    rclcpp::Time one(1, 500000000), other(3000000000LL);
    say(shown((other - one).seconds()) + " " + shown((one + rclcpp::Duration::from_seconds(0.25)).nanoseconds()));
    say(shown(one < other) + shown(one == other) + shown(rclcpp::Duration(2, 0) > rclcpp::Duration(1500ms)));
    builtin_interfaces::msg::Time message = other;
    say(std::to_string(message.sec) + " " + std::to_string(message.nanosec));
    attempt([&] { return one < rclcpp::Time(1, 0, RCL_STEADY_TIME); });
    attempt([&] { return one - rclcpp::Time(1, 0, RCL_ROS_TIME); });
    attempt([&] { rclcpp::Time(-1, 0); });
    attempt([&] { return rclcpp::Duration(1, 0) * INFINITY; });
  };
  all["sleep_for"] = [](const Shared&)
  {
    say(shown(rclcpp::sleep_for(400ms)));
    rclcpp::shutdown();
    say(shown(rclcpp::sleep_for(400ms)));
  };
  all["without_clock"] = [](const Shared&)
  {
    auto node = std::make_shared<Node>("other", rclcpp::NodeOptions().append_parameter_override("use_sim_time", true));
    auto timer = node->create_timer(500ms, [] { say("ROS time"); });
    auto wall = node->create_wall_timer(800ms, [&] { say("wall " + shown(node->now().seconds())); });
    rclcpp::spin(node);
  };

  // --- executors ---

  all["spin_once"] = [](const Shared& node)
  {
    auto one = node->create_wall_timer(400ms, [] { say("one"); });
    auto two = node->create_wall_timer(400ms, [] { say("two"); });
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_node(node);
    work(1s);
    for (int call = 0; call < 4; call++)
    {
      executor.spin_once(100ms);
      say("call");
    }
  };
  all["spin_some_and_all"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<UInt32>("topic", 10);
    unsigned left = 3;
    auto subscription = node->create_subscription<UInt32>("topic", 10,
        [&](const UInt32& message)
        {
          say("heard " + std::to_string(message.data));
          if (--left)
            publisher->publish(number(left));
        });
    publisher->publish(number(7));
    rclcpp::spin_some(node);
    say("some");
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_node(node);
    executor.spin_all(0s);
    say("all");
    attempt([&] { executor.spin_all(-1s); });
  };
  all["future_beside_a_timer"] = [](const Shared& node)
  {
    std::promise<int> promise;
    std::shared_future<int> future = promise.get_future().share();
    auto timer = node->create_wall_timer(300ms, [] { say("tick"); });
    say(shown(rclcpp::spin_until_future_complete(node, future, 500ms)));
    auto keeps = node->create_wall_timer(200ms, [&] { promise.set_value(1), say("kept"); });
    say(shown(rclcpp::spin_until_future_complete(node, future, 500ms)));
  };
  all["executor_of_two_nodes"] = [](const Shared& node)
  {
    auto other = std::make_shared<Node>("other");
    auto one = node->create_wall_timer(500ms, [] { say("one"); });
    auto two = other->create_wall_timer(800ms, [] { say("two"); });
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_node(node);
    executor.add_node(other);
    rclcpp::TimerBase::SharedPtr stop = node->create_wall_timer(1300ms,
        [&]
        {
          executor.remove_node(other);
          stop->cancel();
        });
    executor.spin();
    attempt([&] { executor.remove_node(other); });
  };
  all["executor_cancelled"] = [](const Shared& node)
  {
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_node(node);
    auto timer = node->create_wall_timer(600ms, [&] { say("cancel"), executor.cancel(); });
    executor.spin();
    say("ended " + shown(rclcpp::ok()));
    executor.spin();
    say("ended");
  };
  all["executor_errors"] = [](const Shared& node)
  {
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_node(node);
    attempt([&] { executor.add_node(node); });
    attempt([&] { rclcpp::spin_some(node); });
    auto timer = node->create_wall_timer(100ms, [&] { attempt([&] { executor.spin_some(); }), rclcpp::shutdown(); });
    executor.spin();
    attempt([&] { rclcpp::executors::SingleThreadedExecutor other; });
  };
  all["static_executor"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<UInt32>("topic", 10);
    auto timer = node->create_wall_timer(500ms, [&] { say("tick"), publisher->publish(number(1)), work(600ms); });
    auto subscription = node->create_subscription<UInt32>("topic", 10, [](const UInt32&) { say("heard"); });
    rclcpp::executors::StaticSingleThreadedExecutor executor;
    executor.add_node(node);
    executor.spin();
  };
  all["timer_before_subscription"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<UInt32>("topic", 10);
    auto timer = node->create_wall_timer(500ms, [&] { say("tick"), publisher->publish(number(1)), work(600ms); });
    auto subscription = node->create_subscription<UInt32>("topic", 10, [](const UInt32&) { say("heard"); });
    rclcpp::spin(node);
  };
  all["callback_group"] = [](const Shared& node)
  {
    auto group = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
    auto one = node->create_wall_timer(500ms, [] { say("default"); });
    auto two = node->create_wall_timer(500ms, [] { say("group"); }, group);
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_node(node);
    auto add = node->create_wall_timer(1200ms,
        [&]
        {
          if (!group->get_associated_with_executor_atomic())
            executor.add_callback_group(group, node->get_node_base_interface());
        });
    executor.spin();
  };
  all["group_of_another_node"] = [](const Shared& node)
  {
    auto group = Node("other").create_callback_group(rclcpp::CallbackGroupType::Reentrant);
    attempt([&] { node->create_wall_timer(1s, [] {}, group); });
  };
  return all;
}
}  // namespace
