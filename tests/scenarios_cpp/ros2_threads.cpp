// Scenarios for rclcpp with threads, one for each run, as in ros2.cpp.

#include <condition_variable>
#include <future>
#include <mutex>
#include <vector>

#include "example_interfaces/srv/add_two_ints.hpp"
#include "ros2.hpp"

using example_interfaces::srv::AddTwoInts;
using rclcpp::CallbackGroupType;
using rclcpp::executors::MultiThreadedExecutor;

namespace
{
std::function<void()> slow(const std::string& name, std::chrono::milliseconds takes)
{
  return [=]
  {
    say(name + " begins");
    work(takes);
    say(name + " ends");
  };
}

void hear_slowly(const UInt32& message) { slow(std::to_string(message.data), 400ms)(); }

void add(const std::shared_ptr<AddTwoInts::Request> request, std::shared_ptr<AddTwoInts::Response> response)
{
  say("asked " + std::to_string(request->a));
  work(300ms);
  response->sum = request->a + request->b;
}

std::shared_ptr<AddTwoInts::Request> request(int a)
{
  auto made = std::make_shared<AddTwoInts::Request>();
  made->a = a;
  made->b = 1;
  return made;
}

void spin_in_threads(const Shared& node, std::size_t threads)
{
  MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), threads);
  executor.add_node(node);
  executor.spin();
}

std::map<std::string, Scenario> scenarios()
{
  std::map<std::string, Scenario> all;

  // --- spinning beside main ---

  all["spin_in_a_thread"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(500ms, [] { say("timer"); });
    std::thread spins([&] { rclcpp::spin(node); });
    rclcpp::Rate rate(std::chrono::milliseconds(800));
    for (int pass = 0; pass < 3; pass++)
    {
      say("main");
      rate.sleep();
    }
    rclcpp::shutdown();
    spins.join();
    say("joined " + std::to_string(rclcpp::ok()));
  };
  all["executor_cancelled_from_main"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(500ms, slow("timer", 200ms));
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_node(node);
    std::thread spins([&] { executor.spin(); });
    work(1100ms);
    say("cancels " + std::to_string(executor.is_spinning()));
    executor.cancel();
    spins.join();
    say("joined " + std::to_string(rclcpp::ok()));
  };
  all["future_in_main"] = [](const Shared& node)
  {
    auto service = node->create_service<AddTwoInts>("add", add);
    auto client = node->create_client<AddTwoInts>("add");
    std::thread spins([&] { rclcpp::spin(node); });
    client->wait_for_service();
    for (int each = 1; each < 3; each++)
    {
      auto future = client->async_send_request(request(each));
      say("ready " + std::to_string(future.wait_for(100ms) == std::future_status::ready));
      say("sum " + std::to_string(future.get()->sum));
    }
    rclcpp::shutdown();
    spins.join();
  };
  all["publishes_in_a_thread"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<UInt32>("topic", 10);
    auto subscription = node->create_subscription<UInt32>("topic", 10,
        [](const UInt32& message) { say("heard " + std::to_string(message.data)); });
    std::thread publishes([&]
        {
          for (unsigned each = 1; rclcpp::ok() && each < 5; each++)
          {
            work(500ms);
            publisher->publish(number(each));
          }
        });
    rclcpp::spin(node);
    publishes.join();
  };
  all["timer_made_in_a_thread"] = [](const Shared& node)
  {
    rclcpp::TimerBase::SharedPtr timer;
    std::thread makes([&]
        {
          work(300ms);
          timer = node->create_wall_timer(500ms, [] { say("timer"); });
          work(1600ms);
          say("resets");
          timer->reset();
        });
    rclcpp::spin(node);
    makes.join();
  };
  all["shared_with_a_thread"] = [](const Shared& node)
  {
    std::mutex mutex;
    std::condition_variable changed;
    int count = 0;
    auto timer = node->create_wall_timer(400ms, [&]
        {
          std::lock_guard<std::mutex> lock(mutex);
          count++;
          changed.notify_all();
        });
    std::thread waits([&]
        {
          std::unique_lock<std::mutex> lock(mutex);
          for (int seen = 0; rclcpp::ok();)
            if (changed.wait_for(lock, 900ms, [&] { return count > seen + 1 || !rclcpp::ok(); }))
              say("count " + std::to_string(seen = count));
        });
    rclcpp::on_shutdown([&] { changed.notify_all(); });
    rclcpp::spin(node);
    waits.join();
  };
  all["two_executors"] = [](const Shared& node)
  {
    auto other = std::make_shared<Node>("other");
    auto one = node->create_wall_timer(500ms, slow("one", 300ms));
    auto two = other->create_wall_timer(600ms, slow("two", 800ms));
    std::thread spins([&] { rclcpp::spin(other); });
    rclcpp::spin(node);
    spins.join();
  };
  all["asynchronously"] = [](const Shared& node)
  {
    auto later = std::async(std::launch::async, []
        {
          work(700ms);
          return 5;
        });
    say("spins " + rclcpp::to_string(rclcpp::spin_until_future_complete(node, later, 300ms)));
    say("spins " + rclcpp::to_string(rclcpp::spin_until_future_complete(node, later, 900ms)));
    say("got " + std::to_string(later.get()));
  };
  all["ctrl_c_ends_all"] = [](const Shared& node)
  {
    std::thread sleeps([] { rclcpp::sleep_for(100s); });
    std::thread waits([&] { rclcpp::spin(node); });
    sleeps.join();
    waits.join();
  };

  // --- several threads that call ---

  all["groups_of_their_own"] = [](const Shared& node)
  {
    auto first = node->create_callback_group(CallbackGroupType::MutuallyExclusive);
    auto second = node->create_callback_group(CallbackGroupType::MutuallyExclusive);
    auto one = node->create_wall_timer(500ms, slow("one", 800ms), first);
    auto two = node->create_wall_timer(600ms, slow("two", 200ms), second);
    spin_in_threads(node, 2);
  };
  all["one_group"] = [](const Shared& node)
  {
    auto one = node->create_wall_timer(500ms, slow("one", 200ms));
    auto two = node->create_wall_timer(600ms, slow("two", 300ms));
    spin_in_threads(node, 4);
  };
  all["reentrant"] = [](const Shared& node)
  {
    auto group = node->create_callback_group(CallbackGroupType::Reentrant);
    auto one = node->create_wall_timer(500ms, slow("one", 800ms), group);
    spin_in_threads(node, 3);
  };
  all["more_to_call_than_threads"] = [](const Shared& node)
  {
    auto group = node->create_callback_group(CallbackGroupType::Reentrant);
    auto one = node->create_wall_timer(500ms, slow("one", 900ms), group);
    auto two = node->create_wall_timer(600ms, slow("two", 900ms), group);
    auto three = node->create_wall_timer(700ms, slow("three", 100ms), group);
    spin_in_threads(node, 2);
  };
  all["subscription_exclusive"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<UInt32>("topic", 10);
    auto group = node->create_callback_group(CallbackGroupType::MutuallyExclusive);
    rclcpp::SubscriptionOptions options;
    options.callback_group = group;
    auto subscription = node->create_subscription<UInt32>("topic", 10, hear_slowly, options);
    unsigned count = 0;
    auto timer = node->create_wall_timer(300ms, [&] { publisher->publish(number(++count)); });
    spin_in_threads(node, 3);
  };
  all["subscription_reentrant"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<UInt32>("topic", 10);
    rclcpp::SubscriptionOptions options;
    options.callback_group = node->create_callback_group(CallbackGroupType::Reentrant);
    auto subscription = node->create_subscription<UInt32>("topic", 10, hear_slowly, options);
    unsigned count = 0;
    auto timer = node->create_wall_timer(300ms, [&] { publisher->publish(number(++count)); });
    spin_in_threads(node, 3);
  };
  all["service_in_a_callback"] = [](const Shared& node)
  {
    auto group = node->create_callback_group(CallbackGroupType::MutuallyExclusive);
    auto service = node->create_service<AddTwoInts>("add", add);
    auto client = node->create_client<AddTwoInts>("add", rclcpp::ServicesQoS(), group);
    int count = 0;
    auto own = node->create_callback_group(CallbackGroupType::MutuallyExclusive);
    rclcpp::TimerBase::SharedPtr timer = node->create_wall_timer(500ms,
        [&]
        {
          auto future = client->async_send_request(request(++count));
          say("sum " + std::to_string(future.get()->sum));
          if (count == 3)
            timer->cancel();
        },
        own);
    spin_in_threads(node, 2);
  };
  all["service_in_a_callback_of_one_group"] = [](const Shared& node)
  {
    auto service = node->create_service<AddTwoInts>("add", add);
    auto client = node->create_client<AddTwoInts>("add");
    auto timer = node->create_wall_timer(500ms,
        [&]
        {
          auto future = client->async_send_request(request(1));
          bool ready = future.wait_for(1s) == std::future_status::ready;
          say("ready " + std::to_string(ready));
        });
    spin_in_threads(node, 4);
  };
  all["shutdown_in_a_callback"] = [](const Shared& node)
  {
    auto group = node->create_callback_group(CallbackGroupType::Reentrant);
    auto one = node->create_wall_timer(500ms, slow("one", 800ms), group);
    auto two = node->create_wall_timer(700ms, [] { rclcpp::shutdown(); }, group);
    spin_in_threads(node, 2);
    say("ended");
  };
  all["thrown_in_a_callback"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(500ms, [] { throw std::runtime_error("in a callback"); });
    spin_in_threads(node, 2);
  };
  all["number_of_threads"] = [](const Shared&)
  {
    say(std::to_string(MultiThreadedExecutor(rclcpp::ExecutorOptions(), 3).get_number_of_threads()));
  };
  return all;
}
}  // namespace
