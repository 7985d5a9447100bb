// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_stress_at_rest_h
#define semilunar_flow_stress_at_rest_h

#include <semilunar/flow/lanes.h>

#include <array>
#include <vector>

namespace semilunar::flow
{
  /// The second Piola-Kirchhoff stresses S0 that a prestressed wall has at rest (P1), at points
  /// counted through; none, at no cost, until they are set.
  template <int dim>
  class StressAtRest
  {
  public:
    using Matrix = Lanes[dim][dim];

    void clear() { stresses.clear(); }
    void resize(const std::size_t n_points) { stresses.resize(n_points); }

    void set(const std::size_t point, const Matrix &stress)
    {
      for (int I = 0; I < dim; ++I)
        for (int J = 0; J < dim; ++J)
          stresses[point][I][J] = stress[I][J];
    }

    /// P += F S0, or the same of their changes.
    void add(const std::size_t point, const Matrix &F, Matrix &P) const
    {
      if (stresses.empty())
        return;
      const auto &S = stresses[point];
      for (int i = 0; i < dim; ++i)
        for (int J = 0; J < dim; ++J)
          for (int K = 0; K < dim; ++K)
            P[i][J] += F[i][K] * S[K][J];
    }

    /// Add the derivative of F S0 to dP_iJ / dF_kL.
    void add_tangent(const std::size_t point, Lanes (&tensor)[dim][dim][dim][dim]) const
    {
      if (stresses.empty())
        return;
      for (int i = 0; i < dim; ++i)
        for (int J = 0; J < dim; ++J)
          for (int L = 0; L < dim; ++L)
            tensor[i][J][i][L] += stresses[point][L][J];
    }

    /// S0 : E.
    Lanes energy(const std::size_t point, const Matrix &F) const
    {
      Lanes sum = Lanes{};
      if (stresses.empty())
        return sum;
      const auto &S = stresses[point];
      for (int I = 0; I < dim; ++I)
      {
        sum -= 0.5 * S[I][I];
        for (int J = 0; J < dim; ++J)
          for (int i = 0; i < dim; ++i)
            sum += 0.5 * S[I][J] * F[i][I] * F[i][J];
      }
      return sum;
    }

  private:
    std::vector<std::array<std::array<Lanes, dim>, dim>> stresses;
  };
} // namespace semilunar::flow

#endif
