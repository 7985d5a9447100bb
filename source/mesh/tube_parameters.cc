// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/core/parameters.h>
#include <semilunar/mesh/tube_parameters.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace semilunar::mesh
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    /// Numbers of cells in proportion to those of an edge of the core. They give 6,000 cells for
    /// 24, 26,000 for 36 and 103,000 for 60 cells around.
    constexpr double layers_per_edge = 1.32, cells_along_per_edge = 9.5;
  } // namespace

  TubeParameters TubeParameters::artery()
  {
    TubeParameters tube;
    tube.radius = 1.3;
    tube.begin = -5.;
    tube.end = 11.;
    tube.sinus.exists = true;
    tube.zone_begin = -0.3;
    tube.zone_end = 2.5;
    tube.zone_ratio = 3.;
    return tube;
  }

  TubeParameters TubeParameters::pipe(const double radius, const double length)
  {
    TubeParameters tube;
    tube.radius = radius;
    tube.begin = -0.5 * length;
    tube.end = 0.5 * length;
    return tube;
  }

  void TubeParameters::add_parameters(dealii::ParameterHandler &prm, const bool is_artery)
  {
    prm.add_parameter("Radius", radius, "Inner radius of the straight parts [cm], > 0",
                      positive_number());
    prm.add_parameter("Inlet", begin, "z of the inlet [cm]", Patterns::Double());
    prm.add_parameter("Outlet", end, "z of the outlet [cm], above the inlet", Patterns::Double());
    prm.add_parameter("Cells around", n_cells_around,
                      "Cells around the circumference, multiple of 6", Patterns::Integer(6, 600));
    prm.add_parameter(
        "Layers", n_layers,
        "Layers of cells between the core and the wall; 0: in proportion to the cells "
        "around",
        Patterns::Integer(0, 200));
    prm.add_parameter("Cells along", n_cells_along,
                      "Cells along the axis; 0: in proportion to the cells around",
                      Patterns::Integer(0, 5000));
    prm.add_parameter("Core radius", core_radius,
                      "Radius of the hexagonal core over that of the tube, 0.1 to 0.9 [-]",
                      Patterns::Double(0.1, 0.9));
    prm.add_parameter("Wall clustering", wall_clustering,
                      "Thickness of the innermost layer over that of the outermost one, for many "
                      "layers [-], > 0",
                      Patterns::Double(0.05, 50.));
    prm.add_parameter("Zone begin", zone_begin, "z where the zone of shorter cells begins [cm]",
                      Patterns::Double());
    prm.add_parameter("Zone end", zone_end, "z where it ends [cm]", Patterns::Double());
    prm.add_parameter("Zone transition", zone_transition,
                      "Length over which the cells' length changes [cm], > 0", positive_number());
    prm.add_parameter("Zone ratio", zone_ratio,
                      "How many times shorter cells in the zone are than those far away, 1 to 50; "
                      "1: all cells have the same length [-]",
                      Patterns::Double(1., 50.));
    prm.add_parameter("Wall thickness", wall_thickness,
                      "Thickness of the layer of wall cells [cm]; 0: there are none",
                      Patterns::Double(0.));
    prm.add_parameter("Wall layers", n_wall_layers, "Layers of wall cells, if there are any",
                      Patterns::Integer(1, 50));
    if (!is_artery)
      return;
    prm.enter_subsection("Sinus");
    prm.add_parameter("Enabled", sinus.exists, "Whether there is a sinus");
    prm.add_parameter("Begin", sinus.begin, "z of its lower end [cm]", Patterns::Double());
    prm.add_parameter("Peak", sinus.peak, "z of its widest cross-section [cm]", Patterns::Double());
    prm.add_parameter("End", sinus.end, "z of its upper end [cm]", Patterns::Double());
    prm.add_parameter("Lobe radius", sinus.lobe_radius,
                      "Largest radius, at the peak behind each of the three leaflets [cm]",
                      positive_number());
    prm.add_parameter("Commissure radius", sinus.commissure_radius,
                      "Radius at the peak half way between the lobes [cm]", positive_number());
    prm.leave_subsection();
  }

  void TubeParameters::check(const std::string &section) const
  {
    const auto complain = [&](const std::string &entry, const double value,
                              const std::string &problem, const std::string &remedy)
    { throw InputError(section + "/" + entry, std::to_string(value), problem, remedy); };
    if (!(begin < end))
      complain("Outlet", end, "the outlet must lie above the inlet", "choose a larger z");
    if (n_cells_around % 6 != 0)
      throw InputError(section + "/Cells around", std::to_string(n_cells_around),
                       "the core is a hexagon", "choose a multiple of 6");
    if (!(zone_begin <= zone_end))
      complain("Zone end", zone_end, "the zone ends before it begins", "choose a larger z");
    if (!sinus.exists)
      return;
    if (!(sinus.begin < sinus.peak))
      complain("Sinus/Peak", sinus.peak, "the sinus is widest below its lower end",
               "choose a larger z");
    if (!(sinus.peak < sinus.end))
      complain("Sinus/End", sinus.end, "the sinus ends below its widest cross-section",
               "choose a larger z");
    if (!(begin <= sinus.begin && sinus.end <= end))
      complain("Sinus/End", sinus.end, "the sinus does not lie between inlet and outlet",
               "move it or prolong the tube");
    if (!(sinus.commissure_radius > 0.6 * radius && sinus.lobe_radius > 0.6 * radius))
      complain("Sinus/Lobe radius", sinus.lobe_radius, "the sinus is a narrowing",
               "choose radii above 0.6 times that of the tube");
  }

  unsigned int TubeParameters::layers() const
  {
    const double per_edge = n_cells_around / 6;
    return n_layers > 0 ? n_layers : std::lround(layers_per_edge * per_edge);
  }

  unsigned int TubeParameters::cells_along() const
  {
    const double per_edge = n_cells_around / 6;
    return n_cells_along > 0 ? n_cells_along : std::lround(cells_along_per_edge * per_edge);
  }

  unsigned int TubeParameters::n_lumen_cells() const
  {
    const unsigned int n = n_cells_around / 6;
    return (3 * n * n + 6 * n * layers()) * cells_along();
  }

  double TubeParameters::lumen_volume() const
  {
    constexpr double pi = dealii::numbers::PI;
    double volume = pi * radius * radius * (end - begin);
    if (sinus.exists)
    {
      const double m = 0.5 * (sinus.lobe_radius + sinus.commissure_radius) - radius;
      const double q = 0.5 * (sinus.lobe_radius - sinus.commissure_radius);
      volume += pi * (radius * m + 3. / 8. * (m * m + 0.5 * q * q)) * (sinus.end - sinus.begin);
    }
    return volume;
  }
} // namespace semilunar::mesh
