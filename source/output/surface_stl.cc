// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/output/surface_stl.h>
#include <semilunar/spline/closest_point.h>

#include <cstdint>
#include <cstring>
#include <fstream>

namespace semilunar::output
{
  namespace
  {
    using Vector = spline::Tensor<1, 3>;

    void append(const Vector &x, std::string &bytes)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        const float number = x[d];
        char raw[sizeof(number)];
        std::memcpy(raw, &number, sizeof(number));
        bytes.append(raw, sizeof(number));
      }
    }

    void append_triangle(const Vector &a, const Vector &b, const Vector &c, std::string &bytes)
    {
      const Vector normal = cross_product_3d(b - a, c - a);
      const double length = normal.norm();
      append(length > 0. ? normal / length : normal, bytes);
      for (const Vector &x : {a, b, c})
        append(x, bytes);
      bytes.append(2, '\0'); // attributes
    }
  } // namespace

  void write_stl(const spline::Surface &surface, const std::string &filename, const unsigned int n)
  {
    std::string bytes = "semilunar";
    bytes.resize(80, ' ');
    const std::uint32_t n_triangles = surface.elements.size() * 2 * n * n;
    char raw[sizeof(n_triangles)];
    std::memcpy(raw, &n_triangles, sizeof(n_triangles));
    bytes.append(raw, sizeof(n_triangles));
    const std::vector<Vector> positions = spline::positions(surface);
    for (unsigned int e = 0; e < surface.elements.size(); ++e)
    {
      const spline::BezierPatch patch = spline::bezier_patch(surface, e, positions);
      const auto at = [&](const unsigned int i, const unsigned int j) {
        return spline::evaluate(patch, {double(i) / n, double(j) / n})[spline::value];
      };
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
        {
          append_triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1), bytes);
          append_triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1), bytes);
        }
    }
    std::ofstream file(filename, std::ios::binary);
    file << bytes;
    if (!file.flush())
      throw InputError(filename, "", "the file cannot be written", "");
  }
} // namespace semilunar::output
