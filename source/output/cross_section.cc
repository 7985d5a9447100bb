// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/cross_section.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <limits>

namespace semilunar::output
{
  namespace
  {
    using dealii::Point;

    /// Where a plane cuts a cell, in the cell's reference coordinates.
    template <int dim>
    struct Cut
    {
      std::vector<Point<dim>> points;
      std::vector<double> weights; ///< area [cm^(dim-1)]
    };

    /// The reference direction along which the coordinate changes most.
    template <int dim>
    unsigned int steepest_direction(const dealii::FEValues<dim> &values, const unsigned int q,
                                    const unsigned int axis)
    {
      unsigned int steepest = 0;
      for (unsigned int d = 1; d < dim; ++d)
        if (std::abs(values.jacobian(q)[axis][d]) > std::abs(values.jacobian(q)[axis][steepest]))
          steepest = d;
      return steepest;
    }

    /// Where along a line through the cell in a reference direction the coordinate has a value, by
    /// the secant method within a bracket; NaN if it does not within [0,1).
    template <int dim>
    double find_crossing(const dealii::Mapping<dim> &mapping,
                         const typename dealii::Triangulation<dim>::cell_iterator &cell,
                         Point<dim> xi, const unsigned int direction, const unsigned int axis,
                         const double position)
    {
      const auto distance = [&](const double s)
      {
        xi[direction] = s;
        return mapping.transform_unit_to_real_cell(cell, xi)[axis] - position;
      };
      const double tolerance = 1e-13 * cell->diameter();
      double a = 0., b = 1., fa = distance(a), fb = distance(b);
      // A face on the plane belongs to the cell above it.
      if (std::abs(fa) <= tolerance)
        return fb > 0. ? a : std::numeric_limits<double>::quiet_NaN();
      if (std::abs(fb) <= tolerance)
        return fa > 0. ? b : std::numeric_limits<double>::quiet_NaN();
      if (fa * fb > 0.)
        return std::numeric_limits<double>::quiet_NaN();
      for (unsigned int i = 0; i < 60; ++i)
      {
        const double middle = i % 3 == 2 ? 0.5 * (a + b) : a - fa * (b - a) / (fb - fa);
        const double f = distance(middle);
        if (std::abs(f) <= tolerance)
          return middle;
        if ((f > 0.) == (fa > 0.))
          a = middle, fa = f;
        else
          b = middle, fb = f;
      }
      return 0.5 * (a + b);
    }

    template <int dim>
    Cut<dim> cut_cell(const dealii::Mapping<dim> &mapping,
                      const typename dealii::Triangulation<dim>::cell_iterator &cell,
                      const unsigned int direction, const unsigned int axis, const double position,
                      const unsigned int n_points)
    {
      Cut<dim> cut;
      const dealii::QGauss<dim - 1> lines(n_points);
      std::vector<double> line_weights;
      for (unsigned int q = 0; q < lines.size(); ++q)
      {
        Point<dim> xi;
        for (unsigned int d = 0, e = 0; d < dim; ++d)
          if (d != direction)
            xi[d] = lines.point(q)[e++];
        xi[direction] = find_crossing<dim>(mapping, cell, xi, direction, axis, position);
        if (std::isnan(xi[direction]))
          continue;
        cut.points.push_back(xi);
        line_weights.push_back(lines.weight(q));
      }
      if (cut.points.empty())
        return cut;
      // dA = |det J| / |dz/dxi_direction| of the other two reference coordinates
      const dealii::FE_Q<dim> dummy(1);
      dealii::FEValues<dim> values(mapping, dummy, dealii::Quadrature<dim>(cut.points),
                                   dealii::update_jacobians);
      values.reinit(cell);
      for (unsigned int q = 0; q < cut.points.size(); ++q)
      {
        const auto &jacobian = values.jacobian(q);
        cut.weights.push_back(line_weights[q] * std::abs(jacobian.determinant()) /
                              std::abs(jacobian[axis][direction]));
      }
      return cut;
    }
  } // namespace

  template <int dim>
  void CrossSection<dim>::reinit(const FlowState<dim> &state)
  {
    flow_rate = pressure = {};
    const dealii::FE_Q<dim> dummy(1);
    dealii::FEValues<dim> centre(state.mapping, dummy, dealii::QMidpoint<dim>(),
                                 dealii::update_jacobians);
    area = 0.;
    for (const auto &cell : state.triangulation().active_cell_iterators())
    {
      if (!is_owned_lumen(cell))
        continue;
      const auto box = state.mapping.get_bounding_box(cell);
      const double margin = 0.1 * (box.upper_bound(axis) - box.lower_bound(axis));
      if (position < box.lower_bound(axis) - margin || position > box.upper_bound(axis) + margin)
        continue;
      centre.reinit(cell);
      const Cut<dim> cut = cut_cell<dim>(state.mapping, cell, steepest_direction(centre, 0, axis),
                                         axis, position, n_points);
      if (cut.points.empty())
        continue;
      for (const double weight : cut.weights)
        area += weight;
      flow_rate.add(state.velocity_dofs, cell, cut.points, cut.weights, axis);
      pressure.add(state.pressure_dofs, cell, cut.points, cut.weights, 0);
    }
  }

  template <int dim>
  typename CrossSection<dim>::Values CrossSection<dim>::evaluate(const FlowState<dim> &state) const
  {
    std::vector<double> sums = {area, flow_rate.local_value(state.velocity),
                                pressure.local_value(state.pressure)};
    dealii::Utilities::MPI::sum(sums, state.communicator(), sums);
    return {sums[0], sums[1], sums[2] / sums[0]};
  }

  template class CrossSection<2>;
  template class CrossSection<3>;
} // namespace semilunar::output
