#include "model.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace chain {

namespace {

void set_symmetric(double matrix[3][3], double xx, double xy, double xz, double yy, double yz, double zz) {
  matrix[0][0] = xx;
  matrix[0][1] = matrix[1][0] = xy;
  matrix[0][2] = matrix[2][0] = xz;
  matrix[1][1] = yy;
  matrix[1][2] = matrix[2][1] = yz;
  matrix[2][2] = zz;
}

} // namespace

std::vector<Link> read_links(std::string const &file_name, int count) {
  std::ifstream file(file_name);
  std::string line;
  std::getline(file, line); // the names of the columns
  std::vector<Link> links;
  while (static_cast<int>(links.size()) < count && std::getline(file, line)) {
    std::istringstream row(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (cells.size() != 15) throw std::runtime_error(file_name + ": a row has 15 cells");
    double values[13];
    for (int k = 0; k < 13; k++) values[k] = std::stod(cells[2 + k]);
    Link link;
    link.axis = cells[1][0] - 'x';
    for (int k = 0; k < 3; k++) link.offset[k] = values[k];
    link.mass = values[3];
    for (int k = 0; k < 3; k++) link.centre[k] = values[4 + k];
    set_symmetric(link.inertia, values[7], values[8], values[9], values[10], values[11], values[12]);
    links.push_back(link);
  }
  if (static_cast<int>(links.size()) < count) throw std::runtime_error(file_name + ": too few links");
  return links;
}

Model::Model(std::vector<Link> const &links) : links_(links) {
  for (Link const &link : links_) {
    tree_transforms_.push_back(translation(link.offset));
    inertias_.push_back(rigid_body_inertia(link.mass, link.centre, link.inertia));
    SpatialVector axis;
    axis[link.axis] = 1.0;
    axes_.push_back(axis);
  }
}

std::vector<double> Model::parameters() const {
  std::vector<double> result;
  for (Link const &link : links_) {
    result.push_back(link.mass);
    for (int k = 0; k < 3; k++) result.push_back(link.centre[k]);
    for (int i = 0; i < 3; i++)
      for (int j = i; j < 3; j++) result.push_back(link.inertia[i][j]);
  }
  return result;
}

void Model::set_parameters(double const *parameters) {
  for (int i = 0; i < size(); i++, parameters += parameters_per_link) {
    Link &link = links_[i];
    link.mass = parameters[0];
    for (int k = 0; k < 3; k++) link.centre[k] = parameters[1 + k];
    set_symmetric(link.inertia, parameters[4], parameters[5], parameters[6], parameters[7], parameters[8],
                  parameters[9]);
    inertias_[i] = rigid_body_inertia(link.mass, link.centre, link.inertia);
  }
}

} // namespace chain
