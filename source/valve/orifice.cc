// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/closest_point.h>
#include <semilunar/valve/orifice.h>

#include <algorithm>
#include <cmath>

namespace semilunar::valve
{
  using spline::Point;

  namespace
  {
    /// Triangles per element and direction: their sides stay near a pixel's.
    constexpr unsigned int subdivisions = 12;

    /// A square raster of marks over [-radius, radius]^2.
    class Raster
    {
    public:
      explicit Raster(const double radius)
          : radius(radius), pixel(2. * radius / orifice_pixels),
            covered(orifice_pixels * orifice_pixels, false)
      {
      }

      /// Mark all pixels whose centre lies in the triangle.
      void mark(const std::array<Point<2>, 3> &corners)
      {
        const auto [x_min, x_max] = std::minmax({corners[0][0], corners[1][0], corners[2][0]});
        const auto [y_min, y_max] = std::minmax({corners[0][1], corners[1][1], corners[2][1]});
        for (int j = index(y_min); j <= index(y_max) + 1; ++j)
          for (int i = index(x_min); i <= index(x_max) + 1; ++i)
            if (inside(i, j) && contains(corners, centre(i, j)))
              covered[j * orifice_pixels + i] = true;
      }

      /// Area of the disc that is further than the distance from every mark.
      double free_area(const double distance) const
      {
        const std::vector<double> squares = squared_distances();
        double area = 0.;
        for (unsigned int j = 0; j < orifice_pixels; ++j)
          for (unsigned int i = 0; i < orifice_pixels; ++i)
            if (centre(i, j).norm() < radius &&
                squares[j * orifice_pixels + i] * pixel * pixel > distance * distance)
              area += pixel * pixel;
        return area;
      }

    private:
      const double radius, pixel;
      std::vector<char> covered;

      int index(const double x) const { return int(std::floor((x + radius) / pixel - 0.5)); }
      Point<2> centre(const int i, const int j) const
      {
        return {(i + 0.5) * pixel - radius, (j + 0.5) * pixel - radius};
      }
      static bool inside(const int i, const int j)
      {
        return i >= 0 && j >= 0 && i < int(orifice_pixels) && j < int(orifice_pixels);
      }
      static bool contains(const std::array<Point<2>, 3> &corners, const Point<2> &p)
      {
        bool positive = false, negative = false;
        for (unsigned int k = 0; k < 3; ++k)
        {
          const auto side = corners[(k + 1) % 3] - corners[k], to = p - corners[k];
          const double cross = side[0] * to[1] - side[1] * to[0];
          positive = positive || cross > 0.;
          negative = negative || cross < 0.;
        }
        return !(positive && negative);
      }

      /// Squared distance to the nearest mark, in pixels, row by row and then across: the lower
      /// envelope of parabolas of Felzenszwalb and Huttenlocher, Theory of Computing 8 (2012)
      /// 415-428.
      std::vector<double> squared_distances() const
      {
        constexpr double far = 4. * orifice_pixels * orifice_pixels;
        std::vector<double> result(covered.size());
        for (std::size_t k = 0; k < covered.size(); ++k)
          result[k] = covered[k] ? 0. : far;
        for (unsigned int j = 0; j < orifice_pixels; ++j)
          envelope(&result[j * orifice_pixels], 1);
        for (unsigned int i = 0; i < orifice_pixels; ++i)
          envelope(&result[i], orifice_pixels);
        return result;
      }

      static void envelope(double *line, const std::size_t stride)
      {
        constexpr int n = orifice_pixels;
        double f[n], bound[n + 1];
        int apex[n], k = 0;
        for (int q = 0; q < n; ++q)
          f[q] = line[q * stride];
        apex[0] = 0;
        bound[0] = -1e30;
        bound[1] = 1e30;
        for (int q = 1; q < n; ++q)
        {
          const auto meet = [&](const int p)
          { return ((f[q] + double(q) * q) - (f[p] + double(p) * p)) / (2. * (q - p)); };
          double s = meet(apex[k]);
          while (s <= bound[k])
            s = meet(apex[--k]);
          apex[++k] = q;
          bound[k] = s;
          bound[k + 1] = 1e30;
        }
        k = 0;
        for (int q = 0; q < n; ++q)
        {
          while (bound[k + 1] < q)
            ++k;
          line[q * stride] = double(q - apex[k]) * (q - apex[k]) + f[apex[k]];
        }
      }
    };
  } // namespace

  double orifice_area(const spline::Surface &leaflets,
                      const std::vector<spline::Tensor<1, 3>> &control_vectors, const double radius,
                      const double thickness)
  {
    Raster raster(radius);
    std::vector<Point<2>> nodes((subdivisions + 1) * (subdivisions + 1));
    for (unsigned int e = 0; e < leaflets.elements.size(); ++e)
    {
      const spline::BezierPatch patch = bezier_patch(leaflets, e, control_vectors);
      for (unsigned int j = 0; j <= subdivisions; ++j)
        for (unsigned int i = 0; i <= subdivisions; ++i)
        {
          const auto x = evaluate(
              patch, Point<2>(double(i) / subdivisions, double(j) / subdivisions))[spline::value];
          nodes[j * (subdivisions + 1) + i] = {x[0], x[1]};
        }
      for (unsigned int j = 0; j < subdivisions; ++j)
        for (unsigned int i = 0; i < subdivisions; ++i)
        {
          const Point<2> *n = &nodes[j * (subdivisions + 1) + i];
          raster.mark({{n[0], n[1], n[subdivisions + 2]}});
          raster.mark({{n[0], n[subdivisions + 2], n[subdivisions + 1]}});
        }
    }
    return raster.free_area(0.5 * thickness);
  }
} // namespace semilunar::valve
