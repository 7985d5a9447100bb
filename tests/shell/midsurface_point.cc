// SPDX-License-Identifier: LGPL-2.1-or-later
// The strain energy at a point of the midsurface: fundamental forms against the geometry of the
// shell's layers; gradient and Hessian against differences, for every material in a general state;
// invariance under rigid motions; units; follower pressure.

#include <semilunar/shell/midsurface_point.h>
#include <semilunar/shell/section_parameters.h>

#include "../tests.h"
#include "shell_cases.h"

using namespace semilunar;
using namespace semilunar::shell;
using namespace semilunar::spline;
using namespace semilunar::tests;

namespace
{
  using Gradient = std::array<double, 18>; // derivative d, component i: 3 d + i
  using Hessian = std::array<Gradient, 18>;

  Tensor<1, 3> vector(const double x, const double y, const double z)
  {
    return Tensor<1, 3>({x, y, z});
  }

  /// Stretches from 0.95 to 1.1, shear, curvatures around 1, accelerations within the surface too.
  SurfaceJet general_jet()
  {
    SurfaceJet jet;
    jet[value] = vector(0.7, -1.2, 0.4);
    jet[d1] = vector(1.02, 0.21, -0.13);
    jet[d2] = vector(-0.12, 0.91, 0.3);
    jet[d11] = vector(0.6, -0.4, 1.1);
    jet[d22] = vector(-0.3, 0.5, -0.9);
    jet[d12] = vector(0.2, 0.3, 0.7);
    return jet;
  }
  const Symmetric b0{{0.5, -0.8, 0.35}};
  const std::array<double, 2> fibre{{0.6, 0.8}};

  SectionParameters parameters(const std::string &material)
  {
    SectionParameters p;
    p.material = material;
    p.n_thickness_points = 3;
    p.lee_sacks.c3 = 40.;
    return p;
  }

  struct Response
  {
    double energy;
    Gradient gradient;
    Hessian hessian;
  };

  Response respond(const Section &section, const SurfaceJet &jet, const bool with_tangent = true)
  {
    PointResponse point;
    Response r;
    r.energy = strain_response(section, jet, b0, fibre, with_tangent, point);
    for (unsigned int k = 0; k < 18; ++k)
    {
      r.gradient[k] = point.gradient[k / 3][k % 3];
      for (unsigned int l = 0; l < 18; ++l)
        r.hessian[k][l] = point.hessian[k / 3][k % 3][l / 3][l % 3];
    }
    return r;
  }

  /// 0 for the value, 1 for the first derivatives, 2 for the second ones.
  unsigned int order(const unsigned int k)
  {
    return k < 3 ? 0 : k < 9 ? 1 : 2;
  }

  double gradient_error(const Gradient &x, const Gradient &reference)
  {
    double worst = 0.;
    for (unsigned int block = 1; block <= 2; ++block)
    {
      double error = 0., size = 0.;
      for (unsigned int k = 0; k < 18; ++k)
        if (order(k) == block)
        {
          error += std::pow(x[k] - reference[k], 2);
          size += std::pow(reference[k], 2);
        }
      worst += std::sqrt(error / size);
    }
    return worst;
  }

  /// Sum over the blocks (first and second derivatives) of the relative errors: the blocks differ
  /// by powers of the thickness.
  double hessian_error(const Hessian &x, const Hessian &reference)
  {
    double error[3][3] = {}, size[3][3] = {}, worst = 0.;
    for (unsigned int k = 0; k < 18; ++k)
      for (unsigned int l = 0; l < 18; ++l)
      {
        error[order(k)][order(l)] += std::pow(x[k][l] - reference[k][l], 2);
        size[order(k)][order(l)] += std::pow(reference[k][l], 2);
      }
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        worst += i * j > 0 ? std::sqrt(error[i][j] / size[i][j]) : std::sqrt(error[i][j]);
    return worst;
  }

  void check_derivatives(const std::string &material)
  {
    const auto section = parameters(material).make_section();
    const Response r = respond(*section, general_jet());
    Gradient gradient{};
    Hessian hessian{};
    for (unsigned int k = 0; k < 18; ++k)
    {
      const double step = order(k) == 2 ? 5e-4 / section->thickness() : 5e-4;
      for (const auto &[offset, weight] : central_differences)
      {
        SurfaceJet jet = general_jet();
        jet[k / 3][k % 3] += offset * step;
        const Response moved = respond(*section, jet, false);
        gradient[k] += weight / step * moved.energy;
        for (unsigned int l = 0; l < 18; ++l)
          hessian[l][k] += weight / step * moved.gradient[l];
      }
    }
    check(material + ", gradient", gradient_error(r.gradient, gradient), 1e-8);
    check(material + ", Hessian", hessian_error(r.hessian, hessian), 1e-8);
    Hessian transposed;
    for (unsigned int k = 0; k < 18; ++k)
      for (unsigned int l = 0; l < 18; ++l)
        transposed[k][l] = r.hessian[l][k];
    check(material + ", asymmetry of the Hessian", hessian_error(r.hessian, transposed), 1e-13);
  }

  Tensor<2, 3> rotation()
  {
    // about (2, -1, 2)/3 by 1.1 rad (Rodrigues)
    const double axis[3] = {2. / 3., -1. / 3., 2. / 3.}, c = std::cos(1.1), s = std::sin(1.1);
    Tensor<2, 3> Q;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        Q[i][j] = (1. - c) * axis[i] * axis[j] + (i == j ? c : 0.);
    for (unsigned int i = 0; i < 3; ++i)
    {
      const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
      Q[k][j] += s * axis[i];
      Q[j][k] -= s * axis[i];
    }
    return Q;
  }

  /// A turned and moved shell has the same energy and turned forces and stiffness; its forces do no
  /// work in a rotation, and turn when the shell does.
  void check_rigid_motions(const std::string &material)
  {
    const auto section = parameters(material).make_section();
    const Response r = respond(*section, general_jet());
    const Tensor<2, 3> Q = rotation();
    SurfaceJet turned = general_jet();
    for (auto &derivative : turned)
      derivative = Q * derivative;
    turned[value] += vector(3., 2., 1.);
    const Response t = respond(*section, turned);

    Gradient gradient{};
    Hessian hessian{};
    for (unsigned int k = 0; k < 18; ++k)
      for (unsigned int i = 0; i < 3; ++i)
      {
        gradient[k] += Q[k % 3][i] * r.gradient[k / 3 * 3 + i];
        for (unsigned int l = 0; l < 18; ++l)
          for (unsigned int j = 0; j < 3; ++j)
            hessian[k][l] += Q[k % 3][i] * Q[l % 3][j] * r.hessian[k / 3 * 3 + i][l / 3 * 3 + j];
      }
    check(material + ", turned",
          std::abs(t.energy / r.energy - 1.) + gradient_error(t.gradient, gradient) +
              hessian_error(t.hessian, hessian),
          1e-11);

    const Tensor<1, 3> spin = vector(0.3, -0.7, 0.5);
    Gradient change{}, expected{};
    double work = 0., size = 0.;
    for (unsigned int l = 0; l < 18; ++l)
    {
      const double velocity = cross_product_3d(spin, general_jet()[l / 3])[l % 3];
      work += r.gradient[l] * velocity;
      size += std::abs(r.gradient[l] * velocity);
      for (unsigned int k = 0; k < 18; ++k)
        change[k] += r.hessian[k][l] * velocity;
      const double *force = &r.gradient[l / 3 * 3];
      expected[l] = cross_product_3d(spin, vector(force[0], force[1], force[2]))[l % 3];
    }
    check(material + ", work in a rotation", work / size, 1e-12);
    check(material + ", forces turn with the shell", gradient_error(change, expected), 1e-9);
  }

  /// The same shell in mm and N.
  void check_units()
  {
    const double length = 10., force = 1e-5, stress = force / (length * length);
    SectionParameters p = parameters("Fung");
    const Response r = respond(*p.make_section(), general_jet());
    p.thickness *= length;
    p.fung.c0 *= stress;
    p.fung.c1 *= stress;
    SurfaceJet jet = general_jet();
    jet[value] *= length;
    for (unsigned int I = 0; I < 3; ++I)
      jet[d11 + I] /= length;
    PointResponse s;
    const Symmetric b0_mm{{b0[0] / length, b0[1] / length, b0[2] / length}};
    const double energy = strain_response(*p.make_section(), jet, b0_mm, fibre, true, s);
    check("energy per area in N/mm", energy / (force / length * r.energy) - 1., 1e-12);
    check("membrane force in N/mm", s.gradient[d1][0] / (force / length * r.gradient[3 * d1]) - 1.,
          1e-12);
    check("moment in N", s.gradient[d12][1] / (force * r.gradient[3 * d12 + 1]) - 1., 1e-12);
    check("bending stiffness in N mm",
          s.hessian[d11][2][d22][2] / (force * length * r.hessian[3 * d11 + 2][3 * d22 + 2]) - 1.,
          1e-10);
  }

  /// Layers at distance xi from the surface r = s_1 r_,1 + s_2 r_,2 + ...: their metric begins with
  /// a - 2 xi b.
  void check_fundamental_forms()
  {
    const SurfaceJet jet = general_jet();
    const auto tangents = [&](const double s1, const double s2)
    {
      return std::array<Tensor<1, 3>, 2>{
          {jet[d1] + s1 * jet[d11] + s2 * jet[d12], jet[d2] + s1 * jet[d12] + s2 * jet[d22]}};
    };
    const auto normal = [&](const double s1, const double s2)
    {
      const auto a = tangents(s1, s2);
      const Tensor<1, 3> n =
          vector(a[0][1] * a[1][2] - a[0][2] * a[1][1], a[0][2] * a[1][0] - a[0][0] * a[1][2],
                 a[0][0] * a[1][1] - a[0][1] * a[1][0]);
      return n / std::sqrt(n * n);
    };
    const FundamentalForms forms = fundamental_forms(jet);
    double error_a = 0., error_b = (forms.normal - normal(0., 0.)).norm();
    const double step = 1e-3;
    for (unsigned int I = 0; I < 3; ++I)
    {
      const unsigned int alpha = I == 1 ? 1 : 0, beta = I == 0 ? 0 : 1;
      Tensor<1, 3> slope[2]; // of the normal
      for (const auto &[offset, weight] : central_differences)
      {
        slope[0] += weight / step * normal(offset * step, 0.);
        slope[1] += weight / step * normal(0., offset * step);
      }
      const double metric_slope = jet[d1 + alpha] * slope[beta] + jet[d1 + beta] * slope[alpha];
      error_a += std::abs(forms.a[I] - jet[d1 + alpha] * jet[d1 + beta]);
      error_b += std::abs(forms.b[I] + 0.5 * metric_slope);
    }
    check("first fundamental form", error_a, 1e-14);
    check("second fundamental form and normal", error_b, 1e-10);

    // normals of a sphere that point outwards: b = -a / R
    const double R = 2.5, z = 0.6, theta = 0.4, rho = std::sqrt(R * R - z * z);
    SurfaceJet sphere; // coordinates theta, z
    const double c = std::cos(theta), s = std::sin(theta), slope = -z / rho;
    sphere[d1] = vector(-rho * s, rho * c, 0.);
    sphere[d2] = vector(slope * c, slope * s, 1.);
    sphere[d11] = vector(-rho * c, -rho * s, 0.);
    sphere[d22] = -R * R / (rho * rho * rho) * vector(c, s, 0.);
    sphere[d12] = slope * vector(-s, c, 0.);
    const FundamentalForms on_sphere = fundamental_forms(sphere);
    double error = 0.;
    for (unsigned int I = 0; I < 3; ++I)
      error += std::abs(on_sphere.b[I] + on_sphere.a[I] / R);
    check("sphere", error, 1e-14);
  }

  /// Adds p r_,1 x r_,2 to the force, and its derivative.
  void check_pressure()
  {
    const SurfaceJet jet = general_jet();
    const auto section = parameters("Fung").make_section();
    const double p = 1.7e5;
    PointResponse before, after;
    strain_response(*section, jet, b0, fibre, true, before);
    after = before;
    add_pressure(jet, p, true, after);
    double error = 0., size = 0., elsewhere = 0.;
    for (unsigned int d = 0; d < n_derivatives; ++d)
      for (unsigned int i = 0; i < 3; ++i)
      {
        const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
        const double added = after.gradient[d][i] - before.gradient[d][i];
        if (d == value)
          error += std::abs(added - p * (jet[d1][j] * jet[d2][k] - jet[d1][k] * jet[d2][j]));
        else
          elsewhere += std::abs(added);
      }
    check("pressure, force", error / p, 1e-14);

    error = 0.;
    for (unsigned int l = 0; l < 18; ++l)
    {
      // exact: the force is bilinear
      PointResponse plus, minus;
      SurfaceJet moved = jet;
      moved[l / 3][l % 3] += 0.5;
      add_pressure(moved, p, false, plus);
      moved[l / 3][l % 3] -= 1.;
      add_pressure(moved, p, false, minus);
      for (unsigned int k = 0; k < 18; ++k)
      {
        const double added =
            after.hessian[k / 3][k % 3][l / 3][l % 3] - before.hessian[k / 3][k % 3][l / 3][l % 3];
        const double expected = plus.gradient[k / 3][k % 3] - minus.gradient[k / 3][k % 3];
        error += std::abs(added - expected);
        size += std::abs(expected);
        elsewhere += k < 3 ? 0. : std::abs(added);
      }
    }
    check("pressure, tangent", error / size, 1e-12);
    check("pressure, elsewhere", elsewhere, 0.);
  }
} // namespace

int main()
{
  check_fundamental_forms();
  for (const std::string material :
       {"Saint Venant-Kirchhoff", "neo-Hookean", "Mooney-Rivlin", "Fung", "Lee-Sacks"})
  {
    check_derivatives(material);
    check_rigid_motions(material);
  }
  check_units();
  check_pressure();
}
