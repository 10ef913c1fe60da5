// SPDX-License-Identifier: Apache-2.0
#ifndef BOXLIGHT_VIEWS_GLSL
#define BOXLIGHT_VIEWS_GLSL

#include "frame.glsl"

layout(std430, binding = kBindViews) readonly buffer Views { ViewTriangle viewTriangles[]; };

struct ViewBlend {
  uvec3 view;
  vec3 weight;
};

/// view_sphere.h: ViewSphere::locate, on the sphere of `count` triangles from the first one on.
ViewBlend locateView(vec3 direction, uint first, uint count) {
  uint t = first;
  vec3 weight = vec3(0.0);
  for (uint step = 0; step <= count; ++step) {
    weight = vec3(dot(direction, viewTriangles[t].rows[0].xyz), dot(direction, viewTriangles[t].rows[1].xyz),
                  dot(direction, viewTriangles[t].rows[2].xyz));
    uint lowest = weight.x <= weight.y ? (weight.x <= weight.z ? 0 : 2) : (weight.y <= weight.z ? 1 : 2);
    if (weight[lowest] >= -1e-6 || step == count) break;
    t = first + viewTriangles[t].neighbour[lowest];
  }
  weight = max(weight, vec3(0.0));
  return ViewBlend(viewTriangles[t].view.xyz, weight / (weight.x + weight.y + weight.z));
}

#endif
