// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_flow_lane_matrices_h
#define semilunar_flow_lane_matrices_h

#include <semilunar/flow/lanes.h>

namespace semilunar::flow
{
  /// Inverse and determinant of a matrix in each lane: a Jacobian is [physical][reference].
  template <int dim>
  inline Lanes invert(const Lanes (&J)[dim][dim], Lanes (&inverse)[dim][dim])
  {
    if constexpr (dim == 2)
    {
      const Lanes det = J[0][0] * J[1][1] - J[0][1] * J[1][0], factor = 1. / det;
      inverse[0][0] = J[1][1] * factor;
      inverse[0][1] = -J[0][1] * factor;
      inverse[1][0] = -J[1][0] * factor;
      inverse[1][1] = J[0][0] * factor;
      return det;
    }
    else
    {
      Lanes cofactor[3][3];
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
        {
          const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
          cofactor[i][j] = J[a][c] * J[b][d] - J[a][d] * J[b][c];
        }
      const Lanes det = J[0][0] * cofactor[0][0] + J[0][1] * cofactor[0][1] +
                        J[0][2] * cofactor[0][2],
                  factor = 1. / det;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          inverse[j][i] = cofactor[i][j] * factor;
      return det;
    }
  }
} // namespace semilunar::flow

#endif
