// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_t_mesh_h
#define semilunar_spline_t_mesh_h

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace semilunar::spline
{
  /// A rectangular T-mesh in index space: a grid of base elements, each halved again and again,
  /// alternately by lines across the first and across the second direction. Coordinates are whole
  /// numbers: a base element is TMesh::unit wide, so that lines can be compared exactly.
  class TMesh
  {
  public:
    using Coordinate = std::int32_t;
    using Point = std::array<Coordinate, 2>;

    /// How often an element can be halved in one direction.
    static constexpr unsigned int max_halvings = 14;
    static constexpr Coordinate unit = 1 << max_halvings;

    struct Element
    {
      Point low, high;
      unsigned int level = 0; ///< number of halvings, of both directions together
    };

    /// A grid of n[0] x n[1] base elements for splines of odd degree.
    TMesh(const std::array<unsigned int, 2> &n, unsigned int degree);

    unsigned int degree() const { return p; }
    /// The number of base elements in a direction.
    unsigned int n_base(const unsigned int direction) const { return n[direction]; }
    /// Coordinate of the end of a direction, which starts at 0.
    Coordinate end(const unsigned int direction) const { return n[direction] * unit; }

    /// Numbers of the elements that are not halved, for element(). They stay valid: an element that
    /// is halved keeps its number and is no longer among them.
    std::vector<unsigned int> active_elements() const;
    const Element &element(const unsigned int e) const { return nodes[e].element; }
    bool is_active(const unsigned int e) const { return nodes[e].first_child == none; }
    unsigned int n_active() const { return n_leaves; }

    /// The direction that the next halving of an element divides.
    static unsigned int split_direction(const Element &element) { return element.level % 2; }

    /// Halve the elements and whatever else must be halved to keep the mesh analysis-suitable and
    /// the spline spaces nested, (T5). The cost is proportional to the number of elements made.
    /// @return number of elements that were halved
    unsigned int refine(const std::vector<unsigned int> &marked);

    /// Halve one element and nothing else: the mesh may lose its suitability.
    void halve(unsigned int e);

    /// The active element that holds the point (x, y) moved by an infinitesimal distance in the
    /// directions of the signs (+1 or -1); none if that is outside.
    unsigned int find(const Point &point, int sign_x, int sign_y) const;

    /// Call the function for all active elements whose interior meets the interior of the box (of
    /// the line if the box has no width in a direction).
    void for_each_in(const Point &low, const Point &high,
                     const std::function<void(unsigned int)> &function) const;

    static constexpr unsigned int none = std::numeric_limits<unsigned int>::max();

  private:
    struct Node
    {
      Element element;
      unsigned int first_child = none; ///< the second one follows it
    };

    unsigned int p;
    std::array<unsigned int, 2> n;
    std::vector<Node> nodes; ///< base elements first, the first direction fastest
    unsigned int n_leaves;

    void add_coarser_neighbours(unsigned int e, std::vector<bool> &chosen,
                                std::vector<unsigned int> &front) const;
    void visit(unsigned int node, const Point &low, const Point &high,
               const std::function<void(unsigned int)> &function) const;
  };
} // namespace semilunar::spline

#endif
