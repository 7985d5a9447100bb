// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_equations_h
#define semilunar_flow_equations_h

#include <semilunar/flow/boundary_conditions.h>
#include <semilunar/flow/boundary_faces.h>
#include <semilunar/flow/cell_forms.h>
#include <semilunar/flow/flow_vector.h>
#include <semilunar/flow/point_terms.h>
#include <semilunar/flow/velocity_constraints.h>
#include <semilunar/flow/wall_equations.h>

namespace semilunar::flow
{
  /// The discrete equations of a time step: residual and its derivative, cells, boundaries and
  /// points together. Residuals are masked: zero where velocities are given.
  template <int dim>
  class Equations
  {
  public:
    /// @param wall nullptr: the mesh has no wall cells
    Equations(const Spaces<dim> &spaces, const Parameters &parameters,
              const BoundaryConditions<dim> &conditions, const WallParameters *wall);

    /// After the mesh was refined. @param positions of the nodes, readable, and those at rest
    void reinit(const Vector &positions, const Vector &reference);
    /// After nodes have moved.
    void update_geometry(const Vector &positions);

    /// A step: what is fixed during its iterations. All vectors readable.
    struct Step
    {
      Bdf bdf;
      double time = 0.;                      ///< the new one
      const Vector *history = nullptr;       ///< alpha_1 u_old + alpha_2 u_older
      const Vector *mesh_velocity = nullptr; ///< nullptr: at rest
    };
    void start_step(const Step &step, const VectorFunction<dim> &body_force);
    /// @param advecting readable; also the velocity of the wall that its tangent is for
    void linearise(const Vector &advecting, bool newton);

    /// Ghosts of (velocity, pressure) are updated. @return the norms of both residuals
    void residual(const FlowVector &state, FlowVector &r);
    /// The same without the mask: forces of the boundary where velocities are given.
    /// @param of_wall whether the wall takes part: forces on both of them, not on the blood alone
    void unmasked_residual(const FlowVector &state, FlowVector &r, bool of_wall);
    /// Derivative of the residual.
    void vmult(FlowVector &result, const FlowVector &x) const;
    /// result = derivative of the momentum residual with respect to the pressure, times p.
    void gradient(Vector &result, const Vector &p) const;

    /// Norm of the loads of the pressures of open parts, for the size of rounding errors.
    /// Collective.
    double open_load(const Vector &velocity) const;

    /// alpha_0 of the step [1/s]
    double inertia() const { return step.bdf.alpha[0]; }
    /// Whether the mesh moves in this step.
    bool is_moving() const { return step.mesh_velocity != nullptr; }
    const Spaces<dim> &spaces() const { return space; }
    CellForms<dim> &cells() { return *forms; }
    const CellForms<dim> &cells() const { return *forms; }
    BoundaryFaces<dim> &faces() { return boundary; }
    const BoundaryFaces<dim> &faces() const { return boundary; }
    VelocityConstraints<dim> &constraints() { return fixed; }
    const VelocityConstraints<dim> &constraints() const { return fixed; }
    PointTerms<dim> &points() { return point_terms; }
    const PointTerms<dim> &points() const { return point_terms; }
    const BoundaryConditions<dim> &conditions() const { return bc; }
    /// Stored nodes of the wall that are held.
    const std::vector<unsigned int> &held() const { return held_nodes; }
    /// nullptr if there is none
    WallEquations<dim> *wall() { return wall_equations.get(); }
    const WallEquations<dim> *wall() const { return wall_equations.get(); }

    /// Integral of u.n over each open part at once (one reduction).
    std::map<dealii::types::boundary_id, double> open_flow_rates(const Vector &velocity) const;

  private:
    void find_held_nodes(const Vector &reference);
    void finish_momentum(Vector &momentum, bool masked) const;
    void finish_continuity(Vector &continuity) const;

    const Spaces<dim> &space;
    const Parameters &prm;
    const BoundaryConditions<dim> &bc;
    std::unique_ptr<CellForms<dim>> forms;
    BoundaryFaces<dim> boundary;
    VelocityConstraints<dim> fixed;
    PointTerms<dim> point_terms;
    std::unique_ptr<WallEquations<dim>> wall_equations;
    std::vector<unsigned int> held_nodes; ///< of the wall, by stored index
    Step step;
    std::map<dealii::types::boundary_id, PressureModel::Relation> relations;
    bool has_resistance = false;
  };
} // namespace semilunar::flow

#endif
