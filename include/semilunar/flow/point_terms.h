// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_point_terms_h
#define semilunar_flow_point_terms_h

#include <semilunar/flow/spaces.h>

#include <algorithm>
#include <functional>
#include <numeric>

namespace semilunar::flow
{
  /// What acts on the fluid at a point of a cell: the force K u - f, tested with the velocity's
  /// test functions. Whatever is immersed in the fluid enters through these.
  template <int dim>
  struct PointTerm
  {
    unsigned int active_cell_index; ///< of a cell of this rank
    dealii::Point<dim> unit_point;
    dealii::Tensor<2, dim> penalty; ///< K: coefficient times the point's area [g/s]
    dealii::Tensor<1, dim> force;   ///< f [dyn]
    double preconditioner;          ///< what the momentum matrix takes for K, isotropic [g/s]
  };

  template <int dim>
  class PointTerms
  {
  public:
    explicit PointTerms(const Spaces<dim> &spaces);

    void set(const std::vector<PointTerm<dim>> &terms);
    /// Replace the forces of all terms.
    void set_forces(const std::vector<dealii::Tensor<1, dim>> &forces);
    /// Whether there is nothing to add on any rank.
    bool inactive() const { return terms.empty() && !response; }

    /// How an immersed structure gives way: velocities v of the terms' points that are linear in
    /// the velocities u of the fluid at them. The force is then K (u - v(u)) - f. May be
    /// collective.
    using Response = std::function<std::vector<dealii::Tensor<1, dim>>(
        const std::vector<dealii::Tensor<1, dim>> &velocities)>;
    /// @param response empty: nothing gives way
    void set_response(Response new_response) { response = std::move(new_response); }

    /// momentum += phi_i (K u - f), or only K u.
    void add(const Vector &velocity, bool with_force, Vector &momentum) const;
    /// Power of these forces at the nodes, sum of u . phi_i (K u - f): this rank's part [erg/s].
    double power_at_nodes(const Vector &velocity) const;
    /// Calls add(cell, matrix) for each cell with points: the matrix [node][node] of what stands
    /// for K in the momentum matrix, summed over the cell's points.
    template <class Add>
    void matrix(const Add &add) const;
    /// The velocity at the points, in the order in which they were given.
    std::vector<dealii::Tensor<1, dim>> velocities(const Vector &velocity) const;

  private:
    const Spaces<dim> &spaces;
    unsigned int n_nodes;
    std::vector<PointTerm<dim>> terms;
    std::vector<double> shape;      ///< [term][node], lexicographic
    std::vector<unsigned int> node; ///< [term][node], stored
    std::vector<CellLane> cell;
    Response response;
  };

  template <int dim>
  template <class Add>
  void PointTerms<dim>::matrix(const Add &add) const
  {
    std::vector<unsigned int> order(terms.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](const unsigned int a, const unsigned int b)
                     { return terms[a].active_cell_index < terms[b].active_cell_index; });
    std::vector<double> sum;
    for (auto t = order.begin(); t != order.end();)
    {
      const auto first = t;
      sum.assign(n_nodes * n_nodes, 0.);
      for (; t != order.end() && terms[*t].active_cell_index == terms[*first].active_cell_index;
           ++t)
      {
        const double *phi = shape.data() + std::size_t(*t) * n_nodes;
        for (unsigned int i = 0; i < n_nodes; ++i)
        {
          const double factor = terms[*t].preconditioner * phi[i];
          for (unsigned int j = 0; j < n_nodes; ++j)
            sum[i * n_nodes + j] += factor * phi[j];
        }
      }
      add(cell[*first], sum.data());
    }
  }
} // namespace semilunar::flow

#endif
