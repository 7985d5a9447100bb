// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_wall_points_h
#define semilunar_flow_wall_points_h

#include <semilunar/core/exceptions.h>
#include <semilunar/flow/cell_vectors.h>
#include <semilunar/flow/lane_matrices.h>
#include <semilunar/flow/spaces.h>
#include <semilunar/flow/tensor_kernel.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace semilunar::flow
{
  /// The Gauss points of wall cells in the reference geometry: gradients of vectors with respect to
  /// reference positions, and integrals with gradients of test functions.
  template <int dim, int degree>
  class WallPoints
  {
  public:
    using Kernel = TensorKernel<dim, degree>;
    static constexpr int n_nodes = Kernel::n_nodes, n_points = Kernel::n_points;
    using VectorValues = Lanes[dim][n_points];
    using Gradients = Lanes[dim][dim][n_points];
    using Matrix = Lanes[dim][dim];

    struct Point
    {
      Matrix inverse; ///< d xi_d / d X_e
      Lanes jxw;
    };

    explicit WallPoints(const Spaces<dim> &spaces) : spaces(spaces) {}

    /// @throws NumericsError on all ranks if a cell is degenerate. Collective.
    void set_reference(const Vector &positions);

    /// Points are counted through, those of ghost cells among them.
    std::size_t number(const unsigned int batch, const int q) const
    {
      return std::size_t(batch - spaces.n_batches()) * n_points + q;
    }
    std::size_t size() const { return points.size(); }
    const Point &point(const unsigned int batch, const int q) const
    {
      return points[number(batch, q)];
    }

    /// Values at the points.
    void read(unsigned int batch, const Vector &vector, VectorValues &values) const;
    /// Values at the points and their reference gradients.
    void read(unsigned int batch, const Vector &vector, VectorValues &values,
              Gradients &gradients) const;
    /// Gradient with respect to reference positions, [component][direction].
    void gradient_at(const Gradients &reference, int q, const Point &point, Matrix &gradient) const;
    /// The flux whose integral with gradients of test functions is that of a stress.
    void set_flux(const Matrix &stress, int q, const Point &point, Gradients &fluxes) const;
    /// Add the integrals of values and fluxes at the points, which have the weights in them.
    void integrate(unsigned int batch, VectorValues &values, const Gradients &fluxes,
                   Vector &momentum) const;

    /// Calls visit(batch, q, F) with deformation gradients at the points of batches up to an end.
    template <class Visit>
    void for_deformation_gradients(const Vector &positions, unsigned int end,
                                   const Visit &visit) const;

    /// A shape function at a point: its value and its gradient with respect to reference positions.
    double shape(int node, int q, const Point &point, Lanes (&gradient)[dim]) const;

  private:
    const Spaces<dim> &spaces;
    const Kernel kernel;
    std::vector<Point> points;
  };

  template <int dim, int degree>
  void WallPoints<dim, degree>::read(const unsigned int batch, const Vector &vector,
                                     VectorValues &values) const
  {
    read_nodes(spaces.velocity_nodes(batch), vector.begin(), values);
    for (int c = 0; c < dim; ++c)
      kernel.interpolate(values[c]);
  }

  template <int dim, int degree>
  void WallPoints<dim, degree>::read(const unsigned int batch, const Vector &vector,
                                     VectorValues &values, Gradients &gradients) const
  {
    read(batch, vector, values);
    for (int c = 0; c < dim; ++c)
      kernel.gradient(values[c], gradients[c]);
  }

  template <int dim, int degree>
  void WallPoints<dim, degree>::integrate(const unsigned int batch, VectorValues &values,
                                          const Gradients &fluxes, Vector &momentum) const
  {
    for (int c = 0; c < dim; ++c)
    {
      kernel.gradient_transposed(fluxes[c], values[c]);
      kernel.interpolate_transposed(values[c]);
    }
    add_to_nodes(spaces.velocity_nodes(batch), spaces.n_filled_lanes(batch), values,
                 momentum.begin());
  }

  template <int dim, int degree>
  void WallPoints<dim, degree>::gradient_at(const Gradients &reference, const int q,
                                            const Point &point, Matrix &gradient) const
  {
    for (int c = 0; c < dim; ++c)
      for (int e = 0; e < dim; ++e)
      {
        gradient[c][e] = reference[c][0][q] * point.inverse[0][e];
        for (int d = 1; d < dim; ++d)
          gradient[c][e] += reference[c][d][q] * point.inverse[d][e];
      }
  }

  template <int dim, int degree>
  void WallPoints<dim, degree>::set_flux(const Matrix &stress, const int q, const Point &point,
                                         Gradients &fluxes) const
  {
    for (int c = 0; c < dim; ++c)
      for (int d = 0; d < dim; ++d)
      {
        Lanes sum = stress[c][0] * point.inverse[d][0];
        for (int e = 1; e < dim; ++e)
          sum += stress[c][e] * point.inverse[d][e];
        fluxes[c][d][q] = point.jxw * sum;
      }
  }

  template <int dim, int degree>
  void WallPoints<dim, degree>::set_reference(const Vector &positions)
  {
    points.resize(std::size_t(spaces.end_of_wall() - spaces.n_batches()) * n_points);
    double smallest = 1.;
    for (unsigned int batch = spaces.n_batches(); batch < spaces.end_of_wall(); ++batch)
    {
      VectorValues x;
      Gradients dx;
      read(batch, positions, x, dx);
      for (int q = 0; q < n_points; ++q)
      {
        Matrix jacobian;
        for (int c = 0; c < dim; ++c)
          for (int d = 0; d < dim; ++d)
            jacobian[c][d] = dx[c][d][q];
        Point &point = points[number(batch, q)];
        const Lanes det = invert(jacobian, point.inverse);
        point.jxw = det * kernel.weights()[q];
        for (unsigned int lane = 0; lane < n_lanes; ++lane)
          if (!(det[lane] > 0.))
            smallest = -1.;
      }
    }
    if (dealii::Utilities::MPI::min(smallest, spaces.communicator()) < 0.)
      throw NumericsError("the mesh of the wall has a cell with a Jacobian that is not positive",
                          "", "");
  }

  template <int dim, int degree>
  template <class Visit>
  void WallPoints<dim, degree>::for_deformation_gradients(const Vector &positions,
                                                          const unsigned int end,
                                                          const Visit &visit) const
  {
    for (unsigned int batch = spaces.n_batches(); batch < end; ++batch)
    {
      VectorValues x;
      Gradients dx;
      read(batch, positions, x, dx);
      for (int q = 0; q < n_points; ++q)
      {
        Matrix F;
        gradient_at(dx, q, point(batch, q), F);
        visit(batch, q, F);
      }
    }
  }

  template <int dim, int degree>
  double WallPoints<dim, degree>::shape(const int node, const int q, const Point &point,
                                        Lanes (&gradient)[dim]) const
  {
    constexpr int n_1d = degree + 1;
    double value = 1., reference[dim];
    std::fill(reference, reference + dim, 1.);
    for (int d = 0; d < dim; ++d)
    {
      const int entry = (q / power(n_1d, d)) % n_1d * n_1d + (node / power(n_1d, d)) % n_1d;
      value *= kernel.values_1d()[entry];
      for (int e = 0; e < dim; ++e)
        reference[e] *= d == e ? kernel.derivatives_1d()[entry] : kernel.values_1d()[entry];
    }
    for (int e = 0; e < dim; ++e)
    {
      gradient[e] = reference[0] * point.inverse[0][e];
      for (int d = 1; d < dim; ++d)
        gradient[e] += reference[d] * point.inverse[d][e];
    }
    return value;
  }
} // namespace semilunar::flow

#endif
