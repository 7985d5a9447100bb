// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_pressure_models_h
#define semilunar_flow_pressure_models_h

#include <semilunar/flow/bdf.h>

#include <functional>
#include <vector>

namespace semilunar::flow
{
  /// The uniform pressure at an open boundary: what is connected there. Q is the flow rate out of
  /// the domain [cm^3/s] (in two dimensions [cm^2/s]).
  class PressureModel
  {
  public:
    /// p = pressure + resistance Q at the new time, both at the same time level: implicit in Q.
    struct Relation
    {
      double pressure = 0.;   ///< dyn/cm^2
      double resistance = 0.; ///< dyn s/cm^5
    };

    virtual ~PressureModel() = default;

    /// The relation at the end of the step that starts at the accepted state.
    virtual Relation relation(const Bdf &bdf, double time) const = 0;
    /// The step ended with this flow rate.
    virtual void accept(const Bdf &, double /*time*/, double /*flow_rate*/) {}

    /// What a restart needs.
    virtual std::vector<double> state() const { return {}; }
    virtual void set_state(const std::vector<double> &) {}
  };

  /// A given pressure [dyn/cm^2] over time [s].
  class PrescribedPressure : public PressureModel
  {
  public:
    explicit PrescribedPressure(std::function<double(double)> pressure);
    Relation relation(const Bdf &bdf, double time) const override;

  private:
    const std::function<double(double)> pressure;
  };

  /// p = p0 + R Q.
  class Resistance : public PressureModel
  {
  public:
    /// @param pressure p0 [dyn/cm^2] @param resistance R [dyn s/cm^5]
    Resistance(double pressure, double resistance);
    Relation relation(const Bdf &bdf, double time) const override;

  private:
    const double p0, R;
  };

  /// Proximal resistance, compliance and distal resistance (RCR), equation (13):
  /// p = Rp Q + pc, C dpc/dt + (pc - pd) / Rd = Q.
  class Windkessel : public PressureModel
  {
  public:
    struct Parameters
    {
      double proximal_resistance, compliance, distal_resistance; ///< dyn s/cm^5, cm^5/dyn
      double distal_pressure;                                    ///< pd [dyn/cm^2]
      double initial_pressure; ///< of the compliance, pc [dyn/cm^2]
    };
    explicit Windkessel(const Parameters &parameters);
    Relation relation(const Bdf &bdf, double time) const override;
    void accept(const Bdf &bdf, double time, double flow_rate) override;
    std::vector<double> state() const override { return {pressure, older_pressure}; }
    void set_state(const std::vector<double> &state) override;

    /// Of the compliance, at the last accepted time.
    double compliance_pressure() const { return pressure; }

  private:
    double new_pressure(const Bdf &bdf, double flow_rate) const;

    const Parameters prm;
    double pressure, older_pressure;
  };

  /// The uniform pressure that drives a given flow rate into the domain, by an augmented
  /// Lagrangian, equation (11): p = lambda + I alpha_0 (Q + inflow); after each step lambda becomes
  /// p. Exact for constant inflow after a few steps; the error of a changing one is proportional to
  /// the square of the time step and inversely proportional to I.
  class PrescribedFlow : public PressureModel
  {
  public:
    /// @param inflow    rate into the domain [cm^3/s] over time [s]
    /// @param inertance I [g/cm^4]; large against rho L / A of the domain
    PrescribedFlow(std::function<double(double)> inflow, double inertance);
    Relation relation(const Bdf &bdf, double time) const override;
    void accept(const Bdf &bdf, double time, double flow_rate) override;
    std::vector<double> state() const override { return {lambda}; }
    void set_state(const std::vector<double> &state) override { lambda = state.at(0); }

  private:
    const std::function<double(double)> inflow;
    const double inertance;
    double lambda = 0.;
  };
} // namespace semilunar::flow

#endif
