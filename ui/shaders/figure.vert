#version 300 es
// The figure and its cloth seen by a view of the garment engine: parallel, or from an eye.
layout(location = 0) in vec3 position;  // cm
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 on_fabric; // in tiles
layout(location = 3) in vec2 on_quad;   // 0 … 1 along both sides of the quad; 0.5 where there is none
uniform vec3 centre;
uniform vec3 right;
uniform vec3 up;
uniform vec3 toward;
uniform vec4 fit;       // picture = plane * fit.xy + fit.zw, both -1 … 1, y down in the picture
uniform vec3 depth;     // a, b, 1 / distance of the eye (0: parallel): depth is a + b * nearness before the division
out vec3 n;
out vec2 fabric;
out vec2 quad;

void main() {
    vec3 from = position - centre;
    vec3 seen = vec3(dot(right, from), dot(up, from), dot(toward, from));
    float w = 1.0 - seen.z * depth.z;
    n = vec3(dot(right, normal), dot(up, normal), dot(toward, normal));
    fabric = on_fabric;
    quad = on_quad;
    gl_Position = vec4(seen.xy * fit.xy + fit.zw * w, depth.x + depth.y * seen.z, w);
}
