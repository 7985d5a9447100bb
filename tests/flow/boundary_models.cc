// SPDX-License-Identifier: LGPL-2.1-or-later
// Channels with pressures, resistances and a Windkessel against Poiseuille's law and the ordinary
// differential equations of plug flow.
#include "flow_tests.h"

using namespace semilunar;
using namespace semilunar::tests;

namespace
{
  constexpr double length = 4., height = 1.; // cm
  const std::string laplacian = "Laplacian"; // its traction -p n + mu du/dn suits parallel flow

  /// A channel along x; boundary 0: inlet, 1: outlet, 2 and 3: sides.
  class Channel
  {
  public:
    Channel(const bool slip, const double viscosity, std::shared_ptr<PressureModel> inlet,
            std::shared_ptr<PressureModel> outlet)
        : mesh(MPI_COMM_WORLD)
    {
      dealii::GridGenerator::subdivided_hyper_rectangle(mesh, {8, 2}, Point<2>(),
                                                        Point<2>(length, height), true);
      prm.viscosity = viscosity;
      prm.viscous_form = laplacian;
      prm.linear_tolerance = 1e-11;
      for (unsigned int id : {2, 3})
        slip ? bc.set_slip(id) : bc.set_wall(id);
      bc.set_open(0, std::move(inlet), 0.); // no backflow term: exact solutions have none
      bc.set_open(1, std::move(outlet), 0.);
      solver = std::make_unique<FlowSolver<2>>(prm, mesh, dealii::MappingQ<2>(2), bc, timers);
      solver->initialise(0.);
    }

    Mesh<2> mesh;
    flow::Parameters prm;
    BoundaryConditions<2> bc;
    Timers timers;
    std::unique_ptr<FlowSolver<2>> solver;
  };

  std::shared_ptr<PressureModel> constant(const double pressure)
  {
    return std::make_shared<PrescribedPressure>([=](double) { return pressure; });
  }

  void poiseuille()
  {
    const double mu = 0.5, p_in = 20., p0 = 8., R = 3.;
    Channel channel(false, mu, constant(p_in), std::make_shared<Resistance>(p0, R));
    StepReport report;
    for (unsigned int step = 0; step < 12; ++step)
      report = channel.solver->advance(step < 4 ? 0.5 : 5.);
    const double expected = (p_in - p0) / (R + 12. * mu * length / std::pow(height, 3));
    const double shear = 6. * mu * expected / (height * height);
    const auto force = channel.solver->force(2);
    const double imbalance = report.flow_rate.at(0) + report.flow_rate.at(1);
    if (!first_rank())
      return;
    log() << "Poiseuille flow with a resistance" << std::endl;
    check("  flow rate", report.flow_rate.at(1) / expected - 1., 1e-8);
    check("  inlet minus outlet flow", imbalance / expected, 1e-8);
    check("  pressure at the outlet", report.mean_pressure.at(1) / (p0 + R * expected) - 1., 1e-8);
    check("  wall force over shear stress times area", -force[0] / (shear * length) - 1., 1e-8);
  }

  /// Relative error of the flow rate at t = 1 tau of a step in pressure with time step dt.
  double plug_flow(const double dt_over_tau, const double end_over_tau)
  {
    const double R = 5., dp = 10., tau = length / (R * height);
    // Plug flow feels no viscosity; it makes the linear systems of large steps easy.
    Channel channel(true, 1., constant(dp), std::make_shared<Resistance>(0., R));
    const unsigned int n = std::lround(end_over_tau / dt_over_tau);
    double rate = 0.;
    for (unsigned int step = 0; step < n; ++step)
      rate = channel.solver->advance(dt_over_tau * tau).flow_rate.at(1);
    return rate / (dp / R * (1. - std::exp(-end_over_tau))) - 1.;
  }

  void resistance()
  {
    const double coarse = plug_flow(0.05, 1.), fine = plug_flow(0.025, 1.),
                 large = plug_flow(4., 100.);
    if (!first_rank())
      return;
    log() << "plug flow into a resistance" << std::endl;
    check("  order in time below 2 by", std::max(0., 2. - std::log2(coarse / fine)), 0.2);
    check("  steady state with steps of 4 tau", large, 1e-8);
  }

  /// Flow rate of L dQ/dt = p_in - Rp Q - pc, C dpc/dt = Q - (pc - pd) / Rd, by Runge-Kutta.
  double windkessel_reference(const Windkessel::Parameters &w, const double p_in, const double end)
  {
    const double inertance = length / height;
    const auto rate = [&](const double(&y)[2], double(&f)[2])
    {
      f[0] = (p_in - w.proximal_resistance * y[0] - y[1]) / inertance;
      f[1] = (y[0] - (y[1] - w.distal_pressure) / w.distal_resistance) / w.compliance;
    };
    double y[2] = {0., w.initial_pressure};
    const unsigned int n = 4000;
    const double h = end / n;
    for (unsigned int step = 0; step < n; ++step)
    {
      double k[4][2], at[2];
      rate(y, k[0]);
      for (unsigned int stage = 1; stage < 4; ++stage)
      {
        for (unsigned int i = 0; i < 2; ++i)
          at[i] = y[i] + (stage == 3 ? h : 0.5 * h) * k[stage - 1][i];
        rate(at, k[stage]);
      }
      for (unsigned int i = 0; i < 2; ++i)
        y[i] += h / 6. * (k[0][i] + 2. * k[1][i] + 2. * k[2][i] + k[3][i]);
    }
    return y[0];
  }

  void windkessel()
  {
    const Windkessel::Parameters w{2., 0.3, 6., 1., 2.};
    const double p_in = 10., end = 2.;
    double errors[2];
    for (unsigned int i = 0; i < 2; ++i)
    {
      Channel channel(true, 0.03, constant(p_in), std::make_shared<Windkessel>(w));
      const unsigned int n = 120 << i;
      double rate = 0.;
      for (unsigned int step = 0; step < n; ++step)
        rate = channel.solver->advance(end / n).flow_rate.at(1);
      errors[i] = rate / windkessel_reference(w, p_in, end) - 1.;
    }
    if (!first_rank())
      return;
    log() << "plug flow into a Windkessel" << std::endl;
    check("  flow rate", errors[1], 1e-3);
    check("  order in time below 2 by", std::max(0., 2. - std::log2(errors[0] / errors[1])), 0.2);
  }

  /// Largest relative error of a pulsating inflow after the first period, with an inertance of
  /// ten rho L / A.
  double pulsating_flow(const double dt)
  {
    const auto inflow = [](const double t) { return 1.5 + std::sin(2. * dealii::numbers::PI * t); };
    Channel channel(true, 0.5, std::make_shared<PrescribedFlow>(inflow, 10. * length / height),
                    constant(0.));
    double largest = 0.;
    while (channel.solver->time() < 2. - 0.5 * dt)
    {
      const StepReport report = channel.solver->advance(dt);
      if (report.time > 1.)
        largest = std::max(largest, std::abs(report.flow_rate.at(0) + inflow(report.time)) / 2.5);
    }
    return largest;
  }

  void prescribed_flow()
  {
    Channel channel(false, 0.5, std::make_shared<PrescribedFlow>([](double) { return 1.5; }, 40.),
                    constant(0.));
    StepReport report;
    for (unsigned int step = 0; step < 20; ++step)
      report = channel.solver->advance(0.1);
    const double coarse = pulsating_flow(0.02), fine = pulsating_flow(0.01);
    if (!first_rank())
      return;
    log() << "prescribed flow rate" << std::endl;
    check("  inflow", -report.flow_rate.at(0) / 1.5 - 1., 1e-6);
    check("  outflow", report.flow_rate.at(1) / 1.5 - 1., 1e-6);
    check("  pulsating inflow, relative", fine, 2e-3);
    check("  order in time below 2 by", std::max(0., 2. - std::log2(coarse / fine)), 0.1);
  }

  /// Inflow and outflow balance however loose the tolerance is, from the first step on, which
  /// starts with a velocity that flows into the channel only.
  void balance()
  {
    const auto pulse = [](const double t) { return 40. * std::cos(5. * t); };
    Channel channel(false, 0.05, std::make_shared<PrescribedPressure>(pulse),
                    std::make_shared<Windkessel>(Windkessel::Parameters{2., 0.3, 6., 1., 2.}));
    channel.prm.linear_tolerance = 0.05;
    FlowSolver<2> solver(channel.prm, channel.mesh, dealii::MappingQ<2>(2), channel.bc,
                         channel.timers);
    solver.initialise(0.,
                      [](const Point<2> &x, double) {
                        return Tensor<1, 2>({x[1] * (height - x[1]) * (length - x[0]), 0.});
                      });
    double imbalance = 0., largest = 0.;
    for (unsigned int step = 0; step < 20; ++step)
    {
      const StepReport report = solver.advance(step % 5 == 4 ? 0.1 : 0.02);
      largest = std::max(largest, std::abs(report.flow_rate.at(0)));
      imbalance = std::max(imbalance, std::abs(report.flow_rate.at(0) + report.flow_rate.at(1)));
    }
    if (!first_rank())
      return;
    log() << "balance of flow with a linear tolerance of 0.05" << std::endl;
    check("  inlet minus outlet flow, relative", imbalance / largest, 1e-11);
  }

  /// With the skew form and beta = 1/2 nothing feeds energy in through an open boundary at
  /// pressure 0: vortices that leave and enter there lose energy in each step.
  void backflow()
  {
    Mesh<2> mesh(MPI_COMM_WORLD);
    dealii::GridGenerator::hyper_cube(mesh, 0., 1., true);
    mesh.refine_global(3);
    flow::Parameters prm;
    prm.viscosity = 1e-4;
    prm.time_scheme = "BDF1";
    prm.linear_tolerance = 1e-8;
    BoundaryConditions<2> bc;
    for (const unsigned int id : {0, 2, 3})
      bc.set_wall(id);
    bc.set_open(1, constant(0.));
    Timers timers;
    FlowSolver<2> solver(prm, mesh, dealii::MappingQ<2>(2), bc, timers);
    const double pi = dealii::numbers::PI;
    solver.initialise(0.,
                      [pi](const Point<2> &x, double)
                      {
                        const double a = 1.5 * pi * x[0], b = 2. * pi * x[1];
                        return 10. *
                               Tensor<1, 2>(
                                   {2. * pi * std::sin(a) * std::sin(a) * std::sin(b) * std::cos(b),
                                    -1.5 * pi * std::sin(2. * a) * std::sin(b) * std::sin(b)});
                      });
    const auto zero = [](const Point<2> &, double) { return Tensor<1, 2>(); };
    const auto zero_pressure = [](const Point<2> &, double) { return 0.; };
    const auto speed = [&]() { return errors_of<2>(solver, zero, zero_pressure, false).velocity; };
    double before = speed(), first = before, growth = 0.;
    bool entered = false;
    for (unsigned int step = 0; step < 40; ++step)
    {
      solver.advance(step % 4 == 3 ? 0.01 : 0.003);
      const double now = speed();
      growth = std::max(growth, now - before);
      entered = entered || now < 0.99 * before;
      before = now;
    }
    if (!first_rank())
      return;
    log() << "backflow" << std::endl;
    check("  largest growth of the energy's root in a step", growth / first, 1e-8);
    check("  what is left is less than the start", std::max(0., before / first - 0.9), 0.);
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  poiseuille();
  resistance();
  windkessel();
  prescribed_flow();
  balance();
  backflow();
}
