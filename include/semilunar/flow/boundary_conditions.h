// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_boundary_conditions_h
#define semilunar_flow_boundary_conditions_h

#include <semilunar/flow/cell_forms.h>
#include <semilunar/flow/pressure_models.h>

#include <deal.II/base/types.h>

#include <map>
#include <memory>
#include <set>

namespace semilunar::flow
{
  /// sigma n [dyn/cm^2] at a point of the boundary with outward normal n.
  template <int dim>
  using TractionFunction = std::function<dealii::Tensor<1, dim>(
      const dealii::Point<dim> &x, const dealii::Tensor<1, dim> &normal, double time)>;

  /// What happens at each part of the boundary. Where parts meet, walls and given velocities win
  /// over slip, walls over given velocities.
  template <int dim>
  class BoundaryConditions
  {
  public:
    enum class Kind
    {
      wall,
      slip,
      velocity,
      traction,
      open
    };
    struct Condition
    {
      Kind kind;
      VectorFunction<dim> velocity;
      TractionFunction<dim> traction;
      std::shared_ptr<PressureModel> pressure;
      double backflow; ///< beta of open boundaries, negative: that of the parameters
    };
    using Id = dealii::types::boundary_id;

    /// No slip: the velocity of the mesh.
    void set_wall(const Id id) { conditions[id] = {Kind::wall, {}, {}, {}, 0.}; }
    /// No flow through the (moving) boundary, no tangential traction.
    void set_slip(const Id id) { conditions[id] = {Kind::slip, {}, {}, {}, 0.}; }
    void set_velocity(const Id id, VectorFunction<dim> velocity)
    {
      conditions[id] = {Kind::velocity, std::move(velocity), {}, {}, 0.};
    }
    void set_traction(const Id id, TractionFunction<dim> traction)
    {
      conditions[id] = {Kind::traction, {}, std::move(traction), {}, 0.};
    }
    /// Traction -p n, stabilised against backflow with the factor of the parameters or one of its
    /// own [-].
    void set_open(const Id id, std::shared_ptr<PressureModel> pressure, const double backflow = -1.)
    {
      conditions[id] = {Kind::open, {}, {}, std::move(pressure), backflow};
    }

    /// Places (at rest) where nodes of an elastic wall are held, as by something that cuts it.
    void hold_wall(std::function<bool(const dealii::Point<dim> &)> where)
    {
      held = std::move(where);
    }
    bool is_held(const dealii::Point<dim> &x) const { return held && held(x); }

    /// Parts on which the tissue around an elastic wall acts, besides what acts there anyway.
    void support_wall(const std::set<Id> &ids) { supported_parts = ids; }
    const std::set<Id> &supported() const { return supported_parts; }

    const std::map<Id, Condition> &all() const { return conditions; }

    /// Whether nothing fixes the level of the pressure.
    bool closed() const
    {
      for (const auto &[id, condition] : conditions)
        if (condition.kind == Kind::traction || condition.kind == Kind::open)
          return false;
      return true;
    }

  private:
    std::map<Id, Condition> conditions;
    std::function<bool(const dealii::Point<dim> &)> held;
    std::set<Id> supported_parts;
  };
} // namespace semilunar::flow

#endif
