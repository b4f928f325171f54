// The base complex of a quad mesh by cinolib (https://github.com/mlivesu/cinolib): prints the number of its
// patches.
#include <cinolib/coarse_layout.h>
#include <cinolib/meshes/quadmesh.h>
#include <iostream>
#include <set>

int main(int, char** arguments) {
    cinolib::Quadmesh<> mesh(arguments[1]);
    cinolib::compute_coarse_quad_layout(mesh);
    std::set<int> patches;
    for (unsigned quad = 0; quad < mesh.num_polys(); ++quad)
        patches.insert(mesh.poly_data(quad).label);
    std::cout << '\n' << patches.size() << '\n';
}
