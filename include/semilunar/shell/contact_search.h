// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_contact_search_h
#define semilunar_shell_contact_search_h

#include <semilunar/shell/contact_foot.h>
#include <semilunar/shell/oriented_box.h>
#include <semilunar/shell/quadrature_points.h>
#include <semilunar/shell/spatial_hash.h>
#include <semilunar/spline/cyclic_symmetry.h>

namespace semilunar::shell
{
  /// Finds the nearest points of the other parts of a surface (parts as in
  /// spline::connected_parts) to its quadrature points, as far as they are within reach. A part is
  /// another part of itself where its points were far from each other before deformation. If the
  /// surface is one sector of a symmetric body, the images of its parts are further parts.
  class ContactSearch
  {
  public:
    struct Neighbor
    {
      unsigned int part;          ///< part that holds the foot
      unsigned int image;         ///< of the symmetry, that holds the foot
      spline::SurfacePoint point; ///< of the sector, whose image is the foot
      ContactFoot foot;
    };

    /// @param reach          distance up to which neighbors are reported
    /// @param self_distance  undeformed distance beyond which points of one part are neighbors; 0:
    /// none are
    ContactSearch(const spline::Surface &surface, const QuadraturePoints &points, double reach,
                  double self_distance,
                  const spline::CyclicSymmetry &symmetry = spline::CyclicSymmetry());

    /// Move the control points to @p x (finite). Everything below refers to this configuration.
    void update(const std::vector<spline::Tensor<1, 3>> &x);

    const spline::Tensor<1, 3> &position(const unsigned int q) const { return x_q[q]; }
    /// Replace @p neighbors by those of point q, at most one per part, in ascending order of parts.
    /// @return the number of projections on elements that it took
    unsigned int find(unsigned int q, std::vector<Neighbor> &neighbors) const;

    /// Parts of the sector; the images of part p are p + n_parts(), p + 2 n_parts(), ...
    unsigned int n_parts() const { return number_of_parts; }
    unsigned int part(const unsigned int element) const { return parts[element]; }
    /// Of a point of the sector.
    spline::Tensor<1, 3> undeformed_position(const spline::SurfacePoint &point) const;

  private:
    struct Candidate
    {
      unsigned int part, patch;
      double lower_bound; // of the distance
    };
    void gather(unsigned int q, std::vector<Candidate> &candidates) const;
    bool may_be_neighbors(unsigned int q, unsigned int patch) const;
    bool is_admissible(unsigned int q, const Neighbor &neighbor) const;
    spline::Point<2> starting_point(unsigned int patch, const spline::Tensor<1, 3> &x) const;

    const spline::Surface &surface;
    const QuadraturePoints &points;
    const double reach, self_distance;
    const spline::CyclicSymmetry symmetry;
    std::vector<unsigned int> parts; // per element
    unsigned int number_of_parts;
    std::vector<spline::BezierPatch> undeformed;
    std::vector<spline::BezierPatch> patches;    // of the elements of image 0, then of image 1, ...
    std::vector<std::array<bool, 4>> free_sides; // only for contact of a part with itself
    std::vector<spline::Tensor<1, 3>> undeformed_x_q, x_q;
    std::vector<OrientedBox> boxes;
    SpatialHash hash;
  };
} // namespace semilunar::shell

#endif
