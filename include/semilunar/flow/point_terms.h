// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_point_terms_h
#define semilunar_flow_point_terms_h

#include <semilunar/flow/spaces.h>

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
  };

  template <int dim>
  class PointTerms
  {
  public:
    explicit PointTerms(const Spaces<dim> &spaces);

    void set(const std::vector<PointTerm<dim>> &terms);
    bool empty() const { return terms.empty(); }

    /// momentum += phi_i (K u - f), or only K u.
    void add(const Vector &velocity, bool with_force, Vector &momentum) const;
    /// Calls add(cell, i, j, value) with the isotropic part of K, trace / dim.
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
  };

  template <int dim>
  template <class Add>
  void PointTerms<dim>::matrix(const Add &add) const
  {
    for (unsigned int t = 0; t < terms.size(); ++t)
    {
      const double isotropic = dealii::trace(terms[t].penalty) / dim;
      const double *phi = shape.data() + std::size_t(t) * n_nodes;
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int j = 0; j < n_nodes; ++j)
          add(cell[t], i, j, isotropic * phi[i] * phi[j]);
    }
  }
} // namespace semilunar::flow

#endif
