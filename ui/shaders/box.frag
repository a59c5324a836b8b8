#version 300 es
precision highp float;
in vec2 from_centre;
flat in vec2 half_size;
flat in vec3 form;
flat in vec4 fill;
flat in vec4 border;
out vec4 colour;

void main() {
    float radius = min(form.x, min(half_size.x, half_size.y));
    vec2 q = abs(from_centre) - half_size + radius;
    float d = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - radius;
    if (form.z > 0.0) {
        // the integral of a bell curve across a straight edge, close to a blurred box
        float t = clamp(0.5 - d / (2.0 * form.z), 0.0, 1.0);
        float a = fill.a * t * t * (3.0 - 2.0 * t);
        colour = vec4(fill.rgb * a, a);
        return;
    }
    float outer = clamp(0.5 - d, 0.0, 1.0);
    float inner = form.y > 0.0 ? clamp(0.5 - d - form.y, 0.0, 1.0) : outer;
    float fill_a = fill.a * inner, border_a = border.a * (outer - inner);
    colour = vec4(fill.rgb * fill_a + border.rgb * border_a, fill_a + border_a);
}
