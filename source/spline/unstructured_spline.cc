// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/spline/g1_cap.h>
#include <semilunar/spline/nurbs_patch.h>
#include <semilunar/spline/unstructured_spline.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <map>
#include <set>

namespace semilunar::spline
{
  using TurnedFace = QuadMesh::TurnedFace;

  namespace
  {
    /// Extraction operators on [0,1] of uniform knots with clamped ends so many elements to the
    /// left and to the right.
    class UniformExtraction
    {
    public:
      static constexpr unsigned int far = 3; ///< ends further away do not matter

      UniformExtraction()
      {
        for (unsigned int l = 0; l <= far; ++l)
          for (unsigned int r = 0; r <= far; ++r)
            operators[l][r] = KnotVector::uniform(3, l + 1 + r).extraction_operators()[l];
      }

      /// Coefficient of Bernstein polynomial b in function a, counted from the left.
      double operator()(const std::array<unsigned int, 2> &ends, const unsigned int a,
                        const unsigned int b) const
      {
        return operators[ends[0]][ends[1]][4 * a + b];
      }

    private:
      std::vector<double> operators[far + 1][far + 1];
    };

    /// Makes the coefficients of faces of a mesh from those of its control points.
    class Extractor
    {
    public:
      explicit Extractor(const QuadMesh &mesh) : mesh(mesh), functions(mesh) {}

      /// The bicubic coefficients of a regular face, (U2).
      FaceCoefficients regular(const unsigned int f) const
      {
        const TurnedFace face{f, 0};
        const auto first = ends(face, &QuadMesh::left, &QuadMesh::right),
                   second = ends(face, &QuadMesh::down, &QuadMesh::up);
        FaceCoefficients result(16);
        for (unsigned int row = 0; row < 4; ++row)
          for (unsigned int column = 0; column < 4; ++column)
          {
            const LinearForm function(number(face, column, row));
            for (unsigned int j = 0; j < 4; ++j)
              for (unsigned int i = 0; i < 4; ++i)
              {
                const double c = extraction(first, column, i) * extraction(second, row, j);
                if (c != 0.)
                  result[4 * j + i].add(c, function);
              }
          }
        return result;
      }

      /// The bicubic coefficients that an irregular face starts from: (U1).
      FaceCoefficients averaged(const unsigned int f) const
      {
        FaceCoefficients result(16);
        for (unsigned int corner = 0; corner < 4; ++corner)
        {
          const unsigned int v = mesh.face(f)[corner];
          const TurnedFace here{f, corner};
          result[side_index(3, corner, 0, 0)] = vertex_point(v);
          result[side_index(3, corner, 1, 1)] = inner_point(here);
          result[side_index(3, corner, 1, 0)] = mean({here, turned_at_vertex(mesh.down(here), 3)});
          result[side_index(3, corner, 0, 1)] = mean({here, turned_at_vertex(mesh.left(here), 1)});
        }
        return result;
      }

    private:
      const QuadMesh &mesh;
      const UnstructuredFunctions functions;
      const UniformExtraction extraction;

      using Step = TurnedFace (QuadMesh::*)(const TurnedFace &) const;

      /// Elements until the boundary in two opposite directions.
      std::array<unsigned int, 2> ends(const TurnedFace &face, const Step back,
                                       const Step forth) const
      {
        std::array<unsigned int, 2> result{};
        const Step steps[2] = {back, forth};
        for (unsigned int k = 0; k < 2; ++k)
          for (TurnedFace next = (mesh.*steps[k])(face); next && result[k] < UniformExtraction::far;
               next = (mesh.*steps[k])(next))
            ++result[k];
        return result;
      }

      /// The function in this place of the 4 x 4 that live on a regular face.
      unsigned int number(const TurnedFace &face, const unsigned int column,
                          const unsigned int row) const
      {
        TurnedFace at = face;
        std::array<unsigned int, 2> corner, shifts{};
        const auto place = [&](const unsigned int direction, const unsigned int position,
                               const Step back, const Step forth)
        {
          corner[direction] = position < 2 ? 0 : 1;
          if (position == 1 || position == 2)
            return;
          const TurnedFace next = (mesh.*(position == 0 ? back : forth))(at);
          if (next)
            at = next;
          else
            shifts[direction] = 1;
        };
        place(0, column, &QuadMesh::left, &QuadMesh::right);
        place(1, row, &QuadMesh::down, &QuadMesh::up);
        // turn the face so that the vertex is at its (0,0)
        const unsigned int turn = corner[1] == 0 ? corner[0] : 3 - corner[0];
        if (turn % 2 == 1)
          std::swap(shifts[0], shifts[1]);
        return functions.number({at.face, (at.turn + turn) % 4}, shifts);
      }

      TurnedFace turned_at_vertex(const TurnedFace &face, const unsigned int turn) const
      {
        return {face.face, (face.turn + turn) % 4};
      }

      LinearForm control_point(const TurnedFace &face, const unsigned int turn) const
      {
        return LinearForm(functions.number(turned_at_vertex(face, turn), {{0, 0}}));
      }

      /// The inner coefficient of a face next to its corner at (0,0).
      LinearForm inner_point(const TurnedFace &face) const
      {
        const double n = mesh.valence(mesh.vertex(face, 0, 0)), sum = n + 5.;
        LinearForm result;
        result.add(n / sum, control_point(face, 0));
        result.add(2. / sum, control_point(face, 1));
        result.add(1. / sum, control_point(face, 2));
        result.add(2. / sum, control_point(face, 3));
        return result;
      }

      LinearForm mean(const std::vector<TurnedFace> &faces) const
      {
        LinearForm result;
        for (const TurnedFace &face : faces)
          result.add(1. / faces.size(), inner_point(face));
        return result;
      }

      LinearForm vertex_point(const unsigned int v) const { return mean(mesh.faces_at(v)); }
    };

    /// Groups of irregular faces that share edges.
    std::vector<std::vector<unsigned int>> caps(const QuadMesh &mesh)
    {
      std::vector<std::vector<unsigned int>> result;
      std::vector<bool> done(mesh.n_faces(), false);
      for (unsigned int start = 0; start < mesh.n_faces(); ++start)
      {
        if (done[start] || !mesh.is_irregular(start))
          continue;
        std::vector<unsigned int> group{start};
        done[start] = true;
        for (unsigned int k = 0; k < group.size(); ++k)
          for (unsigned int s = 0; s < 4; ++s)
          {
            const TurnedFace other = mesh.neighbour(group[k], s);
            if (other && !done[other.face] && mesh.is_irregular(other.face))
            {
              done[other.face] = true;
              group.push_back(other.face);
            }
          }
        std::sort(group.begin(), group.end());
        result.push_back(group);
      }
      return result;
    }

    BezierElement element(const FaceCoefficients &coefficients, const unsigned int degree)
    {
      std::set<unsigned int> functions;
      for (const LinearForm &form : coefficients)
        for (const auto &term : form.terms)
          functions.insert(term.first);
      BezierElement result;
      result.degree = {{degree, degree}};
      result.control_points.assign(functions.begin(), functions.end());
      for (const unsigned int a : functions)
        for (const LinearForm &form : coefficients)
          result.extraction.push_back(form.factor(a));
      return result;
    }

    /// The control point that is this combination of others.
    ControlPoint combination(const LinearForm &form, const std::vector<ControlPoint> &points)
    {
      double weight = 0.;
      Tensor<1, 3> sum;
      for (const auto &[a, factor] : form.terms)
      {
        weight += factor * points[a].weight;
        sum += factor * points[a].weight * points[a].position;
      }
      return {Point<3>(sum / weight), weight};
    }

    /// Vertices that only see faces of caps have nothing left to say: their numbers go to the last
    /// of the caps' own functions.
    void fill_unused(std::vector<FaceCoefficients> &faces,
                     std::vector<ControlPoint> &control_points)
    {
      std::vector<bool> used(control_points.size(), false);
      for (const FaceCoefficients &face : faces)
        for (const LinearForm &form : face)
          for (const auto &term : form.terms)
            used[term.first] = true;
      std::map<unsigned int, unsigned int> renamed;
      for (unsigned int a = 0; a < control_points.size(); ++a)
        if (!used[a])
        {
          renamed[control_points.size() - 1] = a;
          control_points[a] = control_points.back();
          control_points.pop_back();
        }
      if (renamed.empty())
        return;
      for (FaceCoefficients &face : faces)
        for (LinearForm &form : face)
          for (const auto &[from, to] : renamed)
            if (const auto found = form.terms.find(from); found != form.terms.end())
            {
              form.terms[to] = found->second;
              form.terms.erase(found);
            }
    }
  } // namespace

  Surface to_surface(const QuadMesh &mesh, std::vector<ControlPoint> control_points,
                     const bool own_functions)
  {
    AssertDimension(control_points.size(), UnstructuredFunctions(mesh).size());
    const Extractor extractor(mesh);
    std::vector<FaceCoefficients> coefficients(mesh.n_faces());
    for (unsigned int f = 0; f < mesh.n_faces(); ++f)
      coefficients[f] = mesh.is_irregular(f) ? extractor.averaged(f) : extractor.regular(f);

    for (const std::vector<unsigned int> &cap : caps(mesh))
    {
      std::map<unsigned int, FaceCoefficients> regular, initial;
      for (const unsigned int f : cap)
      {
        initial[f] = elevated(coefficients[f]);
        for (unsigned int s = 0; s < 4; ++s)
        {
          const unsigned int other = mesh.neighbour(f, s).face;
          if (!mesh.is_irregular(other))
            regular[other] = elevated(coefficients[other]);
        }
      }
      G1Cap joined = g1_cap(mesh, cap, regular, initial, own_functions, control_points.size());
      for (auto &[f, face] : joined.faces)
        coefficients[f] = std::move(face);
      for (const LinearForm &form : joined.own)
        control_points.push_back(combination(form, control_points));
    }

    if (own_functions)
      fill_unused(coefficients, control_points);
    Surface surface;
    surface.control_points = std::move(control_points);
    for (unsigned int f = 0; f < mesh.n_faces(); ++f)
      surface.elements.push_back(element(coefficients[f], mesh.is_irregular(f) ? cap_degree : 3));
    return surface;
  }
} // namespace semilunar::spline
