// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_VIEWS_GLSL
#define BOXLIGHT_VIEWS_GLSL

#include "frame.glsl"

layout(std430, binding = kBindViews) readonly buffer Views { ViewTriangle viewTriangles[]; };

struct ViewBlend {
  uvec3 view;
  vec3 weight;
};

/// view_sphere.h: ViewSphere::locate.
ViewBlend locateView(vec3 direction) {
  uint t = 0;
  vec3 weight = vec3(0.0);
  for (uint step = 0; step <= frame.viewTriangles; ++step) {
    weight = vec3(dot(direction, viewTriangles[t].rows[0].xyz), dot(direction, viewTriangles[t].rows[1].xyz),
                  dot(direction, viewTriangles[t].rows[2].xyz));
    uint lowest = weight.x <= weight.y ? (weight.x <= weight.z ? 0 : 2) : (weight.y <= weight.z ? 1 : 2);
    if (weight[lowest] >= -1e-6 || step == frame.viewTriangles) break;
    t = viewTriangles[t].neighbour[lowest];
  }
  weight = max(weight, vec3(0.0));
  return ViewBlend(viewTriangles[t].view.xyz, weight / (weight.x + weight.y + weight.z));
}

#endif
