// Tells of parameters that change (source: parameter_event_handler.cpp).
#ifndef ROSSPIN_RCLCPP_PARAMETER_EVENT_HANDLER_HPP
#define ROSSPIN_RCLCPP_PARAMETER_EVENT_HANDLER_HPP

#include "rclcpp/node.hpp"

namespace rclcpp
{
struct ParameterCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterCallbackHandle)
  using ParameterCallbackType = std::function<void(const Parameter&)>;
  std::string parameter_name, node_name;
  ParameterCallbackType callback;
};
struct ParameterEventCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventCallbackHandle)
  using ParameterEventCallbackType = std::function<void(const rcl_interfaces::msg::ParameterEvent&)>;
  ParameterEventCallbackType callback;
};

class ParameterEventHandler
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventHandler)
  typedef rcl_interfaces::msg::ParameterEvent Event;
  using ParameterCallbackType = ParameterCallbackHandle::ParameterCallbackType;
  using ParameterEventCallbackType = ParameterEventCallbackHandle::ParameterEventCallbackType;

  template<class AnyNode>
  explicit ParameterEventHandler(const AnyNode& node, const QoS& qos = ParameterEventsQoS())
    : node_(node->get_node_base_interface()), callbacks_(std::make_shared<Callbacks>())
  {
    subscription_ = node->template create_subscription<Event>(
        "/parameter_events", qos, [callbacks = callbacks_](const Event& event) { callbacks->call(event); });
  }
  ParameterEventCallbackHandle::SharedPtr add_parameter_event_callback(ParameterEventCallbackType callback);
  void remove_parameter_event_callback(ParameterEventCallbackHandle::SharedPtr handle);
  ParameterCallbackHandle::SharedPtr add_parameter_callback(
      const std::string& parameter_name, ParameterCallbackType callback, const std::string& node_name = "");
  void remove_parameter_callback(ParameterCallbackHandle::SharedPtr handle);
  static bool get_parameter_from_event(const Event& event, Parameter& parameter, const std::string& parameter_name,
      const std::string& node_name = "");
  static Parameter get_parameter_from_event(
      const Event& event, const std::string& parameter_name, const std::string& node_name = "");
  static std::vector<Parameter> get_parameters_from_event(const Event& event);

private:
  // The newest is called first.
  struct Callbacks
  {
    std::list<ParameterCallbackHandle::WeakPtr> of_parameters;
    std::list<ParameterEventCallbackHandle::WeakPtr> of_events;
    void call(const Event& event);
  };
  node_interfaces::NodeBaseInterface::SharedPtr node_;
  std::shared_ptr<Callbacks> callbacks_;
  std::shared_ptr<SubscriptionBase> subscription_;
};
}  // namespace rclcpp

#endif
