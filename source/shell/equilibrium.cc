// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/equilibrium.h>

#include <cmath>
#include <limits>

namespace semilunar::shell
{
  namespace
  {
    double norm(const ControlVectors &forces)
    {
      double sum = 0.;
      for (const auto &force : forces)
        sum += force.norm_square();
      return std::sqrt(sum);
    }

    /// Norm of the external forces on the control points of the undeformed shell.
    double external_norm(const spline::Surface &surface, const QuadraturePoints &points,
                         const double pressure, const ControlVectors &dead_forces,
                         const EdgeMoments *const edge_moments)
    {
      ControlVectors forces = dead_forces;
      if (edge_moments != nullptr)
        edge_moments->add(spline::positions(surface), -1., forces, {});
      for (unsigned int q = 0; q < points.n_points(); ++q)
      {
        const auto &element = surface.elements[points.element(q)];
        const auto normal = cross_product_3d(points.frame(q)[0], points.frame(q)[1]);
        const double *R = points.basis(q, spline::value);
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          forces[element.control_points[a]] -= pressure * points.weight(q) * R[a] * normal;
      }
      return norm(forces);
    }

    /// Sum of weights times functions, per equation.
    dealii::Vector<double> lump_area(const spline::Surface &surface, const QuadraturePoints &points,
                                     const Equations &equations)
    {
      ControlVectors lumped(surface.control_points.size());
      for (unsigned int q = 0; q < points.n_points(); ++q)
      {
        const auto &element = surface.elements[points.element(q)];
        const double *R = points.basis(q, spline::value);
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          for (unsigned int i = 0; i < 3; ++i)
            lumped[element.control_points[a]][i] += points.weight(q) * R[a];
      }
      dealii::Vector<double> area;
      equations.restrict(lumped, area);
      return area;
    }
  } // namespace

  Equilibrium::Equilibrium(const spline::Surface &surface, const QuadraturePoints &points,
                           const Equations &equations, const Assembly &assembly,
                           const double pressure, const ControlVectors &dead_forces,
                           Contact *const contact, Timers &timers,
                           const EdgeMoments *const edge_moments)
      : equations(equations), assembly(assembly), pressure(pressure), dead_forces(dead_forces),
        contact(contact), edge_moments(edge_moments), surface(surface),
        undeformed(spline::positions(surface)), matrix(surface, equations),
        area(lump_area(surface, points, equations)),
        load_norm(external_norm(surface, points, pressure, dead_forces, edge_moments)),
        points(points), timers(timers)
  {
    if (!std::isfinite(load_norm))
      throw InputError("Loads", "", "the norm of the forces is beyond all numbers",
                       "give smaller loads, or choose larger units");
  }

  ControlVectors Equilibrium::positions(const Vector &u, const double load) const
  {
    ControlVectors x;
    equations.expand(u, load, x);
    for (unsigned int c = 0; c < x.size(); ++c)
      x[c] += undeformed[c];
    return x;
  }

  void Equilibrium::begin_step(const ControlVectors &start, const double share,
                               const bool conserve_energy)
  {
    start_of_step = conserve_energy ? start : ControlVectors();
    if (contact != nullptr)
      contact->set_share_of_step(share);
  }

  void Equilibrium::end_step()
  {
    start_of_step.clear();
    if (contact != nullptr)
      contact->set_share_of_step(1.);
  }

  ControlVectors Equilibrium::internal_minus_external(const ControlVectors &x, const double load)
  {
    const Timers::Scope timer(timers, "assembly");
    ControlVectors forces(x.size());
    if (start_of_step.empty())
    {
      energy = assembly.add(x, load * pressure, forces, {});
      for (unsigned int c = 0; c < x.size(); ++c)
        forces[c] -= load * dead_forces[c];
      if (edge_moments != nullptr)
        edge_moments->add(x, load, forces, {});
      return forces;
    }
    const ControlVectors external = external_forces(x, load);
    ControlVectors end = x;
    for (unsigned int c = 0; c < x.size(); ++c)
    {
      end[c] += x[c] - start_of_step[c];
      forces[c] = -external[c];
    }
    assembly.add_conserving(start_of_step, end, forces);
    return forces;
  }

  double Equilibrium::residual(const Vector &u, const double load, Vector &r)
  {
    const ControlVectors x = positions(u, load);
    ControlVectors forces = internal_minus_external(x, load);
    if (contact != nullptr)
    {
      const Timers::Scope timer(timers, "contact");
      contact->update(x);
      contact->add_gradient(forces);
    }
    equations.restrict(forces, r);
    if (load_norm > 0.)
      return load_norm;
    // Driven by prescribed displacements: what does not vanish are the reactions.
    double reactions = 0.;
    for (unsigned int c = 0; c < forces.size(); ++c)
      for (unsigned int i = 0; i < 3; ++i)
        if (equations(c, i) == Equations::none)
          reactions += forces[c][i] * forces[c][i];
    return std::max(std::sqrt(reactions), std::numeric_limits<double>::min());
  }

  void Equilibrium::linearize(const Vector &u, const double load, const double shift)
  {
    const auto add_shift = [&](SparseSystem &tangent)
    {
      if (shift > 0.)
        tangent.add_diagonal(area, shift);
    };
    linearize(u, load, add_shift, nullptr);
  }

  void Equilibrium::linearize(const Vector &u, const double load,
                              const std::function<void(SparseSystem &)> &add)
  {
    linearize(u, load, add, nullptr);
  }

  void Equilibrium::linearize_predicted(const Vector &u, const double load)
  {
    std::vector<Resultants> predicted;
    {
      const Timers::Scope timer(timers, "assembly");
      ControlVectors change = positions(u, load);
      for (unsigned int c = 0; c < change.size(); ++c)
        change[c] -= linearized_at[c];
      predicted = assembly.predict(linearized_at, change);
    }
    linearize(
        u, load, [](SparseSystem &) {}, &predicted);
  }

  void Equilibrium::linearize(const Vector &u, const double load,
                              const std::function<void(SparseSystem &)> &add,
                              const std::vector<Resultants> *const predicted)
  {
    const ControlVectors x = positions(u, load);
    linearized_at = x;
    if (contact != nullptr)
    {
      const Timers::Scope timer(timers, "contact");
      contact->update(x);
      matrix.couple(touching_elements());
    }
    matrix.set_zero();
    {
      const Timers::Scope timer(timers, "assembly");
      ControlVectors forces(x.size());
      const auto add_block = [&](const std::vector<unsigned int> &control_points,
                                 const double *block) { matrix.add(control_points, block); };
      assembly.add(x, load * pressure, forces, add_block, predicted);
      if (edge_moments != nullptr)
        edge_moments->add(x, load, forces, add_block);
    }
    if (contact != nullptr)
    {
      const Timers::Scope timer(timers, "contact");
      contact->add_hessian(
          [&](const std::vector<unsigned int> &control_points, const std::vector<double> &block)
          { matrix.add(control_points, block.data()); });
    }
    add(matrix);
    const Timers::Scope timer(timers, "linear solver");
    matrix.factorize();
  }

  void Equilibrium::solve(Vector &right_hand_side) const
  {
    const Timers::Scope timer(timers, "linear solver");
    matrix.solve(right_hand_side);
  }

  std::vector<std::pair<unsigned int, unsigned int>> Equilibrium::touching_elements() const
  {
    std::vector<std::pair<unsigned int, unsigned int>> pairs;
    for (const auto &contact_point : contact->contact_points())
      if (contact_point.pressure > 0.)
        pairs.emplace_back(points.element(contact_point.q), contact_point.partner.element);
    return pairs;
  }

  ControlVectors Equilibrium::external_forces(const ControlVectors &x, const double load) const
  {
    ControlVectors forces(x.size());
    for (unsigned int c = 0; c < x.size(); ++c)
      forces[c] = load * dead_forces[c];
    if (edge_moments != nullptr)
      edge_moments->add(x, -load, forces, {});
    if (pressure == 0.)
      return forces;
    for (unsigned int q = 0; q < points.n_points(); ++q)
    {
      const auto &element = surface.elements[points.element(q)];
      const double *R = points.basis(q, spline::value);
      spline::Tensor<1, 3> tangents[2];
      for (unsigned int alpha = 0; alpha < 2; ++alpha)
      {
        const double *slope = points.basis(q, alpha == 0 ? spline::d1 : spline::d2);
        for (unsigned int a = 0; a < element.n_functions(); ++a)
          tangents[alpha] += slope[a] * x[element.control_points[a]];
      }
      const auto force =
          -load * pressure * points.weight(q) * cross_product_3d(tangents[0], tangents[1]);
      for (unsigned int a = 0; a < element.n_functions(); ++a)
        forces[element.control_points[a]] += R[a] * force;
    }
    return forces;
  }

  void Equilibrium::load_derivative(const Vector &u, const double load, Vector &derivative)
  {
    // The pressure's force is linear in the pressure; prescribed displacements enter through a
    // difference.
    constexpr double step = 1e-6;
    Vector forward;
    residual(u, load + step, forward);
    residual(u, load - step, derivative);
    derivative.sadd(-0.5 / step, 0.5 / step, forward);
  }

  double Equilibrium::smallest_change() const
  {
    constexpr double n_units_in_last_place = 16.;
    double largest = 0.;
    for (const auto &point : undeformed)
      largest = std::max(largest, point.norm());
    return n_units_in_last_place * std::numeric_limits<double>::epsilon() * largest;
  }

  double Equilibrium::largest_change() const
  {
    return contact == nullptr ? std::numeric_limits<double>::infinity()
                              : contact->safe_displacement();
  }

  void Equilibrium::accept(const Vector &u, const double load)
  {
    if (contact != nullptr)
    {
      contact->update(positions(u, load));
      contact->accept();
    }
  }
} // namespace semilunar::shell
