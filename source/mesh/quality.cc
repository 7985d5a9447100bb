// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/mesh/quality.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cstdio>
#include <limits>

namespace semilunar::mesh
{
  namespace
  {
    /// Determinant of the normalised columns of the mapping's gradient.
    template <int dim>
    double scaled_jacobian(const dealii::DerivativeForm<1, dim, dim> &gradient)
    {
      dealii::Tensor<2, dim> columns;
      for (unsigned int j = 0; j < dim; ++j)
      {
        dealii::Tensor<1, dim> column;
        for (unsigned int i = 0; i < dim; ++i)
          column[i] = gradient[i][j];
        columns[j] = column / column.norm();
      }
      return dealii::determinant(columns);
    }

    struct Sums
    {
      double min_jacobian = std::numeric_limits<double>::infinity(), sum_jacobian = 0.;
      double min_size = std::numeric_limits<double>::infinity(), max_size = 0., volume = 0.;
      dealii::types::global_cell_index n_cells = 0;
    };

    template <int dim>
    Sums measure_local(const dealii::Triangulation<dim> &triangulation,
                       const dealii::Mapping<dim> &mapping, const Material material)
    {
      const dealii::FE_Nothing<dim> fe;
      const dealii::QGaussLobatto<dim> corners(3);
      const dealii::QGauss<dim> inside(4);
      dealii::FEValues<dim> at_corners(mapping, fe, corners, dealii::update_jacobians);
      dealii::FEValues<dim> at_inside(mapping, fe, inside, dealii::update_JxW_values);
      Sums sums;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() == material)
        {
          at_corners.reinit(cell);
          at_inside.reinit(cell);
          double smallest = std::numeric_limits<double>::infinity();
          for (const auto &gradient : at_corners.get_jacobians())
            smallest = std::min(smallest, scaled_jacobian(gradient));
          for (const double JxW : at_inside.get_JxW_values())
            sums.volume += JxW;
          sums.min_jacobian = std::min(sums.min_jacobian, smallest);
          sums.sum_jacobian += smallest;
          sums.min_size = std::min(sums.min_size, cell->minimum_vertex_distance());
          sums.max_size = std::max(sums.max_size, cell->diameter());
          ++sums.n_cells;
        }
      return sums;
    }
  } // namespace

  template <int dim>
  Quality measure(const dealii::Triangulation<dim> &triangulation,
                  const dealii::Mapping<dim> &mapping, const Material material)
  {
    namespace MPI = dealii::Utilities::MPI;
    const MPI_Comm communicator = triangulation.get_communicator();
    const Sums local = measure_local(triangulation, mapping, material);
    Quality quality;
    quality.n_cells = MPI::sum(local.n_cells, communicator);
    quality.min_scaled_jacobian = MPI::min(local.min_jacobian, communicator);
    quality.mean_scaled_jacobian = MPI::sum(local.sum_jacobian, communicator) / quality.n_cells;
    quality.min_size = MPI::min(local.min_size, communicator);
    quality.max_size = MPI::max(local.max_size, communicator);
    quality.volume = MPI::sum(local.volume, communicator);
    return quality;
  }

  std::string describe(const Quality &quality)
  {
    char text[160];
    std::snprintf(text, sizeof(text),
                  "%llu cells, scaled Jacobian >= %.2f (mean %.2f), sizes %.3g to %.3g",
                  static_cast<unsigned long long>(quality.n_cells), quality.min_scaled_jacobian,
                  quality.mean_scaled_jacobian, quality.min_size, quality.max_size);
    return text;
  }

  template Quality measure(const dealii::Triangulation<2> &, const dealii::Mapping<2> &, Material);
  template Quality measure(const dealii::Triangulation<3> &, const dealii::Mapping<3> &, Material);
} // namespace semilunar::mesh
