// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/refined_region.h>
#include <semilunar/spline/unstructured_spline.h>

#include <algorithm>
#include <map>
#include <set>

namespace semilunar::spline
{
  using TurnedFace = QuadMesh::TurnedFace;

  namespace
  {
    /// The faces of the region, the first direction fastest.
    std::vector<TurnedFace> grid_of_faces(const QuadMesh &mesh, const GridRegion &region,
                                          const std::string &source)
    {
      std::vector<TurnedFace> faces;
      TurnedFace row = region.origin;
      for (unsigned int j = 0; j < region.n[1]; ++j, row = mesh.up(row))
      {
        TurnedFace face = row;
        for (unsigned int i = 0; i < region.n[0]; ++i, face = mesh.right(face))
        {
          if (!face || mesh.is_irregular(face.face))
            throw InputError(source, std::to_string(i) + ", " + std::to_string(j),
                             "no regular face is there",
                             "choose a grid of faces without extraordinary points");
          faces.push_back(face);
          if (!mesh.right(face))
            break;
        }
        if (faces.size() < std::size_t(j + 1) * region.n[0] ||
            (j + 1 < region.n[1] && !mesh.up(row)))
          throw InputError(source, std::to_string(faces.size()), "the mesh ends inside the grid",
                           "choose a smaller grid");
      }
      return faces;
    }

    KnotVector whole_numbers(const unsigned int n)
    {
      std::vector<double> knots(3, 0.);
      for (unsigned int k = 0; k <= n; ++k)
        knots.push_back(k);
      knots.insert(knots.end(), 3, n);
      return KnotVector(3, knots);
    }

    /// The T-spline of a region. Close to an edge of the region inside of the mesh its functions,
    /// which end there, are not those of the surface.
    class RegionSpline
    {
    public:
      RegionSpline(const QuadMesh &mesh, const GridRegion &region, const Surface &surface,
                   const std::string &source)
          : mesh(mesh), functions(mesh), n(region.n), faces(grid_of_faces(mesh, region, source)),
            at_boundary{{!mesh.left(faces.front()), !mesh.right(faces.back()),
                         !mesh.down(faces.front()), !mesh.up(faces.back())}},
            spline(patch(surface)), before(spline.functions())
      {
        for (const BlendingFunction &function : before)
          old_functions[{function.vertex, function.shift}] = &function;
      }
      RegionSpline(const RegionSpline &) = delete;

      void refine(const TSpline::Wanted &wanted) { spline.refine_where(wanted); }

      /// Move control points, append new ones, and return the elements of the faces that changed.
      std::map<unsigned int, std::vector<BezierElement>> apply(Surface &surface,
                                                               const std::string &source) const
      {
        const std::vector<unsigned int> numbers = place_control_points(surface.control_points);
        const Surface fine = to_surface(spline, source);
        const std::vector<BezierBox> boxes = bezier_boxes(spline.mesh());
        std::map<unsigned int, std::vector<unsigned int>> parts; // boxes of each face
        for (unsigned int b = 0; b < boxes.size(); ++b)
          parts[(boxes[b].low[1] / TMesh::unit) * n[0] + boxes[b].low[0] / TMesh::unit].push_back(
              b);

        std::map<unsigned int, std::vector<BezierElement>> changed;
        for (const auto &[base, own] : parts)
          if (own.size() > 1 || has_new_function(fine.elements[own[0]]))
            for (const unsigned int b : own)
            {
              BezierElement element = fine.elements[b];
              for (unsigned int &a : element.control_points)
              {
                if (numbers[a] == TMesh::none)
                  throw InputError(source, "", "refinement reaches the edge of the region",
                                   "refine further inside, or choose a larger region");
                a = numbers[a];
              }
              changed[faces[base].face].push_back(turned_back(element, faces[base].turn));
            }
        return changed;
      }

    private:
      const QuadMesh &mesh;
      const UnstructuredFunctions functions;
      const std::array<unsigned int, 2> n;
      const std::vector<TurnedFace> faces;
      const std::array<bool, 4> at_boundary; ///< of the mesh: left, right, lower, upper edge
      TSpline spline;
      const std::vector<BlendingFunction> before;
      std::map<std::pair<TMesh::Point, std::array<unsigned int, 2>>, const BlendingFunction *>
          old_functions;

      /// The function of the surface at a vertex of the region.
      unsigned int number(const unsigned int i, const unsigned int j,
                          std::array<unsigned int, 2> shifts) const
      {
        const unsigned int right = i == n[0] ? 1 : 0, top = j == n[1] ? 1 : 0;
        const TurnedFace &face = faces[(j - top) * n[0] + i - right];
        const unsigned int corner = top == 0 ? right : 3 - right;
        // shifts along an edge of the region inside of the mesh mean nothing there
        if (!(i == 0 && at_boundary[0]) && !(i == n[0] && at_boundary[1]))
          shifts[0] = 0;
        if (!(j == 0 && at_boundary[2]) && !(j == n[1] && at_boundary[3]))
          shifts[1] = 0;
        if (corner % 2 == 1)
          std::swap(shifts[0], shifts[1]);
        return functions.number({face.face, (face.turn + corner) % 4}, shifts);
      }

      NurbsPatch patch(const Surface &surface) const
      {
        std::vector<ControlPoint> net;
        for (unsigned int j = 0; j < n[1] + 3; ++j)
          for (unsigned int i = 0; i < n[0] + 3; ++i)
          {
            const unsigned int k = std::clamp(i, 1u, n[0] + 1), l = std::clamp(j, 1u, n[1] + 1);
            net.push_back(surface.control_points[number(k - 1, l - 1, {{i != k, j != l}})]);
          }
        return NurbsPatch({{whole_numbers(n[0]), whole_numbers(n[1])}}, net);
      }

      bool is_unchanged(const BlendingFunction &function) const
      {
        const auto old = old_functions.find({function.vertex, function.shift});
        return old != old_functions.end() && old->second->knots == function.knots;
      }

      bool has_new_function(const BezierElement &element) const
      {
        return std::any_of(element.control_points.begin(), element.control_points.end(),
                           [this](const unsigned int a)
                           { return !is_unchanged(spline.functions()[a]); });
      }

      /// Whether the function is one of the surface: its knots do not repeat an edge of the region
      /// that is none of the mesh.
      bool is_inside(const BlendingFunction &function) const
      {
        for (unsigned int d = 0; d < 2; ++d)
        {
          const std::vector<TMesh::Coordinate> &t = function.knots[d];
          if ((!at_boundary[2 * d] && t[0] == t[1]) ||
              (!at_boundary[2 * d + 1] && t[t.size() - 2] == t.back()))
            return false;
        }
        return true;
      }

      /// The number in the surface of each function of the T-spline; none for those that are not
      /// functions of the surface.
      std::vector<unsigned int> place_control_points(std::vector<ControlPoint> &points) const
      {
        std::vector<unsigned int> numbers;
        for (unsigned int a = 0; a < spline.functions().size(); ++a)
        {
          const BlendingFunction &function = spline.functions()[a];
          const TMesh::Point &v = function.vertex;
          numbers.push_back(TMesh::none);
          if (!is_inside(function))
            continue;
          const bool of_old_vertex = v[0] % TMesh::unit == 0 && v[1] % TMesh::unit == 0;
          numbers[a] = of_old_vertex
                           ? number(v[0] / TMesh::unit, v[1] / TMesh::unit, function.shift)
                           : points.size();
          if (!of_old_vertex)
            points.push_back(spline.control_points()[a]);
          else if (!is_unchanged(function))
            points[numbers[a]] = spline.control_points()[a];
        }
        return numbers;
      }

      /// The element in the directions that its face had before it was turned.
      static BezierElement turned_back(BezierElement element, const unsigned int turn)
      {
        const unsigned int p = element.degree[0], m = element.n_bernstein();
        for (unsigned int k = 0; k < turn; ++k)
        {
          const std::vector<double> C = element.extraction;
          // turned once more: (0,0) of the turned face is corner 1 of the other
          for (unsigned int a = 0; a < element.n_functions(); ++a)
            for (unsigned int j = 0; j <= p; ++j)
              for (unsigned int i = 0; i <= p; ++i)
                element.extraction[a * m + i * (p + 1) + (p - j)] = C[a * m + j * (p + 1) + i];
        }
        return element;
      }
    };
  } // namespace

  void refine_region(const QuadMesh &mesh, const GridRegion &region, const TSpline::Wanted &wanted,
                     Surface &surface, const std::string &source)
  {
    RegionSpline spline(mesh, region, surface, source);
    spline.refine(wanted);
    Surface result;
    result.control_points = surface.control_points;
    auto changed = spline.apply(result, source);
    for (unsigned int f = 0; f < mesh.n_faces(); ++f)
      if (changed.count(f) == 0)
        result.elements.push_back(std::move(surface.elements[f]));
      else
        for (BezierElement &element : changed[f])
          result.elements.push_back(std::move(element));
    surface = std::move(result);
  }
} // namespace semilunar::spline
