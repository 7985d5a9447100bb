// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_cap_conditions_h
#define semilunar_spline_cap_conditions_h

#include <semilunar/spline/g1_cap.h>

namespace semilunar::spline
{
  /// What faces around extraordinary points must fulfil to join each other G1 and their regular
  /// neighbours C1: linear conditions on their Bernstein coefficients. Coefficients on a common
  /// edge are one; those that regular neighbours determine are given.
  class CapConditions
  {
  public:
    /// A condition: the sum of factors times coefficients is 0.
    using Condition = std::map<unsigned int, double>;

    /// @param faces    irregular faces that share edges
    /// @param regular  elevated coefficients of their regular neighbours
    CapConditions(const QuadMesh &mesh, const std::vector<unsigned int> &faces,
                  const std::map<unsigned int, FaceCoefficients> &regular);

    /// The number of a face's coefficient: the same for coefficients that are one.
    unsigned int number(unsigned int face, unsigned int k) const;

    const std::vector<Condition> &conditions() const { return all; }
    /// Coefficients that are known, as combinations of control points.
    const std::map<unsigned int, LinearForm> &given() const { return known; }

  private:
    const QuadMesh &mesh;
    std::map<unsigned int, unsigned int> position; // of a face in the list
    std::vector<unsigned int> same_as;             // a smaller number, or itself
    std::vector<Condition> all;
    std::map<unsigned int, LinearForm> known;

    bool has(const unsigned int face) const { return position.count(face) > 0; }
    unsigned int coefficient(unsigned int face, unsigned int side, unsigned int along,
                             unsigned int inside) const;

    /// Share the edge with another face of the cap.
    void identify(unsigned int face, unsigned int side);
    /// Join another face of the cap G1, (U4).
    void join(unsigned int face, unsigned int side);
    /// C1 with a regular neighbour across a side, (U5): two rows are given.
    void join_regular(unsigned int face, unsigned int side, const FaceCoefficients &other,
                      unsigned int other_side);

    /// 2 cos(2 pi / valence), (U3).
    double gluing(unsigned int vertex) const;
    /// The edge has degree d - 1 only, so that its derivative times the gluing has degree d.
    void limit_edge_degree(unsigned int face, unsigned int side);
    /// Subtract coefficient i of the gluing polynomial times the derivative along the edge.
    void add_gluing(unsigned int face, unsigned int side, unsigned int i,
                    const std::array<double, 3> &gluing, Condition &condition) const;
  };
} // namespace semilunar::spline

#endif
