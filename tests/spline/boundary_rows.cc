// SPDX-License-Identifier: LGPL-2.1-or-later
// The boundary of a surface where neighbouring elements see the same functions, as they do to both
// sides of the extension of a T-junction: a bilinear patch cut into three elements without new
// functions.

#include <semilunar/spline/boundary_rows.h>

#include "../tests.h"

using namespace semilunar::spline;
using namespace semilunar::tests;

namespace
{
  /// The part [begin, end] x [0, 1] of the parameter space as an element of its own: a Bernstein
  /// coefficient of a bilinear function is its value at the corner.
  BezierElement part(const double begin, const double end)
  {
    BezierElement element;
    element.degree = {{1, 1}};
    element.control_points = {0, 1, 2, 3};
    for (unsigned int a = 0; a < 4; ++a)
      for (unsigned int b = 0; b < 4; ++b)
      {
        const double x = b % 2 == 0 ? begin : end, y = b / 2;
        element.extraction.push_back((a % 2 == 0 ? 1. - x : x) * (a / 2 == 0 ? 1. - y : y));
      }
    return element;
  }
} // namespace

int main()
{
  Surface surface;
  surface.control_points = {{Point<3>(0., 0., 0.), 1.},
                            {Point<3>(2., 0., 1.), 1.},
                            {Point<3>(0., 1., 0.), 1.},
                            {Point<3>(2., 1., 3.), 1.}};
  surface.elements = {part(0., 0.25), part(0.25, 0.75), part(0.75, 1.)};

  for (const ElementSide &s : boundary_sides(surface))
    log() << "element " << s.element << " side " << s.side << std::endl;
  log() << "along the lower edge: " << boundary_sides(surface, {0, 1}).size() << " sides"
        << std::endl;
  log() << "at the left end: " << boundary_sides(surface, {0, 2}).size() << " side" << std::endl;
}
