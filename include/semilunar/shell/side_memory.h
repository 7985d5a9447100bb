// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_side_memory_h
#define semilunar_shell_side_memory_h

#include <semilunar/spline/surface.h>

#include <boost/serialization/vector.hpp>

namespace semilunar::shell
{
  /// On which side (+-1, along the surface's normal) of its neighbors each quadrature point lay in
  /// the last accepted configuration.
  class SideMemory
  {
  public:
    struct Entry
    {
      unsigned int q, part;
      int side;
      spline::SurfacePoint foot; ///< nearest point of the part

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &q &part &side &foot.element &foot.xi;
      }
    };

    explicit SideMemory(unsigned int n_points) : first(n_points + 1, 0) {}

    /// What is known of point q and the part, or nullptr.
    const Entry *find(unsigned int q, unsigned int part) const
    {
      for (std::size_t i = first[q]; i < first[q + 1]; ++i)
        if (entries[i].part == part)
          return &entries[i];
      return nullptr;
    }

    /// Forget everything and remember these, in ascending order of q.
    void replace(std::vector<Entry> new_entries)
    {
      entries = std::move(new_entries);
      std::size_t i = 0;
      for (unsigned int q = 0; q < first.size(); ++q)
      {
        while (i < entries.size() && entries[i].q < q)
          ++i;
        first[q] = i;
      }
    }

    /// Save or restore.
    template <class Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &entries &first;
    }

  private:
    std::vector<Entry> entries;
    std::vector<std::size_t> first; // entry of each point; the last one is their number
  };
} // namespace semilunar::shell

#endif
