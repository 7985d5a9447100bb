// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/t_spline.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <map>

namespace semilunar::spline
{
  namespace
  {
    using Coordinate = TMesh::Coordinate;

    /// The elements of a T-spline's Bezier mesh by the elements of its T-mesh.
    class BezierLocator
    {
    public:
      BezierLocator(const TMesh &mesh) : mesh(mesh), boxes(bezier_boxes(mesh))
      {
        first_of.assign(boxes.empty() ? 0 : boxes.back().t_element + 1, TMesh::none);
        for (unsigned int b = 0; b < boxes.size(); ++b)
          if (first_of[boxes[b].t_element] == TMesh::none)
            first_of[boxes[b].t_element] = b;
      }

      /// The box that holds the point, moved infinitesimally in the directions of the signs.
      unsigned int find(const TMesh::Point &point, const std::array<int, 2> &signs) const
      {
        unsigned int b = first_of[mesh.find(point, signs[0], signs[1])];
        while (!holds(boxes[b], point, signs))
          ++b;
        return b;
      }

      const BezierBox &box(const unsigned int b) const { return boxes[b]; }

    private:
      const TMesh &mesh;
      const std::vector<BezierBox> boxes;
      std::vector<unsigned int> first_of;

      static bool holds(const BezierBox &box, const TMesh::Point &point,
                        const std::array<int, 2> &signs)
      {
        for (unsigned int d = 0; d < 2; ++d)
          if (signs[d] > 0 ? point[d] < box.low[d] || point[d] >= box.high[d]
                           : point[d] <= box.low[d] || point[d] > box.high[d])
            return false;
        return true;
      }
    };

    /// The weights of the Bernstein coefficients on [a,b] in the value of the polynomial's blossom
    /// at these arguments: the coefficients of prod_k ((1 - s_k) + s_k z).
    std::vector<double> blossom_weights(const std::vector<double> &arguments, const double a,
                                        const double b)
    {
      std::vector<double> weights{1.};
      for (const double x : arguments)
      {
        const double s = (x - a) / (b - a);
        weights.push_back(0.);
        for (unsigned int i = weights.size() - 1; i > 0; --i)
          weights[i] = (1. - s) * weights[i] + s * weights[i - 1];
        weights[0] *= 1. - s;
      }
      return weights;
    }

    /// Apply the functional with weights first x second on the Bernstein coefficients to all
    /// functions of the element.
    SparseRow functional(const BezierElement &element, const std::vector<double> &first,
                         const std::vector<double> &second)
    {
      constexpr double round_off = 1e-15; // relative to coefficients of order one
      SparseRow row;
      const double *c = element.extraction.data();
      for (unsigned int a = 0; a < element.n_functions(); ++a)
      {
        double sum = 0.;
        for (const double weight_2 : second)
          for (const double weight_1 : first)
            sum += weight_1 * weight_2 * *c++;
        if (std::abs(sum) > round_off)
        {
          row.columns.push_back(element.control_points[a]);
          row.values.push_back(sum);
        }
      }
      return row;
    }

    /// Finds the functions that refinement leaves as they are.
    class UnchangedFunctions
    {
    public:
      explicit UnchangedFunctions(std::vector<BlendingFunction> given) : old(std::move(given))
      {
        for (unsigned int a = 0; a < old.size(); ++a)
          number[{old[a].vertex, old[a].shift}] = a;
      }

      /// The number that the function had before, or none.
      unsigned int find(const BlendingFunction &function) const
      {
        const auto found = number.find({function.vertex, function.shift});
        return found != number.end() && old[found->second].knots == function.knots ? found->second
                                                                                   : TMesh::none;
      }

    private:
      const std::vector<BlendingFunction> old;
      std::map<std::pair<TMesh::Point, std::array<unsigned int, 2>>, unsigned int> number;
    };

    void check_patch(const NurbsPatch &patch)
    {
      const unsigned int p = patch.knots(0).degree();
      if (p % 2 == 0 || p < 3 || patch.knots(1).degree() != p)
        throw InputError(
            "T-spline", std::to_string(p) + ", " + std::to_string(patch.knots(1).degree()),
            "the degrees are not the same odd number from 3 on", "elevate both to degree 3");
      for (unsigned int d = 0; d < 2; ++d)
        if (patch.knots(d).n_functions() + 1 != patch.knots(d).breakpoints().size() + p)
          throw InputError("T-spline", "", "an inner knot is repeated",
                           "make pieces that share an edge instead");
    }

    const NurbsPatch &checked(const NurbsPatch &patch)
    {
      check_patch(patch);
      return patch;
    }

    unsigned int n_elements(const KnotVector &knots)
    {
      return knots.breakpoints().size() - 1;
    }
  } // namespace

  std::vector<ControlPoint> refined(const RefinementMatrix &matrix,
                                    const std::vector<ControlPoint> &points)
  {
    std::vector<ControlPoint> result;
    for (const SparseRow &row : matrix)
    {
      if (row.columns.size() == 1 && row.values[0] == 1.)
      {
        result.push_back(points[row.columns[0]]); // to the last bit
        continue;
      }
      Tensor<1, 3> sum;
      double weight = 0.;
      for (unsigned int k = 0; k < row.columns.size(); ++k)
      {
        const ControlPoint &point = points[row.columns[k]];
        weight += row.values[k] * point.weight;
        sum += row.values[k] * point.weight * point.position;
      }
      result.push_back({Point<3>(sum / weight), weight});
    }
    return result;
  }

  std::vector<Tensor<1, 3>> refined(const RefinementMatrix &matrix,
                                    std::vector<ControlPoint> points,
                                    const std::vector<Tensor<1, 3>> &positions)
  {
    AssertDimension(points.size(), positions.size());
    for (unsigned int a = 0; a < points.size(); ++a)
      points[a].position = Point<3>(positions[a]);
    std::vector<Tensor<1, 3>> result;
    for (const ControlPoint &point : refined(matrix, points))
      result.push_back(point.position);
    return result;
  }

  TSpline::TSpline(const NurbsPatch &patch)
      : p(checked(patch).knots(0).degree()), breakpoints{{patch.knots(0).breakpoints(),
                                                          patch.knots(1).breakpoints()}},
        t_mesh({{n_elements(patch.knots(0)), n_elements(patch.knots(1))}}, p),
        blending(blending_functions(t_mesh)), net(patch.control_net())
  {
    AssertDimension(blending.size(), net.size());
  }

  double TSpline::parameter(const unsigned int direction, const Coordinate x) const
  {
    const std::vector<double> &points = breakpoints[direction];
    const unsigned int k = x / TMesh::unit;
    const double share = double(x % TMesh::unit) / TMesh::unit;
    return share == 0. ? points[k] : points[k] + share * (points[k + 1] - points[k]);
  }

  std::vector<double> TSpline::knots(const BlendingFunction &function,
                                     const unsigned int direction) const
  {
    std::vector<double> result;
    for (const Coordinate x : function.knots[direction])
      result.push_back(parameter(direction, x));
    return result;
  }

  RefinementMatrix TSpline::refine(const std::vector<unsigned int> &marked)
  {
    const Surface before = to_surface(*this);
    const TMesh old_mesh = t_mesh;
    const BezierLocator locator(old_mesh);
    const UnchangedFunctions unchanged(std::move(blending));
    t_mesh.refine(marked);
    blending = blending_functions(t_mesh);

    RefinementMatrix matrix;
    for (const BlendingFunction &function : blending)
    {
      if (const unsigned int a = unchanged.find(function); a != TMesh::none)
      {
        matrix.push_back({{a}, {1.}});
        continue;
      }
      std::array<int, 2> signs;
      for (unsigned int d = 0; d < 2; ++d)
        signs[d] = function.vertex[d] == t_mesh.end(d) ? -1 : 1;
      const unsigned int b = locator.find(function.vertex, signs);
      std::array<std::vector<double>, 2> weights;
      for (unsigned int d = 0; d < 2; ++d)
      {
        const std::vector<double> t = knots(function, d);
        weights[d] =
            blossom_weights({t.begin() + 1, t.end() - 1}, parameter(d, locator.box(b).low[d]),
                            parameter(d, locator.box(b).high[d]));
      }
      matrix.push_back(functional(before.elements[b], weights[0], weights[1]));
    }
    net = refined(matrix, net);
    return matrix;
  }

  void TSpline::refine_where(const Wanted &wanted)
  {
    const auto corner = [this](const TMesh::Point &x)
    { return Point<2>(parameter(0, x[0]), parameter(1, x[1])); };
    while (true)
    {
      std::vector<unsigned int> marked;
      for (const unsigned int e : t_mesh.active_elements())
      {
        const TMesh::Element &element = t_mesh.element(e);
        if (wanted(corner(element.low), corner(element.high), element.level))
          marked.push_back(e);
      }
      if (marked.empty())
        return;
      refine(marked);
    }
  }
} // namespace semilunar::spline
