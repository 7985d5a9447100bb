// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef semilunar_shell_contact_h
#define semilunar_shell_contact_h

#include <semilunar/shell/contact_pressure.h>
#include <semilunar/shell/contact_search.h>
#include <semilunar/shell/side_memory.h>

#include <functional>
#include <map>

namespace dealii
{
  class ParameterHandler;
}

namespace semilunar::shell
{
  struct ContactParameters
  {
    bool enabled = false;
    double distance = 0.0237; ///< midsurfaces repel each other below this distance [cm]
    double stiffness = 1e8;   ///< pressure per penetration [dyn/cm^3]
    double smoothing = 0.001; ///< penetration over which the stiffness sets in [cm]
    double self_distance =
        0.; ///< undeformed distance from which a piece touches itself [cm]; 0: never

    /// Declare the entries in subsection "Contact" of the current section.
    void add_parameters(dealii::ParameterHandler &prm);
  };

  /// Frictionless contact of the parts of a shell (pieces that share no control point) with each
  /// other: a penalty potential of the distance between each quadrature point and the nearest point
  /// of another part (both ways, each with half the weight), on the side on which the point was
  /// before it came near. Equations (C1)-(C7) of doc/theory/contact.md.
  ///
  /// Parts that are closer to each other than the contact distance before deformation, as leaflets
  /// at a commissure, start free of forces: there, the undeformed distance takes the place of the
  /// contact distance.
  ///
  /// If the surface is one sector of a symmetric body, its parts touch the images of themselves:
  /// energy, gradient and areas are the sector's share, (C8) and (C9).
  class Contact
  {
  public:
    /// A quadrature point within reach of another part.
    struct ContactPoint
    {
      unsigned int q;               ///< quadrature point
      spline::SurfacePoint partner; ///< nearest point of the other part, or the point of the
                                    ///< sector whose image it is
      unsigned int image;           ///< of the symmetry, that the nearest point belongs to
      spline::Tensor<1, 3> normal;  ///< unit vector along which the gap grows, from the partner to
                                    ///< the point's side of it
      double gap;      ///< distance of the midsurfaces (signed) minus the contact distance
      double pressure; ///< per undeformed area of the point's part
    };

    /// Surface and points must outlive the object. Remembers the sides of the undeformed
    /// configuration; an update() must follow before anything is asked for.
    /// @throws InputError for numbers out of range
    Contact(const spline::Surface &surface, const QuadraturePoints &points,
            const ContactParameters &parameters,
            const spline::CyclicSymmetry &symmetry = spline::CyclicSymmetry());

    /// Find the partners of all points with control points at @p x. Everything below refers to this
    /// state, and asking again for the same one costs nothing. If x is not finite, there are no
    /// contact points and the energy is NaN.
    void update(const std::vector<spline::Tensor<1, 3>> &x);

    /// All points within reach() of another part in ascending order of q, touching or not.
    const std::vector<ContactPoint> &contact_points() const { return near; }
    double energy() const;
    /// Add the derivative of the energy with respect to the control points.
    void add_gradient(std::vector<spline::Tensor<1, 3>> &gradient) const;

    /// Hand over the second derivatives of the energy, one dense block per pair of elements in
    /// contact: the control points involved (c of them, those of the one and then of the other
    /// element, possibly repeated) and the symmetric (3c) x (3c) matrix, row by row. Blocks are
    /// computed by all threads and handed over one after the other, always in the same order.
    using AddBlock = std::function<void(const std::vector<unsigned int> &control_points,
                                        const std::vector<double> &matrix)>;
    void add_hessian(const AddBlock &add) const;

    /// From now on pressures are means over a time step, (D18): the state of an update is that at
    /// this share of the step, whose start is the last accepted state. 1 ends that: pressures are
    /// those of the state again. Energies are of the state only then.
    void set_share_of_step(double share);

    /// The state of the last update is accepted: remember on which side of its neighbors each
    /// point lies.
    void accept();

    /// Save or restore what is remembered of the last accepted state.
    template <class Archive>
    void serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &memory &start_gaps;
      found_at.clear();
    }

    /// Contact distance minus distance of the midsurfaces where that is largest; 0 if nothing
    /// touches. Counts points on the wrong side with a negative distance.
    double largest_penetration() const;
    /// Undeformed area of each part that is under contact pressure.
    std::vector<double> contact_areas() const;
    /// For output, one number per quadrature point: the largest of its pressures (0 away from
    /// contact), and the smallest of its gaps (reach() minus the contact distance if there is
    /// nothing within reach).
    std::vector<double> pressures() const;
    std::vector<double> gaps() const;

    /// Distance up to which neighbors are found and their sides remembered.
    double reach() const { return reach_distance; }
    /// How far any point may move from the last accepted configuration before a point may cross
    /// another part unnoticed.
    double safe_displacement() const { return 0.5 * reach_distance; }
    /// Closest-point projections on single elements in the last update: the cost of the search.
    unsigned long n_projections() const { return projections; }

  private:
    /// What the derivatives need beyond a ContactPoint.
    struct Detail
    {
      unsigned int part;
      int side;
      ContactFoot foot;
      double slope; // d pressure / d penetration
    };
    struct StartGap
    {
      unsigned int q, part;
      double gap;

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &q &part &gap;
      }
    };
    struct Found;
    double contact_distance(unsigned int q, unsigned int part) const;
    int side_of(unsigned int q, const ContactSearch::Neighbor &neighbor) const;
    void append(unsigned int q, const ContactSearch::Neighbor &neighbor, Found &found) const;
    void find_partners();
    void evaluate_partner_bases();
    void remember_undeformed_state();
    /// Second variation of the energy of one contact point, (C6) and (C7).
    SecondVariation energy_variation(unsigned int contact_point) const;
    struct Meeting;
    /// The active points in an order that keeps those of a block together.
    std::vector<Meeting> meetings() const;
    struct HessianScratch;
    struct HessianBlock;
    void compute_block(const Meeting *begin, const Meeting *end, HessianScratch &scratch,
                       HessianBlock &block) const;

    const spline::Surface &surface;
    const QuadraturePoints &points;
    const ContactPressure law;
    const spline::CyclicSymmetry symmetry;
    const double distance;
    const double reach_distance;
    ContactSearch search;
    SideMemory memory;
    std::vector<StartGap> start_gaps; // of the last accepted state, by q and part
    double share_of_step = 1.;
    double start_gap(unsigned int q, unsigned int part) const;
    std::map<std::pair<unsigned int, unsigned int>, double>
        undeformed_distances; // of points (q, part) closer than the contact distance

    std::vector<spline::Tensor<1, 3>> found_at; // positions of the last update, none if outdated
    bool is_finite = false;
    unsigned long projections = 0;
    std::vector<ContactPoint> near;
    std::vector<Detail> details;       // of each in near
    std::vector<unsigned int> active;  // those in near with a pressure
    std::vector<double> partner_bases; // of each active one: values, d/dxi_1, d/dxi_2
    std::vector<std::size_t> partner_offsets;
  };
} // namespace semilunar::shell

#endif
