// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/supports.h>
#include <semilunar/spline/evaluation.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <map>

namespace semilunar::shell
{
  using spline::Tensor;

  namespace
  {
    /// Squared displacements below this part of those of a free piece count as none.
    constexpr double threshold = 1e-8;

    struct Piece
    {
      std::vector<unsigned int> control_points;
      Tensor<1, 3> centre;
      double radius = 0.;
    };

    std::vector<Piece> pieces_of(const spline::Surface &surface)
    {
      const std::vector<unsigned int> parts = connected_parts(surface);
      std::vector<Piece> pieces(parts.empty() ? 0
                                              : *std::max_element(parts.begin(), parts.end()) + 1);
      std::vector<bool> seen(surface.control_points.size(), false);
      for (unsigned int e = 0; e < parts.size(); ++e)
        for (const unsigned int c : surface.elements[e].control_points)
          if (!seen[c])
          {
            seen[c] = true;
            pieces[parts[e]].control_points.push_back(c);
          }
      const auto x = spline::positions(surface);
      for (Piece &piece : pieces)
      {
        for (const unsigned int c : piece.control_points)
          piece.centre += x[c] / static_cast<double>(piece.control_points.size());
        for (const unsigned int c : piece.control_points)
          piece.radius = std::max(piece.radius, (x[c] - piece.centre).norm());
      }
      return pieces;
    }

    /// What a displacement component of a control point is in the six rigid motions of its piece:
    /// translations, and rotations about the centre that move the furthest point by one.
    struct Row
    {
      unsigned int piece;
      std::array<double, 6> values;

      Row(const unsigned int number, const Piece &piece, const Tensor<1, 3> &position,
          const unsigned int component)
          : piece(number)
      {
        for (unsigned int k = 0; k < 3; ++k)
        {
          Tensor<1, 3> axis;
          axis[k] = 1.;
          values[k] = axis[component];
          values[3 + k] = cross_product_3d(axis, position - piece.centre)[component] / piece.radius;
        }
      }
    };

    /// Gram matrix of the rigid motions of all pieces in what the equations demand: prescribed
    /// components are zero, tied ones equal.
    class ConstraintGram
    {
    public:
      ConstraintGram(const spline::Surface &surface, const Equations &equations,
                     const std::vector<Piece> &pieces)
          : matrix(6 * pieces.size(), 6 * pieces.size())
      {
        std::map<unsigned int, Row> first_of_class;
        for (unsigned int p = 0; p < pieces.size(); ++p)
          for (const unsigned int c : pieces[p].control_points)
            for (unsigned int i = 0; i < 3; ++i)
            {
              const Row row(p, pieces[p], surface.control_points[c].position, i);
              if (equations.is_prescribed(c, i))
                add({{1., row}});
              else
              {
                const auto [first, is_new] =
                    first_of_class.emplace(equations.representative(c, i), row);
                if (!is_new)
                  add({{1., row}, {-1., first->second}});
              }
            }
      }
      dealii::LAPACKFullMatrix<double> matrix;

    private:
      void add(const std::vector<std::pair<double, Row>> &constraint)
      {
        for (const auto &[factor, row] : constraint)
          for (const auto &[other_factor, other] : constraint)
            for (unsigned int k = 0; k < 6; ++k)
              for (unsigned int l = 0; l < 6; ++l)
                matrix(6 * row.piece + k, 6 * other.piece + l) +=
                    factor * row.values[k] * other_factor * other.values[l];
      }
    };

    /// How many of the six motions of a piece take part in the common motions that are free: rank
    /// of the piece's block of the projector onto them.
    unsigned int n_free_motions(const dealii::LAPACKFullMatrix<double> &gram_svd,
                                const unsigned int piece)
    {
      const auto &motions = gram_svd.get_svd_vt();
      dealii::LAPACKFullMatrix<double> projector(6, 6);
      for (unsigned int m = 0; m < gram_svd.n(); ++m)
        if (gram_svd.singular_value(m) < threshold)
          for (unsigned int k = 0; k < 6; ++k)
            for (unsigned int l = 0; l < 6; ++l)
              projector(k, l) += motions(m, 6 * piece + k) * motions(m, 6 * piece + l);
      projector.compute_svd();
      unsigned int rank = 0;
      for (unsigned int k = 0; k < 6; ++k)
        rank += projector.singular_value(k) > threshold;
      return rank;
    }
  } // namespace

  std::vector<unsigned int> free_rigid_motions(const spline::Surface &surface,
                                               const Equations &equations)
  {
    const std::vector<Piece> pieces = pieces_of(surface);
    ConstraintGram gram(surface, equations, pieces);
    gram.matrix.compute_svd();
    std::vector<unsigned int> n_free;
    for (unsigned int p = 0; p < pieces.size(); ++p)
      n_free.push_back(n_free_motions(gram.matrix, p));
    return n_free;
  }
} // namespace semilunar::shell
