// Counts what the program allocates with new. A file of its own, so that no compiler sees a new and its delete together and warns
// of malloc and free inside.
#include <cstdlib>
#include <new>

namespace {

std::size_t count = 0;

std::size_t at_least_one(std::size_t size) { return size > 0 ? size : 1; }

void* counted_malloc(std::size_t size) {
  ++count;
  return std::malloc(at_least_one(size));
}

void* or_throw(void* memory) {
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

namespace gjk::test {
std::size_t allocations();
}
std::size_t gjk::test::allocations() { return count; }

void* operator new(std::size_t size) { return or_throw(counted_malloc(size)); }
void* operator new[](std::size_t size) { return or_throw(counted_malloc(size)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted_malloc(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return counted_malloc(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto a = static_cast<std::size_t>(alignment);
  ++count;
  return or_throw(std::aligned_alloc(a, (at_least_one(size) + a - 1) / a * a));
}
void* operator new[](std::size_t size, std::align_val_t alignment) { return operator new(size, alignment); }

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
