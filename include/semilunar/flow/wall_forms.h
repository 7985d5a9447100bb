// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_wall_forms_h
#define semilunar_flow_wall_forms_h

#include <semilunar/flow/spaces.h>
#include <semilunar/flow/wall_parameters.h>

#include <memory>

namespace semilunar::flow
{
  /// The integrals over wall cells, equations (3) to (6) of doc/theory/wall.md, evaluated on the
  /// reference geometry without matrices at all Gauss points of n_lanes cells at once.
  ///
  /// Vectors that are read must be readable (Spaces::make_readable_velocity); vectors that are
  /// written are added to, hanging nodes and ghosts included: fold and compress them afterwards.
  template <int dim>
  class WallForms
  {
  public:
    static std::unique_ptr<WallForms> create(const Spaces<dim> &spaces,
                                             const WallParameters &parameters);
    virtual ~WallForms() = default;

    /// Make the geometry at rest, in which the wall is free of stress at first. Collective.
    /// @throws NumericsError on all ranks if a cell is degenerate
    virtual void set_reference(const Vector &positions) = 0;

    /// From now on the stress in the geometry at rest is that of a linear elastic body with this
    /// readable displacement, equation (P3), until set_reference().
    virtual void set_prestress(const Vector &displacement) = 0;

    /// Deformation gradients that the derivative is about. Of ghost cells as well.
    /// @param inertia alpha_0 [1/s]; 0: the derivative with respect to positions, without inertia
    virtual void linearise(const Vector &positions, double inertia) = 0;

    /// Add the residual of the momentum equation with du/dt = inertia u + history.
    virtual void add_residual(const Vector &positions, const Vector &velocity,
                              const Vector &history, double inertia, Vector &momentum) const = 0;
    /// Add its derivative with respect to the velocity, applied to a velocity; positions change by
    /// 1/inertia of it.
    virtual void add_jacobian(const Vector &velocity, Vector &momentum) const = 0;
    /// Matrices of cells of a batch, [node][component][node][component][lane].
    virtual void tangent_matrix(unsigned int batch, Lanes *matrix) const = 0;

    /// Of the cells that a rank owns.
    struct Energies
    {
      double strain = 0., kinetic = 0.; ///< [erg]
    };
    virtual Energies energies(const Vector &positions, const Vector &velocity) const = 0;
    /// Of a rank's own cells [cm^dim]; smallest determinant of the deformation gradient.
    virtual double reference_volume() const = 0;
    virtual double smallest_determinant(const Vector &positions) const = 0;
  };
} // namespace semilunar::flow

#endif
