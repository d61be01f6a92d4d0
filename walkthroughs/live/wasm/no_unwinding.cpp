// Where a page runs nothing can be caught. Whatever is thrown there is a fault of ours: its words go to the page, which then makes a
// new instance.
#include <cstdlib>
#include <exception>
#include <typeinfo>

// The beginning of libc++abi's own class of all type_infos: its table of virtual functions is laid out so.
namespace __cxxabiv1 {
struct __shim_type_info : std::type_info {
  ~__shim_type_info() override;
  virtual void noop1() const;
  virtual void noop2() const;
  virtual bool can_catch(const __shim_type_info* thrown, void*& object) const = 0;
};
}  // namespace __cxxabiv1

extern "C" {

[[noreturn, clang::import_module("page"), clang::import_name("thrown")]] void tell_page(const char* what);

void* __cxa_allocate_exception(std::size_t size) { return std::malloc(size); }
void __cxa_free_exception(void* exception) { std::free(exception); }
[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void (*)(void*)) {
  using Info = __cxxabiv1::__shim_type_info;
  void* as_exception = object;
  if (static_cast<const Info*>(&typeid(std::exception))->can_catch(static_cast<const Info*>(type), as_exception))
    tell_page(static_cast<std::exception*>(as_exception)->what());
  tell_page(type->name());
}
void* __cxa_begin_catch(void*) { std::abort(); }
void __cxa_end_catch() { std::abort(); }
[[noreturn]] void __cxa_rethrow() { std::abort(); }

// Debian's library of the compiler asks for these.
unsigned long __stack_chk_guard = 0x51a7e5;
[[noreturn]] void __stack_chk_fail() { std::abort(); }

}
