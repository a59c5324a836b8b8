#version 300 es
precision highp float;
in vec3 n;
in vec2 plane;
in vec3 own;
in float height;
uniform sampler2D parts;    // colour of the part here, alpha its weight; image plane of the camera, top row first
uniform vec3 clay;
uniform float part_share;   // 0.76
uniform float own_share;    // 1 shows the model's own colours instead of clay
out vec4 colour;

void main() {
    vec4 part = texture(parts, vec2(plane.x, -plane.y) * 0.5 + 0.5);
    vec3 base = mix(clay, own, own_share);
    vec3 surface = mix(base, part.rgb / max(part.a, 1e-3), part_share * part.a);
    vec3 normal = normalize(n);
    if (normal.z < 0.0) normal = -normal;  // either winding: the side that is seen faces the viewer

    vec3 key = normalize(vec3(-0.42, 0.72, 0.58));
    vec3 fill = normalize(vec3(0.75, 0.05, 0.60));
    float sky = 0.5 + 0.5 * normal.y;
    float diffuse = max(dot(normal, key) * 0.88 + 0.12, 0.0);
    vec3 light = mix(vec3(0.57, 0.54, 0.51), vec3(0.66, 0.67, 0.69), sky)
               + vec3(0.46, 0.45, 0.43) * diffuse
               + vec3(0.10, 0.10, 0.11) * max(dot(normal, fill), 0.0);
    float edge = pow(1.0 - clamp(normal.z, 0.0, 1.0), 2.0);
    light *= 1.0 - 0.26 * edge;            // turns away, so that light parts keep a shaded edge
    float gloss = pow(max(dot(normal, normalize(key + vec3(0.0, 0.0, 1.0))), 0.0), 28.0);
    colour = vec4(min(surface * light + vec3(0.05) * gloss, 1.0), 1.0);
}
