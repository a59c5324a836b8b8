#version 300 es
precision highp float;
in vec3 n;
in vec2 fabric;
in vec2 quad;
uniform sampler2D tile;
uniform vec3 plain;      // colour where there is no fabric
uniform float woven;     // 1: the tile instead
uniform float lines;     // strength of the quads' edges
out vec4 colour;

void main() {
    vec3 surface = woven > 0.0 ? texture(tile, fabric).rgb : plain;
    vec3 normal = normalize(n);
    float inside = 1.0;
    if (normal.z < 0.0) {  // the inner side of the cloth
        normal = -normal;
        inside = 0.80;
    }
    if (lines > 0.0) {
        vec2 width = fwidth(quad);
        vec2 away = min(quad, 1.0 - quad) / max(width, vec2(1e-4));
        // lines that come closer than four pixels would darken the cloth as a whole
        vec2 strength = clamp(vec2(0.30) / max(width, vec2(1e-4)) * 0.4, 0.0, 1.0);
        vec2 edge = clamp(1.1 - away, 0.0, 1.0) * strength;
        surface *= 1.0 - lines * max(edge.x, edge.y);
    }
    vec3 key = normalize(vec3(-0.42, 0.72, 0.58));
    vec3 fill = normalize(vec3(0.75, 0.05, 0.60));
    float sky = 0.5 + 0.5 * normal.y;
    float diffuse = max(dot(normal, key) * 0.88 + 0.12, 0.0);
    vec3 light = mix(vec3(0.60, 0.57, 0.54), vec3(0.68, 0.69, 0.71), sky)
               + vec3(0.42, 0.41, 0.39) * diffuse
               + vec3(0.09, 0.09, 0.10) * max(dot(normal, fill), 0.0);
    float edge = pow(1.0 - clamp(normal.z, 0.0, 1.0), 2.0);
    light *= (1.0 - 0.26 * edge) * inside;
    colour = vec4(min(surface * light, 1.0), 1.0);
}
