// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/mesh/cylinder_channel.h>
#include <semilunar/mesh/parameters.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>

namespace semilunar::mesh
{
  namespace
  {
    using dealii::Point;
    using dealii::Triangulation;

    // Schaefer and Turek 1996; lengths as printed there.
    constexpr double height = 0.41, radius = 0.05, length_downstream = 2.2, length_upstream = 0.3;
    const Point<2> centre(0.2, 0.2);

    /// Ids of deal.II's generator.
    enum ManifoldId : dealii::types::manifold_id
    {
      polar = 0,
      transfinite = 1
    };

    enum BoundaryId : dealii::types::boundary_id
    {
      inlet = 0,
      outlet = 1,
      cylinder = 2,
      walls = 3
    };

    void make_plane(Triangulation<2> &plane, const CylinderChannelParameters &parameters)
    {
      dealii::GridGenerator::channel_with_cylinder(plane, parameters.shell_width,
                                                   parameters.n_shells, parameters.skewness, true);
    }

    /// The cells upstream of the plane mesh, with its points on the common edge.
    void make_upstream(const Triangulation<2> &plane, Triangulation<2> &upstream)
    {
      std::vector<double> y;
      for (const Point<2> &vertex : plane.get_vertices())
        if (std::abs(vertex[0]) < 1e-10)
          y.push_back(vertex[1]);
      std::sort(y.begin(), y.end());
      std::vector<double> steps;
      for (std::size_t i = 1; i < y.size(); ++i)
        steps.push_back(y[i] - y[i - 1]);
      const unsigned int n = std::lround(length_upstream * steps.size() / height);
      dealii::GridGenerator::subdivided_hyper_rectangle(
          upstream, {std::vector<double>(n, length_upstream / n), steps},
          Point<2>(-length_upstream, 0.), Point<2>(0., height));
    }

    void set_manifolds(Triangulation<2> &triangulation)
    {
      triangulation.set_manifold(polar, dealii::PolarManifold<2>(centre));
    }

    void set_manifolds(Triangulation<3> &triangulation)
    {
      triangulation.set_manifold(polar, dealii::CylindricalManifold<3>(
                                            dealii::Tensor<1, 3>({0., 0., 1.}),
                                            Point<3>(centre[0] + length_upstream, centre[1], 0.)));
    }

    template <int dim>
    bool at_cylinder(const Point<dim> &p)
    {
      const Point<2> section(p[0] - (dim == 3 ? length_upstream : 0.), p[1]);
      return std::abs(section.distance(centre) - radius) < 1e-6;
    }

    template <int dim>
    void set_boundaries(Triangulation<dim> &triangulation)
    {
      const double end = length_downstream + (dim == 3 ? length_upstream : 0.);
      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
          {
            const auto all = [&](const auto &condition)
            {
              const auto indices = face->vertex_indices();
              return std::all_of(indices.begin(), indices.end(),
                                 [&](const unsigned int v) { return condition(face->vertex(v)); });
            };
            if (all([](const auto &p) { return p[0] < 1e-10; }))
              face->set_boundary_id(inlet);
            else if (all([end](const auto &p) { return p[0] > end - 1e-10; }))
              face->set_boundary_id(outlet);
            else
              face->set_boundary_id(all(at_cylinder<dim>) ? cylinder : walls);
          }
    }

    /// The mesh as a serial one, with manifold ids.
    void make_serial(Triangulation<2> &serial, const CylinderChannelParameters &parameters)
    {
      make_plane(serial, parameters);
    }

    void make_serial(Triangulation<3> &serial, const CylinderChannelParameters &parameters)
    {
      Triangulation<2> plane, upstream, merged;
      make_plane(plane, parameters);
      make_upstream(plane, upstream);
      dealii::GridGenerator::merge_triangulations(plane, upstream, merged, 1e-10, true);
      dealii::GridTools::shift(Point<2>(length_upstream, 0.), merged);
      dealii::GridGenerator::extrude_triangulation(
          merged, parameters.n_cells_deep + 1, height, serial, true,
          {polar, transfinite, dealii::numbers::flat_manifold_id});
    }
  } // namespace

  template <int dim>
  void make_cylinder_channel(Mesh<dim> &mesh, const CylinderChannelParameters &parameters)
  {
    Triangulation<dim> serial;
    make_serial(serial, parameters);
    serial.reset_all_manifolds(); // the copy gets its own
    mesh.triangulation.copy_triangulation(serial);
    set_manifolds(mesh.triangulation);
    dealii::TransfiniteInterpolationManifold<dim> inner;
    inner.initialize(mesh.triangulation);
    mesh.triangulation.set_manifold(transfinite, inner);
    set_boundaries(mesh.triangulation);
    mesh.boundary_ids = {
        {"inlet", inlet}, {"outlet", outlet}, {"cylinder", cylinder}, {"wall", walls}};
  }

  template void make_cylinder_channel(Mesh<2> &, const CylinderChannelParameters &);
  template void make_cylinder_channel(Mesh<3> &, const CylinderChannelParameters &);
} // namespace semilunar::mesh
