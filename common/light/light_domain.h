// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/base/math.h"

namespace boxlight {

/// The light domain is the equirectangular map, u in [0,1) periodic, v in [0,1] from +Y down to -Y:
///   u = 1/2 + atan2(d.z, d.x) / 2 pi,   v = acos(d.y) / pi.
/// Centre column = +X, 3/4 = +Z. d is a unit vector that points away from the surface.
vec2 directionToUv(vec3 direction);

/// The inverse of directionToUv.
vec3 uvToDirection(vec2 uv);

/// Solid angle in steradians of the phi-theta rectangle [*, * + du] x [v0, v1]: 2 pi du (cos(pi v0) - cos(pi
/// v1)).
double rectangleSolidAngle(double du, double v0, double v1);

/// A phi-theta rectangle of the light domain in double precision; u may lie outside [0,1) and wraps.
struct Rectangle {
  double u0 = 0, v0 = 0, du = 0, dv = 0;
  double solidAngle() const;
};

/// Mean of the unit vectors of the rectangle [u0, u0 + du] x [v0, v0 + dv], by solid angle: its length falls
/// from 1 for a point to 0 for the whole sphere. du, dv > 0.
///   y  = cos t cos h ,  (x, z) = (cos p, sin p) sin(pi du)/(pi du) (sin t cos h + (h - sin h cos h)/(2 sin t
///   sin h)),
/// with t and p the angles of its centre, h half its extent in theta: the integrals of sin^2 and of sin cos.
dvec3 meanDirection(double u0, double v0, double du, double dv);

/// `--env-rotation` turns the environment by `degrees` about +Y, counter-clockwise seen from above. A box or
/// a direction at u then reads the unrotated map at u + environmentOffset(degrees), modulo 1.
float environmentOffset(float degrees);

}  // namespace boxlight
