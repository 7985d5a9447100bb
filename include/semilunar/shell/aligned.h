// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_aligned_h
#define semilunar_shell_aligned_h

#include <cstddef>
#include <new>
#include <vector>

namespace semilunar::shell
{
  /// Allocates at the boundaries of cache lines, which are also those of the widest SIMD registers.
  template <typename T>
  struct CacheLineAllocator
  {
    using value_type = T;
    static constexpr std::align_val_t alignment{64}; ///< bytes

    CacheLineAllocator() = default;
    template <typename U>
    CacheLineAllocator(const CacheLineAllocator<U> &)
    {
    }

    T *allocate(const std::size_t n)
    {
      return static_cast<T *>(::operator new(n * sizeof(T), alignment));
    }
    void deallocate(T *p, std::size_t) { ::operator delete(p, alignment); }

    bool operator==(const CacheLineAllocator &) const { return true; }
    bool operator!=(const CacheLineAllocator &) const { return false; }
  };

  using AlignedTable = std::vector<double, CacheLineAllocator<double>>;
} // namespace semilunar::shell

#endif
