// Registers a component, which runs in a program of its own here.
#ifndef ROSSPIN_RCLCPP_COMPONENTS_REGISTER_NODE_MACRO_HPP
#define ROSSPIN_RCLCPP_COMPONENTS_REGISTER_NODE_MACRO_HPP

#include "rclcpp/rclcpp.hpp"

namespace rclcpp_components
{
struct Component
{
  std::shared_ptr<void> node;
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base;
};
typedef std::function<Component(const rclcpp::NodeOptions&)> Make;
std::vector<Make>& components();

template<class NodeClass>
struct Registered
{
  Registered()
  {
    components().push_back(
        [](const rclcpp::NodeOptions& options)
        {
          auto node = std::make_shared<NodeClass>(options);
          return Component{node, node->get_node_base_interface()};
        });
  }
};
}  // namespace rclcpp_components

#define RCLCPP_COMPONENTS_REGISTER_NODE(NodeClass)                                                                     \
  static rclcpp_components::Registered<NodeClass> RCLCPP_STRING_JOIN(rosspin_component_, __COUNTER__);

#endif
