#version 300 es
precision highp float;
in vec2 uv;
uniform sampler2D picture;
uniform int mode;     // 0 a picture, 1 coverage tinted over, 2 coverage as a wash to multiply with
uniform vec4 tint;
uniform float opacity;
out vec4 colour;

void main() {
    vec4 texel = texture(picture, uv);
    if (mode == 0) {
        colour = texel * opacity;
    } else if (mode == 1) {
        float a = texel.r * tint.a * opacity;
        colour = vec4(tint.rgb * a, a);
    } else {
        colour = vec4(mix(vec3(1.0), tint.rgb, texel.r * tint.a * opacity), 1.0);
    }
}
