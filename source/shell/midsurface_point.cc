// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/midsurface_point.h>

#include <cmath>

namespace semilunar::shell
{
  using namespace spline;

  namespace
  {
    /// Multiplicity of the components 11, 22, 12 of a symmetric tensor.
    constexpr double multiplicity[3] = {1., 1., 2.};

    /// Geometry of the deformed midsurface at the point.
    struct Geometry
    {
      FundamentalForms forms;
      double inverse_a[3];           // contravariant metric 11, 22, 12
      Tensor<1, 3> contravariant[2]; // a^1, a^2
      double christoffel[2][3];      // Gamma^gamma_I, I = 11, 22, 12
    };

    Geometry geometry(const SurfaceJet &jet)
    {
      Geometry g;
      g.forms = fundamental_forms(jet);
      const auto &a = g.forms.a;
      const double det = a[0] * a[1] - a[2] * a[2];
      g.inverse_a[0] = a[1] / det;
      g.inverse_a[1] = a[0] / det;
      g.inverse_a[2] = -a[2] / det;
      g.contravariant[0] = g.inverse_a[0] * jet[d1] + g.inverse_a[2] * jet[d2];
      g.contravariant[1] = g.inverse_a[2] * jet[d1] + g.inverse_a[1] * jet[d2];
      for (unsigned int gamma = 0; gamma < 2; ++gamma)
        for (unsigned int I = 0; I < 3; ++I)
          g.christoffel[gamma][I] = jet[d11 + I] * g.contravariant[gamma];
      return g;
    }

    /// Blocks of the Hessian with respect to r_,alpha and the covariant second derivatives r_|I:
    /// (K8).
    struct CovariantHessian
    {
      double first[2][2][3][3]; // alpha i, beta j
      double mixed[2][3][3][3]; // alpha i, I j
      double second[3][3];      // I, J; times a3_i a3_j
    };

    CovariantHessian covariant_hessian(const SurfaceJet &jet, const Geometry &g,
                                       const SectionResponse &s)
    {
      const Tensor<1, 3> &a3 = g.forms.normal;
      const double zero[3] = {0., 0., 0.};
      const double *r1 = jet[d1].begin_raw(), *r2 = jet[d2].begin_raw();
      // strain variation: d eps_I = strain[I][alpha] . u_,alpha (12 counted twice)
      const double *const strain[3][2] = {{r1, zero}, {zero, r2}, {r2, r1}};
      const double n[2][2] = {{s.n[0], s.n[2]}, {s.n[2], s.n[1]}};
      const double inverse_a[2][2] = {{g.inverse_a[0], g.inverse_a[2]},
                                      {g.inverse_a[2], g.inverse_a[1]}};
      const double m_b = s.m[0] * g.forms.b[0] + s.m[1] * g.forms.b[1] + 2. * s.m[2] * g.forms.b[2];

      CovariantHessian h;
      for (unsigned int alpha = 0; alpha < 2; ++alpha)
      {
        double stress[3][3]; // J, i: sum_I strain[I][alpha]_i membrane_IJ
        double coupling[3][3];
        for (unsigned int J = 0; J < 3; ++J)
          for (unsigned int i = 0; i < 3; ++i)
          {
            stress[J][i] = coupling[J][i] = 0.;
            for (unsigned int I = 0; I < 3; ++I)
            {
              stress[J][i] += strain[I][alpha][i] * s.membrane[3 * I + J];
              coupling[J][i] += strain[I][alpha][i] * s.coupling[3 * I + J];
            }
          }
        for (unsigned int beta = 0; beta < 2; ++beta)
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
            {
              double sum = m_b * inverse_a[alpha][beta] * a3[i] * a3[j];
              for (unsigned int J = 0; J < 3; ++J)
                sum += stress[J][i] * strain[J][beta][j];
              h.first[alpha][beta][i][j] = sum + (i == j ? n[alpha][beta] : 0.);
            }
        for (unsigned int I = 0; I < 3; ++I)
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              h.mixed[alpha][I][i][j] =
                  multiplicity[I] *
                  (s.m[I] * a3[i] * g.contravariant[alpha][j] - coupling[I][i] * a3[j]);
      }
      for (unsigned int I = 0; I < 3; ++I)
        for (unsigned int J = 0; J < 3; ++J)
          h.second[I][J] = multiplicity[I] * multiplicity[J] * s.bending[3 * I + J];
      return h;
    }

    /// From covariant to plain second derivatives, r_|I = r_,I - Gamma^gamma_I r_,gamma: (K9).
    void to_plain_derivatives(const Geometry &g, const CovariantHessian &h, PointResponse &response)
    {
      auto &H = response.hessian;
      const Tensor<1, 3> &a3 = g.forms.normal;
      double second[2][3]; // sum_I Gamma^alpha_I second[I][J]
      double both[2][2];   // sum_IJ Gamma^alpha_I Gamma^beta_J second[I][J]
      for (unsigned int alpha = 0; alpha < 2; ++alpha)
      {
        for (unsigned int J = 0; J < 3; ++J)
          second[alpha][J] = g.christoffel[alpha][0] * h.second[0][J] +
                             g.christoffel[alpha][1] * h.second[1][J] +
                             g.christoffel[alpha][2] * h.second[2][J];
        for (unsigned int beta = 0; beta < 2; ++beta)
          both[alpha][beta] = second[alpha][0] * g.christoffel[beta][0] +
                              second[alpha][1] * g.christoffel[beta][1] +
                              second[alpha][2] * g.christoffel[beta][2];
      }
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
        {
          const double a3a3 = a3[i] * a3[j];
          for (unsigned int alpha = 0; alpha < 2; ++alpha)
          {
            for (unsigned int beta = 0; beta < 2; ++beta)
            {
              double sum = h.first[alpha][beta][i][j] + both[alpha][beta] * a3a3;
              for (unsigned int I = 0; I < 3; ++I)
                sum -= g.christoffel[beta][I] * h.mixed[alpha][I][i][j] +
                       g.christoffel[alpha][I] * h.mixed[beta][I][j][i];
              H[d1 + alpha][i][d1 + beta][j] = sum;
            }
            for (unsigned int J = 0; J < 3; ++J)
            {
              const double mixed = h.mixed[alpha][J][i][j] - second[alpha][J] * a3a3;
              H[d1 + alpha][i][d11 + J][j] = mixed;
              H[d11 + J][j][d1 + alpha][i] = mixed;
            }
          }
          for (unsigned int I = 0; I < 3; ++I)
            for (unsigned int J = 0; J < 3; ++J)
              H[d11 + I][i][d11 + J][j] = h.second[I][J] * a3a3;
        }
    }
  } // namespace

  FundamentalForms fundamental_forms(const SurfaceJet &jet)
  {
    FundamentalForms f;
    f.normal = cross_product_3d(jet[d1], jet[d2]);
    f.normal /= f.normal.norm();
    f.a = {{jet[d1] * jet[d1], jet[d2] * jet[d2], jet[d1] * jet[d2]}};
    f.b = {{jet[d11] * f.normal, jet[d22] * f.normal, jet[d12] * f.normal}};
    return f;
  }

  double strain_response(const Section &section, const SurfaceJet &jet, const Symmetric &b0,
                         const std::array<double, 2> &fibre, const bool with_tangent,
                         PointResponse &response, const Resultants *const predicted)
  {
    const Geometry g = geometry(jet);
    SectionResponse s;
    section.evaluate({g.forms.a, g.forms.b, b0, fibre}, with_tangent, s);

    double m[3], gamma_m[2] = {0., 0.}; // moments counted twice in 12, and Gamma^gamma_I m_I
    for (unsigned int I = 0; I < 3; ++I)
    {
      m[I] = multiplicity[I] * s.m[I];
      gamma_m[0] += g.christoffel[0][I] * m[I];
      gamma_m[1] += g.christoffel[1][I] * m[I];
    }
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double a3 = g.forms.normal[i];
      response.gradient[value][i] = 0.;
      response.gradient[d1][i] = s.n[0] * jet[d1][i] + s.n[2] * jet[d2][i] + gamma_m[0] * a3;
      response.gradient[d2][i] = s.n[2] * jet[d1][i] + s.n[1] * jet[d2][i] + gamma_m[1] * a3;
      for (unsigned int I = 0; I < 3; ++I)
        response.gradient[d11 + I][i] = -m[I] * a3;
    }
    if (with_tangent)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int e = 0; e < n_derivatives; ++e)
          for (unsigned int j = 0; j < 3; ++j)
            response.hessian[value][i][e][j] = response.hessian[e][j][value][i] = 0.;
      if (predicted != nullptr)
      {
        s.n = predicted->n;
        s.m = predicted->m;
      }
      to_plain_derivatives(g, covariant_hessian(jet, g, s), response);
    }
    return s.energy;
  }

  Resultants predict_resultants(const Section &section, const SurfaceJet &jet,
                                const SurfaceJet &change, const Symmetric &b0,
                                const std::array<double, 2> &fibre)
  {
    const Geometry g = geometry(jet);
    SectionResponse s;
    section.evaluate({g.forms.a, g.forms.b, b0, fibre}, true, s);
    const Tensor<1, 3> &a3 = g.forms.normal;
    const double strain[3] = {jet[d1] * change[d1], jet[d2] * change[d2],
                              jet[d1] * change[d2] + jet[d2] * change[d1]};
    double curvature[3];
    for (unsigned int I = 0; I < 3; ++I)
      curvature[I] =
          -multiplicity[I] * (a3 * change[d11 + I] - g.christoffel[0][I] * (a3 * change[d1]) -
                              g.christoffel[1][I] * (a3 * change[d2]));
    Resultants resultants{s.n, s.m};
    for (unsigned int I = 0; I < 3; ++I)
      for (unsigned int J = 0; J < 3; ++J)
      {
        resultants.n[I] += s.membrane[3 * I + J] * strain[J] + s.coupling[3 * I + J] * curvature[J];
        resultants.m[I] += s.coupling[3 * J + I] * strain[J] + s.bending[3 * I + J] * curvature[J];
      }
    return resultants;
  }

  void add_pressure(const SurfaceJet &jet, const double pressure, const bool with_tangent,
                    PointResponse &response)
  {
    const Tensor<1, 3> area = cross_product_3d(jet[d1], jet[d2]);
    for (unsigned int i = 0; i < 3; ++i)
      response.gradient[value][i] += pressure * area[i];
    if (with_tangent)
      for (unsigned int j = 0; j < 3; ++j)
      {
        Tensor<1, 3> e;
        e[j] = pressure;
        const Tensor<1, 3> turn_1 = cross_product_3d(e, jet[d2]);
        const Tensor<1, 3> turn_2 = cross_product_3d(jet[d1], e);
        for (unsigned int i = 0; i < 3; ++i)
        {
          response.hessian[value][i][d1][j] += turn_1[i];
          response.hessian[value][i][d2][j] += turn_2[i];
        }
      }
  }
} // namespace semilunar::shell
