// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/valve/boundary_curves.h>
#include <semilunar/valve/design.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <map>
#include <sstream>

namespace semilunar::valve
{
  using dealii::ParameterHandler;
  namespace Patterns = dealii::Patterns;

  namespace
  {
    /// By how much the free edge's middle must lie further out than the smallest gap: the tip's
    /// radius is proportional to the difference.
    constexpr double rounding_margin = 1.1;

    /// Posts may take this share of the circumference.
    constexpr double largest_post_share = 0.5;

    /// Free edges further out than this share of R leave no leaflet.
    constexpr double largest_gap_share = 0.8;

    /// Posts may lean so far towards the axis or away from it [degree].
    constexpr double largest_lean = 30.;

    /// Stents expand to at least this share, and get no flatter.
    constexpr double smallest_expansion = 0.5, smallest_ellipticity = 0.4;

    /// Narrower bellies would be a dent between two control points of the base patch.
    constexpr double smallest_belly_width = 0.3;

    void add_boundary_parameters(Design &d, ParameterHandler &prm)
    {
      prm.add_parameter("Number of leaflets", d.n_leaflets, "2 or 3", Patterns::Integer(2, 3));
      prm.add_parameter("Radius", d.radius,
                        "R of the stent's wall and of the attachment edge [cm], > 0",
                        Patterns::Double(0.));
      prm.add_parameter("Commissure height", d.commissure_height,
                        "z at the top of the posts, the ends of the free edge [cm], above the post "
                        "foot",
                        Patterns::Double());
      prm.add_parameter("Post foot height", d.post_foot_height,
                        "z where the straight post meets the scallop [cm], above the nadir",
                        Patterns::Double());
      prm.add_parameter("Nadir height", d.nadir_height,
                        "z at the lowest point of the scallop [cm], > 0", Patterns::Double(0.));
      prm.add_parameter("Post width", d.post_width,
                        "Distance between the commissure lines of neighboring leaflets [cm], > 0; "
                        "neighbors keep at least this distance everywhere",
                        Patterns::Double(0.));
      prm.add_parameter("Free edge height", d.free_edge_height,
                        "z of the middle of the free edge [cm], above the nadir",
                        Patterns::Double());
      prm.add_parameter("Free edge gap", d.free_edge_gap,
                        "Distance of the middle of the free edge from the axis [cm], at least 1.1 "
                        "times (post width / 2) / sin(pi / number of leaflets), at most 0.8 R",
                        Patterns::Double(0.));
    }

    void add_belly_parameters(Design &d, ParameterHandler &prm)
    {
      prm.add_parameter(
          "Belly", d.belly,
          "Shape between the edges [-], 0: straight lines from attachment to free "
          "edge, 1: in the middle the leaflet starts straight down from the free edge",
          Patterns::Double(0., 1.));
      prm.add_parameter("Belly height", d.belly_height,
                        "z at which, for belly 1, the middle profile's tangents at free edge and "
                        "nadir meet [cm]; lower is deeper, between -R and the free edge height",
                        Patterns::Double());
      prm.add_parameter(
          "Belly width", d.belly_width,
          "Share of the leaflet's width over which the belly extends, beyond it lines "
          "are straight [-], 0.3 to 1",
          Patterns::Double(smallest_belly_width, 1.));
    }

    void add_deployment_parameters(Design &d, ParameterHandler &prm)
    {
      prm.add_parameter("Post lean", d.post_lean,
                        "Angle by which the posts lean towards the axis, each about its foot "
                        "[degree], -30 to 30; distances between neighboring leaflets stay",
                        Patterns::Double(-largest_lean, largest_lean));
      prm.add_parameter("Expansion", d.expansion,
                        "Circumference of the stent as a share of the design's [-], 0.5 to 1: less "
                        "than 1 for an under-expanded valve. Everything is scaled across the axis",
                        Patterns::Double(smallest_expansion, 1.));
      prm.add_parameter("Ellipticity", d.ellipticity,
                        "Shorter by longer axis of the stent's cross-section [-], 0.4 to 1, at the "
                        "same circumference",
                        Patterns::Double(smallest_ellipticity, 1.));
      prm.add_parameter("Ellipse direction", d.ellipse_direction,
                        "Direction of the longer axis, from x (the middle of leaflet 1) towards y "
                        "[degree]",
                        Patterns::Double(-360., 360.));
    }

    void add_layout(Design &d, ParameterHandler &prm)
    {
      const std::map<std::string, LeafletLayout> layouts = {
          {"uniform", LeafletLayout::uniform},
          {"T-spline", LeafletLayout::t_spline},
          {"unstructured", LeafletLayout::unstructured}};
      prm.declare_entry("Layout", "uniform", Patterns::Selection("uniform|T-spline|unstructured"),
                        "Arrangement of a leaflet's elements: a grid of Elements along x Elements "
                        "across, a coarser grid that is refined where section T-spline says, or "
                        "layers along the attachment edge with two extraordinary points (section "
                        "Unstructured). The surface is the same, but for the last one, whose edge "
                        "is rounded at the post feet");
      prm.add_action("Layout",
                     [&d, layouts](const std::string &name) { d.layout = layouts.at(name); });
    }

    void add_unstructured_layout(UnstructuredLayout &layout, ParameterHandler &prm)
    {
      prm.enter_subsection("Unstructured");
      prm.add_parameter("Core elements along", layout.n_core_along,
                        "Elements of the core from side to side, even, >= 4", Patterns::Integer(4));
      prm.add_parameter("Core elements across", layout.n_core_across,
                        "Elements of the core from below up to the free edge, >= 2",
                        Patterns::Integer(2));
      prm.add_parameter("Layers", layout.n_layers,
                        "Elements between the core and the attachment edge, >= 2",
                        Patterns::Integer(2));
      prm.leave_subsection();
    }

    void add_stent_parameters(Design &d, ParameterHandler &prm)
    {
      const Patterns::Integer positive(1);
      prm.enter_subsection("Stent");
      prm.add_parameter("Suture ring outer radius", d.stent.ring_outer_radius, "[cm], > R",
                        Patterns::Double(0.));
      prm.add_parameter(
          "Elements along", d.stent.n_elements_along,
          "Elements of wall and ring below each leaflet, along its scallop, even, >= 8",
          Patterns::Integer(n_base_elements));
      prm.add_parameter("Wall elements", d.stent.n_wall_elements,
                        "Elements from the ring up to scallop and post foot, >= 1", positive);
      prm.add_parameter("Ring elements", d.stent.n_ring_elements, "Elements across the ring, >= 1",
                        positive);
      prm.add_parameter("Elements across post", d.stent.n_elements_across_post, ">= 1", positive);
      prm.add_parameter("Elements up post", d.stent.n_elements_up_post,
                        "Elements from the post foot to the commissure, >= 1", positive);
      prm.declare_entry("Degree across", std::to_string(d.stent.degree_across),
                        Patterns::Selection("1|3"),
                        "Degree from ring to scallop, across the ring and up the posts, where the "
                        "stent is straight: 1 describes it with fewer control points");
      prm.add_action("Degree across", [&d](const std::string &degree)
                     { d.stent.degree_across = std::stoi(degree); });
      prm.leave_subsection();
    }

    /// Throws unless the condition holds.
    class Requirements
    {
    public:
      explicit Requirements(const std::string &section) : section(section) {}

      template <typename Number>
      void operator()(const bool holds, const std::string &entry, const Number value,
                      const std::string &problem, const std::string &remedy) const
      {
        if (holds)
          return;
        std::ostringstream text;
        text << value;
        throw InputError(section + "/" + entry, text.str(), problem, remedy);
      }

    private:
      std::string section;
    };

    std::string text(const double length)
    {
      std::ostringstream out;
      out << length << " cm";
      return out.str();
    }

    void check_attachment(const Design &d, const Requirements &require)
    {
      require(d.n_leaflets == 2 || d.n_leaflets == 3, "Number of leaflets", d.n_leaflets,
              "no design for this number", "choose 2 or 3");
      require(d.radius > 0. && std::isfinite(d.radius), "Radius", d.radius, "not a radius",
              "choose a number > 0");
      const double widest =
          2. * d.radius * std::sin(largest_post_share * dealii::numbers::PI / d.n_leaflets);
      require(d.post_width > 0. && d.post_width <= widest, "Post width", d.post_width,
              "leaves no room for leaflets or for the post",
              "choose > 0 and at most " + text(widest));
      require(d.nadir_height > 0. && std::isfinite(d.nadir_height), "Nadir height", d.nadir_height,
              "the scallop reaches below the suture ring", "choose a height > 0");
      require(d.post_foot_height > d.nadir_height && std::isfinite(d.post_foot_height),
              "Post foot height", d.post_foot_height, "not above the nadir",
              "choose more than the nadir height, " + text(d.nadir_height));
      require(d.commissure_height > d.post_foot_height && std::isfinite(d.commissure_height),
              "Commissure height", d.commissure_height, "not above the post foot",
              "choose more than the post foot height, " + text(d.post_foot_height));
    }

    void check_deployment(const Design &d, const Requirements &require)
    {
      require(std::abs(d.post_lean) <= largest_lean, "Post lean", d.post_lean, "out of range",
              "choose -30 to 30 degrees");
      // posts that lean inward come closer to each other than the leaflets between them are wide
      const double smallest =
          d.post_width / (2. * std::sin(largest_post_share * dealii::numbers::PI / d.n_leaflets));
      require(d.commissure_radius() >= smallest, "Post lean", d.post_lean,
              "the posts meet: their tops would lie " + text(d.commissure_radius()) +
                  " from the axis",
              "choose a smaller angle or a lower commissure; at least " + text(smallest) +
                  " is needed");
      require(d.expansion >= smallest_expansion && d.expansion <= 1., "Expansion", d.expansion,
              "out of range", "choose 0.5 to 1");
      require(d.ellipticity >= smallest_ellipticity && d.ellipticity <= 1., "Ellipticity",
              d.ellipticity, "out of range", "choose 0.4 to 1");
      require(std::isfinite(d.ellipse_direction), "Ellipse direction", d.ellipse_direction,
              "not an angle", "choose degrees from the x axis");
    }

    void check_unstructured_layout(const UnstructuredLayout &layout, const Requirements &require)
    {
      require(layout.n_core_along >= 4 && layout.n_core_along % 2 == 0,
              "Unstructured/Core elements along", layout.n_core_along,
              "the mesh would not be symmetric or too coarse", "choose an even number from 4 on");
      require(layout.n_core_across >= 2, "Unstructured/Core elements across", layout.n_core_across,
              "an extraordinary point would lie next to the free edge", "choose at least 2");
      require(layout.n_layers >= 2, "Unstructured/Layers", layout.n_layers,
              "an extraordinary point would lie next to the attachment edge", "choose at least 2");
    }

    void check_free_edge_and_belly(const Design &d, const Requirements &require)
    {
      require(d.free_edge_height > d.nadir_height && std::isfinite(d.free_edge_height),
              "Free edge height", d.free_edge_height, "not above the nadir",
              "choose more than the nadir height, " + text(d.nadir_height));
      const double smallest = rounding_margin * d.smallest_gap();
      require(d.free_edge_gap >= smallest, "Free edge gap", d.free_edge_gap,
              "neighboring leaflets would come closer than the post width",
              "choose at least " + text(smallest) + " or smaller posts");
      const double largest = largest_gap_share * std::min(d.radius, d.commissure_radius());
      require(d.free_edge_gap <= largest, "Free edge gap", d.free_edge_gap,
              "the free edge would lie at the wall", "choose at most " + text(largest));
      require(d.belly >= 0. && d.belly <= 1., "Belly", d.belly, "out of range", "choose 0 to 1");
      require(d.belly_height >= -d.radius && d.belly_height < d.free_edge_height, "Belly height",
              d.belly_height, "the belly would lie above the free edge or far below the valve",
              "choose from " + text(-d.radius) + " to below the free edge height, " +
                  text(d.free_edge_height));
      require(d.belly_width >= smallest_belly_width && d.belly_width <= 1., "Belly width",
              d.belly_width, "out of range", "choose 0.3 to 1");
    }

    void check_number_along(const unsigned int n, const std::string &entry,
                            const Requirements &require)
    {
      require(n >= n_base_elements, entry, n, "too few to describe the shape",
              "choose at least " + std::to_string(n_base_elements));
      require(n % 2 == 0, entry, n, "the mesh would not be symmetric", "choose an even number");
    }

    void check_positive(const unsigned int n, const std::string &entry, const Requirements &require)
    {
      require(n >= 1, entry, n, "no elements", "choose at least 1");
    }
  } // namespace

  void Design::add_parameters(ParameterHandler &prm)
  {
    add_boundary_parameters(*this, prm);
    add_belly_parameters(*this, prm);
    add_deployment_parameters(*this, prm);
    add_layout(*this, prm);
    prm.add_parameter(
        "Elements along", n_elements_along,
        "Elements of each leaflet from commissure to commissure in the uniform layout, "
        "even, >= 8; any number describes the same surface",
        Patterns::Integer(n_base_elements));
    prm.add_parameter(
        "Elements across", n_elements_across,
        "Elements of each leaflet from attachment to free edge in the uniform layout, "
        ">= 1",
        Patterns::Integer(1));
    zones.add_parameters(prm);
    add_unstructured_layout(unstructured, prm);
    add_stent_parameters(*this, prm);
  }

  void Design::check(const std::string &section) const
  {
    const Requirements require(section);
    check_attachment(*this, require);
    check_deployment(*this, require);
    check_free_edge_and_belly(*this, require);
    check_number_along(n_elements_along, "Elements along", require);
    check_positive(n_elements_across, "Elements across", require);

    zones.check(section + "/T-spline");
    check_unstructured_layout(unstructured, require);

    require(stent.ring_outer_radius > radius && std::isfinite(stent.ring_outer_radius),
            "Stent/Suture ring outer radius", stent.ring_outer_radius,
            "the ring lies outside of the wall",
            "choose more than the radius of the wall, " + text(radius));
    check_number_along(stent.n_elements_along, "Stent/Elements along", require);
    check_positive(stent.n_wall_elements, "Stent/Wall elements", require);
    check_positive(stent.n_ring_elements, "Stent/Ring elements", require);
    check_positive(stent.n_elements_across_post, "Stent/Elements across post", require);
    check_positive(stent.n_elements_up_post, "Stent/Elements up post", require);
  }

  double Design::half_angle() const
  {
    return dealii::numbers::PI / n_leaflets - std::asin(post_width / (2. * radius));
  }

  double Design::commissure_radius() const
  {
    constexpr double degree = dealii::numbers::PI / 180.;
    return post_lean == 0.
               ? radius
               : radius - (commissure_height - post_foot_height) * std::tan(post_lean * degree);
  }

  double Design::half_commissure_angle() const
  {
    return dealii::numbers::PI / n_leaflets - std::asin(post_width / (2. * commissure_radius()));
  }

  double Design::smallest_gap() const
  {
    return post_width / (2. * std::sin(dealii::numbers::PI / n_leaflets));
  }
} // namespace semilunar::valve
