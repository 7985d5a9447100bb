// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/blossom.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <functional>

namespace semilunar::spline
{
  namespace
  {
    /// (w x, w y, w z, w): in these coordinates a rational spline is an ordinary one.
    using Homogeneous = Tensor<1, 4>;
    using Line = std::vector<Homogeneous>;

    Homogeneous homogeneous(const ControlPoint &point)
    {
      Homogeneous h;
      for (unsigned int d = 0; d < 3; ++d)
        h[d] = point.weight * point.position[d];
      h[3] = point.weight;
      return h;
    }

    ControlPoint cartesian(const Homogeneous &h)
    {
      return {Point<3>(h[0] / h[3], h[1] / h[3], h[2] / h[3]), h[3]};
    }

    /// Apply a change of basis to every line of control points along a direction.
    std::vector<ControlPoint> transform_lines(const std::vector<ControlPoint> &net,
                                              const unsigned int direction,
                                              const std::array<unsigned int, 2> &old_size,
                                              const unsigned int new_length,
                                              const std::function<Line(const Line &)> &transform)
    {
      const unsigned int length = old_size[direction], n_lines = old_size[1 - direction];
      const auto index = [&](const unsigned int k, const unsigned int line, const unsigned int n)
      { return direction == 0 ? line * n + k : k * n_lines + line; };

      std::vector<ControlPoint> result(std::size_t(new_length) * n_lines);
      Line before(length);
      for (unsigned int line = 0; line < n_lines; ++line)
      {
        for (unsigned int k = 0; k < length; ++k)
          before[k] = homogeneous(net[index(k, line, length)]);
        const Line after = transform(before);
        for (unsigned int k = 0; k < new_length; ++k)
          result[index(k, line, new_length)] = cartesian(after[k]);
      }
      return result;
    }

    /// Insert one knot into a line, (S9): only convex combinations, hence stable.
    Line insert_knot(const KnotVector &knots, const double x, const Line &before)
    {
      const unsigned int p = knots.degree(), s = knots.span(x);
      const std::vector<double> &t = knots.knots();
      Line after(before.size() + 1);
      for (unsigned int i = 0; i < after.size(); ++i)
        if (i + p <= s)
          after[i] = before[i];
        else if (i > s)
          after[i] = before[i - 1];
        else
        {
          const double alpha = (x - t[i]) / (t[i + p] - t[i]);
          after[i] = alpha * before[i] + (1. - alpha) * before[i - 1];
        }
      return after;
    }

    /// Every knot once more.
    KnotVector elevated(const KnotVector &knots)
    {
      std::vector<double> t = knots.knots();
      const std::vector<double> breakpoints = knots.breakpoints();
      t.insert(t.end(), breakpoints.begin(), breakpoints.end());
      std::sort(t.begin(), t.end());
      return KnotVector(knots.degree() + 1, t);
    }

    /// The coefficients of a line in the basis of one degree more, (S10).
    Line elevate(const KnotVector &knots, const KnotVector &finer, const Line &before)
    {
      const unsigned int p = knots.degree();
      const std::vector<double> abscissae = finer.greville_abscissae();
      std::vector<double> arguments(p);
      Line after(finer.n_functions()), d(p + 1);
      for (unsigned int i = 0; i < after.size(); ++i)
      {
        const unsigned int s = knots.span(abscissae[i]);
        for (unsigned int left_out = 0; left_out <= p; ++left_out)
        {
          for (unsigned int k = 0, r = 0; k <= p; ++k)
            if (k != left_out)
              arguments[r++] = finer.knots()[i + 1 + k];
          std::copy_n(before.begin() + (s - p), p + 1, d.begin());
          after[i] += blossom(knots, s, arguments, d) / (p + 1.);
        }
      }
      return after;
    }
  } // namespace

  NurbsPatch::NurbsPatch(std::array<KnotVector, 2> knots, std::vector<ControlPoint> net)
      : knot_vectors(std::move(knots)), net(std::move(net))
  {
    AssertDimension(this->net.size(),
                    std::size_t(n_control_points(0)) * std::size_t(n_control_points(1)));
  }

  Point<3> NurbsPatch::evaluate(const Point<2> &u) const
  {
    const KnotVector &first = knot_vectors[0], &second = knot_vectors[1];
    const std::vector<double> N = first.evaluate(u[0]), M = second.evaluate(u[1]);
    const unsigned int i0 = first.span(u[0]) - first.degree();
    const unsigned int j0 = second.span(u[1]) - second.degree();
    Homogeneous sum;
    for (unsigned int j = 0; j < M.size(); ++j)
      for (unsigned int i = 0; i < N.size(); ++i)
        sum += N[i] * M[j] * homogeneous(control_point(i0 + i, j0 + j));
    return cartesian(sum).position;
  }

  void NurbsPatch::insert_knots(const unsigned int direction, const std::vector<double> &values)
  {
    for (const double x : values)
    {
      const KnotVector &before = knot_vectors[direction];
      std::vector<double> t = before.knots();
      if (!(x > t.front() && x < t.back()))
        throw InputError("new knot", std::to_string(x), "not inside of the knot vector",
                         "choose between " + std::to_string(t.front()) + " and " +
                             std::to_string(t.back()));
      t.insert(std::upper_bound(t.begin(), t.end(), x), x);
      const KnotVector after(before.degree(), t);
      net = transform_lines(net, direction, {{n_control_points(0), n_control_points(1)}},
                            after.n_functions(),
                            [&](const Line &line) { return insert_knot(before, x, line); });
      knot_vectors[direction] = after;
    }
  }

  void NurbsPatch::elevate_degree(const unsigned int direction, const unsigned int times)
  {
    for (unsigned int k = 0; k < times; ++k)
    {
      const KnotVector &before = knot_vectors[direction];
      const KnotVector after = elevated(before);
      net = transform_lines(net, direction, {{n_control_points(0), n_control_points(1)}},
                            after.n_functions(),
                            [&](const Line &line) { return elevate(before, after, line); });
      knot_vectors[direction] = after;
    }
  }
} // namespace semilunar::spline
