// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The energy-momentum method (spectral radius 1): at a point, work against change of energy; and
// energy and momenta of a shell that flies, turns and flaps freely in long steps.

#include <semilunar/shell/midsurface_step.h>

#include "../tests.h"
#include "dynamic_cases.h"

using namespace semilunar;
using namespace semilunar::tests;
using spline::n_derivatives;
using spline::SurfaceJet;

namespace
{
  const std::array<double, 2> fibre{{0.8, 0.6}};
  const Symmetric b0{{0.3, -0.2, 0.1}};

  SurfaceJet moved(const SurfaceJet &jet, const double size, const Vectors &noise)
  {
    SurfaceJet result = jet;
    for (unsigned int d = 0; d < n_derivatives; ++d)
      result[d] += size * noise[d];
    return result;
  }

  double energy(const Section &section, const SurfaceJet &jet)
  {
    const FundamentalForms forms = fundamental_forms(jet);
    SectionResponse response;
    section.evaluate({forms.a, forms.b, b0, fibre}, false, response);
    return response.energy;
  }

  void point(const std::string &material)
  {
    SectionParameters parameters;
    parameters.material = material;
    const auto section = parameters.make_section();
    SurfaceJet flat{};
    flat[spline::d1] = Tensor<1, 3>({1., 0., 0.});
    flat[spline::d2] = Tensor<1, 3>({0., 1., 0.});
    const Vectors noise = random_vectors(12, 1., 3), more(noise.begin() + 6, noise.end());
    const SurfaceJet from = moved(flat, 0.08, noise);
    double last_error = 0.;
    for (const double size : {0.1, 0.002, 0.001})
    {
      const SurfaceJet to = moved(from, size, more);
      double force[n_derivatives][3], work = 0., scale = 0.;
      conserving_gradient(*section, from, to, b0, fibre, force);
      Tensor<1, 3> moment;
      for (unsigned int d = 0; d < n_derivatives; ++d)
      {
        const Tensor<1, 3> f({force[d][0], force[d][1], force[d][2]});
        work += f * (to[d] - from[d]);
        moment += cross_product_3d(from[d] + to[d], f);
        scale += f.norm();
      }
      const double change = energy(*section, to) - energy(*section, from);
      check(material + ": work against change of energy", work / change - 1., 1e-10);
      check(material + ": moment", moment.norm() / scale, 1e-14);

      const SurfaceJet middle = moved(from, 0.5 * size, more);
      PointResponse response;
      strain_response(*section, middle, b0, fibre, false, response);
      double error = 0.;
      for (unsigned int d = 0; d < n_derivatives; ++d)
        for (unsigned int i = 0; i < 3; ++i)
          error = std::max(error, std::abs(force[d][i] - response.gradient[d][i]));
      if (size < 0.002) // against twice the distance
        check(material + ": second order, off by", std::log2(last_error / error) - 2., 0.05);
      last_error = error;
    }
  }

  /// A square that turns and flaps by its own size.
  void flight(const std::string &material, const double dt, const unsigned int n_steps)
  {
    SectionParameters section = section_of(1e3, 0.3, 0.05);
    section.material = material;
    section.fung.c0 = 300.;
    section.fung.c1 = 100.;
    TimeIntegratorParameters time;
    time.step = dt;
    time.end_time = 100.;
    time.spectral_radius = 1.;
    time.tolerance = 1e-11;
    time.max_iterations = 60;
    MovingShell shell(plate(1., 1., {{3, 3}}, {{3, 3}}), section, {""}, time);
    shell.start([](const auto &) { return Tensor<1, 3>(); },
                [&](const auto &x)
                {
                  const double flap = 3. * std::cos(M_PI * x[0]) * std::cos(2. * M_PI * x[1]);
                  return Tensor<1, 3>({0.5, -0.2, 1. + flap}) +
                         cross_product_3d(Tensor<1, 3>({1., 2., 4.}), x);
                });
    const TimeIntegrator &integrator = shell.integrator;
    const double kinetic = shell.integrator.energy_balance().kinetic;
    const auto p = integrator.momentum(), l = integrator.angular_momentum();
    double drift = 0., momentum = 0., spin = 0., strain = 0., open = 0.;
    for (unsigned int i = 0; i < n_steps; ++i)
    {
      shell.integrator.advance(100., [] { return false; });
      const EnergyBalance balance = shell.integrator.energy_balance();
      drift = std::max(drift, std::abs((balance.kinetic + balance.strain) / kinetic - 1.));
      open = std::max(open, std::abs(balance.error + balance.numerical) / kinetic);
      strain = std::max(strain, balance.strain / kinetic);
      momentum = std::max(momentum, (integrator.momentum() - p).norm() / p.norm());
      spin = std::max(spin, (integrator.angular_momentum() - l).norm() / l.norm());
    }
    log() << material << ", steps of " << dt << ": strain energy up to " << std::setprecision(2)
          << strain << std::setprecision(8) << " of all" << std::endl;
    check("drift of the energy", drift, 1e-9);
    check("of the balance", open, 1e-9);
    check("of the momentum", momentum, 1e-12);
    check("of the angular momentum", spin, 1e-11);
  }
} // namespace

int main()
{
  for (const std::string material : {"Saint Venant-Kirchhoff", "Fung", "Lee-Sacks"})
    point(material);
  flight("Saint Venant-Kirchhoff", 3e-3, 150);
  flight("Saint Venant-Kirchhoff", 3e-2, 100);
  flight("Fung", 1e-2, 100);
}
