// SPDX-License-Identifier: LGPL-2.1-or-later
// Sums over a curved rational patch in a general state: forces and tangent against differences of
// energy and forces, balance of momentum, independence of the number of threads; the resultant of
// follower pressure against integrals over the edge.

#include <semilunar/shell/assembly.h>
#include <semilunar/shell/section_parameters.h>

#include <deal.II/base/multithread_info.h>
#include <deal.II/base/quadrature_lib.h>

#include "../tests.h"
#include "shell_cases.h"

using namespace semilunar;
using namespace semilunar::shell;
using namespace semilunar::spline;
using namespace semilunar::tests;

namespace
{
  /// Part of a cylinder, cubic around and quadratic along, its inner net and weights perturbed.
  Surface curved_patch()
  {
    Surface surface = refined(cylinder(1.2, 0.3, 1.5, 0., 1.4), {{3, 2}}, {{4, 3}});
    const Vectors noise = random_vectors(surface.control_points.size(), 0.03, 1);
    for (unsigned int c = 0; c < noise.size(); ++c)
    {
      surface.control_points[c].position += noise[c];
      surface.control_points[c].weight *= 1. + 5. * noise[(c + 1) % noise.size()][0];
    }
    return surface;
  }

  Assembly::FibreField fibres(const SectionParameters &parameters)
  {
    return [parameters](const Tensor<1, 3> &position, const std::array<Tensor<1, 3>, 2> &frame)
    { return fibre_direction(parameters, position, frame); };
  }

  /// A surface of a thick material, and everything that its Assembly refers to.
  struct Shell
  {
    Shell(const Surface &undeformed, const std::string &material, const unsigned int n_gauss = 0,
          const double prestress = 0.)
        : surface(undeformed), points(surface, n_gauss),
          parameters(make_parameters(material, prestress)), section(parameters.make_section()),
          assembly(surface, points, *section, fibres(parameters)), X(positions(surface))
    {
    }
    static SectionParameters make_parameters(const std::string &material, const double prestress)
    {
      SectionParameters p;
      p.material = material;
      p.n_thickness_points = 3;
      p.fibre.angle = 25.;
      p.prestress = prestress;
      return p;
    }
    Vectors forces(const Vectors &x, const double pressure) const
    {
      Vectors f(x.size());
      assembly.add(x, pressure, f, {});
      return f;
    }
    /// The tangent times a direction.
    Vectors tangent(const Vectors &x, const double pressure, const Vectors &direction) const
    {
      Vectors f(x.size()), result(x.size());
      assembly.add(x, pressure, f,
                   [&](const std::vector<unsigned int> &c, const double *block)
                   {
                     for (unsigned int k = 0; k < 3 * c.size(); ++k)
                       for (unsigned int l = 0; l < 3 * c.size(); ++l)
                         result[c[k / 3]][k % 3] +=
                             block[k * 3 * c.size() + l] * direction[c[l / 3]][l % 3];
                   });
      return result;
    }
    /// Stretched, bent, twisted, with some roughness.
    Vectors deformed(const double roughness = 0.004) const
    {
      Vectors x = sum(X, 1., random_vectors(X.size(), roughness, 2));
      for (auto &p : x)
        p += Tensor<1, 3>({0.04 * p[0] + 0.05 * p[1] * p[2], -0.03 * p[1] + 0.06 * p[2] * p[2],
                           0.05 * p[2] - 0.04 * p[0] * p[1]});
      return x;
    }

    const Surface surface;
    const QuadraturePoints points;
    const SectionParameters parameters;
    const std::unique_ptr<Section> section;
    const Assembly assembly;
    const Vectors X;
  };

  void check_derivatives(const std::string &material, const double pressure)
  {
    const Shell shell(curved_patch(), material);
    const Vectors x = shell.deformed(), direction = random_vectors(x.size(), 1., 3),
                  other = random_vectors(x.size(), 1., 4);
    const double step = 2e-5;
    double slope = 0.;
    Vectors change(x.size());
    for (const auto &[offset, weight] : central_differences)
    {
      const Vectors moved = sum(x, offset * step, direction);
      Vectors f(x.size());
      slope += weight / step * shell.assembly.add(moved, 0., f, {});
      change = sum(change, weight / step, shell.forces(moved, pressure));
    }
    const std::string name = material + (pressure == 0. ? "" : " under pressure");
    if (pressure == 0.)
    {
      check(name + ", forces", dot(shell.forces(x, 0.), direction) / slope - 1., 1e-8);
      check(name + ", asymmetry of the tangent",
            dot(other, shell.tangent(x, 0., direction)) /
                    dot(direction, shell.tangent(x, 0., other)) -
                1.,
            1e-11);
    }
    const Vectors Kd = shell.tangent(x, pressure, direction);
    check(name + ", tangent", norm(sum(Kd, -1., change)) / norm(change), 1e-8);
  }

  void check_momentum(const std::string &material)
  {
    const Shell shell(curved_patch(), material);
    const Vectors x = shell.deformed(), f = shell.forces(x, 0.);
    double size = 0.;
    for (const auto &force : f)
      size += force.norm();
    check(material + ", total internal force", total(f).norm() / size, 1e-13);
    check(material + ", total internal moment", moment(x, f).norm() / size, 1e-13);
    // relative to forces in a strained state
    check(material + ", forces of the undeformed shell", norm(shell.forces(shell.X, 0.)) / norm(f),
          1e-12);
  }

  struct Sums
  {
    double energy;
    Vectors forces;
    std::vector<double> blocks;
    bool operator==(const Sums &other) const
    {
      return energy == other.energy && forces == other.forces && blocks == other.blocks;
    }
  };

  Sums all_sums(const Shell &shell, const unsigned int n_threads)
  {
    dealii::MultithreadInfo::set_thread_limit(n_threads);
    Sums sums{0., Vectors(shell.X.size()), {}};
    sums.energy = shell.assembly.add(
        shell.deformed(), 1e5, sums.forces,
        [&](const std::vector<unsigned int> &c, const double *block)
        { sums.blocks.insert(sums.blocks.end(), block, block + 9 * c.size() * c.size()); });
    return sums;
  }

  void check_threads()
  {
    const Shell shell(refined(cylinder(1.2, 0.3, 1.5, 0., 1.4), {{3, 2}}, {{16, 10}}), "Fung");
    const Sums one = all_sums(shell, 1);
    bool equal = true;
    for (unsigned int repeat = 0; repeat < 5; ++repeat)
      equal = equal && all_sums(shell, 2) == one;
    check("the same sums with one and two threads", equal ? 0. : 1., 0.);
    dealii::MultithreadInfo::set_thread_limit();
  }

  /// At a quadrature point and at the same place of the surface.
  void check_section_strain()
  {
    const Shell shell(curved_patch(), "Lee-Sacks");
    const Vectors x = shell.deformed();
    double error = 0.;
    for (unsigned int q = 0; q < shell.points.n_points(); ++q)
    {
      const SectionStrain s = shell.assembly.section_strain(x, q),
                          t = shell.assembly.section_strain(
                              x, {shell.points.element(q), shell.points.xi(q)});
      for (unsigned int I = 0; I < 3; ++I)
        error += std::abs(s.a[I] - t.a[I]) + std::abs(s.b[I] - t.b[I]) +
                 std::abs(s.b0[I] - t.b0[I]) + (I < 2 ? std::abs(s.fibre[I] - t.fibre[I]) : 0.);
    }
    check("strains at quadrature points", error / shell.points.n_points(), 1e-11);

    // blown up by a factor; curvatures of the cylinder
    const Shell tube(refined(cylinder(2., 0., 1., 0., 1.), {{2, 2}}, {{2, 2}}), "neo-Hookean");
    const SectionStrain s =
        tube.assembly.section_strain(sum(tube.X, 0.2, tube.X), SurfacePoint{1, {0.3, 0.4}});
    check("a cylinder blown up by 1.2",
          std::abs(s.a[0] - 1.44) + std::abs(s.a[1] - 1.44) + std::abs(s.b0[0] + 0.5) +
              std::abs(s.b[0] + 0.6) + std::abs(s.b0[1]) + std::abs(s.b[2]),
          1e-13);
  }

  /// Integrals of dr and moments over the edge of a patch with moved control points.
  struct EdgeIntegrals
  {
    Tensor<1, 3> r_cross_dr, r_square_dr;
  };

  EdgeIntegrals around(Surface surface, const Vectors &x)
  {
    for (unsigned int c = 0; c < x.size(); ++c)
      surface.control_points[c].position = Point<3>(x[c]);
    const dealii::QGauss<1> gauss(12);
    EdgeIntegrals result;
    for (unsigned int side = 0; side < 4; ++side) // counterclockwise seen from the normal
    {
      const unsigned int along = side % 2 == 0 ? 0 : 1;
      const double sign = side < 2 ? 1. : -1., across = side == 1 || side == 2 ? 1. : 0.;
      for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        Point<2> xi;
        xi[along] = gauss.point(q)[0];
        xi[1 - along] = across;
        const SurfaceJet jet = evaluate(surface, {0, xi});
        const Tensor<1, 3> r = jet[value], dr = sign * gauss.weight(q) * jet[d1 + along];
        result.r_cross_dr += cross_product_3d(r, dr);
        result.r_square_dr += r * r * dr;
      }
    }
    return result;
  }

  /// int n dA = 1/2 int r x dr and int r x n dA = -1/2 int |r|^2 dr around the edge.
  void check_pressure_on_patch()
  {
    const double p = 3e3;
    const Shell shell(plate(1.5, 0.8, {{4, 3}}, {{1, 1}}), "neo-Hookean", 8);
    const Vectors x = shell.deformed(0.03);
    const Vectors f = sum(shell.forces(x, p), -1., shell.forces(x, 0.));
    const EdgeIntegrals edge = around(shell.surface, x);
    // forces are the internal ones minus those of the pressure, which acts against the normal
    check("resultant of pressure", (total(f) / p - 0.5 * edge.r_cross_dr).norm(), 1e-9);
    check("moment of pressure", (moment(x, f) / p + 0.5 * edge.r_square_dr).norm(), 1e-9);
  }

  /// Pressure on spheres, in the undeformed state, where the shell itself is without force.
  void check_pressure_on_spheres()
  {
    const double p = 3e3, R = 1.3, pi = dealii::numbers::PI;
    const auto resultant = [&](const NurbsPatch &patch)
    {
      const Shell shell(refined(patch, {{3, 3}}, {{4, 4}}), "neo-Hookean", 10);
      return total(shell.forces(shell.X, p)) / p;
    };
    const auto closed = resultant(sphere(R, 0., 2. * pi, -pi / 2., pi / 2.));
    check("pressure on a closed sphere", closed.norm(), 1e-10);
    const auto dome = resultant(sphere(R, 0., 2. * pi, 0., pi / 2.));
    check("pressure on a dome", (dome - Tensor<1, 3>({0., 0., pi * R * R})).norm(), 1e-9);
    const auto octant = resultant(sphere(R, 0., pi / 2., 0., pi / 2.));
    const double quarter = pi * R * R / 4.;
    check("pressure on an octant", (octant - Tensor<1, 3>({quarter, quarter, quarter})).norm(),
          1e-9);
  }

  /// A sphere under prestress N is in balance with the pressure 2 N / R inside, away from edges.
  void check_soap_bubble()
  {
    const double N = 200., R = 1.3, pi = dealii::numbers::PI;
    const Shell shell(refined(sphere(R, 0., 0.5 * pi, 0., 0.3 * pi), {{3, 3}}, {{4, 4}}),
                      "neo-Hookean", 10, N);
    std::vector<bool> at_edge(shell.X.size(), false);
    for (const NamedSet &set : shell.surface.sets)
      if (set.kind == SetKind::node)
        for (const unsigned int node : set.members)
          at_edge[node] = true;
    const auto largest = [&](const Vectors &forces)
    {
      double result = 0.;
      for (unsigned int i = 0; i < forces.size(); ++i)
        result = std::max(result, at_edge[i] ? 0. : forces[i].norm());
      return result;
    };
    check("soap bubble: forces in balance, relative",
          largest(shell.forces(shell.X, -2. * N / R)) / largest(shell.forces(shell.X, 0.)), 1e-9);
  }
} // namespace

int main()
{
  for (const std::string material : {"Saint Venant-Kirchhoff", "Mooney-Rivlin", "Lee-Sacks"})
  {
    check_derivatives(material, 0.);
    check_momentum(material);
  }
  check_derivatives("neo-Hookean", 2e5);
  check_derivatives("Fung", -2e5);
  check_section_strain();
  check_pressure_on_patch();
  check_pressure_on_spheres();
  check_soap_bubble();
  check_threads();
}
