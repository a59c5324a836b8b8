#version 300 es
precision highp float;
in vec2 p;
flat in vec4 axis;
flat in vec2 radius;
uniform vec4 tint;      // alpha 0: write the coverage itself
out vec4 colour;

void main() {
    vec2 along = axis.zw - axis.xy;
    float t = clamp(dot(p - axis.xy, along) / max(dot(along, along), 1e-6), 0.0, 1.0);
    float d = length(p - axis.xy - along * t) - mix(radius.x, radius.y, t);
    float a = clamp(0.5 - d, 0.0, 1.0);
    colour = tint.a > 0.0 ? vec4(tint.rgb * tint.a * a, tint.a * a) : vec4(a);
}
