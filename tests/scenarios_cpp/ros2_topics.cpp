// Scenarios for rclcpp, as in ros2.cpp: topics, services, parameters, logs and contexts.

#include <vector>

#include "example_interfaces/srv/add_two_ints.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "ros2.hpp"
#include "rosgraph_msgs/msg/clock.hpp"
#include "std_msgs/msg/string.hpp"

using example_interfaces::srv::AddTwoInts;
using std_msgs::msg::String;

namespace
{
struct Listener
{
  std::string name;
  void hear(const UInt32& message) { say(name + " " + std::to_string(message.data)); }
  void shared(UInt32::SharedPtr message) { say(name + " " + std::to_string(message->data)); }
  void constant(const UInt32::ConstSharedPtr message) const { say(name + " " + std::to_string(message->data)); }
  void with_info(const UInt32& message, const rclcpp::MessageInfo& info)
  {
    say(name + " " + std::to_string(message.data) + (info.get_rmw_message_info().source_timestamp > 0 ? " stamped" : ""));
  }
};

int timer_calls = 0;

void show(const UInt32& message) { say(std::to_string(message.data)); }

void hear(UInt32::UniquePtr message) { say("unique " + std::to_string(message->data)); }

// Tell the time on /clock, and let it be heard.
void tell_time(rclcpp::Publisher<rosgraph_msgs::msg::Clock>& publisher, double seconds)
{
  rosgraph_msgs::msg::Clock message;
  message.clock = rclcpp::Time(static_cast<std::int64_t>(seconds * 1e9));
  publisher.publish(message);
  work(50ms);
}

std::map<std::string, Scenario> scenarios()
{
  std::map<std::string, Scenario> all;

  // --- topics ---

  all["callbacks"] = [](const Shared& node)
  {
    Listener listener{"member"};
    using std::placeholders::_1;
    using std::placeholders::_2;
    auto publisher = node->create_publisher<UInt32>("topic", 10);
    std::vector<rclcpp::SubscriptionBase::SharedPtr> kept;
    kept.push_back(node->create_subscription<UInt32>("topic", 10, std::bind(&Listener::hear, &listener, _1)));
    kept.push_back(node->create_subscription<UInt32>("topic", 10, std::bind(&Listener::shared, &listener, _1)));
    kept.push_back(node->create_subscription<UInt32>("topic", 10, std::bind(&Listener::constant, &listener, _1)));
    kept.push_back(node->create_subscription<UInt32>("topic", 10, std::bind(&Listener::with_info, &listener, _1, _2)));
    kept.push_back(node->create_subscription<UInt32>("topic", 10, hear));
    kept.push_back(node->create_subscription<UInt32>("topic", 10,
        [](const UInt32::ConstSharedPtr& message) { say("lambda " + std::to_string(message->data)); }));
    std::function<void(UInt32::SharedPtr)> function = [](UInt32::SharedPtr) { say("function"); };
    kept.push_back(node->create_subscription<UInt32>("topic", rclcpp::SensorDataQoS(), function));
    publisher->publish(number(1));
    publisher->publish(std::make_unique<UInt32>(number(2)));
    rclcpp::spin_some(node);
    say("some");
    rclcpp::spin_some(node);
  };
  all["matched"] = [](const Shared& node)
  {
    auto tell = [](const std::string& who)
    {
      return [=](rclcpp::MatchedInfo& info)
      {
        say(who + " " + std::to_string(info.total_count) + " " + std::to_string(info.total_count_change) + " " +
            std::to_string(info.current_count) + " " + std::to_string(info.current_count_change));
      };
    };
    rclcpp::PublisherOptions of_publisher;
    of_publisher.event_callbacks.matched_callback = tell("publisher");
    rclcpp::SubscriptionOptions of_subscription;
    of_subscription.event_callbacks.matched_callback = tell("subscription");
    auto publisher = node->create_publisher<UInt32>("topic", 10, of_publisher);
    auto one = node->create_subscription<UInt32>("topic", 10, show, of_subscription);
    auto other = node->create_subscription<UInt32>("topic", 10, show);
    rclcpp::spin_some(node);
    say("one goes");
    other.reset();
    rclcpp::spin_some(node);
    publisher.reset();
    rclcpp::spin_some(node);
  };
  all["incompatible"] = [](const Shared& node)
  {
    auto tell = [](const std::string& who)
    {
      return [=](rclcpp::QOSOfferedIncompatibleQoSInfo& info)
      {
        say(who + " " + std::to_string(info.total_count) + " " + std::to_string(info.total_count_change) + " " +
            rclcpp::qos_policy_name_from_kind(info.last_policy_kind));
      };
    };
    rclcpp::PublisherOptions of_publisher;
    of_publisher.event_callbacks.incompatible_qos_callback = tell("publisher");
    rclcpp::SubscriptionOptions of_subscription;
    of_subscription.event_callbacks.incompatible_qos_callback = tell("subscription");
    auto publisher = node->create_publisher<UInt32>("topic", rclcpp::QoS(10).best_effort(), of_publisher);
    auto one = node->create_subscription<UInt32>("topic", 10, show, of_subscription);
    auto other = node->create_subscription<UInt32>("topic", 10, show);
    rclcpp::SubscriptionOptions silent;
    silent.use_default_callbacks = false;
    auto last = node->create_subscription<UInt32>("topic", rclcpp::QoS(10).transient_local(), show, silent);
    say("nobody spins");
    rclcpp::sleep_for(500ms);
    rclcpp::spin_some(node);
  };
  all["deadline"] = [](const Shared& node)
  {
    auto tell = [](const std::string& who)
    {
      return [=](rclcpp::QOSDeadlineOfferedInfo& info)
      { say(who + " " + std::to_string(info.total_count) + " " + std::to_string(info.total_count_change)); };
    };
    rclcpp::PublisherOptions of_publisher;
    of_publisher.event_callbacks.deadline_callback = tell("publisher");
    rclcpp::SubscriptionOptions of_subscription;
    of_subscription.event_callbacks.deadline_callback = tell("subscription");
    auto qos = rclcpp::QoS(10).deadline(rclcpp::Duration::from_seconds(0.5));
    auto publisher = node->create_publisher<UInt32>("topic", qos, of_publisher);
    auto subscription = node->create_subscription<UInt32>("topic", qos, show, of_subscription);
    auto timer = node->create_wall_timer(700ms, [&]
        {
          publisher->publish(number(7));
          timer_calls++;
          if (timer_calls == 2)
            rclcpp::sleep_for(1300ms);
        });
    rclcpp::spin(node);
  };
  all["liveliness"] = [](const Shared& node)
  {
    rclcpp::PublisherOptions of_publisher;
    of_publisher.event_callbacks.liveliness_callback = [](rclcpp::QOSLivelinessLostInfo& info)
    { say("lost " + std::to_string(info.total_count)); };
    rclcpp::SubscriptionOptions of_subscription;
    of_subscription.event_callbacks.liveliness_callback = [](rclcpp::QOSLivelinessChangedInfo& info)
    {
      say("alive " + std::to_string(info.alive_count) + " " + std::to_string(info.alive_count_change) + " not alive " +
          std::to_string(info.not_alive_count) + " " + std::to_string(info.not_alive_count_change));
    };
    auto qos = rclcpp::QoS(10)
                   .liveliness(rclcpp::LivelinessPolicy::ManualByTopic)
                   .liveliness_lease_duration(rclcpp::Duration::from_seconds(0.5));
    auto publisher = node->create_publisher<UInt32>("topic", qos, of_publisher);
    auto subscription = node->create_subscription<UInt32>("topic", qos, show, of_subscription);
    auto timer = node->create_wall_timer(300ms, [&]
        {
          if (++timer_calls < 3)
            publisher->assert_liveliness();
          if (timer_calls == 6)
            publisher->publish(number(7));
        });
    rclcpp::spin(node);
  };
  all["queue_of_1"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<UInt32>("topic", 10);
    auto subscription = node->create_subscription<UInt32>("topic", 1, show);
    for (unsigned each = 0; each < 5; each++)
      publisher->publish(number(each));
    rclcpp::spin(node);
  };
  all["queue_of_3"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<UInt32>("topic", 10);
    auto subscription = node->create_subscription<UInt32>("topic", rclcpp::QoS(3).best_effort(), show);
    for (unsigned each = 0; each < 5; each++)
      publisher->publish(number(each));
    rclcpp::spin(node);
  };
  all["keep_all"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<UInt32>("topic", rclcpp::QoS(rclcpp::KeepAll()));
    auto subscription = node->create_subscription<UInt32>("topic", rclcpp::QoS(rclcpp::KeepAll()), show);
    for (unsigned each = 0; each < 12; each++)
      publisher->publish(number(each));
    rclcpp::spin_some(node);
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_node(node);
    executor.spin_all(0s);
  };
  all["slow_subscription"] = [](const Shared& node)
  {
    unsigned count = 0;
    auto publisher = node->create_publisher<UInt32>("topic", 10);
    auto timer = node->create_wall_timer(250ms, [&] { publisher->publish(number(++count)); });
    auto subscription = node->create_subscription<UInt32>("topic", 10,
        [](const UInt32& m)
        {
          say(std::to_string(m.data));
          if (m.data == 3)
            work(1700ms);
        });
    rclcpp::spin(node);
  };
  all["transient_local"] = [](const Shared& node)
  {
    auto qos = rclcpp::QoS(rclcpp::KeepLast(2)).transient_local();
    auto publisher = node->create_publisher<UInt32>("topic", qos);
    for (unsigned each = 0; each < 5; each++)
      publisher->publish(number(each));
    auto late = node->create_subscription<UInt32>("topic", qos, [](const UInt32& m) { say("late " + std::to_string(m.data)); });
    auto none = node->create_subscription<UInt32>("topic", 10, [](const UInt32& m) { say("volatile " + std::to_string(m.data)); });
    rclcpp::spin(node);
  };
  all["qos_that_does_not_match"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<UInt32>("topic", rclcpp::SensorDataQoS());
    auto subscription = node->create_subscription<UInt32>("topic", rclcpp::QoS(10), [](const UInt32&) { say("heard"); });
    publisher->publish(number(1));
    rclcpp::spin_some(node);
    say(std::to_string(publisher->get_subscription_count()));
    auto forgets = node->create_publisher<UInt32>("last", 10);
    auto late = node->create_subscription<UInt32>(
        "last", rclcpp::QoS(10).transient_local(), [](const UInt32&) { say("heard"); });
    forgets->publish(number(1));
    rclcpp::spin_some(node);
    say(std::to_string(forgets->get_subscription_count()));
  };
  all["counts"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<UInt32>("~/topic", 10);
    say(publisher->get_topic_name() + std::string(" ") + std::to_string(publisher->get_subscription_count()));
    auto subscription = node->create_subscription<UInt32>("~/topic", 10, [](const UInt32&) {});
    say(std::to_string(publisher->get_subscription_count()) + std::to_string(subscription->get_publisher_count()));
    say(std::to_string(node->count_publishers("/s/topic")) + std::to_string(node->count_subscribers("/s/topic")));
    publisher.reset();
    say(std::to_string(subscription->get_publisher_count()));
    say(std::to_string(node->get_topic_names_and_types().count("/s/topic")));
  };
  all["graph_change"] = [](const Shared& node)
  {
    auto event = node->get_graph_event();
    auto wait = [&]
    {
      node->wait_for_graph_change(event, 500ms);
      say(shown(event->check_and_clear()) + shown(event->check()));
    };
    wait();  // the node itself
    wait();
    auto publisher = node->create_publisher<UInt32>("topic", 1);
    wait();
    publisher.reset();
    auto other = node->get_graph_event();
    wait();
    say(shown(other->check()));
    attempt([&] { node->wait_for_graph_change(nullptr, 1s); });
    attempt([&] { node->wait_for_graph_change(std::make_shared<rclcpp::Event>(), 1s); });
  };
  all["names"] = [](const Shared&)
  {
    Node node("other", "/space");
    say(node.get_fully_qualified_name() + std::string(" ") + node.get_namespace() + " " + node.get_logger().get_name());
    say(node.create_publisher<String>("a", 1)->get_topic_name());
    say(node.create_publisher<String>("/a", 1)->get_topic_name());
    say(node.create_sub_node("sub")->create_publisher<String>("a", 1)->get_topic_name());
    say(node.create_publisher<String>("from", 1)->get_topic_name());
    attempt([&] { node.create_publisher<String>("a b", 1); });
    attempt([] { Node("1"); });
    attempt([] { Node("a", "b c"); });
  };
  all["published_after_shutdown"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<String>("topic", 10);
    rclcpp::shutdown();
    attempt([&] { publisher->publish(String()); });
    attempt([] { Node("late"); });
  };
  all["message"] = [](const Shared&)
  {
    geometry_msgs::msg::Twist twist;
    twist.linear.x = 0.5;
    say(shown(twist == geometry_msgs::msg::Twist()) + shown(twist == twist));
    std::printf("%s", geometry_msgs::msg::to_yaml(twist).c_str());
    std::printf("%s", std_msgs::msg::to_yaml(String().set__data("text")).c_str());
  };

  // --- services ---

  all["service"] = [](const Shared& node)
  {
    auto service = node->create_service<AddTwoInts>("add",
        [](const AddTwoInts::Request::SharedPtr request, AddTwoInts::Response::SharedPtr response)
        {
          say("asked");
          work(400ms);
          response->sum = request->a + request->b;
        });
    auto client = node->create_client<AddTwoInts>("add");
    say(shown(client->wait_for_service(1s)));
    auto request = std::make_shared<AddTwoInts::Request>();
    request->a = 2;
    request->b = 3;
    auto future = client->async_send_request(request);
    say(rclcpp::to_string(rclcpp::spin_until_future_complete(node, future)));
    say(std::to_string(future.get()->sum));
    client->async_send_request(
        request, [](rclcpp::Client<AddTwoInts>::SharedFuture future) { say("callback " + std::to_string(future.get()->sum)); });
    rclcpp::spin(node);
  };
  all["service_that_is_not_there"] = [](const Shared& node)
  {
    auto client = node->create_client<AddTwoInts>("add");
    say(shown(client->service_is_ready()));
    say(shown(client->wait_for_service(700ms)));
    auto future = client->async_send_request(std::make_shared<AddTwoInts::Request>());
    say(rclcpp::to_string(rclcpp::spin_until_future_complete(node, future, 500ms)));
    say(shown(client->remove_pending_request(future)));
  };

  all["service_that_answers_later"] = [](const Shared& node)
  {
    typedef std::shared_ptr<rmw_request_id_t> Header;
    std::vector<std::pair<Header, AddTwoInts::Request::SharedPtr>> waiting;
    auto service = node->create_service<AddTwoInts>("add",
        [&](const Header header, const AddTwoInts::Request::SharedPtr request)
        {
          say("asked " + std::to_string(request->a));
          waiting.emplace_back(header, request);
        });
    auto timer = node->create_wall_timer(700ms,
        [&]
        {
          for (const auto& [header, request] : waiting)
          {
            AddTwoInts::Response response;
            response.sum = request->a + request->b;
            service->send_response(*header, response);
          }
          waiting.clear();
        });
    auto client = node->create_client<AddTwoInts>("add");
    auto ask = [&](int a)
    {
      auto request = std::make_shared<AddTwoInts::Request>();
      request->a = request->b = a;
      return client->async_send_request(request,
          [](rclcpp::Client<AddTwoInts>::SharedFuture future) { say("callback " + std::to_string(future.get()->sum)); });
    };
    auto one = ask(1), two = ask(2), three = ask(3);
    say(shown(client->remove_pending_request(two)) + shown(client->remove_pending_request(two)));
    rclcpp::spin(node);
  };

  // --- parameters ---

  all["parameters"] = [](const Shared& node)
  {
    say(std::to_string(node->declare_parameter("whole", 1)));
    say(shown(node->declare_parameter("real", 1.5)));
    say(node->declare_parameter("text", "words"));
    say(shown(node->declare_parameter<bool>("flag", false)));
    for (auto each : node->declare_parameter("list", std::vector<std::int64_t>{1, 2}))
      say(std::to_string(each));
    int whole = 0;
    say(shown(node->get_parameter("whole", whole)) + std::to_string(whole));
    say(shown(node->get_parameter_or("lacking", whole, 9)) + std::to_string(whole));
    say(shown(node->has_parameter("lacking")));
    say(node->get_parameter("list").value_to_string() + node->get_parameter("real").value_to_string());
    say(shown(node->get_parameter("text")));
  };
  all["parameters_wrong"] = [](const Shared& node)
  {
    node->declare_parameter("whole", 1);
    attempt([&] { node->declare_parameter("whole", 2); });
    attempt([&] { node->declare_parameter("", 2); });
    attempt([&] { node->get_parameter("lacking"); });
    attempt([&] { node->set_parameter(rclcpp::Parameter("lacking", 1)); });
    attempt([&] { node->get_parameter("whole").as_string(); });
    attempt([&] { node->get_parameter("whole").get_value<double>(); });
    attempt([&] { node->undeclare_parameter("whole"); });
    attempt([&] { node->declare_parameter<int>("empty"); });
    say(node->set_parameter(rclcpp::Parameter("whole", "text")).reason);
  };
  all["parameter_ranges"] = [](const Shared& node)
  {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.integer_range.resize(1);
    descriptor.integer_range[0].set__from_value(0).set__to_value(10).set__step(2);
    node->declare_parameter("even", 4, descriptor);
    for (int value : {6, 7, 12, 10})
    {
      auto result = node->set_parameter(rclcpp::Parameter("even", value));
      say(shown(result.successful) + " " + result.reason);
    }
    descriptor = rcl_interfaces::msg::ParameterDescriptor();
    descriptor.read_only = true;
    node->declare_parameter("fixed", 1, descriptor);
    say(node->set_parameter(rclcpp::Parameter("fixed", 2)).reason);
    attempt([&] { node->declare_parameter("odd", 3, node->describe_parameter("even")); });
    descriptor = rcl_interfaces::msg::ParameterDescriptor();
    descriptor.integer_range.resize(1);
    descriptor.integer_range[0].set__from_value(1).set__to_value(10).set__step(4);
    node->declare_parameter("steps", 1, descriptor);
    for (int value : {5, 8, 9, 10})  // its end, too, which no step meets
      say(std::to_string(value) + " " + shown(node->set_parameter(rclcpp::Parameter("steps", value)).successful));
    descriptor = rcl_interfaces::msg::ParameterDescriptor();
    descriptor.floating_point_range.resize(1);
    descriptor.floating_point_range[0].set__from_value(0.25).set__to_value(2.0).set__step(0.5);
    node->declare_parameter("real", 0.25, descriptor);
    for (double value : {0.75, 1.0, 1.75, 2.0, 2.25})
      say(shown(value) + " " + shown(node->set_parameter(rclcpp::Parameter("real", value)).successful));
  };
  all["parameter_callbacks"] = [](const Shared& node)
  {
    node->declare_parameter("whole", 1);
    auto first = node->add_on_set_parameters_callback(
        [](const std::vector<rclcpp::Parameter>& parameters)
        {
          say("on " + shown(parameters[0]));
          rcl_interfaces::msg::SetParametersResult result;
          result.successful = parameters[0].as_int() < 5;
          result.reason = "too much";
          return result;
        });
    auto before = node->add_pre_set_parameters_callback(
        [](std::vector<rclcpp::Parameter>& parameters)
        {
          say("pre");
          if (parameters[0].as_int() == 3)
            parameters[0] = rclcpp::Parameter(parameters[0].get_name(), 4);
        });
    auto after = node->add_post_set_parameters_callback([](const std::vector<rclcpp::Parameter>&) { say("post"); });
    for (int value : {2, 3, 8})
      say(shown(node->set_parameter(rclcpp::Parameter("whole", value)).successful) + std::to_string(node->get_parameter("whole").as_int()));
    first.reset();
    say(shown(node->set_parameter(rclcpp::Parameter("whole", 8)).successful));
  };
  all["parameter_set_in_its_callback"] = [](const Shared& node)
  {
    node->declare_parameter("whole", 1);
    node->declare_parameter("other", 1);
    auto allows = node->add_on_set_parameters_callback(
        [](const std::vector<rclcpp::Parameter>&)
        {
          say("allows");
          return rcl_interfaces::msg::SetParametersResult().set__successful(true);
        });
    auto asked_first = node->add_on_set_parameters_callback(
        [&](const std::vector<rclcpp::Parameter>& parameters)
        {
          attempt([&] { node->set_parameter(rclcpp::Parameter("other", 5)); });
          return rcl_interfaces::msg::SetParametersResult().set__successful(parameters[0].as_int() < 5);
        });
    auto after = node->add_post_set_parameters_callback(
        [&](const std::vector<rclcpp::Parameter>&) { attempt([&] { node->declare_parameter("third", 1); }); });
    for (int value : {2, 8})
      say(shown(node->set_parameter(rclcpp::Parameter("whole", value)).successful));
    say(shown(node->get_parameter("whole")) + shown(node->get_parameter("other")));
  };
  all["parameters_undeclared"] = [](const Shared&)
  {
    auto options = rclcpp::NodeOptions().allow_undeclared_parameters(true).automatically_declare_parameters_from_overrides(true);
    options.append_parameter_override("given", 5);
    Node node("other", options);
    say(std::to_string(node.get_parameter("given").as_int()) + node.get_parameter("lacking").get_type_name());
    say(shown(node.set_parameter(rclcpp::Parameter("new.part", "text")).successful));
    say(node.get_parameter("new.part").as_string());
    std::map<std::string, std::string> found;
    say(shown(node.get_parameters("new", found)) + found["part"]);
    for (const auto& name : node.list_parameters({"new"}, 2).names)
      say(name);
  };

  // --- /clock ---

  all["sim_time_set"] = [](const Shared& node)
  {
    auto clock = node->get_clock();
    rcl_jump_threshold_t threshold{true, {5'000'000'000}, {-1'000'000'000}};
    auto handler = clock->create_jump_callback([] { say("before"); },
        [](const rcl_time_jump_t& jump)
        {
          bool same = jump.clock_change == RCL_ROS_TIME_NO_CHANGE;
          say(same ? "jump " + shown(jump.delta.nanoseconds / 1e9) : "another clock");
        },
        threshold);
    auto publisher = node->create_publisher<rosgraph_msgs::msg::Clock>("/clock", 1);
    auto tell = [&](double seconds)
    {
      rosgraph_msgs::msg::Clock message;
      message.clock = rclcpp::Time(static_cast<std::int64_t>(seconds * 1e9));
      publisher->publish(message);
      work(100ms);
      say("told " + shown(node->now().seconds()));
      rclcpp::spin_some(node);
    };
    say(shown(clock->ros_time_is_active()) + shown(node->now().seconds() > 90));
    tell(10);
    node->set_parameter(rclcpp::Parameter("use_sim_time", true));
    say(shown(clock->ros_time_is_active()) + shown(node->now().seconds()));
    auto timer = node->create_timer(2s, [&] { say("timer " + shown(node->now().seconds())); });
    for (double seconds : {1.0, 2.0, 3.0, 8.0, 8.5, 10.0, 9.5, 8.5})
      tell(seconds);
    node->set_parameter(rclcpp::Parameter("use_sim_time", false));
    say(shown(clock->ros_time_is_active()) + shown(node->now().seconds() > 90));
  };

  // As in scenarios_ros2/sim_time_jumps.py.
  all["sim_time_jumps"] = [](const Shared& teller)
  {
    auto publisher = teller->create_publisher<rosgraph_msgs::msg::Clock>("/clock", 10);
    auto node =
        std::make_shared<Node>("sim_time_jumps", rclcpp::NodeOptions().append_parameter_override("use_sim_time", true));
    auto timer = node->create_timer(1s, [&] { say("tick " + shown(node->now().seconds())); });
    for (double second : {100.0, 100.5, 101.0, 101.5, 102.0, 107.5, 108.0, 109.0, 50.0, 50.5, 51.0, 51.5, 52.0})
    {
      tell_time(*publisher, second);
      for (int each = 0; each < 4; each++)
        rclcpp::spin_some(node);
      say("told " + shown(second));
    }
  };
  // As in scenarios_ros2/clock_jump_callbacks_sim_time.py.
  all["sim_time_jump_callbacks"] = [](const Shared& other)
  {
    auto publisher = other->create_publisher<rosgraph_msgs::msg::Clock>("/clock", 10);
    auto node = std::make_shared<Node>("clock_jumps_sim_time");
    auto clock = node->get_clock();
    auto handler = clock->create_jump_callback([] { say("before"); },
        [&](const rcl_time_jump_t& jump)
        { say("after " + shown(jump.clock_change) + " " + shown(jump.delta.nanoseconds) + " " + shown(clock->ros_time_is_active())); },
        {true, {2'000'000'000}, {-1}});
    for (bool value : {true, false, true})
    {
      say("use_sim_time " + shown(value));
      node->set_parameter(rclcpp::Parameter("use_sim_time", value));
      for (double second : {10.0, 11.0, 13.0, 12.0, 20.0})
        if (value)
        {
          say("clock " + shown(second));
          tell_time(*publisher, second);
        }
    }
  };
  all["jump_thresholds"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<rosgraph_msgs::msg::Clock>("/clock", 10);
    auto clock = node->get_clock();
    std::vector<rclcpp::JumpHandler::SharedPtr> handlers;
    auto watch = [&](const std::string& name, const rcl_jump_threshold_t& threshold)
    {
      auto say_after = [name](const rcl_time_jump_t& jump) { say(name + " " + shown(jump.delta.nanoseconds / 1e9)); };
      attempt([&] { handlers.push_back(clock->create_jump_callback(nullptr, say_after, threshold)); });
    };
    watch("none", {false, {0}, {0}});
    watch("forward", {false, {1'000'000'000}, {0}});
    watch("backward", {false, {0}, {-1'000'000'000}});
    watch("change", {true, {0}, {0}});
    watch("wrong", {true, {-1}, {0}});
    watch("wrong", {true, {0}, {1}});
    node->set_parameter(rclcpp::Parameter("use_sim_time", true));
    for (double second : {5.0, 5.5, 6.5, 6.0, 5.0, 5.0})
      tell_time(*publisher, second);
    handlers.pop_back();
    node->set_parameter(rclcpp::Parameter("use_sim_time", false));
  };
  // What is left of a period is what has gone by of it in the other time: next - now becomes now - last.
  all["timer_switches"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<rosgraph_msgs::msg::Clock>("/clock", 10);
    auto timer = node->create_timer(800ms, [] { say("tick"); });
    auto left = [&]
    { say("left " + shown(std::chrono::duration_cast<std::chrono::milliseconds>(timer->time_until_trigger()).count())); };
    auto follow = [&](bool follows)
    {
      node->set_parameter(rclcpp::Parameter("use_sim_time", follows));
      left();
    };
    work(300ms);
    left();
    follow(true);
    tell_time(*publisher, 10.0);
    left();
    tell_time(*publisher, 10.5);
    left();
    follow(false);
    rclcpp::spin_some(node);
    work(200ms);
    rclcpp::spin_some(node);
    follow(true);
    tell_time(*publisher, 11.3);
    rclcpp::spin_some(node);
    left();
  };

  // --- logs and contexts ---

  all["log"] = [](const Shared& node)
  {
    auto logger = node->get_logger();
    RCLCPP_DEBUG(logger, "debug");
    RCLCPP_INFO(logger, "info %d %s %.2f %ld %c %5d|%-5d|%05d %x %%", 1, "text", 2.5, std::int64_t(1) << 40, 'c', 1, 2, 3, 255);
    RCLCPP_WARN_STREAM(logger, "warn " << 1 << true << 0.5);
    RCLCPP_ERROR(logger.get_child("part"), "error");
    RCLCPP_FATAL(rclcpp::get_logger("free"), "fatal");
    logger.set_level(rclcpp::Logger::Level::Error);
    RCLCPP_WARN(logger, "warn");
    RCLCPP_WARN(logger.get_child("part"), "warn");
    RCLCPP_ERROR(logger.get_child("part"), "error");
    (void)rcutils_logging_set_logger_level("free", RCUTILS_LOG_SEVERITY_DEBUG);
    RCLCPP_DEBUG(rclcpp::get_logger("free"), "debug");
  };
  all["log_filters"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(400ms,
        [&]
        {
          RCLCPP_INFO_ONCE(node->get_logger(), "once");
          RCLCPP_INFO_SKIPFIRST(node->get_logger(), "skipfirst");
          RCLCPP_INFO_THROTTLE(node->get_logger(), *node->get_clock(), 1000, "throttle");
          RCLCPP_INFO_STREAM_EXPRESSION(node->get_logger(), node->now().seconds() < 101, "expression");
        });
    rclcpp::spin(node);
  };
  all["shutdown"] = [](const Shared& node)
  {
    rclcpp::on_shutdown([] { say("on_shutdown " + shown(rclcpp::ok())); });
    rclcpp::contexts::get_global_default_context()->add_pre_shutdown_callback([] { say("pre " + shown(rclcpp::ok())); });
    auto timer = node->create_wall_timer(500ms, [] { say(shown(rclcpp::shutdown()) + shown(rclcpp::shutdown())); });
    rclcpp::spin(node);
    say("ended");
  };
  all["ctrl_c"] = [](const Shared& node)
  {
    rclcpp::on_shutdown([] { std::puts("on_shutdown"); });
    rclcpp::spin(node);
    std::puts("ended");
  };
  all["context_of_its_own"] = [](const Shared&)
  {
    auto context = std::make_shared<rclcpp::Context>();
    attempt([&] { Node("early", rclcpp::NodeOptions().context(context)); });
    context->init(0, nullptr);
    attempt([&] { context->init(0, nullptr); });
    auto node = std::make_shared<Node>("other", rclcpp::NodeOptions().context(context));
    auto timer = node->create_wall_timer(500ms, [&] { context->shutdown("enough"); });
    rclcpp::spin(node);
    say(context->shutdown_reason() + shown(rclcpp::ok()) + shown(rclcpp::ok(context)));
  };
  all["wait_set"] = [](const Shared& node)
  {
    auto heard = node->create_subscription<String>("to", 10, [](const String&) { say("never"); });
    auto publisher = node->create_publisher<String>("to", 10);
    auto guard = std::make_shared<rclcpp::GuardCondition>();
    auto timer = node->create_wall_timer(1s, [&] { publisher->publish(String().set__data("hello")); });
    rclcpp::WaitSet set({{heard}}, {guard}, {timer});
    auto wait = [&](std::chrono::milliseconds timeout)
    {
      auto result = set.wait(timeout);
      if (result.kind() != rclcpp::WaitResultKind::Ready)
        return say(result.kind() == rclcpp::WaitResultKind::Timeout ? "timeout" : "empty");
      const rcl_wait_set_t& ready = result.get_wait_set().get_rcl_wait_set();
      String message;
      rclcpp::MessageInfo info;
      if (ready.guard_conditions[0])
        say("guard");
      if (ready.timers[0])
        timer->execute_callback(timer->call());
      if (ready.subscriptions[0] && heard->take(message, info))
        say(message.data);
    };
    wait(600ms);
    guard->trigger();
    wait(600ms);
    wait(600ms);
    wait(0ms);
    timer->cancel();
    say(shown(timer->call() == nullptr));
    wait(600ms);
    set.remove_timer(timer);
    attempt([&] { set.remove_timer(timer); });
    set.remove_subscription(heard);
    set.remove_guard_condition(guard);
    wait(600ms);
  };
  all["static_wait_set"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(500ms, [] {});
    typedef rclcpp::StaticWaitSet<0, 0, 1, 0, 0, 0> Set;
    Set set({}, {}, std::array<rclcpp::TimerBase::SharedPtr, 1>{timer});
    say(shown(set.wait(2s).kind() == rclcpp::WaitResultKind::Ready));
  };
  all["wait_for_message"] = [](const Shared& node)
  {
    auto publisher = node->create_publisher<String>("to", rclcpp::QoS(1).transient_local());
    String message;
    say(shown(rclcpp::wait_for_message(message, node, "to", 500ms)));
    publisher->publish(String().set__data("hello"));
    auto late = node->create_subscription<String>("to", rclcpp::QoS(1).transient_local(), [](const String&) {});
    say(shown(rclcpp::wait_for_message(message, late, node->get_node_options().context())) + message.data);
  };
  all["loaned_message"] = [](const Shared& node)
  {
    auto texts = node->create_publisher<String>("texts", 10);
    auto numbers = node->create_publisher<UInt32>("to", 10);
    auto heard = node->create_subscription<UInt32>("to", 10, [](const UInt32& message) { say(shown(message.data)); });
    say(shown(texts->can_loan_messages()) + shown(numbers->can_loan_messages()));
    auto text = texts->borrow_loaned_message();
    auto number = numbers->borrow_loaned_message();
    number.get().data = 5;
    numbers->publish(std::move(number));
    numbers->publish<UInt32>(UInt32().set__data(6));
    say(shown(text.is_valid()) + shown(number.is_valid()));
    attempt([&] { numbers->publish(std::move(number)); });
    rclcpp::spin_all(node, 1s);
  };
  all["timers_by_interfaces"] = [](const Shared& node)
  {
    auto base = node->get_node_base_interface();
    auto timers = node->get_node_timers_interface();
    auto clock = node->get_node_clock_interface()->get_clock();
    auto one = rclcpp::create_timer(base, timers, clock, 800ms, [] { say("one"); });
    auto two = rclcpp::create_wall_timer(700ms, [] { say("two"); }, nullptr, base.get(), timers.get());
    auto call = [] { say("three"); };
    auto three = std::make_shared<rclcpp::GenericTimer<decltype(call)>>(
        clock, 1100ms, std::move(call), base->get_context());
    timers->add_timer(three, nullptr);
    auto other = std::make_shared<rclcpp::Clock>(RCL_ROS_TIME);
    rclcpp::TimeSource source(node);
    source.attachClock(other);
    say(shown(other->ros_time_is_active()) + node->get_node_logging_interface()->get_logger_name());
    rclcpp::spin(node);
  };
  all["parameter_client"] = [](const Shared& node)
  {
    node->declare_parameter("whole", 1);
    rclcpp::SyncParametersClient client(node);
    say(shown(client.wait_for_service(1s)) + std::to_string(client.get_parameter<int>("whole")));
    say(std::to_string(client.get_parameter("lacking", 9)) + std::to_string(client.get_parameters({"whole", "lacking"}).size()));
    attempt([&] { client.get_parameter<int>("lacking"); });
    for (const auto& result : client.set_parameters({rclcpp::Parameter("whole", 6), rclcpp::Parameter("lacking", 1)}))
      say(shown(result.successful) + " " + result.reason);
    say(client.set_parameters_atomically({rclcpp::Parameter("whole", 7), rclcpp::Parameter("lacking", 1)}).reason);
    say(client.set_parameters_atomically({rclcpp::Parameter("whole", "text")}).reason);
    say(std::to_string(node->get_parameter("whole").as_int()) + shown(client.has_parameter("whole")) + shown(client.has_parameter("lacking")));
    say(shown(client.get_parameter_types({"whole", "use_sim_time"})[1]) + client.describe_parameters({"whole"})[0].name);
    say(shown(client.list_parameters({}, 1).names.size() >= 2));
    auto other = std::make_shared<Node>("other");
    rclcpp::SyncParametersClient far(other, "s");
    say(shown(far.wait_for_service(1s)) + std::to_string(far.get_parameters({"whole"}, 500ms).size()));
    attempt([&] { far.list_parameters({}, 1, 500ms); });
    rclcpp::AsyncParametersClient nobody(node, "nobody");
    say(shown(nobody.wait_for_service(500ms)));
    rclcpp::AsyncParametersClient asynchronous(node.get(), "/s");
    auto future = asynchronous.get_parameters(
        {"whole"}, [](std::shared_future<std::vector<rclcpp::Parameter>> got) { say(shown(got.get()[0])); });
    say(shown(rclcpp::spin_until_future_complete(node, future)));
  };
  all["parameter_services_off"] = [](const Shared& node)
  {
    auto off = rclcpp::NodeOptions().start_parameter_services(false).start_parameter_event_publisher(false);
    auto other = std::make_shared<Node>("other", off);
    rclcpp::ParameterEventHandler handler(node);
    auto heard = handler.add_parameter_event_callback([](const auto& event) { say(event.node); });
    other->declare_parameter("whole", 1);
    say(shown(rclcpp::AsyncParametersClient(node, "other").wait_for_service(500ms)));
    say(shown(rclcpp::AsyncParametersClient(node, "s").wait_for_service(500ms)));
    rclcpp::spin_all(node, 1s);
  };
  all["parameter_events"] = [](const Shared& node)
  {
    auto other = std::make_shared<Node>("other", rclcpp::NodeOptions().allow_undeclared_parameters(true));
    node->declare_parameter("before", 1);
    rclcpp::ParameterEventHandler handler(node);
    auto first = handler.add_parameter_callback("whole", [](const auto& parameter) { say("first " + shown(parameter)); });
    auto second = handler.add_parameter_callback("whole", [](const auto& parameter) { say("second " + shown(parameter)); });
    auto third = handler.add_parameter_callback("text", [](const auto& parameter) { say("third " + shown(parameter)); }, "other");
    auto all = handler.add_parameter_event_callback(
        [](const rcl_interfaces::msg::ParameterEvent& event)
        {
          say(event.node + " " + std::to_string(event.new_parameters.size()) + std::to_string(event.changed_parameters.size()) + std::to_string(event.deleted_parameters.size()));
          for (const auto& parameter : rclcpp::ParameterEventHandler::get_parameters_from_event(event))
            say(shown(parameter));
          attempt([&] { rclcpp::ParameterEventHandler::get_parameter_from_event(event, "whole", "/s"); });
        });
    rclcpp::spin_all(node, 1s);
    node->declare_parameter("whole", 1);
    node->set_parameters_atomically({rclcpp::Parameter("whole", 2), rclcpp::Parameter("before", 3)});
    other->set_parameter(rclcpp::Parameter("text", "words"));
    other->set_parameter(rclcpp::Parameter("text"));
    rclcpp::spin_all(node, 1s);
    handler.remove_parameter_callback(first);
    attempt([&] { handler.remove_parameter_callback(first); });
    second.reset();
    handler.remove_parameter_event_callback(all);
    node->set_parameter(rclcpp::Parameter("whole", 4));
    rclcpp::spin_all(node, 1s);
  };
  all["exception_leaves_spin"] = [](const Shared& node)
  {
    auto timer = node->create_wall_timer(500ms, [] { throw std::runtime_error("in a callback"); });
    attempt([&] { rclcpp::spin(node); });
    attempt([&] { rclcpp::spin(node); });
  };
  return all;
}
}  // namespace
