// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/first_rank.h>
#include <semilunar/output/atomic_file.h>
#include <semilunar/output/log_log_plot.h>
#include <semilunar/output/variation_table.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>

namespace semilunar::output
{
  namespace
  {
    /// NaN if the run does not have it.
    double value_of(const VariedRun &run, const std::string &quantity)
    {
      for (const Quantity &candidate : run.results.quantities)
        if (candidate.name == quantity)
          return candidate.value;
      return std::nan("");
    }

    /// NaN if the text is not one number.
    double number_of(const std::string &text)
    {
      char *end = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      return !text.empty() && *end == '\0' ? value : std::nan("");
    }

    std::string quoted(const std::string &text)
    {
      std::string result = text;
      std::replace(result.begin(), result.end(), '"', '\'');
      return '"' + result + '"';
    }

    void write_csv(std::ostream &out, const std::vector<VariedRun> &runs,
                   const std::vector<std::string> &quantities)
    {
      out.precision(12);
      out << "run,entry,value,processor_seconds,steps";
      for (const std::string &name : quantities)
        out << ',' << name;
      out << ",failure\n";
      for (const VariedRun &run : runs)
      {
        out << run.name << ',' << quoted(run.entry) << ',' << quoted(run.value) << ','
            << run.cost.cpu_seconds << ',' << run.results.steps;
        for (const std::string &name : quantities)
          out << ',' << value_of(run, name);
        out << ',' << quoted(run.failure) << '\n';
      }
    }

    LogLogPlot plot(const std::vector<VariedRun> &runs, const std::string &quantity,
                    const std::vector<ParameterDescription> &entries)
    {
      LogLogPlot result{quantity, "value over that of the base", quantity, {}};
      for (const VariedRun &run : runs)
      {
        const auto entry =
            std::find_if(entries.begin(), entries.end(),
                         [&](const auto &candidate) { return candidate.path == run.entry; });
        if (entry == entries.end())
          continue;
        if (result.curves.empty() || result.curves.back().name != run.entry)
          result.curves.push_back({run.entry, {{{1., std::abs(value_of(runs[0], quantity))}}}});
        result.curves.back().points.push_back(
            {{number_of(run.value) / number_of(entry->value), std::abs(value_of(run, quantity))}});
      }
      for (auto &curve : result.curves)
        std::sort(curve.points.begin(), curve.points.end());
      return result;
    }
  } // namespace

  void write_variations(const std::filesystem::path &folder, const std::vector<VariedRun> &runs,
                        std::vector<std::string> quantities,
                        const std::vector<ParameterDescription> &entries)
  {
    if (quantities.empty())
      for (const Quantity &quantity : runs.front().results.quantities)
        quantities.push_back(quantity.name);
    on_first_rank(
        [&]()
        {
          write_atomically((folder / "study.csv").string(),
                           [&](std::ostream &out) { write_csv(out, runs, quantities); });
          if (!quantities.empty())
            write_atomically((folder / "study.svg").string(), [&](std::ostream &out)
                             { write_svg(out, plot(runs, quantities.front(), entries)); });
        });
  }
} // namespace semilunar::output
