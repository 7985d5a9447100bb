// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/valve/adaptive_leaflets.h>
#include <semilunar/valve/leaflet_t_spline.h>
#include <semilunar/valve/leaflets.h>

#include <deal.II/base/exceptions.h>

#include <set>

namespace semilunar::valve
{
  using namespace spline;

  namespace
  {
    /// The element at the mirror image of an element: the mesh is symmetric.
    unsigned int mirrored(const TMesh &mesh, const unsigned int e)
    {
      const TMesh::Element &element = mesh.element(e);
      const TMesh::Point corner{{mesh.end(0) - element.high[0], element.low[1]}};
      const unsigned int image = mesh.find(corner, 1, 1);
      Assert(mesh.element(image).level == element.level,
             dealii::ExcMessage("The mesh of the leaflet is not symmetric."));
      return image;
    }

    /// The block-diagonal matrix with n copies of a matrix of so many columns.
    RefinementMatrix repeated(const RefinementMatrix &matrix, const unsigned int n,
                              const unsigned int n_columns)
    {
      RefinementMatrix all;
      for (unsigned int k = 0; k < n; ++k)
        for (SparseRow row : matrix)
        {
          for (unsigned int &column : row.columns)
            column += k * n_columns;
          all.push_back(std::move(row));
        }
      return all;
    }

    const Design &checked(const Design &design)
    {
      if (design.layout != LeafletLayout::t_spline)
        throw InputError("Valve/Layout", "", "leaflets of this layout cannot be refined by need",
                         "choose T-spline");
      return design;
    }
  } // namespace

  AdaptiveLeaflets::AdaptiveLeaflets(const Design &design, const unsigned int n_leaflets)
      : design(checked(design)), n(n_leaflets), t_spline(leaflet_t_spline(design))
  {
    Assert(n == 1 || n == design.n_leaflets, dealii::ExcMessage("One leaflet, or all of them."));
  }

  Surface AdaptiveLeaflets::surface() const
  {
    return n == 1 ? valve::leaflet(design, t_spline) : valve::leaflets(design, t_spline);
  }

  RefinementMatrix AdaptiveLeaflets::refine(const std::vector<unsigned int> &marked)
  {
    const std::vector<BezierBox> boxes = bezier_boxes(t_spline.mesh());
    std::set<unsigned int> elements;
    for (const unsigned int e : marked)
    {
      AssertIndexRange(e, n * boxes.size());
      const unsigned int t_element = boxes[e % boxes.size()].t_element;
      elements.insert({t_element, mirrored(t_spline.mesh(), t_element)});
    }
    const unsigned int n_columns = t_spline.control_points().size();
    return repeated(t_spline.refine({elements.begin(), elements.end()}), n, n_columns);
  }
} // namespace semilunar::valve
