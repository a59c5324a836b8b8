#version 300 es
layout(location = 0) in vec4 rect;   // pixels, y down
layout(location = 1) in vec4 place;  // in the texture, 0 … 1
uniform vec2 viewport;
uniform float flip;
out vec2 uv;
out float across;

void main() {
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    across = corner.x;
    uv = place.xy + place.zw * corner;
    vec2 ndc = (rect.xy + rect.zw * corner) / viewport * 2.0 - 1.0;
    gl_Position = vec4(ndc.x, ndc.y * flip, 0.0, 1.0);
}
