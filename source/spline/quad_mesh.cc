// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/core/exceptions.h>
#include <semilunar/spline/quad_mesh.h>

#include <algorithm>
#include <map>

namespace semilunar::spline
{
  namespace
  {
    using Edge = std::pair<unsigned int, unsigned int>;

    [[noreturn]] void fail(const std::string &source, const std::string &place,
                           const std::string &problem, const std::string &remedy)
    {
      throw InputError(source, place, problem, remedy);
    }

    std::string number(const std::string &what, const unsigned int i)
    {
      return what + " " + std::to_string(i);
    }
  } // namespace

  QuadMesh::QuadMesh(const unsigned int n_vertices, std::vector<Face> faces,
                     const std::string &source)
      : all_faces(std::move(faces)), neighbours(all_faces.size()), vertex_faces(n_vertices),
        on_boundary(n_vertices, false)
  {
    for (unsigned int f = 0; f < n_faces(); ++f)
      for (unsigned int k = 0; k < 4; ++k)
      {
        if (all_faces[f][k] >= n_vertices)
          fail(source, number("face", f), "there is no such vertex",
               "there are " + std::to_string(n_vertices));
        vertex_faces[all_faces[f][k]].push_back({f, k});
      }
    connect(source);
    check_vertices(source);
  }

  void QuadMesh::connect(const std::string &source)
  {
    std::map<Edge, TurnedFace> sides;
    for (unsigned int f = 0; f < n_faces(); ++f)
      for (unsigned int s = 0; s < 4; ++s)
        if (!sides.insert({{all_faces[f][s], all_faces[f][(s + 1) % 4]}, {f, s}}).second)
          fail(source, number("face", f), "an edge belongs to two faces of opposite orientation",
               "list the vertices of all faces counter-clockwise");
    for (const auto &[edge, side] : sides)
    {
      const auto other = sides.find({edge.second, edge.first});
      if (other != sides.end())
        neighbours[side.face][side.turn] = other->second;
      else
        on_boundary[edge.first] = on_boundary[edge.second] = true;
    }
  }

  void QuadMesh::check_vertices(const std::string &source) const
  {
    for (unsigned int v = 0; v < n_vertices(); ++v)
    {
      const std::string place = number("vertex", v);
      if (valence(v) == 0)
        fail(source, place, "belongs to no face", "");
      if (on_boundary[v] && valence(v) > 2)
        fail(source, place, std::to_string(valence(v)) + " faces meet on the boundary",
             "one (a corner) or two are possible");
      if (is_extraordinary(v) && valence(v) != 3 && valence(v) != 5 && valence(v) != 6)
        fail(source, place, "the valence is " + std::to_string(valence(v)),
             "extraordinary points have valence 3, 5 or 6");
      if (is_extraordinary(v))
        for (const TurnedFace &face : vertex_faces[v])
          for (const unsigned int w : all_faces[face.face])
            if (on_boundary[w])
              fail(source, place, "the extraordinary point is next to the boundary",
                   "leave one ring of faces between them, for example by subdividing");
    }
  }

  unsigned int QuadMesh::vertex(const TurnedFace &face, const unsigned int i,
                                const unsigned int j) const
  {
    const unsigned int corner = j == 0 ? i : 3 - i;
    return all_faces[face.face][(face.turn + corner) % 4];
  }

  QuadMesh::TurnedFace QuadMesh::across(const TurnedFace &face, const unsigned int side,
                                        const unsigned int turn) const
  {
    const TurnedFace other = neighbours[face.face][(face.turn + side) % 4];
    return other ? TurnedFace{other.face, (other.turn + turn) % 4} : other;
  }

  bool QuadMesh::is_irregular(const unsigned int face) const
  {
    return std::any_of(all_faces[face].begin(), all_faces[face].end(),
                       [this](const unsigned int v) { return is_extraordinary(v); });
  }

  QuadMesh QuadMesh::subdivide(std::vector<std::vector<unsigned int>> &parents) const
  {
    parents.clear();
    for (unsigned int v = 0; v < n_vertices(); ++v)
      parents.push_back({v});
    std::map<Edge, unsigned int> edge_vertex;
    const auto middle = [&](const unsigned int a, const unsigned int b)
    {
      const auto [found, is_new] = edge_vertex.insert({std::minmax(a, b), parents.size()});
      if (is_new)
        parents.push_back({a, b});
      return found->second;
    };
    for (const Face &face : all_faces)
      for (unsigned int k = 0; k < 4; ++k)
        middle(face[k], face[(k + 1) % 4]);
    std::vector<Face> finer;
    for (const Face &face : all_faces)
    {
      const unsigned int centre = parents.size();
      parents.push_back({face[0], face[1], face[2], face[3]});
      for (unsigned int k = 0; k < 4; ++k)
      {
        // the child at corner k keeps the directions of the face
        Face child;
        child[k] = face[k];
        child[(k + 1) % 4] = middle(face[k], face[(k + 1) % 4]);
        child[(k + 2) % 4] = centre;
        child[(k + 3) % 4] = middle(face[k], face[(k + 3) % 4]);
        finer.push_back(child);
      }
    }
    return QuadMesh(parents.size(), finer, "subdivided mesh");
  }
} // namespace semilunar::spline
