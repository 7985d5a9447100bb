// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/stress_at_rest.h>
#include <semilunar/flow/wall_forms.h>
#include <semilunar/flow/wall_material.h>
#include <semilunar/flow/wall_points.h>

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
          : spaces(spaces), prm(parameters), material(parameters), points(spaces)
      {
      }

      void set_reference(const Vector &positions) override
      {
        points.set_reference(positions);
        stress_at_rest.clear();
      }
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
      using Points = WallPoints<dim, degree>;
      static constexpr int n_nodes = Points::n_nodes, n_points = Points::n_points;
      using VectorValues = typename Points::VectorValues;
      using Gradients = typename Points::Gradients;
      using Matrix = Lanes[dim][dim];

      void tangent_tensor(const Matrix &F, Lanes (&tensor)[dim][dim][dim][dim]) const;
      /// The deformation gradient that the derivative is about.
      void deformation_at(unsigned int batch, int q, Matrix &F) const;

      const Spaces<dim> &spaces;
      const WallParameters &prm;
      const WallMaterial<dim> material;
      Points points;
      StressAtRest<dim> stress_at_rest;
      std::vector<std::array<std::array<Lanes, dim>, dim>> deformation; ///< F at the points
      double inertia = 0.;
    };

    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::set_prestress(const Vector &displacement)
    {
      stress_at_rest.resize(points.size());
      Matrix unit = {};
      for (int i = 0; i < dim; ++i)
        unit[i][i] = Lanes{} + 1.;
      const typename WallMaterial<dim>::Tangent at_rest(material, unit);
      points.for_deformation_gradients(
          displacement, spaces.end_of_wall(),
          [&](const unsigned int batch, const int q, const Matrix &gradient)
          {
            Matrix stress;
            at_rest.apply(gradient, stress);
            stress_at_rest.set(points.number(batch, q), stress);
          });
    }

    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::linearise(const Vector &positions, const double alpha)
    {
      inertia = alpha;
      deformation.resize(points.size());
      points.for_deformation_gradients(
          positions, spaces.end_of_wall(),
          [this](const unsigned int batch, const int q, const Matrix &F)
          {
            auto &stored = deformation[points.number(batch, q)];
            for (int i = 0; i < dim; ++i)
              for (int J = 0; J < dim; ++J)
                stored[i][J] = F[i][J];
          });
    }

    template <int dim, int degree>
    void WallFormsOfDegree<dim, degree>::deformation_at(const unsigned int batch, const int q,
                                                        Matrix &F) const
    {
      const auto &stored = deformation[points.number(batch, q)];
      for (int i = 0; i < dim; ++i)
        for (int J = 0; J < dim; ++J)
          F[i][J] = stored[i][J];
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
        points.read(batch, positions, x, dx);
        points.read(batch, velocity, u);
        points.read(batch, history, past);
        for (int q = 0; q < n_points; ++q)
        {
          const auto &point = points.point(batch, q);
          Matrix F, P;
          points.gradient_at(dx, q, point, F);
          material.stress(F, P);
          stress_at_rest.add(points.number(batch, q), F, P);
          points.set_flux(P, q, point, dx);
          const Lanes mass = prm.density * point.jxw;
          for (int c = 0; c < dim; ++c)
            u[c][q] = mass * ((alpha + prm.damping) * u[c][q] + past[c][q] - prm.acceleration[c]);
        }
        points.integrate(batch, u, dx, momentum);
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
        points.read(batch, velocity, u, du);
        for (int q = 0; q < n_points; ++q)
        {
          const auto &point = points.point(batch, q);
          Matrix F, dF, dP;
          deformation_at(batch, q, F);
          points.gradient_at(du, q, point, dF);
          typename WallMaterial<dim>::Tangent(material, F).apply(dF, dP);
          stress_at_rest.add(points.number(batch, q), dF, dP);
          for (int c = 0; c < dim; ++c)
          {
            u[c][q] *= mass * point.jxw;
            for (int e = 0; e < dim; ++e)
              dP[c][e] *= scale;
          }
          points.set_flux(dP, q, point, du);
        }
        points.integrate(batch, u, du, momentum);
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
      constexpr int n = n_nodes * dim;
      const double scale = inertia > 0. ? 1. / inertia : 1.;
      const double mass = inertia > 0. ? prm.density * (inertia + prm.damping) : 0.;
      std::fill(matrix, matrix + n * n, Lanes{});
      for (int q = 0; q < n_points; ++q)
      {
        const auto &point = points.point(batch, q);
        Matrix F;
        deformation_at(batch, q, F);
        Lanes tensor[dim][dim][dim][dim], gradient[n_nodes][dim];
        tangent_tensor(F, tensor);
        stress_at_rest.add_tangent(points.number(batch, q), tensor);
        double value[n_nodes];
        for (int i = 0; i < n_nodes; ++i)
          value[i] = points.shape(i, q, point, gradient[i]);
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
      points.for_deformation_gradients(
          positions, spaces.end_of_owned_wall(),
          [&](const unsigned int batch, const int q, const Matrix &F)
          {
            add(batch, sum.strain,
                points.point(batch, q).jxw *
                    (material.energy(F) + stress_at_rest.energy(points.number(batch, q), F)));
          });
      for (unsigned int batch = spaces.n_batches(); batch < spaces.end_of_owned_wall(); ++batch)
      {
        VectorValues u;
        points.read(batch, velocity, u);
        for (int c = 0; c < dim; ++c)
          for (int q = 0; q < n_points; ++q)
            add(batch, sum.kinetic,
                0.5 * prm.density * points.point(batch, q).jxw * u[c][q] * u[c][q]);
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
            sum += points.point(batch, q).jxw[lane];
      return sum;
    }

    template <int dim, int degree>
    double WallFormsOfDegree<dim, degree>::smallest_determinant(const Vector &positions) const
    {
      double smallest = std::numeric_limits<double>::max();
      points.for_deformation_gradients(positions, spaces.end_of_owned_wall(),
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
