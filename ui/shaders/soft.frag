#version 300 es
precision highp float;
in vec2 q;
flat in vec4 ink;
out vec4 colour;

void main() {
    float t = clamp(1.0 - dot(q, q), 0.0, 1.0);
    float a = ink.a * t * t;
    colour = vec4(ink.rgb * a, a);
}
