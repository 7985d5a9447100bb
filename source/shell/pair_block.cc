// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/pair_block.h>

#include <algorithm>

namespace semilunar::shell
{
  namespace
  {
    constexpr unsigned int simd_width = 8;
    constexpr unsigned int directions[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

    /// row += c_0 f_0 + c_1 f_1 + c_2 f_2, for n (a multiple of the SIMD width) numbers
    inline void add_multiples(double *__restrict row, const unsigned int n, const double c0,
                              const double *__restrict f0, const double c1,
                              const double *__restrict f1, const double c2,
                              const double *__restrict f2)
    {
      for (unsigned int j = 0; j < n; j += simd_width)
        for (unsigned int k = j; k < j + simd_width; ++k) // a fixed count: is vectorised at -O2
          row[k] += c0 * f0[k] + c1 * f1[k] + c2 * f2[k];
    }
  } // namespace

  void PairBlock::reinit(const std::array<unsigned int, 2> &n_functions)
  {
    sizes = n_functions;
    n = sizes[0] + sizes[1];
    stride = (n + simd_width - 1) / simd_width * simd_width;
    for (AlignedTable &plane : planes)
      plane.assign(std::size_t(n) * stride, 0.);
    for (AlignedTable &factor : factors)
      factor.assign(stride, 0.);
  }

  void PairBlock::add(const unsigned int own_place, const double *own, const double *partner,
                      const SecondVariation &form)
  {
    const unsigned int n_own = sizes[own_place], n_partner = sizes[1 - own_place];
    const unsigned int own_begin = own_place == 0 ? 0 : n_partner,
                       partner_begin = own_place == 0 ? n_own : 0;
    for (AlignedTable &factor : factors)
      std::fill(factor.begin(), factor.end(), 0.);
    std::copy(own, own + n_own, factors[0].begin() + own_begin);
    for (unsigned int a = 0; a < n_partner; ++a)
    {
      factors[0][partner_begin + a] = -partner[a];
      factors[1][partner_begin + a] = partner[n_partner + a];
      factors[2][partner_begin + a] = partner[2 * n_partner + a];
    }
    for (unsigned int plane = 0; plane < 6; ++plane)
    {
      const unsigned int c = directions[plane][0], d = directions[plane][1];
      double q[3][3];
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int l = 0; l < 3; ++l)
          q[k][l] = form[k][l][c][d];
      for (unsigned int i = 0; i < n; ++i)
      {
        double coefficient[3];
        for (unsigned int l = 0; l < 3; ++l)
          coefficient[l] =
              factors[0][i] * q[0][l] + factors[1][i] * q[1][l] + factors[2][i] * q[2][l];
        add_multiples(planes[plane].data() + std::size_t(i) * stride, stride, coefficient[0],
                      factors[0].data(), coefficient[1], factors[1].data(), coefficient[2],
                      factors[2].data());
      }
    }
  }

  void PairBlock::copy_to(std::vector<double> &matrix) const
  {
    matrix.resize(std::size_t(9) * n * n);
    for (unsigned int plane = 0; plane < 6; ++plane)
    {
      const unsigned int c = directions[plane][0], d = directions[plane][1];
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
        {
          const double entry = planes[plane][std::size_t(i) * stride + j];
          matrix[std::size_t(3 * i + c) * 3 * n + 3 * j + d] = entry;
          matrix[std::size_t(3 * j + d) * 3 * n + 3 * i + c] = entry;
        }
    }
  }
} // namespace semilunar::shell
