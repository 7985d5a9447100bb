// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/mesh/refinement.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/distributed/grid_refinement.h>

#include <algorithm>
#include <functional>
#include <set>

namespace semilunar::mesh
{
  namespace
  {
    template <int dim>
    using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;

    /// Refine the cells that are wanted, so many times.
    template <int dim>
    void refine_where(Mesh<dim> &mesh, const unsigned int n_times,
                      const std::function<bool(const Cell<dim> &)> &wanted)
    {
      for (unsigned int i = 0; i < n_times; ++i)
      {
        for (const auto &cell : mesh.triangulation.active_cell_iterators())
          if (cell->is_locally_owned() && wanted(cell))
            cell->set_refine_flag();
        mesh.triangulation.execute_coarsening_and_refinement();
      }
    }

    template <int dim>
    bool lies_in(const dealii::Point<dim> &p, const std::vector<double> &box)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (p[d] < box[d] || p[d] > box[dim + d])
          return false;
      return true;
    }
  } // namespace

  void RefinementParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.add_parameter("Refinements", n_global, "How often all cells are halved in each direction",
                      Patterns::Integer(0, 10));
    prm.add_parameter(
        "Box refinements", n_boxes,
        "How often the cells with their centre in one of the boxes are refined further",
        Patterns::Integer(0, 10));
    prm.add_parameter("Boxes", boxes,
                      "Two opposite corners of each box, x, y, z, x, y, z [cm], in the plane x, y, "
                      "x, y; boxes separated by semicolons",
                      Patterns::List(Patterns::List(Patterns::Double(), 4, 6), 0,
                                     Patterns::List::max_int_value, ";"));
    prm.add_parameter("Boundary refinements", n_boundaries,
                      "How often the cells at the refined boundaries are refined further",
                      Patterns::Integer(0, 10));
    prm.add_parameter("Refined boundaries", boundaries, "Names of the refined boundaries",
                      Patterns::List(Patterns::Anything()));
  }

  void RefinementParameters::check(const unsigned int dim) const
  {
    for (const auto &box : boxes)
      if (box.size() != 2 * dim)
        throw InputError("Mesh/Boxes", std::to_string(box.size()) + " numbers",
                         "a box has two corners",
                         "give " + std::to_string(2 * dim) + " numbers for each box");
  }

  template <int dim>
  void refine(Mesh<dim> &mesh, const RefinementParameters &parameters)
  {
    std::set<dealii::types::boundary_id> refined_ids;
    for (const std::string &name : parameters.boundaries)
      refined_ids.insert(mesh.boundary_id(name, "Mesh/Refined boundaries"));
    refine_where<dim>(mesh, parameters.n_global, [](const auto &) { return true; });
    refine_where<dim>(mesh, parameters.n_boxes,
                      [&](const auto &cell)
                      {
                        return std::any_of(parameters.boxes.begin(), parameters.boxes.end(),
                                           [&](const auto &box)
                                           { return lies_in<dim>(cell->center(), box); });
                      });
    refine_where<dim>(mesh, parameters.n_boundaries,
                      [&](const auto &cell)
                      {
                        for (const auto &face : cell->face_iterators())
                          if (face->at_boundary() && refined_ids.count(face->boundary_id()) > 0)
                            return true;
                        return false;
                      });
  }

  void AdaptivityParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.enter_subsection("Adaptivity");
    prm.add_parameter("Interval", interval,
                      "Time steps between changes of the mesh; 0: the mesh does not change",
                      Patterns::Integer(0));
    prm.add_parameter("Refined share", refined_share,
                      "Share of the cells that are refined, 0 to 1 [-]", Patterns::Double(0., 1.));
    prm.add_parameter("Coarsened share", coarsened_share,
                      "Share of the cells that are coarsened, 0 to 1 [-]",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Largest number of cells", max_cells,
                      "No cells are refined beyond about this number", Patterns::Integer(1));
    prm.add_parameter("Largest level", max_level,
                      "How often a cell of the coarse mesh may be refined",
                      Patterns::Integer(0, 10));
    prm.add_parameter("Vorticity weight", vorticity_weight,
                      "Weight of the vorticity beside the jumps of the velocity's gradient in the "
                      "error indicator [-], >= 0",
                      Patterns::Double(0.));
    prm.leave_subsection();
  }

  template <int dim>
  bool flag_cells(Mesh<dim> &mesh, const dealii::Vector<float> &indicators,
                  const AdaptivityParameters &parameters)
  {
    AssertDimension(indicators.size(), mesh.triangulation.n_active_cells());
    dealii::parallel::distributed::GridRefinement::refine_and_coarsen_fixed_number(
        mesh.triangulation, indicators, parameters.refined_share, parameters.coarsened_share,
        parameters.max_cells);
    unsigned int n_flagged = 0;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        if (static_cast<unsigned int>(cell->level()) >= parameters.max_level)
          cell->clear_refine_flag();
        n_flagged += cell->refine_flag_set() || cell->coarsen_flag_set();
      }
    return dealii::Utilities::MPI::sum(n_flagged, mesh.triangulation.get_communicator()) > 0;
  }

  template void refine(Mesh<2> &, const RefinementParameters &);
  template void refine(Mesh<3> &, const RefinementParameters &);
  template bool flag_cells(Mesh<2> &, const dealii::Vector<float> &, const AdaptivityParameters &);
  template bool flag_cells(Mesh<3> &, const dealii::Vector<float> &, const AdaptivityParameters &);
} // namespace semilunar::mesh
