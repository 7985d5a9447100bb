// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_core_time_table_h
#define semilunar_core_time_table_h

#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace semilunar
{
  /// A time table in the words of a scene file.
  struct TimeTableParameters
  {
    std::string values;
    std::string file;
    std::string interpolation = "linear";
    bool periodic = false;

    /// Declare the entries in the current section.
    /// @param what the quantity with its unit, for the documentation: "pressure [mmHg]"
    void add_parameters(dealii::ParameterHandler &prm, const std::string &what);
    bool empty() const { return values.empty() && file.empty(); }
  };

  /// A quantity over time, given at some times: linear between them, or a monotone cubic without
  /// overshoot (M. Steffen, Astron. Astrophys. 239 (1990) 443-450, eqs. 1-11: continuously
  /// differentiable, extrema at the given points only). Constant before the first and after the
  /// last time, or periodic with their distance as period.
  class TimeTable
  {
  public:
    enum class Interpolation
    {
      linear,
      monotone_cubic
    };
    /// Time and value, by ascending time.
    using Points = std::vector<std::pair<double, double>>;

    /// Constant in time.
    explicit TimeTable(double value);

    /// @param place entry or file that the points come from, for the message
    /// @throws InputError for no points, times that do not ascend, numbers that are not finite, and
    /// a periodic table of fewer than two points or whose last value is not the first
    TimeTable(const Points &points, Interpolation interpolation, bool periodic,
              const std::string &place);

    /// @param section where the entries stand, for the message: "Loads/Pressure table"
    /// @throws InputError naming the entry to change, or file and line
    TimeTable(const TimeTableParameters &parameters, const std::string &section);

    double value(double time) const;
    /// The derivative in time; at the corner of a linear table that of the side that follows.
    double derivative(double time) const;

    /// The table's first time after this one where the derivative jumps (linear tables only), or
    /// infinity: where a time step should end.
    double next_corner(double time) const;

    const Points &points() const { return table; }

  private:
    /// Interval and position in it.
    struct Place
    {
      std::size_t interval;
      double offset; ///< time since the interval's start
    };

    bool is_constant_at(double time) const;
    /// The same time within the table. Must not be called where the table is constant.
    double reduce(double time) const;
    Place locate(double time) const;
    void compute_slopes();

    Points table;
    bool cubic = false, periodic = false;
    std::vector<double> slopes; ///< at the points, of the cubic
  };
} // namespace semilunar

#endif
