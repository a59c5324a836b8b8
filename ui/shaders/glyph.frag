#version 300 es
precision highp float;
in vec2 uv;
flat in vec4 ink;
uniform sampler2D atlas;
out vec4 colour;

void main() {
    float a = ink.a * texture(atlas, uv).r;
    colour = vec4(ink.rgb * a, a);
}
