// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/nearest_name.h>
#include <semilunar/output/oscillation.h>
#include <semilunar/scene/flow_record.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace semilunar::scene
{
  namespace
  {
    const char *const axes[] = {"x", "y", "z"};

    std::string flow_unit(const int dim)
    {
      return dim == 3 ? "cm^3/s" : "cm^2/s";
    }
  } // namespace

  template <int dim>
  FlowRecord<dim>::FlowRecord(const std::filesystem::path &folder,
                              const FlowRecordParameters &parameters, const mesh::Mesh<dim> &mesh,
                              const bool resume,
                              const std::vector<output::TimeSeries::Column> &more)
      : parameters(parameters), boundary_ids(mesh.lumen_boundary_ids())
  {
    for (const std::string &name : parameters.forces)
      force_ids.push_back(mesh.boundary_id(name, "Output/Forces"));
    for (const double position : parameters.sections)
      sections.emplace_back(parameters.section_axis[0] - 'x', position);
    std::vector<std::string> names;
    for (const auto &[name, text] : named_parts(parameters.probes, "Output/Probes"))
    {
      const auto parts = components(text, dim, "Output/Probes");
      dealii::Point<dim> position;
      for (unsigned int d = 0; d < dim; ++d)
        position[d] = number(parts[d], {}, "Output/Probes");
      probes.push_back({name, output::FlowProbe<dim>(position)});
      names.push_back(name);
    }
    const std::string entry = "Output/Pressure differences";
    for (const auto &[name, text] : named_parts(parameters.pressure_differences, entry))
    {
      const auto pair = components(text, 2, entry);
      std::array<std::size_t, 2> indices;
      for (unsigned int i = 0; i < 2; ++i)
      {
        indices[i] = std::find(names.begin(), names.end(), pair[i]) - names.begin();
        if (indices[i] == names.size())
          throw InputError(entry, pair[i], "there is no such probe", suggest(pair[i], names));
      }
      differences.push_back({name, indices});
    }
    declare_columns();
    for (const output::TimeSeries::Column &title : more)
      columns.push_back({title});
    for (const std::string &name : parameters.peaks)
      find(name, "Output/Peaks");
    for (const std::string &name : parameters.oscillations)
      find(name, "Output/Oscillations");
    if (!folder.empty())
    {
      std::vector<output::TimeSeries::Column> titles;
      for (const Column &column : columns)
        titles.push_back(column.title);
      series = std::make_unique<output::TimeSeries>(folder, titles, "timeseries.csv", resume);
    }
  }

  template <int dim>
  void FlowRecord<dim>::declare_columns()
  {
    declare("time", "s");
    declare("time_step", "s");
    declare("cfl", "-");
    declare("cell_reynolds", "-");
    declare("nonlinear_iterations", "-");
    declare("krylov_iterations", "-");
    for (const auto &[name, id] : boundary_ids)
    {
      declare("flow_rate_" + name, flow_unit(dim));
      declare("pressure_" + name, "dyn/cm^2");
    }
    for (const double position : parameters.sections)
    {
      char text[32];
      std::snprintf(text, sizeof(text), "%s%g", parameters.section_axis.c_str(), position);
      declare(std::string("flow_rate_") + text, flow_unit(dim));
      declare(std::string("pressure_") + text, "dyn/cm^2");
    }
    for (const std::string &name : parameters.forces)
      for (unsigned int d = 0; d < dim; ++d)
        declare("force_" + name + "_" + axes[d],
                parameters.force_scale == 1. ? (dim == 3 ? "dyn" : "dyn/cm") : "-");
    for (const NamedProbe &probe : probes)
    {
      for (unsigned int d = 0; d < dim; ++d)
        declare(probe.name + "_u" + axes[d], "cm/s");
      declare(probe.name + "_p", "dyn/cm^2");
    }
    for (const auto &difference : differences)
      declare(difference.first, "dyn/cm^2");
  }

  template <int dim>
  const typename FlowRecord<dim>::Column &FlowRecord<dim>::find(const std::string &name,
                                                                const std::string &entry) const
  {
    std::vector<std::string> names;
    for (const Column &column : columns)
    {
      if (column.title.name == name)
        return column;
      names.push_back(column.title.name);
    }
    throw InputError(entry, name, "there is no such column", suggest(name, names));
  }

  template <int dim>
  void FlowRecord<dim>::reinit(const output::FlowState<dim> &state)
  {
    for (auto &section : sections)
      section.reinit(state);
    for (NamedProbe &probe : probes)
      if (!probe.probe.reinit(state) && columns[0].values.empty())
        throw InputError("Output/Probes", probe.name, "the probe does not lie in the mesh",
                         "move or remove it");
  }

  template <int dim>
  void FlowRecord<dim>::add(const flow::StepReport &report, flow::FlowSolver<dim> &solver,
                            const output::FlowState<dim> &state, const std::vector<double> &more)
  {
    std::vector<double> row = {report.time,
                               report.dt,
                               report.cfl,
                               report.cell_reynolds,
                               double(report.n_nonlinear),
                               double(report.n_linear)};
    last_imbalance = 0.;
    for (const auto &[name, id] : boundary_ids)
    {
      const double flow_rate = solver.flow_rate(id);
      last_imbalance += flow_rate;
      largest_flow_rate = std::max(largest_flow_rate, std::abs(flow_rate));
      row.insert(row.end(), {flow_rate, solver.mean_pressure(id)});
    }
    largest_imbalance = std::max(largest_imbalance, std::abs(last_imbalance));
    for (const auto &section : sections)
    {
      const auto values = section.evaluate(state);
      row.insert(row.end(), {values.flow_rate, values.pressure});
    }
    for (const auto id : force_ids)
    {
      const auto force = solver.force(id); // of the boundary on the fluid
      for (unsigned int d = 0; d < dim; ++d)
        row.push_back(-parameters.force_scale * force[d]);
    }
    std::vector<double> pressures;
    for (const NamedProbe &probe : probes)
    {
      const auto values = probe.probe.evaluate(state);
      for (unsigned int d = 0; d < dim; ++d)
        row.push_back(values.velocity[d]);
      row.push_back(values.pressure);
      pressures.push_back(values.pressure);
    }
    for (const auto &[name, pair] : differences)
      row.push_back(pressures[pair[0]] - pressures[pair[1]]);
    row.insert(row.end(), more.begin(), more.end());
    AssertDimension(row.size(), columns.size());
    for (std::size_t i = 0; i < row.size(); ++i)
      columns[i].values.push_back(row[i]);
    series->add_row(row);
  }

  template <int dim>
  void FlowRecord<dim>::add_peak(const std::string &name, const double sign,
                                 RunResults &results) const
  {
    const Column &column = find(name, "Output/Peaks");
    const std::vector<double> &times = columns[0].values, &values = column.values;
    const std::size_t k =
        std::max_element(values.begin(), values.end(),
                         [&](const double a, const double b) { return sign * a < sign * b; }) -
        values.begin();
    const std::pair<double, double> peak = output::extremum(times, values, k);
    const std::string what = sign > 0. ? "max_" : "min_";
    results.quantities.push_back({what + name, peak.second, column.title.unit});
    results.quantities.push_back({"time_of_" + what + name, peak.first, "s"});
  }

  template <int dim>
  double FlowRecord<dim>::largest_volume_error() const
  {
    const std::vector<double> &times = columns[0].values,
                              &volumes = find("lumen_volume", "").values;
    std::vector<double> outflow(times.size(), 0.);
    for (const auto &[name, id] : boundary_ids)
    {
      const std::vector<double> &rates = find("flow_rate_" + name, "").values;
      std::transform(rates.begin(), rates.end(), outflow.begin(), outflow.begin(), std::plus<>());
    }
    double inside = volumes[0], largest = 0.;
    for (std::size_t i = 1; i < times.size(); ++i)
    {
      inside -= 0.5 * (times[i] - times[i - 1]) * (outflow[i] + outflow[i - 1]);
      largest = std::max(largest, std::abs(volumes[i] - inside));
    }
    return largest;
  }

  template <int dim>
  void FlowRecord<dim>::add_oscillation(const std::string &name, RunResults &results) const
  {
    const Column &column = find(name, "Output/Oscillations");
    const auto found = output::last_oscillation(columns[0].values, column.values);
    results.quantities.insert(results.quantities.end(),
                              {{"mean_" + name, found.mean, column.title.unit},
                               {"amplitude_" + name, found.amplitude, column.title.unit},
                               {"frequency_" + name, found.frequency, "1/s"},
                               {"amplitude_change_" + name, found.amplitude_change, "-"}});
  }

  template <int dim>
  void FlowRecord<dim>::add_quantities(RunResults &results) const
  {
    if (columns[0].values.empty())
      return;
    for (const Column &column : columns)
      results.quantities.push_back({column.title.name, column.values.back(), column.title.unit});
    for (const std::string &name : parameters.peaks)
      for (const double sign : {1., -1.})
        add_peak(name, sign, results);
    for (const std::string &name : parameters.oscillations)
      add_oscillation(name, results);
    const std::vector<double> &iterations = columns[5].values;
    double sum = 0.;
    for (const double n : iterations)
      sum += n;
    results.quantities.push_back({"mean_krylov_iterations", sum / iterations.size(), "-"});
    const double scale = largest_flow_rate > 0. ? largest_flow_rate : 1.;
    results.quantities.push_back({"flow_imbalance", std::abs(last_imbalance) / scale, "-"});
    results.quantities.push_back({"max_flow_imbalance", largest_imbalance / scale, "-"});
    const bool volume_changes =
        std::any_of(columns.begin(), columns.end(),
                    [](const Column &column) { return column.title.name == "lumen_volume"; });
    if (volume_changes)
      results.quantities.push_back(
          {"largest_volume_error", largest_volume_error(), dim == 3 ? "cm^3" : "cm^2"});
  }

  template class FlowRecord<2>;
  template class FlowRecord<3>;
} // namespace semilunar::scene
