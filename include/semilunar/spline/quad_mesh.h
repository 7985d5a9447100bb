// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_spline_quad_mesh_h
#define semilunar_spline_quad_mesh_h

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace semilunar::spline
{
  /// The topology of an unstructured mesh of quadrilaterals, oriented and conforming.
  class QuadMesh
  {
  public:
    static constexpr unsigned int none = std::numeric_limits<unsigned int>::max();

    /// The vertices of a face, counter-clockwise: at local coordinates (0,0), (1,0), (1,1), (0,1).
    using Face = std::array<unsigned int, 4>;

    /// A face turned so that its corner number `turn` is at (0,0).
    struct TurnedFace
    {
      unsigned int face = none, turn = 0;
      explicit operator bool() const { return face != none; }
    };

    /// @throws InputError naming @p source for meshes that are not oriented surfaces, boundaries
    /// where more than two faces meet, extraordinary points whose valence is not 3, 5 or 6, and
    /// those closer than two faces to the boundary
    QuadMesh(unsigned int n_vertices, std::vector<Face> faces,
             const std::string &source = "quadrilateral mesh");

    unsigned int n_vertices() const { return vertex_faces.size(); }
    unsigned int n_faces() const { return all_faces.size(); }
    const Face &face(const unsigned int f) const { return all_faces[f]; }

    /// The vertex at local (i, j), each 0 or 1.
    unsigned int vertex(const TurnedFace &face, unsigned int i, unsigned int j) const;

    /// The neighbour across the side at xi_1 = 1 (right), ..., turned so that its directions
    /// continue those of the face.
    TurnedFace right(const TurnedFace &face) const { return across(face, 1, 1); }
    TurnedFace up(const TurnedFace &face) const { return across(face, 2, 0); }
    TurnedFace left(const TurnedFace &face) const { return across(face, 3, 3); }
    TurnedFace down(const TurnedFace &face) const { return across(face, 0, 2); }

    /// The face on the other side of side s (from corner s to corner s + 1), and its side there as
    /// `turn`.
    TurnedFace neighbour(const unsigned int face, const unsigned int side) const
    {
      return neighbours[face][side];
    }

    bool is_on_boundary(const unsigned int v) const { return on_boundary[v]; }
    /// The number of faces around a vertex.
    unsigned int valence(const unsigned int v) const { return vertex_faces[v].size(); }
    bool is_extraordinary(const unsigned int v) const { return !on_boundary[v] && valence(v) != 4; }
    /// Faces with the corner where the vertex is, in no particular order.
    const std::vector<TurnedFace> &faces_at(const unsigned int v) const { return vertex_faces[v]; }
    /// Whether a corner of the face is extraordinary.
    bool is_irregular(unsigned int face) const;

    /// Each face divided into four. New vertices follow the old ones: edges, then faces.
    /// @param parents for each new vertex the old vertices that it is the middle of
    QuadMesh subdivide(std::vector<std::vector<unsigned int>> &parents) const;

  private:
    std::vector<Face> all_faces;
    std::vector<std::array<TurnedFace, 4>> neighbours;
    std::vector<std::vector<TurnedFace>> vertex_faces;
    std::vector<bool> on_boundary;

    TurnedFace across(const TurnedFace &face, unsigned int side, unsigned int turn) const;
    void connect(const std::string &source);
    void check_vertices(const std::string &source) const;
  };
} // namespace semilunar::spline

#endif
