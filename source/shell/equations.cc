// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/equations.h>

#include <deal.II/base/utilities.h>

#include <numeric>

namespace semilunar::shell
{
  Equations::Equations(const unsigned int n_control_points)
      : parents(3 * n_control_points), numbers(3 * n_control_points, none),
        held(3 * n_control_points, false), values(3 * n_control_points, 0.)
  {
    std::iota(parents.begin(), parents.end(), 0u);
  }

  unsigned int Equations::representative(const unsigned int control_point,
                                         const unsigned int component) const
  {
    unsigned int root = 3 * control_point + component;
    while (parents[root] != root)
      root = parents[root];
    return root;
  }

  namespace
  {
    /// @param component number of a component, 3 times the control point's plus its own
    void require_same(const unsigned int component, const double first, const double second)
    {
      if (first != second)
        throw InputError("Supports/Supports", "",
                         "control point " + std::to_string(component / 3 + 1) +
                             " is given two different displacements in " + "xyz"[component % 3] +
                             ": " + dealii::Utilities::to_string(first) + " and " +
                             dealii::Utilities::to_string(second),
                         "prescribe each component once, that of tied control points too");
    }
  } // namespace

  void Equations::prescribe(const unsigned int control_point, const unsigned int component,
                            const double value)
  {
    const unsigned int root = representative(control_point, component);
    if (held[root])
      require_same(3 * control_point + component, values[root], value);
    held[root] = true;
    values[root] = value;
  }

  void Equations::tie(const unsigned int control_point, const unsigned int other,
                      const unsigned int component)
  {
    const unsigned int a = representative(control_point, component);
    const unsigned int b = representative(other, component);
    if (a == b)
      return;
    if (held[a] && held[b])
      require_same(3 * control_point + component, values[a], values[b]);
    // a prescribed value survives the tie
    const unsigned int root = held[b] ? b : a, child = held[b] ? a : b;
    parents[child] = root;
  }

  void Equations::close()
  {
    n = 0;
    for (unsigned int c = 0; c < n_control_points(); ++c)
      for (unsigned int i = 0; i < 3; ++i)
      {
        const unsigned int root = representative(c, i);
        if (!held[root])
        {
          if (numbers[root] == none)
            numbers[root] = n++;
          numbers[3 * c + i] = numbers[root];
        }
        values[3 * c + i] = values[root];
      }
  }

  bool Equations::moves_supports() const
  {
    for (unsigned int i = 0; i < values.size(); ++i)
      if (numbers[i] == none && values[i] != 0.)
        return true;
    return false;
  }

  void Equations::expand(const dealii::Vector<double> &solution, const double load_factor,
                         std::vector<dealii::Tensor<1, 3>> &displacements) const
  {
    displacements.resize(n_control_points());
    for (unsigned int c = 0; c < n_control_points(); ++c)
      for (unsigned int i = 0; i < 3; ++i)
        displacements[c][i] = numbers[3 * c + i] == none ? load_factor * values[3 * c + i]
                                                         : solution[numbers[3 * c + i]];
  }

  void Equations::gather(const std::vector<dealii::Tensor<1, 3>> &displacements,
                         dealii::Vector<double> &solution) const
  {
    AssertDimension(displacements.size(), n_control_points());
    solution.reinit(n);
    for (unsigned int c = 0; c < n_control_points(); ++c)
      for (unsigned int i = 0; i < 3; ++i)
        if (!is_prescribed(c, i))
          solution[(*this)(c, i)] = displacements[c][i];
  }

  void Equations::restrict(const std::vector<dealii::Tensor<1, 3>> &forces,
                           dealii::Vector<double> &residual) const
  {
    residual.reinit(n);
    for (unsigned int c = 0; c < n_control_points(); ++c)
      for (unsigned int i = 0; i < 3; ++i)
        if (numbers[3 * c + i] != none)
          residual[numbers[3 * c + i]] += forces[c][i];
  }
} // namespace semilunar::shell
