// A serial chain of rigid links with revolute joints, read from a table.
#ifndef CHAIN_MODEL_H
#define CHAIN_MODEL_H

#include "spatial.h"

#include <string>
#include <vector>

namespace chain {

struct Link {
  int axis;         // of the joint: 0, 1, 2 for x, y, z
  double offset[3]; // of the joint, in the parent's frame
  double mass;
  double centre[3];     // of mass, in the link's frame
  double inertia[3][3]; // about the centre of mass, in the link's frame
};

// The first `count` links of a table with the columns link, axis, r (3), m, c (3), I (xx, xy, xz, yy, yz, zz).
std::vector<Link> read_links(std::string const &file_name, int count);

class Model {
public:
  explicit Model(std::vector<Link> const &links);

  int size() const { return static_cast<int>(links_.size()); }
  std::vector<Link> const &links() const { return links_; }
  Link const &link(int i) const { return links_[i]; }
  SpatialMatrix const &tree_transform(int i) const { return tree_transforms_[i]; }
  SpatialMatrix const &inertia(int i) const { return inertias_[i]; }
  SpatialVector const &axis(int i) const { return axes_[i]; }

  // Ten numbers for each link: m, c (3), I about the centre of mass (xx, xy, xz, yy, yz, zz).
  static int const parameters_per_link = 10;
  std::vector<double> parameters() const;
  void set_parameters(double const *parameters);

private:
  std::vector<Link> links_;
  std::vector<SpatialMatrix> tree_transforms_, inertias_;
  std::vector<SpatialVector> axes_;
};

} // namespace chain

#endif
