// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_output_surface_vtu_h
#define semilunar_output_surface_vtu_h

#include <semilunar/spline/surface.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>

namespace semilunar::output
{
  enum class CellKind
  {
    bezier, ///< rational Bezier quadrilaterals of the elements' degrees: exact geometry
    linear  ///< each element divided into bilinear quadrilaterals
  };

  /// A field on a surface.
  struct SurfaceField
  {
    std::string name;
    unsigned int n_components = 1;
    /// Writes n_components values at a point; called for the points of one element after the other,
    /// never at element corners or edges for Bezier cells.
    std::function<void(const spline::SurfacePoint &, double *)> evaluate;
  };

  struct SurfaceVtuParameters
  {
    CellKind cells = CellKind::bezier;
    unsigned int subdivisions = 4; ///< linear cells per element and direction
    bool compress = true;

    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// The field of vectors given at the control points (displacement, velocity). Refers to both
  /// arguments, which must outlive it.
  SurfaceField control_point_field(const std::string &name, const spline::Surface &surface,
                                   const std::vector<spline::Tensor<1, 3>> &control_vectors);

  /// Write a surface and fields on it as a VTU file for ParaView (5.8 or newer for Bezier cells).
  /// Geometry is exact in double precision, fields are in single precision; on Bezier cells those
  /// of the spline space are reproduced, others interpolated element by element (O2). The cells
  /// carry their element and the connected part of the surface.
  /// @param control_vectors positions of all control points in the configuration to draw
  /// @throws InputError if the file cannot be written
  void write_surface_vtu(const std::string &filename, const spline::Surface &surface,
                         const std::vector<spline::Tensor<1, 3>> &control_vectors,
                         const std::vector<SurfaceField> &fields,
                         const SurfaceVtuParameters &parameters, double time);
} // namespace semilunar::output

#endif
