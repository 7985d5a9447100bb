// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/compat.h>
#include <semilunar/core/exceptions.h>
#include <semilunar/core/first_rank.h>
#include <semilunar/output/cell_numbers.h>
#include <semilunar/output/flow_vtu.h>
#include <semilunar/output/wall_shear_stress.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_out_faces.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <cstdio>

namespace semilunar::output
{
  namespace
  {
    using Interpretation = dealii::DataComponentInterpretation::DataComponentInterpretation;
    constexpr Interpretation scalar = dealii::DataComponentInterpretation::component_is_scalar;
    constexpr Interpretation part_of_vector =
        dealii::DataComponentInterpretation::component_is_part_of_vector;

    /// Vorticity and Q criterion.
    template <int dim>
    class Rotation : public dealii::DataPostprocessor<dim>
    {
    public:
      static constexpr unsigned int n_vorticities = dim == 2 ? 1 : 3;

      std::vector<std::string> get_names() const override
      {
        std::vector<std::string> names(n_vorticities, "vorticity");
        names.push_back("q_criterion");
        return names;
      }

      std::vector<Interpretation> get_data_component_interpretation() const override
      {
        std::vector<Interpretation> all(n_vorticities, dim == 2 ? scalar : part_of_vector);
        all.push_back(scalar);
        return all;
      }

      dealii::UpdateFlags get_needed_update_flags() const override
      {
        return dealii::update_gradients;
      }

      void evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<dim> &in,
                                 std::vector<dealii::Vector<double>> &out) const override
      {
        for (std::size_t q = 0; q < out.size(); ++q)
        {
          const auto &g = in.solution_gradients[q];
          for (unsigned int c = 0; c < n_vorticities; ++c)
          {
            const unsigned int i = dim == 2 ? 0 : (c + 1) % dim, j = dim == 2 ? 1 : (c + 2) % dim;
            out[q][c] = g[j][i] - g[i][j];
          }
          double trace = 0.; // of the squared gradient
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              trace += g[i][j] * g[j][i];
          out[q][n_vorticities] = -0.5 * trace;
        }
      }
    };

    /// Wall shear stress, as a vector and its magnitude.
    template <int dim>
    class ShearStress : public dealii::DataPostprocessor<dim>
    {
    public:
      explicit ShearStress(const double viscosity) : viscosity(viscosity) {}

      std::vector<std::string> get_names() const override
      {
        std::vector<std::string> names(dim, "wall_shear_stress");
        names.push_back("wall_shear_stress_magnitude");
        return names;
      }

      std::vector<Interpretation> get_data_component_interpretation() const override
      {
        std::vector<Interpretation> all(dim, part_of_vector);
        all.push_back(scalar);
        return all;
      }

      dealii::UpdateFlags get_needed_update_flags() const override
      {
        return dealii::update_gradients | dealii::update_normal_vectors;
      }

      void evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<dim> &in,
                                 std::vector<dealii::Vector<double>> &out) const override
      {
        for (std::size_t q = 0; q < out.size(); ++q)
        {
          dealii::Tensor<2, dim> gradient;
          for (unsigned int i = 0; i < dim; ++i)
            gradient[i] = in.solution_gradients[q][i];
          const auto stress = wall_shear_stress(gradient, in.normals[q], viscosity);
          for (unsigned int i = 0; i < dim; ++i)
            out[q][i] = stress[i];
          out[q][dim] = stress.norm();
        }
      }

    private:
      const double viscosity;
    };

    /// The faces between blood and walls.
    template <int dim>
    class WallFaces : public dealii::DataOutFaces<dim>
    {
    public:
      using Face = typename dealii::DataOutFaces<dim>::FaceDescriptor;

      explicit WallFaces(const std::set<dealii::types::boundary_id> &walls)
          : dealii::DataOutFaces<dim>(false), walls(walls)
      {
      }

      Face first_face() override { return skip_others(dealii::DataOutFaces<dim>::first_face()); }

      Face next_face(const Face &face) override
      {
        return skip_others(dealii::DataOutFaces<dim>::next_face(face));
      }

    private:
      Face skip_others(Face face)
      {
        while (face.first != this->triangulation->end() &&
               !is_at_wall(face.first, face.second, walls))
          face = dealii::DataOutFaces<dim>::next_face(face);
        return face;
      }

      const std::set<dealii::types::boundary_id> walls;
    };

    /// Write what all ranks have into one file.
    template <class Data>
    void write_vtu(Data &data, const std::filesystem::path &filename, const double time,
                   const bool high_order, const MPI_Comm communicator)
    {
      data.set_flags(fast_vtk_flags(time, high_order));
      try
      {
        data.write_vtu_in_parallel(filename.string(), communicator);
      }
      catch (const dealii::ExceptionBase &)
      {
        throw InputError(filename.string(), "", "the file cannot be written",
                         "choose an output folder that is writable and has space left");
      }
    }
  } // namespace

  void FlowVtuParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Interval", interval,
                      "Time between VTU files [s]; 0: the first and the last state only",
                      dealii::Patterns::Double(0.));
    prm.add_parameter(
        "High order", high_order,
        "VTU cells of the velocity's degree (ParaView 5.5 or newer) instead of linear "
        "ones into which each is divided");
    prm.add_parameter("Walls", wall, "Whether to write VTU files of the walls");
    prm.add_parameter("Derived fields", derived,
                      "Whether the VTU files have vorticity, Q criterion, and the Reynolds and CFL "
                      "numbers of the cells");
  }

  template <int dim>
  FlowVtu<dim>::FlowVtu(const std::filesystem::path &folder, const FlowVtuParameters &parameters,
                        std::set<dealii::types::boundary_id> walls)
      : folder(folder), parameters(parameters), walls(std::move(walls)),
        flow_collection((folder / "flow.pvd").string()),
        wall_collection((folder / "wall.pvd").string())
  {
  }

  template <int dim>
  std::string FlowVtu<dim>::write(const FlowState<dim> &state)
  {
    dealii::DataOut<dim> data;
    const Rotation<dim> rotation;
    data.attach_triangulation(state.triangulation());
    data.add_data_vector(state.velocity_dofs, state.velocity,
                         std::vector<std::string>(dim, "velocity"),
                         std::vector<Interpretation>(dim, part_of_vector));
    data.add_data_vector(state.pressure_dofs, state.pressure, "pressure");
    const bool has_wall = state.has_wall();
    dealii::Vector<float> in_wall;
    if (has_wall)
    {
      in_wall.reinit(state.triangulation().n_active_cells());
      for (const auto &cell : state.triangulation().active_cell_iterators())
        in_wall[cell->active_cell_index()] = cell->material_id() == mesh::wall;
      data.add_data_vector(in_wall, "in_wall");
    }
    CellNumbers numbers;
    if (parameters.derived)
    {
      data.add_data_vector(state.velocity_dofs, state.velocity, rotation);
      numbers = cell_numbers(state);
      data.add_data_vector(numbers.reynolds, "cell_reynolds");
      data.add_data_vector(numbers.cfl, "cfl");
    }
    data.build_patches(state.mapping, state.degree(), dealii::DataOut<dim>::curved_inner_cells);

    char number[16];
    std::snprintf(number, sizeof(number), "%04u.vtu", n_written++);
    const std::string name = std::string("flow-") + number;
    write_vtu(data, folder / name, state.time, parameters.high_order, state.communicator());
    on_first_rank([&]() { flow_collection.add(state.time, name); });
    if (parameters.wall && (has_wall || !walls.empty()))
      write_walls(state, number);
    return name;
  }

  template <int dim>
  void FlowVtu<dim>::write_walls(const FlowState<dim> &state, const std::string &number)
  {
    WallFaces<dim> data(walls);
    const ShearStress<dim> stress(state.viscosity);
    data.attach_triangulation(state.triangulation());
    data.add_data_vector(state.velocity_dofs, state.velocity, stress);
    data.add_data_vector(state.pressure_dofs, state.pressure, "pressure");
    data.build_patches(state.mapping, state.degree());
    const std::string name = "wall-" + number;
    write_vtu(data, folder / name, state.time, parameters.high_order, state.communicator());
    on_first_rank([&]() { wall_collection.add(state.time, name); });
  }

  template class FlowVtu<2>;
  template class FlowVtu<3>;
} // namespace semilunar::output
