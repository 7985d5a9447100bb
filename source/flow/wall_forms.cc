// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/flow/cell_vectors.h>
#include <semilunar/flow/wall_forms.h>
#include <semilunar/flow/wall_material.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace semilunar::flow
{
  namespace
  {
    /// The forms for one degree, which the loops are unrolled for.
    template <int dim, int degree>
    class WallFormsOfDegree : public WallForms<dim>
    {
    public:
      WallFormsOfDegree(const Spaces<dim> &spaces, const WallParameters &parameters)
          : spaces(spaces), prm(parameters), material(parameters)
      {
      }

      void set_reference(const Vector &positions) override;
      void set_prestress(const Vector &displacement) override;
      void linearise(const Vector &positions, double inertia) override;
      void add_residual(const Vector &positions, const Vector &velocity, const Vector &history,
                        double inertia, Vector &momentum) const override;
      void add_jacobian(const Vector &velocity, Vector &momentum) const override;
      void tangent_matrix(unsigned int batch, Lanes *matrix) const override;
      typename WallForms<dim>::Energies energies(const Vector &positions,
                                                 const Vector &velocity) const override;
      double reference_volume() const override;
      double smallest_determinant(const Vector &positions) const override;

    private:
      using Kernel = TensorKernel<dim, degree>;
      static constexpr int n_nodes = Kernel::n_nodes, n_points = Kernel::n_points;
      using VectorValues = Lanes[dim][n_points];
      using Gradients = Lanes[dim][dim][n_points];
      using Matrix = Lanes[dim][dim];

      struct GeometryPoint
      {
        Matrix inverse; ///< d xi_d / d X_e
        Lanes jxw;
      };

      void read(unsigned int batch, const Vector &vector, VectorValues &values) const;
      void integrate(unsigned int batch, VectorValues &values, const Gradients &fluxes,
                     Vector &momentum) const;
      /// values: nodal values, then values at the points; gradients: reference gradients.
      void evaluate(VectorValues &values, Gradients &gradients) const;
      /// Gradient with respect to reference positions, [component][direction].
      void gradient_at(const Gradients &reference, int q, const GeometryPoint &point,
                       Matrix &gradient) const;
      void set_flux(const Matrix &stress, int q, const GeometryPoint &point,
                    Gradients &fluxes) const;
      void tangent_tensor(const Matrix &F, Lanes (&tensor)[dim][dim][dim][dim]) const;
      /// P += F S0, or the same of their changes; nothing without a prestress.
      void add_prestress(unsigned int batch, int q, const Matrix &F, Matrix &P) const;
      /// S0 : E, zero without a prestress.
      Lanes prestress_energy(unsigned int batch, int q, const Matrix &F) const;
      std::size_t point_number(const unsigned int batch, const int q) const
      {
        return std::size_t(batch - spaces.n_batches()) * n_points + q;
      }
      const GeometryPoint &geometry(const unsigned int batch, const int q) const
      {
        return geometry_points[point_number(batch, q)];
      }
      /// Calls visit(batch, q, F) at the points of owned cells.
      template <class Visit>
      void for_deformation_gradients(const Vector &positions, unsigned int end,
                                     const Visit &visit) const;

      const Spaces<dim> &spaces;
      const WallParameters &prm;
      const WallMaterial<dim> material;
      const Kernel kernel;
      std::vector<GeometryPoint> geometry_points;
      using StoredMatrix = std::array<std::array<Lanes, dim>, dim>;
      std::vector<StoredMatrix> deformation; ///< F, [batch][point]
      std::vector<StoredMatrix> prestress;   ///< S0; empty: there is none
      double inertia = 0.;
    };

    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::read(const unsigned int batch, const Vector &vector,
                                              VectorValues &values) const
    {
      read_nodes(spaces.velocity_nodes(batch), vector.begin(), values);
    }

    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::evaluate(VectorValues &values, Gradients &gradients) const
    {
      for (int c = 0; c < dim; ++c)
      {
        kernel.interpolate(values[c]);
        kernel.gradient(values[c], gradients[c]);
      }
    }

    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::integrate(const unsigned int batch, VectorValues &values,
                                                   const Gradients &fluxes, Vector &momentum) const
    {
      double *target = momentum.begin();
      const auto *nodes = spaces.velocity_nodes(batch);
      for (int c = 0; c < dim; ++c)
      {
        kernel.gradient_transposed(fluxes[c], values[c]);
        kernel.interpolate_transposed(values[c]);
      }
      for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
        for (int i = 0; i < n_nodes; ++i)
          for (int c = 0; c < dim; ++c)
            target[dim * nodes[i][lane] + c] += values[c][i][lane];
    }

    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::gradient_at(const Gradients &reference, const int q,
                                                     const GeometryPoint &point,
                                                     Matrix &gradient) const
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
    void WallFormsOfDegree<dim, degree>::set_flux(const Matrix &stress, const int q,
                                                  const GeometryPoint &point,
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
    void WallFormsOfDegree<dim, degree>::set_reference(const Vector &positions)
    {
      geometry_points.resize(std::size_t(spaces.end_of_wall() - spaces.n_batches()) * n_points);
      prestress.clear();
      double smallest = 1.;
      for (unsigned int batch = spaces.n_batches(); batch < spaces.end_of_wall(); ++batch)
      {
        VectorValues x;
        Gradients dx;
        read(batch, positions, x);
        evaluate(x, dx);
        for (int q = 0; q < n_points; ++q)
        {
          Matrix jacobian;
          for (int c = 0; c < dim; ++c)
            for (int d = 0; d < dim; ++d)
              jacobian[c][d] = dx[c][d][q];
          auto &point = geometry_points[point_number(batch, q)];
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
    void WallFormsOfDegree<dim, degree>::for_deformation_gradients(const Vector &positions,
                                                                   const unsigned int end,
                                                                   const Visit &visit) const
    {
      for (unsigned int batch = spaces.n_batches(); batch < end; ++batch)
      {
        VectorValues x;
        Gradients dx;
        read(batch, positions, x);
        evaluate(x, dx);
        for (int q = 0; q < n_points; ++q)
        {
          Matrix F;
          gradient_at(dx, q, geometry(batch, q), F);
          visit(batch, q, F);
        }
      }
    }

    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::set_prestress(const Vector &displacement)
    {
      prestress.resize(geometry_points.size());
      Matrix unit = {};
      for (int i = 0; i < dim; ++i)
        unit[i][i] = Lanes{} + 1.;
      const typename WallMaterial<dim>::Tangent at_rest(material, unit);
      for_deformation_gradients(displacement, spaces.end_of_wall(),
                                [&](const unsigned int batch, const int q, const Matrix &gradient)
                                {
                                  Matrix stress;
                                  at_rest.apply(gradient, stress);
                                  auto &stored = prestress[point_number(batch, q)];
                                  for (int I = 0; I < dim; ++I)
                                    for (int J = 0; J < dim; ++J)
                                      stored[I][J] = stress[I][J];
                                });
    }

    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::add_prestress(const unsigned int batch, const int q,
                                                       const Matrix &F, Matrix &P) const
    {
      if (prestress.empty())
        return;
      const StoredMatrix &S = prestress[point_number(batch, q)];
      for (int i = 0; i < dim; ++i)
        for (int J = 0; J < dim; ++J)
          for (int K = 0; K < dim; ++K)
            P[i][J] += F[i][K] * S[K][J];
    }

    template <int dim, int degree>
    Lanes WallFormsOfDegree<dim, degree>::prestress_energy(const unsigned int batch, const int q,
                                                           const Matrix &F) const
    {
      Lanes sum = Lanes{};
      if (prestress.empty())
        return sum;
      const StoredMatrix &S = prestress[point_number(batch, q)];
      for (int I = 0; I < dim; ++I)
      {
        sum -= 0.5 * S[I][I];
        for (int J = 0; J < dim; ++J)
          for (int i = 0; i < dim; ++i)
            sum += 0.5 * S[I][J] * F[i][I] * F[i][J];
      }
      return sum;
    }

    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::linearise(const Vector &positions, const double alpha)
    {
      inertia = alpha;
      deformation.resize(geometry_points.size());
      for_deformation_gradients(positions, spaces.end_of_wall(),
                                [this](const unsigned int batch, const int q, const Matrix &F)
                                {
                                  auto &stored = deformation[point_number(batch, q)];
                                  for (int i = 0; i < dim; ++i)
                                    for (int J = 0; J < dim; ++J)
                                      stored[i][J] = F[i][J];
                                });
    }

    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::add_residual(const Vector &positions,
                                                      const Vector &velocity, const Vector &history,
                                                      const double alpha, Vector &momentum) const
    {
      for (unsigned int batch = spaces.n_batches(); batch < spaces.end_of_owned_wall(); ++batch)
      {
        VectorValues x, u, past;
        Gradients dx;
        read(batch, positions, x);
        evaluate(x, dx);
        read(batch, velocity, u);
        read(batch, history, past);
        for (int c = 0; c < dim; ++c)
        {
          kernel.interpolate(u[c]);
          kernel.interpolate(past[c]);
        }
        for (int q = 0; q < n_points; ++q)
        {
          const GeometryPoint &point = geometry(batch, q);
          Matrix F, P;
          gradient_at(dx, q, point, F);
          material.stress(F, P);
          add_prestress(batch, q, F, P);
          set_flux(P, q, point, dx);
          const Lanes mass = prm.density * point.jxw;
          for (int c = 0; c < dim; ++c)
            u[c][q] = mass * ((alpha + prm.damping) * u[c][q] + past[c][q] - prm.acceleration[c]);
        }
        integrate(batch, u, dx, momentum);
      }
    }

    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::add_jacobian(const Vector &velocity,
                                                      Vector &momentum) const
    {
      const double scale = inertia > 0. ? 1. / inertia : 1.;
      const double mass = inertia > 0. ? prm.density * (inertia + prm.damping) : 0.;
      for (unsigned int batch = spaces.n_batches(); batch < spaces.end_of_owned_wall(); ++batch)
      {
        VectorValues u;
        Gradients du;
        read(batch, velocity, u);
        evaluate(u, du);
        for (int q = 0; q < n_points; ++q)
        {
          const GeometryPoint &point = geometry(batch, q);
          const auto &stored = deformation[point_number(batch, q)];
          Matrix F, dF, dP;
          for (int i = 0; i < dim; ++i)
            for (int J = 0; J < dim; ++J)
              F[i][J] = stored[i][J];
          gradient_at(du, q, point, dF);
          typename WallMaterial<dim>::Tangent(material, F).apply(dF, dP);
          add_prestress(batch, q, dF, dP);
          for (int c = 0; c < dim; ++c)
          {
            u[c][q] *= mass * point.jxw;
            for (int e = 0; e < dim; ++e)
              dP[c][e] *= scale;
          }
          set_flux(dP, q, point, du);
        }
        integrate(batch, u, du, momentum);
      }
    }

    /// dP_iJ / dF_kL
    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::tangent_tensor(const Matrix &F,
                                                        Lanes (&tensor)[dim][dim][dim][dim]) const
    {
      const typename WallMaterial<dim>::Tangent tangent(material, F);
      for (int k = 0; k < dim; ++k)
        for (int L = 0; L < dim; ++L)
        {
          Matrix dF = {}, dP;
          dF[k][L] = Lanes{} + 1.;
          tangent.apply(dF, dP);
          for (int i = 0; i < dim; ++i)
            for (int J = 0; J < dim; ++J)
              tensor[i][J][k][L] = dP[i][J];
        }
    }

    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::tangent_matrix(const unsigned int batch,
                                                        Lanes *matrix) const
    {
      constexpr int n = n_nodes * dim, n_1d = degree + 1;
      const double scale = inertia > 0. ? 1. / inertia : 1.;
      const double mass = inertia > 0. ? prm.density * (inertia + prm.damping) : 0.;
      std::fill(matrix, matrix + n * n, Lanes{});
      for (int q = 0; q < n_points; ++q)
      {
        const GeometryPoint &point = geometry(batch, q);
        const auto &stored = deformation[point_number(batch, q)];
        Matrix F;
        for (int i = 0; i < dim; ++i)
          for (int J = 0; J < dim; ++J)
            F[i][J] = stored[i][J];
        Lanes tensor[dim][dim][dim][dim], gradient[n_nodes][dim];
        tangent_tensor(F, tensor);
        if (!prestress.empty())
          for (int i = 0; i < dim; ++i)
            for (int J = 0; J < dim; ++J)
              for (int L = 0; L < dim; ++L)
                tensor[i][J][i][L] += prestress[point_number(batch, q)][L][J];
        double value[n_nodes];
        for (int i = 0; i < n_nodes; ++i)
        {
          double reference[dim];
          value[i] = 1.;
          std::fill(reference, reference + dim, 1.);
          for (int d = 0; d < dim; ++d)
          {
            const int entry = (q / power(n_1d, d)) % n_1d * n_1d + (i / power(n_1d, d)) % n_1d;
            value[i] *= kernel.values_1d()[entry];
            for (int e = 0; e < dim; ++e)
              reference[e] *= d == e ? kernel.derivatives_1d()[entry] : kernel.values_1d()[entry];
          }
          for (int e = 0; e < dim; ++e)
          {
            gradient[i][e] = reference[0] * point.inverse[0][e];
            for (int d = 1; d < dim; ++d)
              gradient[i][e] += reference[d] * point.inverse[d][e];
          }
        }
        for (int j = 0; j < n_nodes; ++j)
          for (int k = 0; k < dim; ++k)
          {
            Lanes flux[dim][dim]; // of a unit velocity k of node j
            for (int i = 0; i < dim; ++i)
              for (int J = 0; J < dim; ++J)
              {
                Lanes sum = tensor[i][J][k][0] * gradient[j][0];
                for (int L = 1; L < dim; ++L)
                  sum += tensor[i][J][k][L] * gradient[j][L];
                flux[i][J] = (scale * point.jxw) * sum;
              }
            for (int i = 0; i < n_nodes; ++i)
              for (int c = 0; c < dim; ++c)
              {
                Lanes sum = gradient[i][0] * flux[c][0];
                for (int e = 1; e < dim; ++e)
                  sum += gradient[i][e] * flux[c][e];
                if (c == k)
                  sum += (mass * value[i] * value[j]) * point.jxw;
                matrix[(i * dim + c) * n + j * dim + k] += sum;
              }
          }
      }
    }

    template <int dim, int degree>
    typename WallForms<dim>::Energies
    WallFormsOfDegree<dim, degree>::energies(const Vector &positions, const Vector &velocity) const
    {
      typename WallForms<dim>::Energies sum;
      const auto add = [&](const unsigned int batch, double &target, const Lanes &value)
      {
        for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
          target += value[lane];
      };
      for_deformation_gradients(positions, spaces.end_of_owned_wall(),
                                [&](const unsigned int batch, const int q, const Matrix &F)
                                {
                                  add(batch, sum.strain,
                                      geometry(batch, q).jxw *
                                          (material.energy(F) + prestress_energy(batch, q, F)));
                                });
      for (unsigned int batch = spaces.n_batches(); batch < spaces.end_of_owned_wall(); ++batch)
      {
        VectorValues u;
        read(batch, velocity, u);
        for (int c = 0; c < dim; ++c)
        {
          kernel.interpolate(u[c]);
          for (int q = 0; q < n_points; ++q)
            add(batch, sum.kinetic, 0.5 * prm.density * geometry(batch, q).jxw * u[c][q] * u[c][q]);
        }
      }
      return sum;
    }

    template <int dim, int degree>
    double WallFormsOfDegree<dim, degree>::reference_volume() const
    {
      double sum = 0.;
      for (unsigned int batch = spaces.n_batches(); batch < spaces.end_of_owned_wall(); ++batch)
        for (int q = 0; q < n_points; ++q)
          for (unsigned int lane = 0; lane < spaces.n_filled_lanes(batch); ++lane)
            sum += geometry(batch, q).jxw[lane];
      return sum;
    }

    template <int dim, int degree>
    double WallFormsOfDegree<dim, degree>::smallest_determinant(const Vector &positions) const
    {
      double smallest = std::numeric_limits<double>::max();
      for_deformation_gradients(positions, spaces.end_of_owned_wall(),
                                [&](const unsigned int, const int, const Matrix &F)
                                {
                                  Matrix inverse;
                                  const Lanes det = invert(F, inverse);
                                  for (unsigned int lane = 0; lane < n_lanes; ++lane)
                                    smallest = std::min(smallest, det[lane]);
                                });
      return smallest;
    }
  } // namespace

  template <int dim>
  std::unique_ptr<WallForms<dim>> WallForms<dim>::create(const Spaces<dim> &spaces,
                                                         const WallParameters &parameters)
  {
    if (spaces.degree() == 2)
      return std::make_unique<WallFormsOfDegree<dim, 2>>(spaces, parameters);
    return std::make_unique<WallFormsOfDegree<dim, 3>>(spaces, parameters);
  }

  template class WallForms<2>;
  template class WallForms<3>;
} // namespace semilunar::flow
