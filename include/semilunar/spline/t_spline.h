// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_t_spline_h
#define semilunar_spline_t_spline_h

#include <semilunar/spline/nurbs_patch.h>
#include <semilunar/spline/t_mesh.h>

namespace semilunar::spline
{
  /// A blending function of a T-spline: the product of two B-splines with local knot vectors, (T1).
  struct BlendingFunction
  {
    TMesh::Point vertex; ///< of the T-mesh, which it belongs to
    /// Functions of the same vertex on the boundary, where end knots are repeated: 0 has its middle
    /// knot at the first of the repeated ones, (degree - 1) / 2 does not vanish on the boundary.
    std::array<unsigned int, 2> shift;
    std::array<std::vector<TMesh::Coordinate>, 2> knots; ///< degree + 2 in each direction
  };

  /// The functions of a T-mesh, sorted by their second and then their first coordinate, which is
  /// the order of the control points of a NURBS patch where the mesh is a grid.
  std::vector<BlendingFunction> blending_functions(const TMesh &mesh);

  /// A linear map of control points (in homogeneous coordinates), row by row.
  struct SparseRow
  {
    std::vector<unsigned int> columns;
    std::vector<double> values;
  };
  using RefinementMatrix = std::vector<SparseRow>;

  /// The control points that the matrix makes of these, (T6).
  std::vector<ControlPoint> refined(const RefinementMatrix &matrix,
                                    const std::vector<ControlPoint> &points);

  /// The same for other positions of the control points, as those of the deformed surface.
  std::vector<Tensor<1, 3>> refined(const RefinementMatrix &matrix,
                                    std::vector<ControlPoint> points,
                                    const std::vector<Tensor<1, 3>> &positions);

  /// A T-spline surface on a rectangular T-mesh with clamped ends, rational, of odd degree.
  class TSpline
  {
  public:
    /// The T-mesh is the grid of the patch's elements, the surface the patch.
    /// @throws InputError unless both degrees are the same odd number and no inner knot is repeated
    explicit TSpline(const NurbsPatch &patch);

    const TMesh &mesh() const { return t_mesh; }
    const std::vector<BlendingFunction> &functions() const { return blending; }
    const std::vector<ControlPoint> &control_points() const { return net; }

    /// The parameter of a coordinate of the T-mesh: linear between the knots of the patch.
    double parameter(unsigned int direction, TMesh::Coordinate x) const;

    /// The local knot vector of a function as parameters.
    std::vector<double> knots(const BlendingFunction &function, unsigned int direction) const;

    /// Refine the mesh as TMesh::refine() and express the same surface by the new functions, (T6).
    /// @return the matrix that maps the old homogeneous control points to the new ones
    RefinementMatrix refine(const std::vector<unsigned int> &marked);

    /// Refine until no element that @p wanted holds of is left; wanted is asked with the low and
    /// high corner as parameters and with the number of halvings so far.
    using Wanted = std::function<bool(const Point<2> &low, const Point<2> &high, unsigned int)>;
    void refine_where(const Wanted &wanted);

  private:
    unsigned int p;
    std::array<std::vector<double>, 2> breakpoints;
    TMesh t_mesh;
    std::vector<BlendingFunction> blending;
    std::vector<ControlPoint> net;
  };

  /// Where a Bezier element of a T-spline lies in the T-mesh.
  struct BezierBox
  {
    TMesh::Point low, high;
    unsigned int t_element; ///< the element of the T-mesh that it is, or is part of
  };

  /// Bezier elements: elements of the T-mesh, divided by extensions of T-junctions, (T7).
  std::vector<BezierBox> bezier_boxes(const TMesh &mesh);

  /// Bezier extraction of a T-spline, (T8), with the node sets of to_surface(NurbsPatch). Elements
  /// are in the order of bezier_boxes().
  /// @throws InputError naming @p source if the mesh is not analysis-suitable
  Surface to_surface(const TSpline &spline, const std::string &source = "T-mesh");

  /// The Bernstein coefficients on [a,b] of the B-spline with these degree + 2 knots, none of which
  /// lies between a and b, (T8).
  void extract_function(const std::vector<double> &knots, double a, double b, double *coefficients);
} // namespace semilunar::spline

#endif
