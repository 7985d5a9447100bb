// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_wall_material_h
#define semilunar_flow_wall_material_h

#include <semilunar/flow/lane_matrices.h>
#include <semilunar/flow/tensor_kernel.h>
#include <semilunar/flow/wall_parameters.h>

namespace semilunar::flow
{
  /// The strain energy of the wall at one point of n_lanes cells, equations (1) and (2) of
  /// doc/theory/wall.md: first Piola-Kirchhoff stress P [i][J] and its derivative. In the plane the
  /// strain out of it is zero.
  template <int dim>
  class WallMaterial
  {
  public:
    using Tensor = Lanes[dim][dim];

    explicit WallMaterial(const WallParameters &prm)
        : neo_hookean(prm.material == "neo-Hookean"), mu(prm.shear_modulus()), lambda(prm.lame()),
          kappa(prm.bulk_modulus())
    {
    }

    /// Energy per reference volume [dyn/cm^2] of a deformation gradient F [i][J].
    Lanes energy(const Tensor &F) const;
    void stress(const Tensor &F, Tensor &P) const;

    /// The derivative of the stress at one deformation gradient.
    class Tangent
    {
    public:
      Tangent(const WallMaterial &material, const Tensor &F);
      /// dP = derivative of P applied to dF
      void apply(const Tensor &dF, Tensor &dP) const;

    private:
      const WallMaterial &material;
      Tensor F, inverse, S; ///< S: St.Venant-Kirchhoff only
      Lanes isochoric, trace_third, volumetric, volumetric_change;
    };

  private:
    /// E = (F^T F - I)/2 and its trace.
    static Lanes strain(const Tensor &F, Tensor &E);
    void second_stress(const Tensor &F, Tensor &S) const;
    static Lanes first_invariant(const Tensor &F);

    const bool neo_hookean;
    const double mu, lambda, kappa;
  };

  /// A function of each lane.
  template <class Function>
  inline Lanes lane_by_lane(const Lanes &x, const Function &function)
  {
    Lanes result;
    for (unsigned int lane = 0; lane < n_lanes; ++lane)
      result[lane] = function(x[lane]);
    return result;
  }

  /// J^(-2/3)
  inline Lanes isochoric_scaling(const Lanes &J)
  {
    return lane_by_lane(J,
                        [](const double x)
                        {
                          const double root = std::cbrt(x);
                          return 1. / (root * root);
                        });
  }

  template <int dim>
  Lanes WallMaterial<dim>::first_invariant(const Tensor &F)
  {
    Lanes sum = Lanes{} + (3. - dim);
    for (int i = 0; i < dim; ++i)
      for (int J = 0; J < dim; ++J)
        sum += F[i][J] * F[i][J];
    return sum;
  }

  template <int dim>
  Lanes WallMaterial<dim>::strain(const Tensor &F, Tensor &E)
  {
    Lanes trace = Lanes{};
    for (int I = 0; I < dim; ++I)
    {
      for (int J = 0; J < dim; ++J)
      {
        Lanes sum = F[0][I] * F[0][J];
        for (int i = 1; i < dim; ++i)
          sum += F[i][I] * F[i][J];
        E[I][J] = 0.5 * sum;
      }
      E[I][I] -= 0.5;
      trace += E[I][I];
    }
    return trace;
  }

  template <int dim>
  void WallMaterial<dim>::second_stress(const Tensor &F, Tensor &S) const
  {
    const Lanes trace = strain(F, S);
    for (int I = 0; I < dim; ++I)
    {
      for (int J = 0; J < dim; ++J)
        S[I][J] *= 2. * mu;
      S[I][I] += lambda * trace;
    }
  }

  template <int dim>
  Lanes WallMaterial<dim>::energy(const Tensor &F) const
  {
    Tensor work;
    if (neo_hookean)
    {
      const Lanes J = invert(F, work);
      const Lanes logarithm = lane_by_lane(J, [](const double x) { return std::log(x); });
      return 0.5 * mu * (isochoric_scaling(J) * first_invariant(F) - 3.) +
             0.5 * kappa * (0.5 * (J * J - 1.) - logarithm);
    }
    const Lanes trace = strain(F, work);
    Lanes energy = 0.5 * lambda * trace * trace;
    for (int I = 0; I < dim; ++I)
      for (int J = 0; J < dim; ++J)
        energy += mu * work[I][J] * work[I][J];
    return energy;
  }

  template <int dim>
  void WallMaterial<dim>::stress(const Tensor &F, Tensor &P) const
  {
    Tensor work;
    if (neo_hookean)
    {
      const Lanes J = invert(F, work), factor = mu * isochoric_scaling(J);
      const Lanes pressure = 0.5 * kappa * (J * J - 1.) - factor * first_invariant(F) * (1. / 3.);
      for (int i = 0; i < dim; ++i)
        for (int I = 0; I < dim; ++I)
          P[i][I] = factor * F[i][I] + pressure * work[I][i];
      return;
    }
    second_stress(F, work);
    for (int i = 0; i < dim; ++i)
      for (int I = 0; I < dim; ++I)
      {
        P[i][I] = F[i][0] * work[0][I];
        for (int K = 1; K < dim; ++K)
          P[i][I] += F[i][K] * work[K][I];
      }
  }

  template <int dim>
  WallMaterial<dim>::Tangent::Tangent(const WallMaterial &material, const Tensor &F_)
      : material(material)
  {
    for (int i = 0; i < dim; ++i)
      for (int J = 0; J < dim; ++J)
        F[i][J] = F_[i][J];
    if (!material.neo_hookean)
    {
      material.second_stress(F, S);
      return;
    }
    const Lanes J = invert(F, inverse);
    isochoric = material.mu * isochoric_scaling(J);
    trace_third = first_invariant(F) * (1. / 3.);
    volumetric = 0.5 * material.kappa * (J * J - 1.);
    volumetric_change = material.kappa * J * J;
  }

  template <int dim>
  void WallMaterial<dim>::Tangent::apply(const Tensor &dF, Tensor &dP) const
  {
    Tensor work;
    if (!material.neo_hookean)
    {
      // dS from dE = sym(F^T dF), then dP = dF S + F dS.
      Lanes trace = Lanes{};
      for (int I = 0; I < dim; ++I)
        for (int J = 0; J < dim; ++J)
        {
          work[I][J] = F[0][I] * dF[0][J] + dF[0][I] * F[0][J];
          for (int i = 1; i < dim; ++i)
            work[I][J] += F[i][I] * dF[i][J] + dF[i][I] * F[i][J];
          if (I == J)
            trace += 0.5 * work[I][I];
          work[I][J] *= material.mu;
        }
      for (int I = 0; I < dim; ++I)
        work[I][I] += material.lambda * trace;
      for (int i = 0; i < dim; ++i)
        for (int I = 0; I < dim; ++I)
        {
          dP[i][I] = dF[i][0] * S[0][I] + F[i][0] * work[0][I];
          for (int K = 1; K < dim; ++K)
            dP[i][I] += dF[i][K] * S[K][I] + F[i][K] * work[K][I];
        }
      return;
    }
    // work = F^-1 dF, transposed F^-T dF^T F^-T = (work F^-1)^T.
    Lanes divergence = Lanes{}, along = Lanes{};
    for (int I = 0; I < dim; ++I)
      for (int J = 0; J < dim; ++J)
      {
        work[I][J] = inverse[I][0] * dF[0][J];
        for (int i = 1; i < dim; ++i)
          work[I][J] += inverse[I][i] * dF[i][J];
        if (I == J)
          divergence += work[I][I];
        along += F[I][J] * dF[I][J];
      }
    const Lanes scaled = (2. / 3.) * divergence * isochoric;
    const Lanes diagonal =
        (2. / 3.) * isochoric * (trace_third * divergence - along) + volumetric_change * divergence;
    const Lanes transposed = isochoric * trace_third - volumetric;
    for (int i = 0; i < dim; ++i)
      for (int I = 0; I < dim; ++I)
      {
        Lanes product = work[I][0] * inverse[0][i];
        for (int K = 1; K < dim; ++K)
          product += work[I][K] * inverse[K][i];
        dP[i][I] = isochoric * dF[i][I] - scaled * F[i][I] + diagonal * inverse[I][i] +
                   transposed * product;
      }
  }
} // namespace semilunar::flow

#endif
