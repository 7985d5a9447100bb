// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/shell/contact.h>

#include <deal.II/base/parallel.h>

#include <algorithm>
#include <limits>
#include <tuple>

namespace semilunar::shell
{
  using namespace spline;

  namespace
  {
    void require(const bool good, const std::string &entry, const double value,
                 const std::string &allowed)
    {
      if (!good)
        throw InputError("Contact/" + entry, std::to_string(value), "out of range",
                         "allowed: " + allowed);
    }

    const ContactParameters &checked(const ContactParameters &p)
    {
      const double largest = std::numeric_limits<double>::max();
      require(p.distance > 0. && p.distance <= largest, "Distance", p.distance, "a number > 0");
      require(p.stiffness > 0. && p.stiffness <= largest, "Stiffness", p.stiffness, "a number > 0");
      require(p.smoothing >= 0. && p.smoothing <= largest, "Smoothing", p.smoothing,
              "a number >= 0");
      require(p.self_distance == 0. ||
                  (p.self_distance >= p.distance && p.self_distance <= largest),
              "Self distance", p.self_distance,
              "0 or a number not below Distance, or undeformed neighbors would touch");
      return p;
    }

    /// Far enough to let points move by several contact distances per load step, and no less than
    /// the spacing of the points.
    double choose_reach(const QuadraturePoints &points, const double contact_distance)
    {
      constexpr double steps = 3.; // contact distances
      double area = 0.;
      for (unsigned int q = 0; q < points.n_points(); ++q)
        area += points.weight(q);
      const double spacing = std::sqrt(area / std::max(1u, points.n_points()));
      return contact_distance + std::max(steps * contact_distance, spacing);
    }

    /// Finite, and within what the cells of the search can count.
    bool can_be_searched(const std::vector<Tensor<1, 3>> &x, const double reach)
    {
      constexpr double most_cells = 1e15;
      for (const Tensor<1, 3> &position : x)
        for (unsigned int d = 0; d < 3; ++d)
          if (!(std::abs(position[d]) < most_cells * reach))
            return false;
      return true;
    }
  } // namespace

  /// The contact points of a range of quadrature points.
  struct Contact::Found
  {
    std::vector<ContactPoint> near;
    std::vector<Detail> details;
    unsigned long projections = 0;
  };

  Contact::Contact(const Surface &surface, const QuadraturePoints &points,
                   const ContactParameters &parameters, const CyclicSymmetry &symmetry)
      : surface(surface), points(points), law{checked(parameters).stiffness, parameters.smoothing},
        symmetry(symmetry), distance(parameters.distance),
        reach_distance(choose_reach(points, parameters.distance)),
        search(surface, points, reach_distance, parameters.self_distance, symmetry),
        memory(points.n_points())
  {
    remember_undeformed_state();
  }

  void Contact::remember_undeformed_state()
  {
    constexpr double rounding = 1e-10; // so that rounding does not close the undeformed gaps
    update(positions(surface));
    for (unsigned int i = 0; i < near.size(); ++i)
      if (details[i].foot.distance < distance)
        undeformed_distances[{near[i].q, details[i].part}] =
            (1. - rounding) * details[i].foot.distance;
    accept();
  }

  double Contact::contact_distance(const unsigned int q, const unsigned int part) const
  {
    const auto closer = undeformed_distances.find({q, part});
    return closer == undeformed_distances.end() ? distance : closer->second;
  }

  int Contact::side_of(const unsigned int q, const ContactSearch::Neighbor &neighbor) const
  {
    const int side_now = neighbor.foot.side();
    const SideMemory::Entry *known = memory.find(q, neighbor.part);
    if (!known || known->side == side_now)
      return side_now;
    // On the other side now: pushed through, unless this foot belongs to another layer of the part,
    // too far away for the foot to have slid there.
    const double slid =
        (search.undeformed_position(neighbor.point) - search.undeformed_position(known->foot))
            .norm();
    return slid > 2. * reach_distance ? side_now : known->side;
  }

  void Contact::append(const unsigned int q, const ContactSearch::Neighbor &neighbor,
                       Found &found) const
  {
    const ContactFoot &foot = neighbor.foot;
    const int side = side_of(q, neighbor);
    const DirectedDistance directed = directed_distance(foot, side);
    // past an edge, behind the remembered side: the surface is not in the way
    const bool is_blocked = foot.on_face() || !foot.side_is_plain() || foot.side() == side;
    const double gap = directed.value - (is_blocked ? contact_distance(q, neighbor.part) : 0.);
    double pressure = 0., slope = 0.;
    if (is_blocked && share_of_step == 1.)
    {
      pressure = law.value(-gap);
      slope = law.slope(-gap);
    }
    else if (is_blocked)
    {
      const double start = start_gap(q, neighbor.part);
      const double end = start + (gap - start) / share_of_step;
      pressure = law.mean(-start, -end);
      slope = law.mean_slope(-start, -end) / share_of_step;
    }
    found.near.push_back({q, neighbor.point, neighbor.image, directed.direction, gap, pressure});
    found.details.push_back({neighbor.part, side, foot, slope});
  }

  double Contact::start_gap(const unsigned int q, const unsigned int part) const
  {
    const auto before = [](const StartGap &a, const std::pair<unsigned int, unsigned int> &b)
    { return std::tie(a.q, a.part) < std::tie(b.first, b.second); };
    const auto found =
        std::lower_bound(start_gaps.begin(), start_gaps.end(), std::make_pair(q, part), before);
    if (found != start_gaps.end() && found->q == q && found->part == part)
      return found->gap;
    return reach_distance - contact_distance(q, part); // at least
  }

  void Contact::set_share_of_step(const double share)
  {
    if (share == share_of_step)
      return;
    share_of_step = share;
    found_at.clear();
  }

  void Contact::find_partners()
  {
    constexpr unsigned int points_per_range = 512; // fixed: the order is the same on any machine
    std::vector<Found> found((points.n_points() + points_per_range - 1) / points_per_range);
    const auto work = [&](const unsigned int begin, const unsigned int end)
    {
      std::vector<ContactSearch::Neighbor> neighbors;
      for (unsigned int range = begin; range < end; ++range)
        for (unsigned int q = range * points_per_range;
             q < std::min((range + 1) * points_per_range, points.n_points()); ++q)
        {
          found[range].projections += search.find(q, neighbors);
          for (const ContactSearch::Neighbor &neighbor : neighbors)
            append(q, neighbor, found[range]);
        }
    };
    dealii::parallel::apply_to_subranges(0u, static_cast<unsigned int>(found.size()), work, 1);

    for (const Found &range : found)
    {
      near.insert(near.end(), range.near.begin(), range.near.end());
      details.insert(details.end(), range.details.begin(), range.details.end());
      projections += range.projections;
    }
  }

  void Contact::evaluate_partner_bases()
  {
    std::size_t n_values = 0;
    for (unsigned int i = 0; i < near.size(); ++i)
      if (near[i].pressure > 0.)
      {
        active.push_back(i);
        partner_offsets.push_back(n_values);
        n_values += 3 * surface.elements[near[i].partner.element].n_functions();
      }
    partner_bases.resize(n_values);
    const auto work = [&](const unsigned int begin, const unsigned int end)
    {
      BasisValues basis;
      for (unsigned int k = begin; k < end; ++k)
      {
        const SurfacePoint &partner = near[active[k]].partner;
        evaluate_basis(surface, partner.element, partner.xi, basis);
        double *values = &partner_bases[partner_offsets[k]];
        for (const unsigned int derivative : {spline::value, d1, d2})
          values =
              std::copy(basis.values[derivative].begin(), basis.values[derivative].end(), values);
      }
    };
    constexpr unsigned int grain = 64;
    dealii::parallel::apply_to_subranges(0u, static_cast<unsigned int>(active.size()), work, grain);
  }

  void Contact::update(const std::vector<Tensor<1, 3>> &x)
  {
    if (x == found_at)
      return;
    found_at = x;
    near.clear();
    details.clear();
    active.clear();
    partner_bases.clear();
    partner_offsets.clear();
    projections = 0;
    is_finite = can_be_searched(x, reach_distance);
    if (!is_finite)
      return;
    search.update(x);
    find_partners();
    evaluate_partner_bases();
  }

  void Contact::accept()
  {
    found_at.clear(); // with other sides remembered, the same positions may mean other contacts
    start_gaps.clear();
    for (unsigned int i = 0; i < near.size(); ++i)
      start_gaps.push_back({near[i].q, details[i].part, near[i].gap});
    std::vector<SideMemory::Entry> entries;
    for (unsigned int i = 0; i < near.size(); ++i)
    {
      const ContactFoot &foot = details[i].foot;
      if (!foot.side_is_plain())
        continue;
      const bool is_apart = foot.distance >= contact_distance(near[i].q, details[i].part);
      const bool passed_around_edge = !foot.on_face() && is_apart;
      entries.push_back({near[i].q, details[i].part,
                         passed_around_edge ? foot.side() : details[i].side, near[i].partner});
    }
    memory.replace(std::move(entries));
  }

  double Contact::energy() const
  {
    if (!is_finite)
      return std::numeric_limits<double>::quiet_NaN();
    double sum = 0.;
    for (const unsigned int i : active)
      sum += 0.5 * points.weight(near[i].q) * law.energy(-near[i].gap);
    return sum;
  }

  void Contact::add_gradient(std::vector<Tensor<1, 3>> &gradient) const
  {
    for (unsigned int k = 0; k < active.size(); ++k)
    {
      const ContactPoint &point = near[active[k]];
      const BezierElement &own = surface.elements[points.element(point.q)];
      const BezierElement &partner = surface.elements[point.partner.element];
      const Tensor<1, 3> force =
          -0.5 * points.weight(point.q) * point.pressure * point.normal; // (C5)
      const double *own_basis = points.basis(point.q, spline::value);
      const double *partner_basis = partner_bases.data() + partner_offsets[k];
      const Tensor<1, 3> force_on_partner =
          point.image == 0 ? -force : -(transpose(symmetry.turn(point.image)) * force); // (C9)
      for (unsigned int a = 0; a < own.n_functions(); ++a)
        gradient[own.control_points[a]] += own_basis[a] * force;
      for (unsigned int a = 0; a < partner.n_functions(); ++a)
        gradient[partner.control_points[a]] += partner_basis[a] * force_on_partner;
    }
  }
} // namespace semilunar::shell
