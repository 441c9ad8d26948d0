// What all message classes of ROS 2 have: their fields can be gone through, and so serialised (as CDR), compared and
// printed.
#ifndef ROSSPIN_RCLCPP_MESSAGE_HPP
#define ROSSPIN_RCLCPP_MESSAGE_HPP

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace rclcpp
{
namespace detail
{
// Whether T is a message: it has `visit`, which calls a function with the name and a reference of each field.
template<class T, class = void>
struct IsMessage : std::false_type
{
};
template<class T>
struct IsMessage<T, std::void_t<decltype(T::rosspin_type)>> : std::true_type
{
};

// Writes and reads CDR as Fast CDR does: each number stands at a multiple of its size, counted from behind the head.
class Writer
{
public:
  std::string bytes{'\0', '\1', '\0', '\0'};

  template<class T>
  void operator()(const char*, const T& value)
  {
    put(value);
  }

  template<class T>
  void put(const T& value)
  {
    if constexpr (IsMessage<T>::value)
    {
      T::visit(value, *this);
      if (T::rosspin_is_empty)
        bytes += '\0';
    }
    else
    {
      bytes.append((4 - bytes.size()) % sizeof value, '\0');
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
  }
  void put(const std::string& text)
  {
    put(static_cast<std::uint32_t>(text.size() + 1));
    bytes.append(text.c_str(), text.size() + 1);
  }
  void put(const std::u16string& text)
  {
    put(static_cast<std::uint32_t>(text.size()));
    for (char16_t unit : text)
      put(static_cast<std::uint32_t>(unit));
  }
  template<class T>
  void put(const std::vector<T>& items)
  {
    put(static_cast<std::uint32_t>(items.size()));
    for (const T& item : items)
      put(item);
  }
  template<class T, std::size_t size>
  void put(const std::array<T, size>& items)
  {
    for (const T& item : items)
      put(item);
  }
};

class Reader
{
public:
  explicit Reader(const std::string& bytes) : begin_(bytes.data() + 4), at_(begin_), end_(bytes.data() + bytes.size()) {}

  template<class T>
  void operator()(const char*, T& value)
  {
    get(value);
  }

  template<class T>
  void get(T& value)
  {
    if constexpr (IsMessage<T>::value)
    {
      T::visit(value, *this);
      if (T::rosspin_is_empty)
        take(1);
    }
    else
    {
      take((begin_ - at_) & (sizeof value - 1));
      std::memcpy(&value, take(sizeof value), sizeof value);
    }
  }
  void get(std::string& text)
  {
    std::uint32_t size;
    get(size);
    text.assign(take(size), size ? size - 1 : 0);
  }
  void get(std::u16string& text)
  {
    std::uint32_t size, unit;
    get(size);
    text.clear();
    for (std::uint32_t each = 0; each < size; each++)
    {
      get(unit);
      text += static_cast<char16_t>(unit);
    }
  }
  template<class T>
  void get(std::vector<T>& items)
  {
    std::uint32_t size;
    get(size);
    items.clear();
    for (std::uint32_t each = 0; each < size; each++)
    {
      T item{};
      get(item);
      items.push_back(std::move(item));
    }
  }
  template<class T, std::size_t size>
  void get(std::array<T, size>& items)
  {
    for (T& item : items)
      get(item);
  }

private:
  const char* take(std::size_t size)
  {
    if (size > static_cast<std::size_t>(end_ - at_))
      throw std::runtime_error("the message is longer than its bytes");
    const char* begin = at_;
    at_ += size;
    return begin;
  }
  const char* begin_;
  const char* at_;
  const char* end_;
};

// Prints a message as `to_yaml` of rosidl does (source: rosidl_generator_cpp's templates).
class Printer
{
public:
  Printer(std::ostream& stream, std::size_t indent) : stream_(stream), indent_(indent) {}

  template<class T>
  void operator()(const char* name, const T& value)
  {
    stream_ << std::string(indent_, ' ') << name << ":";
    if constexpr (IsMessage<T>::value)
    {
      stream_ << "\n";
      Printer deeper(stream_, indent_ + 2);
      T::visit(value, deeper);
    }
    else
    {
      stream_ << " ";
      print(value);
      stream_ << "\n";
    }
  }
  template<class T>
  void operator()(const char* name, const std::vector<T>& items)
  {
    list(name, items);
  }
  template<class T, std::size_t size>
  void operator()(const char* name, const std::array<T, size>& items)
  {
    list(name, items);
  }

private:
  template<class T>
  void print(const T& value)
  {
    if constexpr (std::is_same_v<T, std::string>)
      stream_ << '"' << value << '"';
    else if constexpr (std::is_same_v<T, bool>)
      stream_ << (value ? "true" : "false");
    else if constexpr (std::is_floating_point_v<T>)
      stream_ << std::showpoint << value << std::noshowpoint;
    else if constexpr (std::is_integral_v<T>)
      stream_ << +value;
  }
  template<class Items>
  void list(const char* name, const Items& items)
  {
    stream_ << std::string(indent_, ' ') << name << ":" << (items.size() ? "" : " []") << "\n";
    typedef typename Items::value_type Item;
    for (const Item& item : items)
    {
      stream_ << std::string(indent_, ' ') << "-";
      if constexpr (IsMessage<Item>::value)
      {
        stream_ << "\n";
        Printer deeper(stream_, indent_ + 2);
        Item::visit(item, deeper);
      }
      else
      {
        stream_ << " ";
        print(item);
        stream_ << "\n";
      }
    }
  }
  std::ostream& stream_;
  std::size_t indent_;
};

template<class M>
std::string serialized(const M& message)
{
  Writer writer;
  writer.put(message);
  return std::move(writer.bytes);
}

template<class M>
void deserialize(const std::string& bytes, M& message)
{
  Reader reader(bytes);
  reader.get(message);
}
}  // namespace detail
}  // namespace rclcpp

// What is said of each message class, within it and next to it.
#define ROSSPIN_MESSAGE_TYPES(Message)                                                                                 \
  using RawPtr = Message*;                                                                                             \
  using ConstRawPtr = const Message*;                                                                                  \
  using SharedPtr = std::shared_ptr<Message>;                                                                          \
  using ConstSharedPtr = std::shared_ptr<Message const>;                                                               \
  using UniquePtr = std::unique_ptr<Message>;                                                                          \
  using ConstUniquePtr = std::unique_ptr<Message const>;                                                               \
  using WeakPtr = std::weak_ptr<Message>;                                                                              \
  using ConstWeakPtr = std::weak_ptr<Message const>;                                                                   \
  using Ptr = std::shared_ptr<Message>;                                                                                \
  using ConstPtr = std::shared_ptr<Message const>;                                                                     \
  bool operator==(const Message& other) const                                                                          \
  {                                                                                                                    \
    return ::rclcpp::detail::serialized(*this) == ::rclcpp::detail::serialized(other);                                 \
  }                                                                                                                    \
  bool operator!=(const Message& other) const { return !(*this == other); }
#define ROSSPIN_MESSAGE(Message)                                                                                       \
  inline void to_block_style_yaml(const Message& message, std::ostream& out, std::size_t indent = 0)                   \
  {                                                                                                                    \
    ::rclcpp::detail::Printer printer(out, indent);                                                                    \
    Message::visit(message, printer);                                                                                  \
  }                                                                                                                    \
  inline std::string to_yaml(const Message& message)                                                                   \
  {                                                                                                                    \
    std::ostringstream out;                                                                                            \
    to_block_style_yaml(message, out);                                                                                 \
    return out.str();                                                                                                  \
  }

#endif
