#version 300 es
precision highp float;
in vec2 uv;
in float across;       // 0 … 1 over the rect
uniform sampler2D picture;
uniform int mode;     // 0 a picture, 1 coverage tinted over, 2 coverage as a wash to multiply with
uniform vec4 tint;
uniform float opacity;
uniform vec2 ramp;     // opacity 0 at x, 1 at y, both across; equal: everywhere 1
out vec4 colour;

void main() {
    vec4 texel = texture(picture, uv);
    float o = opacity;
    if (ramp.x != ramp.y) {
        float t = clamp((across - ramp.x) / (ramp.y - ramp.x), 0.0, 1.0);
        o *= t * t * (3.0 - 2.0 * t);
    }
    if (mode == 0) {
        colour = texel * o;
    } else if (mode == 1) {
        float a = texel.r * tint.a * o;
        colour = vec4(tint.rgb * a, a);
    } else {
        colour = vec4(mix(vec3(1.0), tint.rgb, texel.r * tint.a * o), 1.0);
    }
}
