// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_quadrature_points_h
#define semilunar_shell_quadrature_points_h

#include <semilunar/shell/aligned.h>
#include <semilunar/spline/evaluation.h>

namespace semilunar::shell
{
  /// The Gauss points of the undeformed midsurface, with the basis functions at each. The points of
  /// an element follow each other.
  class QuadraturePoints
  {
  public:
    /// @param n_per_direction Gauss points per element and direction; 0 means degree + 1
    /// @throws InputError naming the element if the surface has no tangent plane at a Gauss point
    QuadraturePoints(const spline::Surface &surface, unsigned int n_per_direction = 0);
    /// @param numbers of Gauss points of each element in its two directions; the first runs fastest
    QuadraturePoints(const spline::Surface &surface,
                     const std::vector<std::array<unsigned int, 2>> &numbers);

    unsigned int n_points() const { return elements.size(); }
    /// First point of an element; first_point(n_elements) is n_points().
    unsigned int first_point(unsigned int element) const { return first[element]; }
    unsigned int element(unsigned int q) const { return elements[q]; }
    const spline::Point<2> &xi(unsigned int q) const { return coordinates[q]; }
    /// Gauss weight times undeformed area, in area units.
    double weight(unsigned int q) const { return weights[q]; }

    /// The functions of the point's element, or their derivatives with respect to coordinates s_1,
    /// s_2 that are lengths along an orthonormal frame of the undeformed tangent plane (the map
    /// from xi to s is linear, fixed at each point: equations (Q2) and (Q3) of
    /// doc/theory/contact.md). Padded with zeros to stride(element) numbers; starts at a cache
    /// line.
    const double *basis(unsigned int q, spline::Derivative derivative) const
    {
      return table.data() + offsets[q] + std::size_t(derivative) * strides[elements[q]];
    }
    /// Number of functions of an element, rounded up to a multiple of simd_width.
    unsigned int stride(unsigned int element) const { return strides[element]; }
    static constexpr unsigned int simd_width = 8;

    /// Unit vectors e_1, e_2 of the frame; e_1 along the first direction of the element.
    const std::array<spline::Tensor<1, 3>, 2> &frame(unsigned int q) const { return frames[q]; }

  private:
    void append_element(const spline::Surface &surface, unsigned int element,
                        const std::array<unsigned int, 2> &numbers, spline::BasisValues &basis);
    void append_point(const spline::Surface &surface, unsigned int element,
                      const spline::Point<2> &xi, double gauss_weight, spline::BasisValues &basis);

    std::vector<unsigned int> first, elements, strides;
    std::vector<std::size_t> offsets;
    std::vector<spline::Point<2>> coordinates;
    std::vector<double> weights;
    AlignedTable table; // per point: one row of stride numbers per derivative
    std::vector<std::array<spline::Tensor<1, 3>, 2>> frames;
  };
} // namespace semilunar::shell

#endif
