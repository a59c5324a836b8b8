#version 300 es
// A glyph or icon of the atlas an instance.
layout(location = 0) in vec4 rect;   // pixels, y down
layout(location = 1) in vec4 place;  // the same in the atlas, 0 … 1
layout(location = 2) in vec4 tint;
uniform vec2 viewport;
uniform float flip;
out vec2 uv;
flat out vec4 ink;

void main() {
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    uv = place.xy + place.zw * corner;
    ink = tint;
    vec2 ndc = (rect.xy + rect.zw * corner) / viewport * 2.0 - 1.0;
    gl_Position = vec4(ndc.x, ndc.y * flip, 0.0, 1.0);
}
