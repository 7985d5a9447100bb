// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/spatial_hash.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace semilunar::shell
{
  namespace
  {
    /// The size of cells: the mean extent of the boxes, but large enough that a single huge box
    /// (in a diverging iteration) does not touch cells without number.
    double choose_cell_size(const std::vector<SpatialHash::Box> &boxes, const double smallest)
    {
      constexpr double most_cells_across_a_box = 16.;
      double sum = 0., largest = 0.;
      for (const SpatialHash::Box &box : boxes)
      {
        const auto size = box.upper - box.lower;
        const double extent = std::max({size[0], size[1], size[2]});
        sum += extent;
        largest = std::max(largest, extent);
      }
      return std::max({smallest, sum / std::max<std::size_t>(1, boxes.size()),
                       largest / most_cells_across_a_box});
    }
  } // namespace

  SpatialHash::Cell SpatialHash::cell(const dealii::Tensor<1, 3> &x) const
  {
    Cell c;
    for (unsigned int d = 0; d < 3; ++d)
      c[d] = static_cast<std::int64_t>(std::floor(x[d] / cell_size));
    return c;
  }

  std::size_t SpatialHash::bucket(const Cell &c) const
  {
    // large odd factors scatter neighbouring cells over the low bits
    const std::uint64_t h = static_cast<std::uint64_t>(c[0]) * 0x9E3779B97F4A7C15u ^
                            static_cast<std::uint64_t>(c[1]) * 0xC2B2AE3D27D4EB4Fu ^
                            static_cast<std::uint64_t>(c[2]) * 0x165667B19E3779F9u;
    return (h ^ (h >> 32)) & (starts.size() - 2);
  }

  template <typename Visit>
  void SpatialHash::for_each_bucket(const std::vector<Box> &boxes, Visit &&visit)
  {
    last_visitor.assign(starts.size(), dealii::numbers::invalid_unsigned_int);
    for (unsigned int box = 0; box < boxes.size(); ++box)
    {
      const Cell lower = cell(boxes[box].lower), upper = cell(boxes[box].upper);
      Cell c;
      for (c[0] = lower[0]; c[0] <= upper[0]; ++c[0])
        for (c[1] = lower[1]; c[1] <= upper[1]; ++c[1])
          for (c[2] = lower[2]; c[2] <= upper[2]; ++c[2])
          {
            const std::size_t b = bucket(c);
            if (last_visitor[b] != box)
              visit(b, box);
            last_visitor[b] = box;
          }
    }
  }

  void SpatialHash::build(const std::vector<Box> &boxes, const double smallest_cell)
  {
    constexpr std::size_t buckets_per_box = 8;
    std::size_t n_buckets = 2;
    while (n_buckets < buckets_per_box * boxes.size())
      n_buckets *= 2;
    cell_size = choose_cell_size(boxes, smallest_cell);
    starts.assign(n_buckets + 1, 0);

    for_each_bucket(boxes, [&](const std::size_t b, unsigned int) { ++starts[b + 1]; });
    for (std::size_t b = 0; b < n_buckets; ++b)
      starts[b + 1] += starts[b];
    members.resize(starts.back());
    std::vector<std::size_t> end(starts.begin(), starts.end() - 1);
    for_each_bucket(boxes,
                    [&](const std::size_t b, const unsigned int box) { members[end[b]++] = box; });
  }

  SpatialHash::Range SpatialHash::near(const dealii::Tensor<1, 3> &x) const
  {
    if (members.empty())
      return {nullptr, nullptr};
    const std::size_t b = bucket(cell(x));
    return {members.data() + starts[b], members.data() + starts[b + 1]};
  }
} // namespace semilunar::shell
