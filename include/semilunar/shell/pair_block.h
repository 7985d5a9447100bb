// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_pair_block_h
#define semilunar_shell_pair_block_h

#include <semilunar/shell/aligned.h>
#include <semilunar/shell/contact_foot.h>

namespace semilunar::shell
{
  /// Sums up second derivatives of energies of two elements that touch, (C7): the dense matrix for
  /// the functions of the first and then of the second element.
  class PairBlock
  {
  public:
    /// Start from zero. @param n_functions of the two elements
    void reinit(const std::array<unsigned int, 2> &n_functions);

    /// Add the quadratic form of (dx - dy, dy,1, dy,2), where x is a point of one element (whose
    /// functions have the values @p own there) and y of the other (values and derivatives with
    /// respect to xi, one row after the other, in @p partner).
    /// @param own_place which of the two elements holds x
    void add(unsigned int own_place, const double *own, const double *partner,
             const SecondVariation &form);

    /// The symmetric matrix for three displacements per function, row by row.
    void copy_to(std::vector<double> &matrix) const;

  private:
    std::array<unsigned int, 2> sizes;
    unsigned int n, stride;
    /// A matrix of functions x functions for each pair of directions 11, 22, 33, 12, 13, 23.
    std::array<AlignedTable, 6> planes;
    /// dx - dy, dy,1 and dy,2 per displacement of each function.
    std::array<AlignedTable, 3> factors;
  };
} // namespace semilunar::shell

#endif
