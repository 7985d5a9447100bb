// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_surface_h
#define semilunar_spline_surface_h

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace semilunar::spline
{
  using dealii::Point;
  using dealii::Tensor;

  /// A control point: Cartesian position (not multiplied by the weight) and rational weight.
  struct ControlPoint
  {
    Point<3> position;
    double weight = 1.;
  };

  /// One Bezier element. On it, function a is N_a = sum_b C_ab B_b with the tensor-product
  /// Bernstein polynomials B_b on [0,1]^2, b = j (p+1) + i, i along the first direction (fastest).
  /// The rational function is R_a = w_a N_a / sum_c w_c N_c.
  struct BezierElement
  {
    std::array<unsigned int, 2> degree;       ///< p, q
    std::vector<unsigned int> control_points; ///< the n control points whose functions live here
    std::vector<double> extraction;           ///< C: n x (p+1)(q+1), row by row

    unsigned int n_functions() const { return control_points.size(); }
    unsigned int n_bernstein() const { return (degree[0] + 1) * (degree[1] + 1); }
  };

  enum class SetKind
  {
    node,    ///< members are control points
    element, ///< members are elements
    side     ///< members are pairs (element, side), flattened
  };

  struct NamedSet
  {
    SetKind kind;
    std::string name;
    std::vector<unsigned int> members;
  };

  /// The one interface through which analysis sees a spline surface, wherever it came from.
  struct Surface
  {
    std::vector<ControlPoint> control_points;
    std::vector<BezierElement> elements;
    std::vector<NamedSet> sets;

    /// The set of this kind and name, or nullptr.
    const NamedSet *find_set(SetKind kind, const std::string &name) const;
  };

  /// A point of a surface: element and local coordinates in [0,1]^2.
  struct SurfacePoint
  {
    unsigned int element = dealii::numbers::invalid_unsigned_int;
    Point<2> xi;
  };

  /// One number per element: which edge-connected piece of the surface it belongs to (elements that
  /// share a control point are connected), counted from 0 in the order of the elements.
  std::vector<unsigned int> connected_parts(const Surface &surface);

  /// Append b to a; a control point of b that is not farther than the tolerance from one of a (and
  /// has the same weight) is merged with the nearest one. A negative tolerance merges nothing. Sets
  /// of equal kind and name are united. Cost linear in the sizes.
  void append(Surface &a, const Surface &b, double tolerance);

  /// Check partition of unity, index ranges, positive weights, finite numbers and sizes.
  /// @throws InputError naming @p source (a file or entry) and the element or control point.
  void check(const Surface &surface, const std::string &source);
} // namespace semilunar::spline

#endif
