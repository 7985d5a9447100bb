// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_nurbs_patch_h
#define semilunar_spline_nurbs_patch_h

#include <semilunar/spline/surface.h>

namespace semilunar::spline
{
  /// A clamped (open) knot vector and its degree.
  class KnotVector
  {
  public:
    /// @throws InputError unless the knots do not decrease, the end knots are repeated degree + 1
    /// times and no inner knot more than degree times.
    KnotVector(unsigned int degree, std::vector<double> knots);

    /// The open uniform knot vector on [0,1] with the given number of elements, maximal smoothness.
    static KnotVector uniform(unsigned int degree, unsigned int n_elements);

    unsigned int degree() const { return p; }
    const std::vector<double> &knots() const { return t; }
    unsigned int n_functions() const { return t.size() - p - 1; }
    /// The distinct knots: boundaries of the elements.
    std::vector<double> breakpoints() const;
    /// The averages of degree consecutive knots, one per function: with them as coefficients the
    /// spline is the parameter itself.
    std::vector<double> greville_abscissae() const;
    /// The span [t_i, t_i+1) that holds x (the last non-empty one for the right end).
    unsigned int span(double x) const;
    /// The degree + 1 functions that do not vanish on the span of x, (S6); function span - degree
    /// comes first.
    std::vector<double> evaluate(double x) const;
    /// One matrix per element, (p+1) x (p+1) row by row: local function a = sum_b C_ab Bernstein_b,
    /// (S8).
    std::vector<std::vector<double>> extraction_operators() const;

  private:
    unsigned int p;
    std::vector<double> t;
  };

  /// A tensor-product NURBS surface patch.
  class NurbsPatch
  {
  public:
    /// @param net control points, first direction fastest
    NurbsPatch(std::array<KnotVector, 2> knots, std::vector<ControlPoint> net);

    const KnotVector &knots(unsigned int direction) const { return knot_vectors[direction]; }
    unsigned int n_control_points(unsigned int direction) const
    {
      return knot_vectors[direction].n_functions();
    }
    const ControlPoint &control_point(unsigned int i, unsigned int j) const
    {
      return net[j * n_control_points(0) + i];
    }
    const std::vector<ControlPoint> &control_net() const { return net; }

    Point<3> evaluate(const Point<2> &u) const;

    /// Insert knots, (S9). Exact: the surface does not change. @throws InputError for a knot that
    /// is not inside or would be repeated more than degree times.
    void insert_knots(unsigned int direction, const std::vector<double> &values);
    /// Raise the degree, (S10). Exact: the surface and its smoothness do not change.
    void elevate_degree(unsigned int direction, unsigned int times = 1);
    /// Divide elements evenly, always the one whose parts are the widest, until there are
    /// n_elements; maximal smoothness at new knots. A symmetric knot vector stays so whenever that
    /// is possible (an even n_elements, or an odd number of elements to begin with).
    /// @throws InputError if there are more elements already.
    void refine_to(unsigned int direction, unsigned int n_elements);

  private:
    std::array<KnotVector, 2> knot_vectors;
    std::vector<ControlPoint> net;
  };

  /// Bezier extraction of a patch, (S11); the control points keep their numbers. Node sets: left,
  /// right (first direction's ends), bottom, top (second direction's ends), and the next row inside
  /// of each: nextLeft, nextRight, nextBottom, nextTop.
  Surface to_surface(const NurbsPatch &patch);
} // namespace semilunar::spline

#endif
