// Exceptions on WebAssembly. The compiler throws and catches with the instructions of WebAssembly; what it calls for
// the rest is here, as the C++ ABI for Itanium (1.15: level II) and LLVM's lowering for WebAssembly define it: clang's
// package has neither libunwind nor a libc++abi with exceptions.
#include <cctype>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <cxxabi.h>
#include <exception>
#include <functional>
#include <map>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <stdexcept>
#include <typeinfo>

// The tag of all C++ exceptions.
__asm__(".globl __cpp_exception\n.tagtype __cpp_exception i32\n__cpp_exception:\n");

namespace
{
// What can_catch of libc++abi's type_info is called through: a virtual function after a destructor and two more.
struct Catchable : std::type_info
{
  virtual void first() const;
  virtual void second() const;
  virtual bool can_catch(const Catchable* thrown, void*& object) const = 0;
};

// Comes before each thrown object.
struct alignas(16) Header
{
  const std::type_info* type;
  void* (*destroy)(void*);  // on WebAssembly a destructor returns its object
  int references;
  int handlers;      // how many catch clauses it is in; negative once it is thrown again
  Header* caught;    // the exception of the catch clause around this one's
  void* adjusted;    // the object as the type that is caught
  Header* primary;   // of one that another exception_ptr rethrows: that whose object it shares
};

}  // namespace

// Of the thread that runs: the exception of its innermost catch clause, and how many are on their way.
extern "C"
{
struct
{
  Header* caught;
  unsigned uncaught;
} rosspin_handling;
Header* rosspin_raised;  // last
}

namespace
{
auto& [caught_here, uncaught] = rosspin_handling;

Header* header_of(void* object) { return static_cast<Header*>(object) - 1; }
void* object_of(Header* header) { return header + 1; }

[[noreturn]] void raise(Header* header)
{
  uncaught++;
  rosspin_raised = header;
  __builtin_wasm_throw(0, header);
}

void release(Header* header)
{
  if (--header->references > 0)
    return;
  if (header->destroy)
    header->destroy(object_of(header));
  std::free(header);
}

std::uintptr_t read_unsigned(const std::uint8_t*& at)
{
  std::uintptr_t value = 0;
  for (int shift = 0;; shift += 7)
  {
    std::uint8_t byte = *at++;
    value |= static_cast<std::uintptr_t>(byte & 0x7f) << shift;
    if (byte < 0x80)
      return value;
  }
}

std::intptr_t read_signed(const std::uint8_t*& at)
{
  std::intptr_t value = 0;
  for (int shift = 0;;)
  {
    std::uint8_t byte = *at++;
    value |= static_cast<std::intptr_t>(byte & 0x7f) << shift;
    shift += 7;
    if (byte < 0x80)
      return byte & 0x40 && shift < 32 ? value | -(static_cast<std::intptr_t>(1) << shift) : value;
  }
}

// Name a type as libstdc++ does, if it is a number, a text or a class without parameters; else as the compiler does. The
// library's own demangler would be a fifth of a program.
std::string readable(const std::string& mangled)
{
  static const std::map<std::string, std::string> others = {{"b", "bool"}, {"c", "char"}, {"d", "double"},
      {"f", "float"}, {"i", "int"}, {"j", "unsigned int"}, {"l", "long"}, {"m", "unsigned long"}, {"x", "long long"},
      {"y", "unsigned long long"}, {"PKc", "char const*"}, {"Pc", "char*"},
      {"NSt3__212basic_stringIcNS_11char_traitsIcEENS_9allocatorIcEEEE",
          "std::__cxx11::basic_string<char, std::char_traits<char>, std::allocator<char> >"}};
  if (auto found = others.find(mangled); found != others.end())
    return found->second;
  std::string name;
  std::size_t at = mangled[0] == 'N', end = mangled.size() - at;
  if (mangled.compare(at, 2, "St") == 0)
  {
    name = "std";
    at += 2;
  }
  while (at < end && std::isdigit(static_cast<unsigned char>(mangled[at])))
  {
    char* rest;
    std::size_t length = std::strtoul(&mangled[at], &rest, 10);
    at = rest - mangled.data();
    std::string part = mangled.substr(at, length);
    at += length;
    if (part != "__2")  // of libc++
      name += (name.empty() ? "" : "::") + (part == "_GLOBAL__N_1" ? "(anonymous namespace)" : part);
  }
  return at == end ? name : mangled;
}

// Says what ends the program, as libstdc++ does, which the real ROS is built with. There, what nothing catches ends it
// before any destructor could.
[[noreturn]] void say_and_abort()
{
  if (uncaught && !caught_here)
    __cxxabiv1::__cxa_begin_catch(rosspin_raised);
  if (const std::type_info* type = __cxxabiv1::__cxa_current_exception_type())
  {
    std::fprintf(stderr, "terminate called after throwing an instance of '%s'\n", readable(type->name()).c_str());
    try
    {
      throw;
    }
    catch (const std::exception& error)
    {
      std::fprintf(stderr, "  what():  %s\n", error.what());
    }
    catch (...)
    {
    }
  }
  else
  {
    std::fputs("terminate called without an active exception\n", stderr);
  }
  std::abort();
}

__attribute__((constructor)) void prepare() { std::set_terminate(say_and_abort); }
}  // namespace

extern "C"
{
struct
{
  std::uintptr_t pad;
  const std::uint8_t* table;
  std::uintptr_t selector;
} __wasm_lpad_context;

// Find the catch clause for an exception: the landing pad and its function's table are in the context, and the
// selector of the clause is put there; 0 if there is none.
int _Unwind_CallPersonality(void* thrown)
{
  Header* header = static_cast<Header*>(thrown);
  Header* primary = header->primary ? header->primary : header;
  const std::uint8_t* at = __wasm_lpad_context.table;
  __wasm_lpad_context.selector = 0;
  if (*at++ != 0xff)  // where landing pads begin
    read_unsigned(at);
  const std::uint8_t* types = nullptr;
  if (*at++ != 0xff)
  {
    std::uintptr_t offset = read_unsigned(at);
    types = at + offset;
  }
  at++;  // how call sites are encoded
  std::uintptr_t length = read_unsigned(at);
  const std::uint8_t* actions = at + length;
  std::uintptr_t action = 0;
  for (std::uintptr_t site = 0; site <= __wasm_lpad_context.pad; site++)
  {
    read_unsigned(at);
    action = read_unsigned(at);
  }
  if (action == 0)
    return 0;
  for (at = actions + action - 1;;)
  {
    std::intptr_t index = read_signed(at);
    if (index > 0)
    {
      const Catchable* type;
      std::memcpy(&type, types - index * sizeof type, sizeof type);
      void* object = object_of(primary);
      if (!type || type->can_catch(static_cast<const Catchable*>(primary->type), object))
      {
        // Only a catch clause for the object itself needs to know where in it its type begins.
        header->adjusted = type ? object : object_of(primary);
        __wasm_lpad_context.selector = index;
        return 0;
      }
    }
    const std::uint8_t* next = at;
    std::intptr_t offset = read_signed(at);
    if (offset == 0)
      return 0;
    at = next + offset;
  }
}

void* __cxa_allocate_exception(std::size_t size) noexcept
{
  auto header = static_cast<Header*>(std::calloc(1, sizeof(Header) + size));
  if (!header)
    std::terminate();
  return object_of(header);
}

void __cxa_free_exception(void* object) noexcept { std::free(header_of(object)); }

__cxxabiv1::__cxa_exception* __cxa_init_primary_exception(
    void* object, std::type_info* type, void* (*destroy)(void*)) noexcept
{
  Header* header = header_of(object);
  header->type = type;
  header->destroy = destroy;
  header->adjusted = object;
  return reinterpret_cast<__cxxabiv1::__cxa_exception*>(header);
}

void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*))
{
  __cxa_init_primary_exception(object, type, destroy);
  header_of(object)->references = 1;
  raise(header_of(object));
}

void* __cxa_get_exception_ptr(void* thrown) noexcept { return static_cast<Header*>(thrown)->adjusted; }

void* __cxa_begin_catch(void* thrown) noexcept
{
  Header* header = static_cast<Header*>(thrown);
  header->handlers = header->handlers < 0 ? 1 - header->handlers : header->handlers + 1;
  if (caught_here != header)
  {
    header->caught = caught_here;
    caught_here = header;
  }
  uncaught--;
  return header->adjusted;
}

void __cxa_end_catch()
{
  Header* header = caught_here;
  if (!header)
    return;
  if (header->handlers < 0)  // it is on its way again
  {
    if (++header->handlers == 0)
      caught_here = header->caught;
  }
  else if (--header->handlers == 0)
  {
    caught_here = header->caught;
    if (header->primary)
    {
      release(header->primary);
      std::free(header);
    }
    else
    {
      release(header);
    }
  }
}

void __cxa_rethrow()
{
  if (!caught_here)
    std::terminate();
  caught_here->handlers = -caught_here->handlers;
  raise(caught_here);
}

std::type_info* __cxa_current_exception_type()
{
  if (!caught_here)
    return nullptr;
  Header* primary = caught_here->primary ? caught_here->primary : caught_here;
  return const_cast<std::type_info*>(primary->type);
}

bool __cxa_uncaught_exception() noexcept { return uncaught > 0; }
unsigned __cxa_uncaught_exceptions() noexcept { return uncaught; }

void __cxa_increment_exception_refcount(void* object) noexcept
{
  if (object)
    header_of(object)->references++;
}

void __cxa_decrement_exception_refcount(void* object) noexcept
{
  if (object)
    release(header_of(object));
}

void* __cxa_current_primary_exception() noexcept
{
  if (!caught_here)
    return nullptr;
  Header* primary = caught_here->primary ? caught_here->primary : caught_here;
  primary->references++;
  return object_of(primary);
}

void __cxa_rethrow_primary_exception(void* object)
{
  if (!object)
    return;
  auto dependent = static_cast<Header*>(std::calloc(1, sizeof(Header)));
  dependent->primary = header_of(object);
  dependent->primary->references++;
  raise(dependent);
}

void rosspin_left_main();

// What ends a program whose exception nothing catches; the host calls it with what has left the program.
__attribute__((export_name("rosspin_uncaught"))) void rosspin_uncaught(void* thrown)
{
  __cxa_begin_catch(thrown);
  rosspin_left_main();
  std::terminate();
}

// The library is compiled without exceptions: where it would throw one, it calls this with a text that begins with its
// type. The library declares this function in a way that keeps it from throwing; so it is defined by its symbol.
[[noreturn]] void rosspin_throw_for_library(const char* format, ...) __asm__(
    "_ZNSt3__222__libcpp_verbose_abortEPKcz");

[[noreturn]] void rosspin_throw_for_library(const char* format, ...)
{
  char text[1000];
  va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof text, format, values);
  va_end(values);
  std::string all(text), type = all.substr(0, all.find(' ')), what = type;
  if (std::size_t from = all.find('"'), to = all.rfind('"'); from != std::string::npos && from < to)
    what = all.substr(from + 1, to - from - 1);
  for (const char* added : {": no conversion", ": out of range"})  // libstdc++ names the function only
    if (std::size_t at = what.rfind(added); at != std::string::npos && at + std::strlen(added) == what.size())
      what.resize(at);
  if (type.compare(0, 5, "std::") == 0)
    type = type.substr(5);
  if (type == "out_of_range")
    throw std::out_of_range(what);
  if (type == "invalid_argument")
    throw std::invalid_argument(what);
  if (type == "length_error")
    throw std::length_error(what);
  if (type == "bad_alloc")
    throw std::bad_alloc();
  if (type == "bad_cast")
    throw std::bad_cast();
  if (type == "bad_function_call")
    throw std::bad_function_call();
  if (type == "bad_optional_access")
    throw std::bad_optional_access();
  if (std::size_t at = all.find_first_of("0123456789"); type == "system_error" && at != std::string::npos)
    throw std::system_error(std::atoi(&all[at]), std::generic_category());
  if (type == "system_error" || type == "filesystem_error")
    throw std::system_error(std::make_error_code(std::errc::not_supported), what);
  throw std::runtime_error(what);
}
}

// The library's own end the program where there is no memory left.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size ? size : 1); }
void* operator new[](std::size_t size, const std::nothrow_t& nothrow) noexcept { return operator new(size, nothrow); }
void* operator new(std::size_t size)
{
  if (void* made = operator new(size, std::nothrow))
    return made;
  throw std::bad_alloc();
}
