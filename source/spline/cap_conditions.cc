// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/bernstein.h>
#include <semilunar/spline/cap_conditions.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <numeric>

namespace semilunar::spline
{
  using TurnedFace = QuadMesh::TurnedFace;

  namespace
  {
    constexpr unsigned int d = cap_degree, n_coefficients = (d + 1) * (d + 1);
  } // namespace

  CapConditions::CapConditions(const QuadMesh &mesh, const std::vector<unsigned int> &faces,
                               const std::map<unsigned int, FaceCoefficients> &regular)
      : mesh(mesh), same_as(faces.size() * n_coefficients)
  {
    for (unsigned int k = 0; k < faces.size(); ++k)
      position[faces[k]] = k;
    std::iota(same_as.begin(), same_as.end(), 0u);
    const auto for_each_side = [&](const auto &inner, const auto &outer)
    {
      for (const unsigned int f : faces)
        for (unsigned int s = 0; s < 4; ++s)
        {
          const TurnedFace other = mesh.neighbour(f, s);
          if (!has(other.face))
            outer(f, s, other);
          else if (f < other.face)
            inner(f, s);
        }
    };
    const auto nothing = [](auto &&...) {};
    for_each_side([&](const unsigned int f, const unsigned int s) { identify(f, s); }, nothing);
    for_each_side([&](const unsigned int f, const unsigned int s) { join(f, s); },
                  [&](const unsigned int f, const unsigned int s, const TurnedFace &other)
                  { join_regular(f, s, regular.at(other.face), other.turn); });
  }

  unsigned int CapConditions::number(const unsigned int face, const unsigned int k) const
  {
    unsigned int i = position.at(face) * n_coefficients + k;
    while (same_as[i] != i)
      i = same_as[i];
    return i;
  }

  unsigned int CapConditions::coefficient(const unsigned int face, const unsigned int side,
                                          const unsigned int along, const unsigned int inside) const
  {
    return number(face, side_index(d, side, along, inside));
  }

  void CapConditions::identify(const unsigned int face, const unsigned int side)
  {
    const TurnedFace other = mesh.neighbour(face, side);
    for (unsigned int i = 0; i <= d; ++i)
    {
      const unsigned int a = coefficient(face, side, i, 0);
      const unsigned int b = coefficient(other.face, other.turn, d - i, 0);
      same_as[std::max(a, b)] = std::min(a, b);
    }
  }

  void CapConditions::join_regular(const unsigned int face, const unsigned int side,
                                   const FaceCoefficients &other, const unsigned int other_side)
  {
    for (unsigned int i = 0; i <= d; ++i)
    {
      const LinearForm &edge = other[side_index(d, other_side, d - i, 0)];
      LinearForm inside;
      inside.add(2., edge);
      inside.add(-1., other[side_index(d, other_side, d - i, 1)]);
      known[coefficient(face, side, i, 0)] = edge;
      known[coefficient(face, side, i, 1)] = inside;
    }
  }

  void CapConditions::join(const unsigned int face, const unsigned int side)
  {
    const TurnedFace other = mesh.neighbour(face, side);
    const double first = gluing(mesh.face(face)[side]);
    const double last = -gluing(mesh.face(face)[(side + 1) % 4]);
    if (first != 0. || last != 0.)
      limit_edge_degree(face, side);
    for (unsigned int i = 0; i <= d; ++i)
    {
      Condition condition;
      condition[coefficient(face, side, i, 1)] += d; // derivatives across
      condition[coefficient(other.face, other.turn, d - i, 1)] += d;
      condition[coefficient(face, side, i, 0)] -= 2. * d;
      add_gluing(face, side, i, {{first, 0., last}}, condition);
      all.push_back(condition);
    }
  }

  double CapConditions::gluing(const unsigned int vertex) const
  {
    return mesh.is_extraordinary(vertex)
               ? 2. * std::cos(2. * dealii::numbers::PI / mesh.valence(vertex))
               : 0.;
  }

  void CapConditions::limit_edge_degree(const unsigned int face, const unsigned int side)
  {
    Condition condition;
    for (unsigned int i = 0; i <= d; ++i)
      condition[coefficient(face, side, i, 0)] = (i % 2 == 0 ? 1. : -1.) * binomial(d, i);
    all.push_back(condition);
  }

  void CapConditions::add_gluing(const unsigned int face, const unsigned int side,
                                 const unsigned int i, const std::array<double, 3> &gluing,
                                 Condition &condition) const
  {
    // the derivative, degree d - 1, is known to have degree d - 2 only: reduce it (U6)
    static_assert(d == 5, "the reduction is written out for this degree");
    const double reduce[4][5] = {{1., 0., 0., 0., 0.},
                                 {-1. / 3., 4. / 3., 0., 0., 0.},
                                 {0., 0., 0., 4. / 3., -1. / 3.},
                                 {0., 0., 0., 0., 1.}};
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int l = 0; l < 4; ++l)
        if (k + l == i && gluing[k] != 0.)
        {
          const double product = binomial(2, k) * binomial(3, l) / binomial(5, i) * gluing[k];
          for (unsigned int m = 0; m < 5; ++m)
          {
            condition[coefficient(face, side, m + 1, 0)] -= d * product * reduce[l][m];
            condition[coefficient(face, side, m, 0)] += d * product * reduce[l][m];
          }
        }
  }
} // namespace semilunar::spline
