// What all message classes of ROS 1 have: their fields can be gone through, and so serialised, compared and printed.
#ifndef ROSSPIN_ROS_MESSAGE_H
#define ROSSPIN_ROS_MESSAGE_H

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

#include "boost/shared_ptr.hpp"
#include "ros/time.h"

namespace ros
{
namespace serialization
{
class StreamOverrunException : public ros::Exception
{
public:
  using Exception::Exception;
};

// Whether T is a message: it has `visit`, which calls a function with the name and a reference of each field.
template<class T, class = void>
struct IsMessage : std::false_type
{
};
template<class T>
struct IsMessage<T, std::void_t<decltype(T::rosspin_type)>> : std::true_type
{
};

class Writer
{
public:
  std::string bytes;

  template<class T>
  void operator()(const char*, const T& value)
  {
    put(value);
  }

  template<class T>
  void put(const T& value)
  {
    if constexpr (IsMessage<T>::value)
      T::visit(value, *this);
    else
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put(const std::string& text)
  {
    put(static_cast<std::uint32_t>(text.size()));
    bytes += text;
  }
  void put(const Time& time)
  {
    put(time.sec);
    put(time.nsec);
  }
  void put(const Duration& duration)
  {
    put(duration.sec);
    put(duration.nsec);
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
  explicit Reader(const std::string& bytes) : at_(bytes.data()), end_(at_ + bytes.size()) {}

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
    }
    else
    {
      std::memcpy(&value, take(sizeof value), sizeof value);
    }
  }
  void get(std::string& text)
  {
    std::uint32_t size;
    get(size);
    text.assign(take(size), size);
  }
  void get(Time& time)
  {
    get(time.sec);
    get(time.nsec);
  }
  void get(Duration& duration)
  {
    get(duration.sec);
    get(duration.nsec);
  }
  template<class T>
  void get(std::vector<T>& items)
  {
    std::uint32_t size;
    get(size);
    items.clear();
    for (std::uint32_t each = 0; each < size; each++)
    {
      items.emplace_back();
      get(items.back());
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
      throw StreamOverrunException("Buffer Overrun");
    const char* begin = at_;
    at_ += size;
    return begin;
  }
  const char* at_;
  const char* end_;
};

// Prints a message as its operator<< does: a field a line, two spaces deeper for each level.
class Printer
{
public:
  Printer(std::ostream& stream, const std::string& indent = "") : stream_(stream), indent_(indent) {}

  template<class T>
  void operator()(const char* name, const T& value)
  {
    stream_ << indent_ << name << ": ";
    print(value);
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
    if constexpr (IsMessage<T>::value)
    {
      stream_ << "\n";
      Printer deeper(stream_, indent_ + "  ");
      T::visit(value, deeper);
    }
    else if constexpr (std::is_same_v<T, std::int8_t>)
    {
      stream_ << static_cast<int>(value) << "\n";
    }
    else if constexpr (std::is_same_v<T, std::uint8_t>)
    {
      stream_ << static_cast<int>(value) << "\n";
    }
    else
    {
      stream_ << value << "\n";
    }
  }
  template<class Items>
  void list(const char* name, const Items& items)
  {
    stream_ << indent_ << name << "[]\n";
    for (std::size_t each = 0; each < items.size(); each++)
    {
      stream_ << indent_ << "  " << name << "[" << each << "]: ";
      Printer(stream_, indent_ + "  ").print(items[each]);
    }
  }
  std::ostream& stream_;
  std::string indent_;
};

template<class M>
std::string serialized(const M& message)
{
  Writer writer;
  M::visit(message, writer);
  return std::move(writer.bytes);
}

template<class M>
std::uint32_t serializationLength(const M& message)
{
  return serialized(message).size();
}
}  // namespace serialization

namespace message_traits
{
template<class M>
const char* datatype()
{
  return M::rosspin_type;
}
template<class M>
const char* datatype(const M&)
{
  return M::rosspin_type;
}
template<class M>
struct DataType
{
  static const char* value() { return M::rosspin_type; }
  static const char* value(const M&) { return M::rosspin_type; }
};
template<class M>
using IsMessage = serialization::IsMessage<M>;
}  // namespace message_traits
}  // namespace ros

// What is said of each message class next to it.
#define ROSSPIN_MESSAGE(Message)                                                                                       \
  typedef ::boost::shared_ptr<Message> Message##Ptr;                                                                   \
  typedef ::boost::shared_ptr<Message const> Message##ConstPtr;                                                        \
  inline std::ostream& operator<<(std::ostream& stream, const Message& message)                                        \
  {                                                                                                                    \
    ::ros::serialization::Printer printer(stream);                                                                     \
    Message::visit(message, printer);                                                                                  \
    return stream;                                                                                                     \
  }                                                                                                                    \
  inline bool operator==(const Message& one, const Message& other)                                                     \
  {                                                                                                                    \
    return ::ros::serialization::serialized(one) == ::ros::serialization::serialized(other);                           \
  }                                                                                                                    \
  inline bool operator!=(const Message& one, const Message& other) { return !(one == other); }

#endif
