// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_valve_element_sizes_h
#define semilunar_valve_element_sizes_h

#include <semilunar/spline/t_spline.h>

#include <filesystem>

namespace semilunar::valve
{
  /// How large elements are where on a leaflet: those of a mesh that suits its purpose, as low and
  /// high corners in the leaflet's parameters, [0,1]^2 (commissure to commissure, attachment to
  /// free edge). Other meshes may be refined to the same sizes.
  class ElementSizes
  {
  public:
    /// The elements of a leaflet.
    explicit ElementSizes(const spline::TSpline &leaflet);

    /// Read what write() wrote.
    /// @throws InputError naming the file and the line
    explicit ElementSizes(const std::filesystem::path &file);

    /// A table u_low,v_low,u_high,v_high.
    /// @throws InputError if the file cannot be written
    void write(const std::filesystem::path &file) const;

    /// Whether an element is more than sqrt(2) times as long or as wide as one of these whose
    /// middle it holds. Halved until it is not, a mesh of the same grid becomes the same mesh.
    bool is_too_large(const spline::Point<2> &low, const spline::Point<2> &high) const;

  private:
    struct Box
    {
      spline::Point<2> low, high;
    };
    std::vector<Box> boxes;
  };
} // namespace semilunar::valve

#endif
