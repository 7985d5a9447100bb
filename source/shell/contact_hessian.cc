// SPDX-License-Identifier: LGPL-2.1-or-later
#include <semilunar/shell/contact.h>
#include <semilunar/shell/pair_block.h>

#include <deal.II/base/work_stream.h>

#include <algorithm>
#include <tuple>

namespace semilunar::shell
{
  using namespace spline;

  /// An active contact point and the two elements that meet there: in ascending order, so that the
  /// points of both come into one block, or the point's first if it touches an image.
  struct Contact::Meeting
  {
    unsigned int image, first, second;
    unsigned int active; // index among the active points

    auto pair() const { return std::tie(image, first, second); }
    bool operator<(const Meeting &other) const
    {
      return std::tie(image, first, second, active) <
             std::tie(other.image, other.first, other.second, other.active);
    }
  };

  struct Contact::HessianScratch
  {
    PairBlock block;
  };

  struct Contact::HessianBlock
  {
    std::vector<unsigned int> control_points;
    std::vector<double> matrix;
  };

  namespace
  {
    /// Replace the displacement of the image, D = turn d, by d in rows and columns from begin on of
    /// a matrix of n x n directions, three after the other belonging to one function.
    void turn_back(std::vector<double> &matrix, const unsigned int n, const unsigned int begin,
                   const dealii::Tensor<2, 3> &turn)
    {
      const auto multiply = [&](double *entry, const unsigned int stride)
      {
        const Tensor<1, 3> old({entry[0], entry[stride], entry[2 * stride]});
        const Tensor<1, 3> turned = old * turn;
        for (unsigned int d = 0; d < 3; ++d)
          entry[d * stride] = turned[d];
      };
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = begin; j < n; j += 3)
          multiply(&matrix[std::size_t(i) * n + j], 1);
      for (unsigned int i = begin; i < n; i += 3)
        for (unsigned int j = 0; j < n; ++j)
          multiply(&matrix[std::size_t(i) * n + j], n);
    }
  } // namespace

  SecondVariation Contact::energy_variation(const unsigned int contact_point) const
  {
    const ContactPoint &point = near[contact_point];
    const double half_weight = 0.5 * points.weight(point.q);
    SecondVariation form =
        second_variation(details[contact_point].foot, details[contact_point].side);
    for (auto &row : form)
      for (auto &block : row)
        block *= -half_weight * point.pressure;
    form[0][0] +=
        half_weight * details[contact_point].slope * outer_product(point.normal, point.normal);
    return form;
  }

  std::vector<Contact::Meeting> Contact::meetings() const
  {
    std::vector<Meeting> result;
    for (unsigned int k = 0; k < active.size(); ++k)
    {
      const ContactPoint &point = near[active[k]];
      const unsigned int own = points.element(point.q), partner = point.partner.element;
      if (point.image == 0)
        result.push_back({0, std::min(own, partner), std::max(own, partner), k});
      else
        result.push_back({point.image, own, partner, k});
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  void Contact::compute_block(const Meeting *const begin, const Meeting *const end,
                              HessianScratch &scratch, HessianBlock &block) const
  {
    const BezierElement &first = surface.elements[begin->first],
                        &second = surface.elements[begin->second];
    scratch.block.reinit({{first.n_functions(), second.n_functions()}});
    for (const Meeting *meeting = begin; meeting != end; ++meeting)
    {
      const unsigned int k = meeting->active, q = near[active[k]].q;
      scratch.block.add(points.element(q) == begin->first ? 0 : 1, points.basis(q, spline::value),
                        partner_bases.data() + partner_offsets[k], energy_variation(active[k]));
    }
    scratch.block.copy_to(block.matrix);
    block.control_points = first.control_points;
    block.control_points.insert(block.control_points.end(), second.control_points.begin(),
                                second.control_points.end());
    if (begin->image > 0)
      turn_back(block.matrix, 3 * block.control_points.size(), 3 * first.n_functions(),
                symmetry.turn(begin->image));
  }

  void Contact::add_hessian(const AddBlock &add) const
  {
    const std::vector<Meeting> all = meetings();
    std::vector<std::size_t> starts; // of the blocks
    for (std::size_t i = 0; i < all.size(); ++i)
      if (i == 0 || all[i].pair() != all[i - 1].pair())
        starts.push_back(i);
    const auto work = [&](const std::vector<std::size_t>::const_iterator &start,
                          HessianScratch &scratch, HessianBlock &block)
    {
      const std::size_t end = start + 1 == starts.end() ? all.size() : *(start + 1);
      compute_block(&all[*start], all.data() + end, scratch, block);
    };
    const auto copy = [&](const HessianBlock &block) { add(block.control_points, block.matrix); };
    dealii::WorkStream::run(starts.cbegin(), starts.cend(), work, copy, HessianScratch(),
                            HessianBlock());
  }
} // namespace semilunar::shell
