// SPDX-License-Identifier: Apache-2.0
#version 460
#extension GL_GOOGLE_include_directive : require
// display.comp's words to the window's image.
#include "shared.h"

layout(constant_id = 0) const bool kEncodes = false;  // does the image's format encode sRGB by itself?
layout(std430, binding = kBindDisplay) readonly buffer Display { uint display[]; };
layout(push_constant) uniform Push { DisplayPush push; };
layout(location = 0) out vec4 color;

void main() {
  uvec2 pixel = min(uvec2(gl_FragCoord.xy), push.size - 1);
  vec3 srgb = unpackUnorm4x8(display[pixel.y * push.size.x + pixel.x]).rgb;
  if (kEncodes) srgb = mix(pow((srgb + 0.055) / 1.055, vec3(2.4)), srgb / 12.92, lessThanEqual(srgb, vec3(0.04045)));
  color = vec4(srgb, 1.0);
}
