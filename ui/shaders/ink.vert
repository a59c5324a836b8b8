#version 300 es
// One piece of a stroke an instance: a tapered capsule between two points.
layout(location = 0) in vec4 ends;   // x, y of both ends, pixels of the layer, y down
layout(location = 1) in vec2 radii;
uniform vec2 viewport;
uniform float flip;
out vec2 p;
flat out vec4 axis;
flat out vec2 radius;

void main() {
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    float pad = max(radii.x, radii.y) + 1.0;
    vec2 low = min(ends.xy, ends.zw) - pad, high = max(ends.xy, ends.zw) + pad;
    p = mix(low, high, corner);
    axis = ends;
    radius = radii;
    vec2 ndc = p / viewport * 2.0 - 1.0;
    gl_Position = vec4(ndc.x, ndc.y * flip, 0.0, 1.0);
}
