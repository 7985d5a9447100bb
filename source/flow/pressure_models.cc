// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/flow/pressure_models.h>

#include <utility>

namespace semilunar::flow
{
  using Relation = PressureModel::Relation;

  PrescribedPressure::PrescribedPressure(std::function<double(double)> pressure)
      : pressure(std::move(pressure))
  {
  }

  Relation PrescribedPressure::relation(const Bdf &, const double time) const
  {
    return {pressure(time), 0.};
  }

  Resistance::Resistance(const double pressure, const double resistance)
      : p0(pressure), R(resistance)
  {
  }

  Relation Resistance::relation(const Bdf &, const double) const
  {
    return {p0, R};
  }

  Windkessel::Windkessel(const Parameters &parameters)
      : prm(parameters), pressure(parameters.initial_pressure),
        older_pressure(parameters.initial_pressure)
  {
  }

  double Windkessel::new_pressure(const Bdf &bdf, const double flow_rate) const
  {
    const double history = bdf.alpha[1] * pressure + bdf.alpha[2] * older_pressure;
    return (flow_rate + prm.distal_pressure / prm.distal_resistance - prm.compliance * history) /
           (prm.compliance * bdf.alpha[0] + 1. / prm.distal_resistance);
  }

  Relation Windkessel::relation(const Bdf &bdf, const double) const
  {
    const double at_rest = new_pressure(bdf, 0.);
    return {at_rest, prm.proximal_resistance + new_pressure(bdf, 1.) - at_rest};
  }

  void Windkessel::accept(const Bdf &bdf, const double, const double flow_rate)
  {
    const double updated = new_pressure(bdf, flow_rate);
    older_pressure = pressure;
    pressure = updated;
  }

  void Windkessel::set_state(const std::vector<double> &state)
  {
    pressure = state.at(0);
    older_pressure = state.at(1);
  }

  PrescribedFlow::PrescribedFlow(std::function<double(double)> inflow, const double inertance)
      : inflow(std::move(inflow)), inertance(inertance)
  {
  }

  Relation PrescribedFlow::relation(const Bdf &bdf, const double time) const
  {
    const double resistance = inertance * bdf.alpha[0];
    return {lambda + resistance * inflow(time), resistance};
  }

  void PrescribedFlow::accept(const Bdf &bdf, const double time, const double flow_rate)
  {
    lambda += inertance * bdf.alpha[0] * (flow_rate + inflow(time));
  }
} // namespace semilunar::flow
