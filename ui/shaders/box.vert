#version 300 es
// A rounded rectangle an instance: rect is x, y, width, height in pixels, y down.
layout(location = 0) in vec4 rect;
layout(location = 1) in vec3 shape;  // corner radius, border width, softness of the edge
layout(location = 2) in vec4 fill_colour;
layout(location = 3) in vec4 border_colour;
uniform vec2 viewport;
uniform float flip;
out vec2 from_centre;
flat out vec2 half_size;
flat out vec3 form;
flat out vec4 fill;
flat out vec4 border;

void main() {
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    float pad = shape.z + 1.0;
    vec2 p = mix(rect.xy - pad, rect.xy + rect.zw + pad, corner);
    half_size = rect.zw * 0.5;
    from_centre = p - rect.xy - half_size;
    form = shape;
    fill = fill_colour;
    border = border_colour;
    vec2 ndc = p / viewport * 2.0 - 1.0;
    gl_Position = vec4(ndc.x, ndc.y * flip, 0.0, 1.0);
}
