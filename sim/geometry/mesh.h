#pragma once

#include <array>
#include <vector>

#include <Eigen/Geometry>

namespace eod::sim {

/// Corners counter-clockwise seen from outside.
using Triangle = std::array<Eigen::Vector3d, 3>;
using Mesh = std::vector<Triangle>;

/// Box centred on the origin; `size` is the whole length along X, Y, Z [m].
Mesh BoxMesh(const Eigen::Vector3d& size);

/// Prism of `sides` >= 3 inscribed in a cylinder along Z, centred on the origin, closed.
Mesh CylinderMesh(double radius, double length, int sides);

/// Cone along Z: base at -length/2, tip at +length/2, closed.
Mesh ConeMesh(double radius, double length, int sides);

/// Sphere of `rings` >= 2 bands and `sides` >= 3 meridians, inscribed.
Mesh SphereMesh(double radius, int rings, int sides);

/// Capsule along Z, inscribed like the sphere; `length` is that of its straight part.
Mesh CapsuleMesh(double radius, double length, int rings, int sides);

/// Rectangle in the XY plane facing +Z, cut into cells no longer than `cell` [m].
Mesh PlaneMesh(double size_x, double size_y, double cell);

/// `mesh`, given in B, with every corner in A.
Mesh Transformed(const Eigen::Isometry3d& X_AB, Mesh mesh);

}  // namespace eod::sim
