#version 300 es
// A mesh seen by a parallel camera. The rows of the camera turn the normalised frame into right, up, nearness.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 own_colour;
uniform vec3 right;
uniform vec3 up;
uniform vec3 toward;
uniform vec4 fit;      // picture = plane * fit.xy + fit.zw, both -1 … 1, y down in the picture
uniform float mirror;  // -1 shows the model flipped left-right
out vec3 n;
out vec2 plane;
out vec3 own;
out float height;

void main() {
    plane = vec2(dot(right, position), dot(up, position));
    n = vec3(dot(right, normal) * mirror, dot(up, normal), dot(toward, normal));
    own = own_colour;
    height = plane.y;
    gl_Position = vec4(plane * fit.xy + fit.zw, -dot(toward, position) * 0.45, 1.0);
}
