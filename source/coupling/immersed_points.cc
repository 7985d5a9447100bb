// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/coupling/immersed_points.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/cell_id.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace semilunar::coupling
{
  ImmersedPoints::ImmersedPoints(const flow::FlowSolver<3> &flow,
                                 const std::vector<Position> &positions)
      : flow(flow), communicator(flow.spaces().communicator()), map(flow),
        participants(positions.size(), true)
  {
    search_all(positions);
    exclude_missing();
  }

  void ImmersedPoints::exclude_missing()
  {
    for (const unsigned int q : missing())
      participants[q] = false;
  }

  void ImmersedPoints::search_again(const std::vector<Position> &positions)
  {
    const unsigned int inside_before = inside;
    search_all(positions);
    if (inside < inside_before)
      throw_lost(positions);
  }

  void ImmersedPoints::search_all(const std::vector<Position> &positions)
  {
    std::vector<unsigned int> all;
    for (unsigned int q = 0; q < participants.size(); ++q)
      if (participants[q])
        all.push_back(q);
    held.clear();
    search(positions, all);
    collect();
  }

  void ImmersedPoints::search(const std::vector<Position> &positions,
                              const std::vector<unsigned int> &which)
  {
    const std::vector<CellMap::Place> places = map.search(positions, which);
    const CellMap::Cell nowhere = flow.spaces().velocity_dofs().end();
    const unsigned int this_rank = dealii::Utilities::MPI::this_mpi_process(communicator);
    std::vector<unsigned int> owners(which.size(), dealii::numbers::invalid_unsigned_int);
    for (unsigned int i = 0; i < which.size(); ++i)
      if (places[i].cell != nowhere)
        owners[i] = this_rank;
    // A point on the border of two ranks goes to the first of them.
    dealii::Utilities::MPI::min(owners, communicator, owners);
    for (unsigned int i = 0; i < which.size(); ++i)
      if (owners[i] == this_rank)
        held.push_back({which[i], places[i]});
  }

  void ImmersedPoints::collect()
  {
    std::sort(held.begin(), held.end(), [](const Held &a, const Held &b) { return a.q < b.q; });
    of_this_rank.clear();
    for (const Held &point : held)
      of_this_rank.push_back(
          {point.q, point.place.cell->active_cell_index(), point.place.unit_point});
    inside = dealii::Utilities::MPI::sum(static_cast<unsigned int>(held.size()), communicator);
  }

  std::vector<unsigned int> ImmersedPoints::missing() const
  {
    std::vector<unsigned int> found(participants.size(), 0);
    for (const Local &point : of_this_rank)
      found[point.q] = 1;
    dealii::Utilities::MPI::max(found, communicator, found);
    std::vector<unsigned int> result;
    for (unsigned int q = 0; q < found.size(); ++q)
      if (participants[q] && found[q] == 0)
        result.push_back(q);
    return result;
  }

  void ImmersedPoints::hand_over(const std::vector<Position> &positions,
                                 const std::vector<Held> &leaving)
  {
    using Message = std::vector<std::pair<unsigned int, dealii::CellId>>;
    std::map<unsigned int, Message> messages;
    for (const Held &point : leaving)
      messages[point.place.cell->subdomain_id()].emplace_back(point.q, point.place.cell->id());
    const auto &handler = flow.spaces().velocity_dofs();
    for (const auto &[rank, message] : dealii::Utilities::MPI::some_to_some(communicator, messages))
      for (const auto &[q, id] : message)
      {
        const auto cell = handler.get_triangulation().create_cell_iterator(id);
        const CellMap::Place guess{
            CellMap::Cell(&handler.get_triangulation(), cell->level(), cell->index(), &handler),
            dealii::Point<3>(0.5, 0.5, 0.5)};
        const CellMap::Place place = map.find(positions[q], guess);
        if (place.cell != handler.end() && place.cell->is_locally_owned())
          held.push_back({q, place});
      }
  }

  void ImmersedPoints::move(const std::vector<Position> &positions)
  {
    Assert(positions.size() >= participants.size(), dealii::ExcInternalError());
    const unsigned int inside_before = inside;
    walk(positions);
    if (inside == inside_before)
      return;
    // Points that the walk has lost are searched in the whole mesh.
    search(positions, missing());
    collect();
    if (inside < inside_before)
      throw_lost(positions);
  }

  void ImmersedPoints::follow_mesh(const std::vector<Position> &positions)
  {
    walk(positions);
    participants.assign(participants.size(), true);
    search(positions, missing());
    collect();
    exclude_missing();
  }

  void ImmersedPoints::walk(const std::vector<Position> &positions)
  {
    std::vector<Held> staying, leaving;
    for (const Held &point : held)
    {
      const CellMap::Place place = map.find(positions[point.q], point.place);
      if (place.cell == flow.spaces().velocity_dofs().end())
        continue;
      (place.cell->is_locally_owned() ? staying : leaving).push_back({point.q, place});
    }
    held = std::move(staying);
    hand_over(positions, leaving);
    collect();
  }

  void ImmersedPoints::throw_lost(const std::vector<Position> &positions) const
  {
    std::ostringstream text;
    text << "a point of an immersed surface has left the fluid, at "
         << dealii::Point<3>(positions[missing().front()]);
    throw NumericsError(text.str(), "t = " + std::to_string(flow.time()), "");
  }
} // namespace semilunar::coupling
