// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/element_matrix.h>
#include <semilunar/shell/error_indicator.h>
#include <semilunar/shell/tangent_frame.h>
#include <semilunar/spline/bernstein.h>

#include <deal.II/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace semilunar::shell
{
  using namespace spline;

  namespace
  {
    /// Degree of the bubble functions above that of the element, (A1): three functions for each
    /// direction of a cubic element.
    constexpr unsigned int more_degrees = 3;

    /// Bernstein polynomials of this degree but the two first and last ones vanish at both ends
    /// together with their derivatives.
    constexpr unsigned int first_bubble = 2;

    /// The bubbles of an element and their derivatives with respect to xi.
    class Bubbles
    {
    public:
      explicit Bubbles(const std::array<unsigned int, 2> &degree)
          : degrees{{std::min(degree[0] + more_degrees, max_degree),
                     std::min(degree[1] + more_degrees, max_degree)}}
      {
        for (unsigned int d = 0; d < 2; ++d)
          for (auto &derivative : table[d])
            derivative.resize(degrees[d] + 1);
      }

      unsigned int size() const { return n_in(0) * n_in(1); }
      /// The same, padded for ElementMatrix.
      unsigned int stride() const
      {
        constexpr unsigned int width = QuadraturePoints::simd_width;
        return (size() + width - 1) / width * width;
      }

      void evaluate(const Point<2> &xi)
      {
        for (unsigned int d = 0; d < 2; ++d)
          bernstein_jet(degrees[d], xi[d], table[d][0].data(), table[d][1].data(),
                        table[d][2].data());
      }

      std::array<double, n_derivatives> jet(const unsigned int k) const
      {
        const unsigned int i = k % n_in(0) + first_bubble, j = k / n_in(0) + first_bubble;
        const auto &s = table[0], &t = table[1];
        return {{s[0][i] * t[0][j], s[1][i] * t[0][j], s[0][i] * t[1][j], s[2][i] * t[0][j],
                 s[0][i] * t[2][j], s[1][i] * t[1][j]}};
      }

    private:
      std::array<unsigned int, 2> degrees;
      std::array<std::array<std::vector<double>, 3>, 2> table; // direction, derivative

      unsigned int n_in(const unsigned int d) const { return degrees[d] + 1 - 2 * first_bubble; }
    };

    /// The bubbles at a quadrature point as rows that ElementMatrix takes.
    void fill_rows(const Surface &surface, const QuadraturePoints &points, const unsigned int q,
                   Bubbles &bubbles, std::vector<double> &rows)
    {
      const SurfaceJet undeformed = evaluate(surface, {points.element(q), points.xi(q)});
      const TangentFrame frame(undeformed[d1], undeformed[d2]);
      const unsigned int stride = bubbles.stride();
      rows.assign(n_derivatives * stride, 0.);
      bubbles.evaluate(points.xi(q));
      for (unsigned int k = 0; k < bubbles.size(); ++k)
      {
        const auto jet = frame.transform(bubbles.jet(k));
        for (unsigned int d = 0; d < n_derivatives; ++d)
          rows[d * stride + k] = jet[d];
      }
    }

    /// The tensile part of membrane forces, without moments: with it, the geometric stiffness is
    /// not negative.
    Resultants tension(const Symmetric &n)
    {
      const double mean = 0.5 * (n[0] + n[1]), radius = std::hypot(0.5 * (n[0] - n[1]), n[2]);
      const double larger = mean + radius, smaller = mean - radius;
      if (smaller >= 0.)
        return {n, {}};
      if (larger <= 0.)
        return {{}, {}};
      // larger times the projection on its direction, (n - smaller) / (larger - smaller)
      const double factor = larger / (2. * radius);
      return {{{factor * (n[0] - smaller), factor * (n[1] - smaller), factor * n[2]}}, {}};
    }

    /// r K^-1 r for a symmetric K, row by row; directions without stiffness do not count.
    double energy_norm(std::vector<double> K, std::vector<double> r)
    {
      const unsigned int n = r.size();
      double largest = 0.;
      for (unsigned int k = 0; k < n; ++k)
        largest = std::max(largest, K[k * n + k]);
      constexpr double round_off = 1e-12;
      double sum = 0.;
      for (unsigned int k = 0; k < n; ++k)
      {
        const double pivot = K[k * n + k];
        if (!(pivot > round_off * largest))
          continue;
        sum += r[k] * r[k] / pivot;
        for (unsigned int i = k + 1; i < n; ++i)
        {
          const double factor = K[i * n + k] / pivot;
          r[i] -= factor * r[k];
          for (unsigned int j = k + 1; j < n; ++j)
            K[i * n + j] -= factor * K[k * n + j];
        }
      }
      return sum;
    }

    void add_force(const Surface &surface, const SurfacePoint &point, const Tensor<1, 3> &force,
                   std::vector<double> &residual)
    {
      Bubbles bubbles(surface.elements[point.element].degree);
      residual.resize(3 * bubbles.size());
      bubbles.evaluate(point.xi);
      for (unsigned int k = 0; k < bubbles.size(); ++k)
        for (unsigned int i = 0; i < 3; ++i)
          residual[3 * k + i] += bubbles.jet(k)[value] * force[i];
    }

    /// The residuals of contact on the bubbles of each element, empty where there is none: (C5) and
    /// (C9) of doc/theory/contact.md.
    std::vector<std::vector<double>> contact_residuals(const Surface &surface,
                                                       const QuadraturePoints &points,
                                                       const ActingLoads &loads)
    {
      std::vector<std::vector<double>> residuals(surface.elements.size());
      if (loads.contact == nullptr)
        return residuals;
      for (const Contact::ContactPoint &point : loads.contact->contact_points())
      {
        if (!(point.pressure > 0.))
          continue;
        const unsigned int own = points.element(point.q);
        const Tensor<1, 3> force = -0.5 * points.weight(point.q) * point.pressure * point.normal;
        add_force(surface, {own, points.xi(point.q)}, force, residuals[own]);
        add_force(surface, point.partner, -(transpose(loads.symmetry.turn(point.image)) * force),
                  residuals[point.partner.element]);
      }
      return residuals;
    }
  } // namespace

  std::vector<double> error_indicators(const Surface &surface, const QuadraturePoints &points,
                                       const Section &section, const Assembly &assembly,
                                       const ControlVectors &x, const ActingLoads &loads)
  {
    const std::vector<std::vector<double>> contact = contact_residuals(surface, points, loads);
    std::vector<double> indicators(surface.elements.size());
    const auto estimate = [&](const unsigned int e)
    {
      Bubbles bubbles(surface.elements[e].degree);
      ElementMatrix matrix;
      matrix.reinit(bubbles.size(), bubbles.stride(), true);
      std::vector<double> rows, K;
      PointResponse response;
      SectionResponse state;
      for (unsigned int q = points.first_point(e); q < points.first_point(e + 1); ++q)
      {
        section.evaluate(assembly.section_strain(x, q), false, state);
        assembly.point_response(x, q, loads.pressure, tension(state.n), response);
        for (unsigned int i = 0; i < 3; ++i)
          response.gradient[value][i] -= loads.dead_load[i];
        fill_rows(surface, points, q, bubbles, rows);
        matrix.add(response, rows.data(), points.weight(q));
      }
      matrix.copy_matrix(K);
      std::vector<double> r(matrix.force(), matrix.force() + 3 * bubbles.size());
      for (unsigned int k = 0; k < contact[e].size(); ++k)
        r[k] += contact[e][k];
      indicators[e] = energy_norm(std::move(K), std::move(r));
    };
    constexpr unsigned int elements_per_task = 8;
    dealii::parallel::apply_to_subranges(
        0u, static_cast<unsigned int>(indicators.size()),
        [&](const unsigned int begin, const unsigned int end)
        {
          for (unsigned int e = begin; e < end; ++e)
            estimate(e);
        },
        elements_per_task);
    return indicators;
  }

  std::vector<unsigned int> mark_elements(const std::vector<double> &indicators, const double share)
  {
    std::vector<unsigned int> order(indicators.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](const unsigned int a, const unsigned int b)
                     { return indicators[a] > indicators[b]; });
    const double wanted = share * std::accumulate(indicators.begin(), indicators.end(), 0.);
    constexpr double mirror_images = 1. - 1e-6; // are marked alike
    double sum = 0.;
    unsigned int n = 0;
    while (n < order.size() && indicators[order[n]] > 0. &&
           (sum < wanted || indicators[order[n]] >= mirror_images * indicators[order[n - 1]]))
      sum += indicators[order[n++]];
    order.resize(n);
    std::sort(order.begin(), order.end());
    return order;
  }
} // namespace semilunar::shell
