// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_contact_h
#define semilunar_shell_contact_h

#include <semilunar/shell/quadrature_points.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>

namespace semilunar::shell
{
  struct ContactParameters
  {
    bool enabled = false;
    double distance = 0.0237; ///< midsurfaces repel each other below this distance [cm]
    double stiffness = 1e8;   ///< pressure per penetration [dyn/cm^3]
    double smoothing = 0.001; ///< penetration over which the stiffness sets in [cm]
    double self_distance =
        0.; ///< undeformed distance from which a piece touches itself [cm]; 0: never

    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// Frictionless contact of the pieces of a shell with each other: a penalty potential of the
  /// distance between each quadrature point and the nearest point of another piece (both ways, each
  /// with half the weight), on the side on which the point was before it came near.
  class Contact
  {
  public:
    /// A quadrature point within reach of another piece.
    struct ContactPoint
    {
      unsigned int q;               ///< quadrature point
      spline::SurfacePoint partner; ///< nearest point of the other piece
      spline::Tensor<1, 3>
          normal;      ///< unit vector from the partner to the point (gap grows along it)
      double gap;      ///< distance of the midsurfaces (signed) minus the contact distance
      double pressure; ///< per undeformed area of the point's piece
    };

    Contact(const spline::Surface &surface, const QuadraturePoints &points,
            const ContactParameters &parameters);

    /// Find the partners of all points with control points at @p x. Everything below refers to this
    /// state.
    void update(const std::vector<spline::Tensor<1, 3>> &x);

    const std::vector<ContactPoint> &contact_points() const { return active; }
    double energy() const;
    /// Add the derivative of the energy with respect to the control points.
    void add_gradient(std::vector<spline::Tensor<1, 3>> &gradient) const;

    /// Hand over the second derivatives of the energy, one dense block per contact point: the
    /// control points involved (c of them, those of the point's and of the partner's element,
    /// possibly repeated) and the (3c) x (3c) matrix, row by row.
    using AddBlock = std::function<void(const std::vector<unsigned int> &control_points,
                                        const std::vector<double> &matrix)>;
    void add_hessian(const AddBlock &add) const;

    /// The state of the last update is accepted: remember on which side of its neighbours each
    /// point lies.
    void accept();

  private:
    std::vector<ContactPoint> active;
  };
} // namespace semilunar::shell

#endif
