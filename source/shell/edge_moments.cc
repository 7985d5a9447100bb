// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/edge_moments.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

namespace semilunar::shell
{
  using spline::Tensor;

  namespace
  {
    const std::string entry = "Loads/Edge moments";

    /// The frame of a deformed edge: normal, outward conormal and tangent, all of unit length, and
    /// their components.
    struct EdgeFrame
    {
      Tensor<1, 3> normal, conormal, contravariant[2];
      double along_conormal[2], along_tangent[2]; // contravariant components

      EdgeFrame(const Tensor<1, 3> &r1, const Tensor<1, 3> &r2, const unsigned int across,
                const double outward)
      {
        normal = cross_product_3d(r1, r2);
        const double area = normal.norm();
        normal /= area;
        contravariant[0] = cross_product_3d(r2, normal) / area;
        contravariant[1] = cross_product_3d(normal, r1) / area;
        conormal = outward * contravariant[across] / contravariant[across].norm();
        const Tensor<1, 3> tangent = cross_product_3d(normal, conormal);
        for (unsigned int alpha = 0; alpha < 2; ++alpha)
        {
          along_conormal[alpha] = contravariant[alpha] * conormal;
          along_tangent[alpha] = contravariant[alpha] * tangent;
        }
      }

      /// d^2 theta, (L2): with respect to component i of r_,alpha and component j of r_,lambda.
      double second_derivative(const unsigned int alpha, const unsigned int i,
                               const unsigned int lambda, const unsigned int j) const
      {
        return -along_conormal[alpha] * contravariant[lambda][i] * normal[j] -
               normal[i] * along_conormal[lambda] * contravariant[alpha][j] -
               normal[i] * along_tangent[alpha] * along_tangent[lambda] * conormal[j];
      }
    };

    /// The derivative of minus the force of a moment, (3n) x (3n), row by row, index 3 a + i.
    void tangent(const EdgeFrame &frame, const std::array<std::vector<double>, 2> &basis,
                 const double moment, std::vector<double> &block)
    {
      const unsigned int n = basis[0].size();
      block.assign(9 * n * n, 0.);
      for (unsigned int alpha = 0; alpha < 2; ++alpha)
        for (unsigned int lambda = 0; lambda < 2; ++lambda)
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
            {
              const double factor = -moment * frame.second_derivative(alpha, i, lambda, j);
              for (unsigned int a = 0; a < n; ++a)
                for (unsigned int b = 0; b < n; ++b)
                  block[(3 * a + i) * 3 * n + 3 * b + j] +=
                      factor * basis[alpha][a] * basis[lambda][b];
            }
    }
  } // namespace

  EdgeMoments::EdgeMoments(const spline::Surface &surface, const LoadParameters &parameters)
      : surface(surface)
  {
    for (const std::string &item :
         dealii::Utilities::split_string_list(parameters.edge_moments, ';'))
      if (!item.empty())
      {
        const std::vector<std::string> parts = dealii::Utilities::split_string_list(item, ':');
        if (parts.size() != 2)
          throw InputError(entry, item, "this is not a moment along an edge", "write PLACE: M");
        const Location location = find_location(surface, parts[0], entry);
        const double moment = parse_number(parts[1], entry);
        for (const auto &side : location_sides(surface, location, entry))
          append_points(side, moment);
      }
  }

  void EdgeMoments::append_points(const spline::ElementSide &side, const double moment)
  {
    const auto &element = surface.elements[side.element];
    const auto positions = spline::positions(surface);
    const unsigned int across = side.side < 2 ? 0 : 1, along = 1 - across;
    const dealii::QGauss<1> quadrature(element.degree[along] + 1);
    spline::BasisValues basis;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      spline::Point<2> xi;
      xi[across] = side.side % 2;
      xi[along] = quadrature.point(q)[0];
      spline::evaluate_basis(surface, side.element, xi, basis);
      const auto jet = spline::interpolate(element, basis, positions);
      const double length = quadrature.weight(q) * jet[spline::d1 + along].norm();
      points.push_back({side.element,
                        across,
                        side.side % 2 == 1 ? 1. : -1.,
                        moment * length,
                        {{basis.values[spline::d1], basis.values[spline::d2]}}});
    }
  }

  void EdgeMoments::add(const ControlVectors &x, const double load, ControlVectors &forces,
                        const Assembly::AddBlock &add_block) const
  {
    std::vector<double> block;
    for (const Point &point : points)
    {
      const auto &control_points = surface.elements[point.element].control_points;
      const unsigned int n = control_points.size();
      Tensor<1, 3> r[2];
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int alpha = 0; alpha < 2; ++alpha)
          r[alpha] += point.basis[alpha][a] * x[control_points[a]];
      const EdgeFrame frame(r[0], r[1], point.across, point.outward);
      const double moment = load * point.moment;
      for (unsigned int a = 0; a < n; ++a)
        forces[control_points[a]] -= moment *
                                     (frame.along_conormal[0] * point.basis[0][a] +
                                      frame.along_conormal[1] * point.basis[1][a]) *
                                     frame.normal; // (L1)
      if (!add_block)
        continue;
      tangent(frame, point.basis, moment, block);
      add_block(control_points, block.data());
    }
  }
} // namespace semilunar::shell
