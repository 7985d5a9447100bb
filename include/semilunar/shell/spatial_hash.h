// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_spatial_hash_h
#define semilunar_shell_spatial_hash_h

#include <deal.II/base/tensor.h>

#include <array>
#include <cstdint>
#include <vector>

namespace semilunar::shell
{
  /// Axis-parallel boxes sorted into the cells of a uniform grid that they touch; cells share
  /// buckets of a hash table, so memory and time are proportional to the number of boxes whatever
  /// the extent of the scene.
  class SpatialHash
  {
  public:
    struct Box
    {
      dealii::Tensor<1, 3> lower, upper;
    };

    /// @param smallest_cell lower limit of the size of a cell; cells grow with the boxes so that no
    /// box touches too many
    void build(const std::vector<Box> &boxes, double smallest_cell);

    /// The boxes whose cells share the bucket of x, each once, in ascending order. All boxes that
    /// hold x are among them.
    struct Range
    {
      const unsigned int *first, *last;
      const unsigned int *begin() const { return first; }
      const unsigned int *end() const { return last; }
    };
    Range near(const dealii::Tensor<1, 3> &x) const;

  private:
    using Cell = std::array<std::int64_t, 3>;
    Cell cell(const dealii::Tensor<1, 3> &x) const;
    std::size_t bucket(const Cell &c) const;
    /// Call visit(bucket, box) for each bucket that a box touches, for one box after the other,
    /// each pair once.
    template <typename Visit>
    void for_each_bucket(const std::vector<Box> &boxes, Visit &&visit);

    double cell_size = 1.;
    std::vector<std::size_t> starts; // of the buckets in members; their number is a power of two
    std::vector<unsigned int> members;
    std::vector<unsigned int> last_visitor; // per bucket, to recognise repetitions
  };
} // namespace semilunar::shell

#endif
