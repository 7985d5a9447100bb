// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/archive.h>
#include <semilunar/core/exceptions.h>
#include <semilunar/core/interrupt.h>
#include <semilunar/scene/dynamic_analysis.h>
#include <semilunar/scene/probes.h>
#include <semilunar/scene/shell_output.h>
#include <semilunar/scene/surface_report.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace semilunar::scene
{
  namespace
  {
    using Columns = std::vector<output::TimeSeries::Column>;
    const char *const velocity_entry = "Initial/Velocity";

    /// The first multiple of an interval after a time; infinity if there is none.
    double next_multiple(const double time, const double interval)
    {
      constexpr double rounding = 1e-9;
      return interval > 0. ? interval * (std::floor(time / interval + rounding) + 1.)
                           : std::numeric_limits<double>::infinity();
    }

    bool is_multiple(const double time, const double interval)
    {
      constexpr double rounding = 1e-9;
      return interval > 0. && std::abs(std::remainder(time, interval)) <= rounding * interval;
    }

    /// Project a velocity given by expressions in x, y, z to the equations.
    shell::NonlinearSystem::Vector project_velocity(const std::string &expressions,
                                                    const ShellModel &model,
                                                    const shell::Mass &mass)
    {
      dealii::FunctionParser<3> function(3);
      try
      {
        function.initialize("x,y,z", expressions, {{"pi", M_PI}});
        function.value(dealii::Point<3>());
      }
      catch (const dealii::ExceptionBase &)
      {
        throw InputError(velocity_entry, expressions, "this is not a velocity",
                         "write three expressions in x, y, z, separated by semicolons");
      }
      const auto velocity = [&](const unsigned int q)
      {
        const auto position = spline::evaluate(
            model.surface, {model.points.element(q), model.points.xi(q)})[spline::value];
        dealii::Vector<double> value(3);
        function.vector_value(dealii::Point<3>(position), value);
        return spline::Tensor<1, 3>({value[0], value[1], value[2]});
      };
      shell::NonlinearSystem::Vector right_hand_side, result;
      model.equations.restrict(mass.load(velocity), right_hand_side);
      mass.solve(model.equations, right_hand_side, result);
      return result;
    }

    /// A run: what lives as long as it.
    class Run
    {
    public:
      Run(const DynamicAnalysis &analysis, ShellModel &model, const TimeTable &load_factor,
          RunContext &context, MotionObserver &observer, const Probes &probes)
          : analysis(analysis), model(model), load_factor(load_factor), context(context),
            observer(observer), probes(probes),
            mass(model.surface, model.points, analysis.shell.section.mass_per_area()),
            integrator(model.equilibrium, model.equations, mass, model.contact.get(), load_factor,
                       analysis.time),
            series(context.folder, columns(), "timeseries.csv", context.restart),
            files(context.folder, model, analysis.vtu),
            checkpoints(context.folder, analysis.checkpoints, fit())
      {
        checkpoints.add_object("motion", integrator);
        if (model.contact)
          checkpoints.add_object("contact", *model.contact);
        checkpoints.add_object("files", files);
        checkpoints.add_object("record", record);
        observer.add_to(checkpoints);
      }

      void operator()()
      {
        if (context.restart)
          go_on();
        else
          begin();
        while (!integrator.at_end())
        {
          const shell::TimeStepReport report =
              integrator.advance(next_stop(), [] { return false; });
          record.iterations += report.iterations;
          record.rejections += report.rejections;
          describe(report);
          write(report);
          save_if_due();
          if (interrupted() && !waits_for_checkpoint())
            break;
        }
        finish();
      }

      std::string last_file;

    private:
      const DynamicAnalysis &analysis;
      ShellModel &model;
      const TimeTable &load_factor;
      RunContext &context;
      MotionObserver &observer;
      const Probes &probes;
      const shell::Mass mass;
      shell::TimeIntegrator integrator;
      output::TimeSeries series;
      ShellOutput files;
      Checkpoints checkpoints;
      bool checkpoint_wanted = false;

      struct Record
      {
        std::uintmax_t series_size = 0;
        unsigned int iterations = 0, rejections = 0, factorizations = 0;
        double start_energy = 0., largest_energy = 0., largest_drift = 0., largest_imbalance = 0.;

        template <class Archive>
        void serialize(Archive &archive, const unsigned int /*version*/)
        {
          archive &series_size &iterations &rejections &factorizations;
          archive &start_energy &largest_energy &largest_drift &largest_imbalance;
        }
      } record;

      std::string fit() const
      {
        return "a shell of " + std::to_string(model.surface.elements.size()) + " elements, " +
               std::to_string(model.surface.control_points.size()) + " control points and " +
               std::to_string(model.equations.n_equations()) + " equations" +
               (model.contact ? " with contact" : "");
      }

      Columns columns() const
      {
        Columns all = {{"time", "time"},
                       {"step", "time"},
                       {"iterations", "-"},
                       {"load_factor", "-"},
                       {"kinetic_energy", "energy"},
                       {"strain_energy", "energy"},
                       {"contact_energy", "energy"},
                       {"work_in", "energy"},
                       {"damped", "energy"},
                       {"numerically_lost", "energy"},
                       {"balance_error", "energy"},
                       {"momentum_x", "momentum"},
                       {"momentum_y", "momentum"},
                       {"momentum_z", "momentum"},
                       {"spin_x", "angular momentum"},
                       {"spin_y", "angular momentum"},
                       {"spin_z", "angular momentum"},
                       {"max_mipe", "-"},
                       {"max_mipe_back", "-"},
                       {"largest_penetration", "length"}};
        for (const Columns &more : {probes.columns(), observer.columns()})
          all.insert(all.end(), more.begin(), more.end());
        return all;
      }

      void begin()
      {
        shell::NonlinearSystem::Vector u(model.equations.n_equations());
        integrator.start(u, project_velocity(analysis.initial_velocity, model, mass));
        const shell::EnergyBalance balance = integrator.energy_balance();
        record.start_energy = record.largest_energy =
            balance.kinetic + balance.strain + balance.contact;
        write({0, std::nan(""), 0, 0, 0., std::nan("")});
      }

      void go_on()
      {
        checkpoints.restore();
        series.go_on_at(record.series_size);
        context.log.line("going on from step " + std::to_string(integrator.n_steps()) + ", time " +
                         std::to_string(integrator.time()));
      }

      double next_stop() const
      {
        return std::min(next_multiple(integrator.time(), analysis.series_interval),
                        next_multiple(integrator.time(), analysis.vtu_interval));
      }

      void describe(const shell::TimeStepReport &report)
      {
        std::ostringstream text;
        text << "step " << report.number << ": time " << integrator.time() << ", length "
             << report.dt << ", " << report.iterations << " iterations, residual "
             << report.residual;
        if (report.rejections > 0)
          text << ", " << report.rejections << " rejected";
        context.log.line(text.str());
        context.log.progress("motion", integrator.time() / analysis.time.end_time);
      }

      void write(const shell::TimeStepReport &report)
      {
        const Timers::Scope timer(context.timers, "output");
        const double time = integrator.time();
        const bool at_ends = time == 0. || integrator.at_end();
        if (at_ends || analysis.series_interval == 0. ||
            is_multiple(time, analysis.series_interval))
          add_row(report);
        if (at_ends || is_multiple(time, analysis.vtu_interval))
          last_file = files.write(time, integrator.positions());
      }

      void add_row(const shell::TimeStepReport &report)
      {
        const shell::ControlVectors x = integrator.positions();
        const shell::EnergyBalance b = integrator.energy_balance();
        remember(b);
        const auto p = integrator.momentum(), l = integrator.angular_momentum();
        std::vector<double> all = {integrator.time(),
                                   report.dt,
                                   double(report.iterations),
                                   load_factor.value(integrator.time()),
                                   b.kinetic,
                                   b.strain,
                                   b.contact,
                                   b.work_in,
                                   b.damped,
                                   b.numerical,
                                   b.error,
                                   p[0],
                                   p[1],
                                   p[2],
                                   l[0],
                                   l[1],
                                   l[2],
                                   largest_strain(model, x, 1).value,
                                   largest_strain(model, x, -1).value,
                                   model.contact ? model.contact->largest_penetration()
                                                 : std::nan("")};
        for (const auto &more : {probes.displacements(x), observer.row(integrator.time(), x)})
          all.insert(all.end(), more.begin(), more.end());
        series.add_row(all);
      }

      void remember(const shell::EnergyBalance &balance)
      {
        const double energy = balance.kinetic + balance.strain + balance.contact;
        record.largest_energy = std::max(record.largest_energy, energy);
        record.largest_drift =
            std::max(record.largest_drift,
                     std::abs(energy - record.start_energy - balance.work_in + balance.damped));
        record.largest_imbalance = std::max(record.largest_imbalance, std::abs(balance.error));
      }

      bool waits_for_checkpoint() const { return checkpoint_wanted; }

      /// A checkpoint that is due is written at the next step that allows one.
      void save_if_due()
      {
        checkpoint_wanted = checkpoints.due(integrator.n_steps()) || checkpoint_wanted;
        if (!checkpoint_wanted || !integrator.has_forgotten())
          return;
        const Timers::Scope timer(context.timers, "output");
        record.series_size = series.size();
        checkpoints.write(integrator.n_steps(), integrator.time());
        checkpoint_wanted = false;
        context.log.line("checkpoint at time " + std::to_string(integrator.time()));
      }

      void finish()
      {
        RunResults &results = context.results;
        results.steps = integrator.n_steps();
        results.newton_iterations = record.iterations;
        results.unknowns = model.equations.n_equations();
        const shell::ControlVectors x = integrator.positions();
        const shell::EnergyBalance b = integrator.energy_balance();
        const double largest = std::max(
            {record.largest_energy, std::abs(b.work_in), std::numeric_limits<double>::min()});
        auto &q = results.quantities;
        q.insert(
            q.end(),
            {{"end_time", integrator.time(), "time"},
             {"steps", double(integrator.n_steps()), "-"},
             {"iterations_per_step", double(record.iterations) / integrator.n_steps(), "-"},
             {"rejected_steps", double(record.rejections), "-"},
             {"max_mipe",
              std::max(largest_strain(model, x, 1).value, largest_strain(model, x, -1).value), "-"},
             {"kinetic_energy", b.kinetic, "energy"},
             {"strain_energy", b.strain, "energy"},
             {"contact_energy", b.contact, "energy"},
             {"work_in", b.work_in, "energy"},
             {"damped", b.damped, "energy"},
             {"numerically_lost", b.numerical, "energy"},
             {"largest_energy_drift", record.largest_drift / largest, "-"},
             {"largest_balance_error", record.largest_imbalance / largest, "-"}});
        probes.add_quantities(x, results);
      }
    };
  } // namespace

  void DynamicAnalysis::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii;
    shell.section.add_parameters(prm);
    shell.supports.add_parameters(prm);
    shell.supports.may_move_rigidly = true;
    shell.contact.add_parameters(prm);
    time.add_parameters(prm);
    prm.enter_subsection("Initial");
    prm.add_parameter("Velocity", initial_velocity,
                      "Velocity at the start, three expressions in x, y, z separated by "
                      "semicolons [length/time].",
                      Patterns::Anything());
    prm.leave_subsection();
    checkpoints.add_parameters(prm);
    prm.enter_subsection("Output");
    vtu.add_parameters(prm);
    prm.add_parameter("Series interval", series_interval,
                      "Time between the rows of timeseries.csv; 0: a row for each step [time].",
                      Patterns::Double(0.));
    prm.add_parameter("VTU interval", vtu_interval,
                      "Time between VTU files; 0: only start and end [time].",
                      Patterns::Double(0.));
    prm.add_parameter("Probes", probes,
                      "Points whose displacement is recorded, 'NAME: (x, y, z)', separated by "
                      "semicolons; the nearest point of the undeformed surface is taken.");
    prm.leave_subsection();
  }

  void DynamicAnalysis::check() const
  {
    time.check();
  }

  void DynamicAnalysis::run(ShellModel &model, const TimeTable &load_factor, RunContext &context,
                            MotionObserver &observer) const
  {
    const Probes points(probes, model.surface, "Output/Probes");
    report_size(model, context.log);
    if (context.dry_run)
    {
      print(report(model.surface), context.log);
      return;
    }
    Run run(*this, model, load_factor, context, observer, points);
    try
    {
      run();
    }
    catch (const NumericsError &error)
    {
      throw error.after((context.folder / run.last_file).string());
    }
  }
} // namespace semilunar::scene
