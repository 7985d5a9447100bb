// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/archive.h>
#include <semilunar/core/first_rank.h>
#include <semilunar/scene/flow_checkpoint.h>

#include <fstream>

namespace semilunar::scene
{
  template <int dim>
  void save_flow(flow::FlowSolver<dim> &flow, mesh::Mesh<dim> &mesh,
                 const std::filesystem::path &folder)
  {
    const std::vector<double> numbers = flow.save_state();
    mesh.triangulation.save((folder / "mesh").string());
    on_first_rank(
        [&]()
        {
          std::ofstream file(folder / "numbers", std::ios::binary);
          boost::archive::binary_oarchive(file) << numbers;
        });
  }

  template <int dim>
  void load_flow(flow::FlowSolver<dim> &flow, mesh::Mesh<dim> &mesh,
                 const std::filesystem::path &folder)
  {
    mesh.triangulation.load((folder / "mesh").string());
    std::vector<double> numbers;
    std::ifstream file(folder / "numbers", std::ios::binary);
    boost::archive::binary_iarchive(file) >> numbers;
    flow.load_state(numbers);
  }

  void add_structure(Checkpoints &checkpoints, coupling::FluidStructure &coupled,
                     coupling::ShellInFlow *const shell, const ShellModel *const model)
  {
    checkpoints.add(
        "structure",
        [&coupled, shell](std::ostream &out)
        {
          boost::archive::binary_oarchive archive(out);
          if (shell)
          {
            const coupling::ShellInFlow::State state = shell->state();
            const coupling::PointNumbers numbers = coupled.numbers_of_points();
            archive << state << numbers;
          }
          archive << coupled.multipliers();
        },
        [&coupled, shell](std::istream &in)
        {
          coupling::ShellInFlow::State state;
          coupling::PointNumbers numbers;
          std::vector<double> multipliers;
          boost::archive::binary_iarchive archive(in);
          if (shell)
          {
            archive >> state >> numbers;
            shell->set_state(state);
          }
          archive >> multipliers;
          coupled.set_points(numbers, multipliers);
        });
    if (model && model->contact)
      checkpoints.add_object("contact", *model->contact);
  }

  template void save_flow(flow::FlowSolver<2> &, mesh::Mesh<2> &, const std::filesystem::path &);
  template void save_flow(flow::FlowSolver<3> &, mesh::Mesh<3> &, const std::filesystem::path &);
  template void load_flow(flow::FlowSolver<2> &, mesh::Mesh<2> &, const std::filesystem::path &);
  template void load_flow(flow::FlowSolver<3> &, mesh::Mesh<3> &, const std::filesystem::path &);
} // namespace semilunar::scene
