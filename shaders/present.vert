// SPDX-License-Identifier: Apache-2.0
#version 460
// One triangle over the whole window.
void main() { gl_Position = vec4(vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1) * 4.0 - 1.0, 0.0, 1.0); }
