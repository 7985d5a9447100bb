// SPDX-License-Identifier: LGPL-2.1-or-later
// The error indicator: against the same bubbles as control points of elevated patches, with contact
// and pressure; effectivity and order on the clamped plate and the Scordelis-Lo roof; marking.

#include <semilunar/shell/error_indicator.h>
#include <semilunar/shell/loads.h>
#include <semilunar/shell/supports.h>

#include <deal.II/lac/full_matrix.h>

#include "../spline/quad_meshes.h"
#include "../tests.h"
#include "spline_shells.h"

#include <numeric>

using namespace semilunar;
using namespace semilunar::shell;
using namespace semilunar::tests;

namespace
{
  double total(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.);
  }

  /// A cubic patch of one element near the unit square at a height, stretched and bent.
  spline::NurbsPatch one_element(const double height, const double stretch, const double bend)
  {
    const spline::NurbsPatch patch = cubic_square(1);
    std::vector<spline::ControlPoint> net = patch.control_net();
    for (auto &c : net)
    {
      const double x = c.position[0], y = c.position[1];
      c.position = Point<3>((1. + stretch) * x + bend * y * y, (1. + stretch) * y - bend * x * x,
                            height + bend * x * (1. - y));
    }
    return spline::NurbsPatch({{patch.knots(0), patch.knots(1)}}, net);
  }

  /// Two layers of one element each, of degree 3 + elevation.
  Surface layers(const double stretch, const double bend, const double distance,
                 const unsigned int elevation)
  {
    Surface both;
    for (const double height : {0., distance})
    {
      spline::NurbsPatch patch = one_element(height, stretch, bend);
      for (unsigned int d = 0; elevation > 0 && d < 2; ++d)
        patch.elevate_degree(d, elevation);
      append(both, to_surface(patch), -1.);
    }
    return both;
  }

  /// Inner control points of an element of degree 6, whose functions are the bubbles.
  std::vector<double> by_elevation(const SectionParameters &parameters,
                                   const ContactParameters &contact_parameters,
                                   const double pressure, const Vectors &deformed_cubic)
  {
    const SplineShell cubic(layers(0., 0., 0.2, 0), parameters);
    const SplineShell model(layers(0., 0., 0.2, 3), parameters, 4);
    std::vector<Resultants> tension;
    for (unsigned int q = 0; q < cubic.points.n_points(); ++q)
    {
      SectionResponse state;
      cubic.section->evaluate(cubic.assembly.section_strain(deformed_cubic, q), false, state);
      tension.push_back({state.n, {}}); // all of them tensile
    }
    const Vectors x = positions(layers(0.05, 0.01, 0.1, 3));
    Contact contact(model.surface, model.points, contact_parameters);
    contact.update(x);
    Vectors forces(x.size());
    std::vector<std::vector<double>> blocks;
    model.assembly.add(x, pressure, forces, {});
    Vectors unused(x.size()); // the stiffness is without that of the pressure
    model.assembly.add(
        x, 0., unused,
        [&](const std::vector<unsigned int> &c, const double *block)
        { blocks.emplace_back(block, block + 9 * c.size() * c.size()); },
        &tension);
    contact.add_gradient(forces);
    std::vector<double> result;
    for (unsigned int e = 0; e < 2; ++e)
    {
      const auto &c = model.surface.elements[e].control_points;
      std::vector<unsigned int> inner; // functions of the element
      for (unsigned int j = 2; j < 5; ++j)
        for (unsigned int i = 2; i < 5; ++i)
          inner.push_back(7 * j + i);
      dealii::FullMatrix<double> K(27, 27);
      dealii::Vector<double> r(27), z(27);
      const auto dof = [&](const unsigned int k) { return 3 * inner[k / 3] + k % 3; };
      for (unsigned int k = 0; k < 27; ++k)
      {
        r[k] = forces[c[inner[k / 3]]][k % 3];
        for (unsigned int l = 0; l < 27; ++l)
          K(k, l) = blocks[e][std::size_t(dof(k)) * 3 * c.size() + dof(l)];
      }
      K.gauss_jordan();
      K.vmult(z, r);
      result.push_back(r * z);
    }
    return result;
  }

  void against_elevated_patches()
  {
    const SectionParameters parameters = linear_elastic(1e4, 0.3, 0.05);
    ContactParameters contact_parameters;
    contact_parameters.enabled = true;
    contact_parameters.distance = 0.15;
    contact_parameters.stiffness = 1e4;
    contact_parameters.smoothing = 0.01;
    const double pressure = 3.;
    const SplineShell model(layers(0., 0., 0.2, 0), parameters);
    const Vectors x = positions(layers(0.05, 0.01, 0.1, 0));
    Contact contact(model.surface, model.points, contact_parameters);
    contact.update(x);
    ActingLoads loads;
    loads.pressure = pressure;
    loads.contact = &contact;
    const std::vector<double> found =
        error_indicators(model.surface, model.points, *model.section, model.assembly, x, loads);
    const std::vector<double> expected = by_elevation(parameters, contact_parameters, pressure, x);
    loads.contact = nullptr;
    const double without =
        error_indicators(model.surface, model.points, *model.section, model.assembly, x, loads)[0];
    for (unsigned int e = 0; e < 2; ++e)
      check("layer " + std::to_string(e) + ": bubbles as control points",
            found[e] / expected[e] - 1., 1e-9);
    check("contact matters", without / found[0], 0.5);
  }

  struct Estimate
  {
    unsigned int n;
    double error, estimate; ///< energy norms, squared
  };

  /// A linear analysis under a small dead load: its error from the work of the load.
  Estimate estimate(const Surface &surface, const SectionParameters &parameters,
                    const std::string &supports, const std::string &area_load, const double exact)
  {
    const SplineShell model(surface, parameters);
    const Equations equations = make_equations(model.surface, {supports});
    LoadParameters loads;
    loads.area_load = area_load;
    const ControlVectors forces = dead_forces(model.surface, model.points, loads, 0.);
    const ControlVectors x = linear_response(model, equations, forces);
    ActingLoads acting;
    acting.dead_load = loads.dead_area_load(0.);
    const double work = dot(sum(x, -1., positions(surface)), forces);
    return {unsigned(surface.control_points.size()), exact - work,
            total(error_indicators(model.surface, model.points, *model.section, model.assembly, x,
                                   acting))};
  }

  /// Effectivities within bounds on all meshes; the order of the estimate from the last two.
  void log_effectivities(const std::string &name, const std::vector<Estimate> &estimates,
                         const double smallest, const double largest, const double order)
  {
    std::fprintf(stderr, "%s:", name.c_str());
    bool within = true;
    for (const Estimate &e : estimates)
    {
      const double effectivity = std::sqrt(e.estimate / e.error);
      std::fprintf(stderr, " %u %.3e %.2f", e.n, std::sqrt(e.error), effectivity);
      within = within && effectivity >= smallest && effectivity <= largest;
    }
    const Estimate &last = estimates.back(), &before = estimates[estimates.size() - 2];
    const double found =
        std::log(before.estimate / last.estimate) / std::log(double(last.n) / before.n);
    std::fprintf(stderr, " order %.2f\n", found);
    log() << name << ": effectivity between " << smallest << " and " << largest << ": " << within
          << std::endl;
    check(name + ": order below the expected one by", std::max(0., order - found), 0.);
  }

  void clamped_plate()
  {
    const SectionParameters parameters = linear_elastic(1e7, 0.3, 0.01);
    const auto plate = [&](const Surface &surface, const double exact)
    { return estimate(surface, parameters, clamped_all_round, "0, 0, 1e-4", exact); };
    const double exact = -plate(to_surface(cubic_square(40)), 0.).error;
    std::vector<Estimate> grids, t_meshes, with_points;
    for (const unsigned int n : {4u, 8u, 16u})
    {
      grids.push_back(plate(to_surface(cubic_square(n)), exact));
      t_meshes.push_back(plate(to_surface(with_t_junctions(cubic_square(n))), exact));
      const PlacedMesh placed = square_with_points(n / 2);
      with_points.push_back(plate(
          to_surface(placed.mesh, lifted(placed, [](const Point<2> &) { return 0.; })), exact));
    }
    // the square falls with h^4, the number of control points grows with h^-2
    log_effectivities("clamped plate, tensor product", grids, 0.4, 1., 1.8);
    log_effectivities("clamped plate, T-junctions", t_meshes, 0.4, 1., 1.8);
    // bubbles do not see what the conditions between the elements of caps cost
    log_effectivities("clamped plate, extraordinary points", with_points, 0.25, 1., 1.8);
  }

  void scordelis_lo()
  {
    const SectionParameters parameters = linear_elastic(4.32e8, 0., 0.25);
    const auto roof = [&](const unsigned int n, const double exact) {
      return estimate(to_surface(cubic_roof(n)), parameters, roof_supports, "0, -90e-6, 0", exact);
    };
    const double exact = -roof(40, 0.).error;
    std::vector<Estimate> grids;
    for (const unsigned int n : {8u, 12u, 18u})
      grids.push_back(roof(n, exact));
    log_effectivities("Scordelis-Lo roof", grids, 0.3, 1., 1.8);
  }

  void log_marks(const std::vector<double> &indicators, const double share)
  {
    log() << "share " << share << ":";
    for (const unsigned int e : mark_elements(indicators, share))
      log() << " " << e;
    log() << std::endl;
  }
} // namespace

int main()
{
  against_elevated_patches();
  clamped_plate();
  scordelis_lo();
  for (const double share : {0.1, 0.5, 0.8, 1.})
    log_marks({4., 1., 3., 1. + 1e-9, 0.}, share);
}
