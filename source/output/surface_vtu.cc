// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/output/bezier_cell.h>
#include <semilunar/output/surface_vtu.h>
#include <semilunar/output/vtu_file.h>
#include <semilunar/spline/closest_point.h>

#include <map>
#include <numeric>

namespace semilunar::output
{
  namespace
  {
    using Degree = std::array<unsigned int, 2>;
    using Points = std::vector<dealii::Point<2>>;

    constexpr std::uint8_t vtk_quad = 9;
    constexpr std::uint8_t vtk_bezier_quadrilateral = 77;

    /// A homogeneous coefficient or point: w x, w y, w z, w.
    constexpr unsigned int n_homogeneous = 4;

    /// The surface and what is drawn on it.
    struct Drawing
    {
      const spline::Surface &surface;
      const std::vector<spline::Tensor<1, 3>> &control_vectors;
      const std::vector<SurfaceField> &fields;
    };

    /// The homogeneous Bernstein coefficients of an element, one after the other.
    std::vector<double> homogeneous_coefficients(const Drawing &drawing, const unsigned int element)
    {
      std::vector<double> numbers;
      for (const std::array<double, n_homogeneous> &coefficient :
           spline::bezier_patch(drawing.surface, element, drawing.control_vectors).coefficients)
        numbers.insert(numbers.end(), coefficient.begin(), coefficient.end());
      return numbers;
    }

    std::vector<double> values_at(const SurfaceField &field, const unsigned int element,
                                  const Points &points)
    {
      std::vector<double> values(points.size() * field.n_components);
      for (std::size_t k = 0; k < points.size(); ++k)
        field.evaluate({element, points[k]}, &values[k * field.n_components]);
      return values;
    }

    void append_position(VtuGrid &grid, const double *homogeneous)
    {
      for (unsigned int d = 0; d < 3; ++d)
        grid.points.push_back(homogeneous[d] / homogeneous[3]);
    }

    /// Append tuples of an element to the array of a field, in the order of the grid's points.
    void append_tuples(VtuArray &array, const std::vector<double> &values,
                       const std::vector<unsigned int> &order)
    {
      auto &numbers = std::get<std::vector<float>>(array.values);
      for (const unsigned int k : order)
        for (unsigned int c = 0; c < array.n_components; ++c)
          numbers.push_back(static_cast<float>(values[k * array.n_components + c]));
    }

    std::vector<VtuArray> field_arrays(const std::vector<SurfaceField> &fields)
    {
      std::vector<VtuArray> arrays;
      for (const SurfaceField &field : fields)
        arrays.push_back({field.name, field.n_components, std::vector<float>(), ""});
      return arrays;
    }

    /// What all Bezier cells of one pair of degrees share.
    struct BezierCellType
    {
      explicit BezierCellType(const Degree &degree)
          : order(vtk_node_order(degree)), interpolation(degree)
      {
      }

      std::vector<unsigned int> order;
      RationalInterpolation interpolation;
    };

    void append_bezier_cell(VtuGrid &grid, std::vector<double> &weights, const Drawing &drawing,
                            const unsigned int element, const BezierCellType &type)
    {
      const std::vector<double> coefficients = homogeneous_coefficients(drawing, element);
      std::vector<double> bernstein_weights;
      for (std::size_t b = 0; b < type.order.size(); ++b)
        bernstein_weights.push_back(coefficients[b * n_homogeneous + 3]);

      for (const unsigned int b : type.order)
      {
        grid.connectivity.push_back(grid.connectivity.size());
        append_position(grid, &coefficients[b * n_homogeneous]);
        weights.push_back(bernstein_weights[b]);
      }
      grid.offsets.push_back(grid.connectivity.size());
      grid.types.push_back(vtk_bezier_quadrilateral);

      for (std::size_t f = 0; f < drawing.fields.size(); ++f)
        append_tuples(grid.point_data[f],
                      type.interpolation.coefficients(
                          bernstein_weights,
                          values_at(drawing.fields[f], element, type.interpolation.points()),
                          drawing.fields[f].n_components),
                      type.order);
    }

    VtuGrid bezier_grid(const Drawing &drawing)
    {
      VtuGrid grid;
      grid.point_data = field_arrays(drawing.fields);
      std::map<Degree, BezierCellType> types;
      std::vector<double> weights;
      std::vector<std::int32_t> degrees;
      for (unsigned int e = 0; e < drawing.surface.elements.size(); ++e)
      {
        const Degree degree = drawing.surface.elements[e].degree;
        const BezierCellType &type = types.try_emplace(degree, degree).first->second;
        append_bezier_cell(grid, weights, drawing, e, type);
        degrees.insert(degrees.end(),
                       {static_cast<int>(degree[0]), static_cast<int>(degree[1]), 0});
      }
      grid.point_data.push_back({"RationalWeights", 1, std::move(weights), "RationalWeights"});
      grid.cell_data.push_back({"HigherOrderDegrees", 3, std::move(degrees), "HigherOrderDegrees"});
      return grid;
    }

    /// A uniform grid of points on elements of one pair of degrees.
    struct ElementGrid
    {
      ElementGrid(const Degree &degree, const std::vector<double> &coordinates)
          : first(bernstein_matrix(degree[0], coordinates)),
            second(bernstein_matrix(degree[1], coordinates)),
            points(tensor_points({{coordinates, coordinates}}))
      {
      }

      Matrix first, second;
      Points points;
    };

    void append_linear_cells(VtuGrid &grid, const unsigned int subdivisions)
    {
      const std::int64_t n = subdivisions + 1;
      const std::int64_t begin = grid.points.size() / 3 - n * n;
      for (unsigned int j = 0; j < subdivisions; ++j)
        for (unsigned int i = 0; i < subdivisions; ++i)
        {
          const std::int64_t corner = begin + j * n + i;
          grid.connectivity.insert(grid.connectivity.end(),
                                   {corner, corner + 1, corner + n + 1, corner + n});
          grid.offsets.push_back(grid.connectivity.size());
          grid.types.push_back(vtk_quad);
        }
    }

    VtuGrid linear_grid(const Drawing &drawing, const unsigned int subdivisions)
    {
      std::vector<double> coordinates;
      for (unsigned int i = 0; i <= subdivisions; ++i)
        coordinates.push_back(i / static_cast<double>(subdivisions));
      std::vector<unsigned int> order(coordinates.size() * coordinates.size());
      std::iota(order.begin(), order.end(), 0);

      VtuGrid grid;
      grid.point_data = field_arrays(drawing.fields);
      std::map<Degree, ElementGrid> element_grids;
      for (unsigned int e = 0; e < drawing.surface.elements.size(); ++e)
      {
        const Degree degree = drawing.surface.elements[e].degree;
        const ElementGrid &element_grid =
            element_grids.try_emplace(degree, degree, coordinates).first->second;
        const std::vector<double> x = apply(element_grid.first, element_grid.second,
                                            homogeneous_coefficients(drawing, e), n_homogeneous);
        for (const unsigned int k : order)
          append_position(grid, &x[k * n_homogeneous]);
        append_linear_cells(grid, subdivisions);
        for (std::size_t f = 0; f < drawing.fields.size(); ++f)
          append_tuples(grid.point_data[f], values_at(drawing.fields[f], e, element_grid.points),
                        order);
      }
      return grid;
    }

    /// Number the cells by element and by connected part of the surface.
    void append_cell_numbers(VtuGrid &grid, const spline::Surface &surface,
                             const unsigned int n_cells_per_element)
    {
      const std::vector<unsigned int> part_of = spline::connected_parts(surface);
      std::vector<std::int32_t> elements, parts;
      for (unsigned int e = 0; e < surface.elements.size(); ++e)
      {
        elements.insert(elements.end(), n_cells_per_element, e);
        parts.insert(parts.end(), n_cells_per_element, part_of[e]);
      }
      grid.cell_data.push_back({"element", 1, std::move(elements), ""});
      grid.cell_data.push_back({"part", 1, std::move(parts), ""});
    }
  } // namespace

  void SurfaceVtuParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.declare_entry("Cells", cells == CellKind::bezier ? "bezier" : "linear",
                      dealii::Patterns::Selection("bezier|linear"),
                      "Cells of the surface files: rational Bezier cells (exact geometry, ParaView "
                      "5.8 or newer) or linear ones (any version).");
    prm.add_action("Cells", [this](const std::string &kind)
                   { cells = kind == "bezier" ? CellKind::bezier : CellKind::linear; });
    prm.add_parameter("Subdivisions", subdivisions, "Linear cells for each element and direction.",
                      dealii::Patterns::Integer(1, 100));
    prm.add_parameter("Compress", compress, "Compress the arrays in the surface files.");
  }

  SurfaceField control_point_field(const std::string &name, const spline::Surface &surface,
                                   const std::vector<spline::Tensor<1, 3>> &control_vectors)
  {
    const auto evaluate = [&surface, &control_vectors, patch = spline::BezierPatch(),
                           element = dealii::numbers::invalid_unsigned_int](
                              const spline::SurfacePoint &point, double *values) mutable
    {
      if (point.element != element)
        patch = spline::bezier_patch(surface, element = point.element, control_vectors);
      const spline::Tensor<1, 3> v = spline::evaluate(patch, point.xi)[spline::value];
      for (unsigned int d = 0; d < 3; ++d)
        values[d] = v[d];
    };
    return {name, 3, evaluate};
  }

  void write_surface_vtu(const std::string &filename, const spline::Surface &surface,
                         const std::vector<spline::Tensor<1, 3>> &control_vectors,
                         const std::vector<SurfaceField> &fields,
                         const SurfaceVtuParameters &parameters, const double time)
  {
    AssertDimension(control_vectors.size(), surface.control_points.size());
    const Drawing drawing{surface, control_vectors, fields};
    const unsigned int n = parameters.subdivisions;
    const bool bezier = parameters.cells == CellKind::bezier;
    VtuGrid grid = bezier ? bezier_grid(drawing) : linear_grid(drawing, n);
    append_cell_numbers(grid, surface, bezier ? 1 : n * n);
    write_vtu(filename, grid, time, parameters.compress);
  }
} // namespace semilunar::output
