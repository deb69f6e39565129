#include "sim/camera/shaders.h"

namespace eod::sim {

const std::string_view kSurfaceVertexShader = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in uint a_bone;
layout(location = 3) in vec2 a_uv;
layout(location = 4) in vec4 a_material;
uniform vec4 u_bones[3 * 65];     // rows of each bone's pose in the module
uniform mat4 u_view_projection;
uniform mat4 u_shadow_matrix;
uniform vec3 u_eye;
uniform vec3 u_to_sun;
uniform vec3 u_sky_light;
uniform vec3 u_ground_light;
out vec2 v_uv;
out vec4 v_material;
out vec3 v_position;
out vec3 v_normal;
out vec3 v_shadow;
out vec4 v_light;                 // ambient colour, share of the sun
void main() {
  int row = int(a_bone) * 3;
  vec4 here = vec4(a_position, 1.0);
  vec3 position = vec3(dot(u_bones[row], here), dot(u_bones[row + 1], here),
                       dot(u_bones[row + 2], here));
  vec3 normal = vec3(dot(u_bones[row].xyz, a_normal), dot(u_bones[row + 1].xyz, a_normal),
                     dot(u_bones[row + 2].xyz, a_normal));
  v_uv = a_uv;
  v_material = vec4(a_material.rgb * a_material.rgb, a_material.a);
  v_position = position;
  v_normal = normal;
  // The shadow is looked up a little outside the surface, else it would shade itself.
  v_shadow = (u_shadow_matrix * vec4(position + normal * 0.025, 1.0)).xyz;
  v_light = vec4(mix(u_ground_light, u_sky_light, 0.5 + 0.5 * normal.z),
                 max(dot(normal, u_to_sun), 0.0));
  gl_Position = u_view_projection * vec4(position, 1.0);
}
)";

const std::string_view kSurfaceFragmentShader = R"(
uniform sampler2D u_texture;
uniform sampler2D u_variation;
uniform sampler2DShadow u_shadow;
uniform vec3 u_eye;
uniform vec3 u_to_sun;
uniform vec3 u_sun_light;
uniform vec3 u_fog_colour;
uniform float u_fog_density;      // in powers of two per metre
in vec2 v_uv;
in vec4 v_material;
in vec3 v_position;
in vec3 v_normal;
in vec3 v_shadow;
in vec4 v_light;
out vec4 o_colour;
void main() {
  vec3 to_eye = u_eye - v_position;
  float distance = length(to_eye);
#ifdef GROUND
  vec2 slow = texture(u_variation, v_position.xy * 0.021).rg;
  vec3 tone = texture(u_texture, v_position.xy * 0.6).rgb;
  tone = mix(tone, vec3(1.22, 1.10, 0.86) * tone, smoothstep(0.42, 0.72, slow.r));
  tone *= 0.55 + 0.9 * slow.g;
  vec3 albedo = tone * tone * v_material.rgb;
  float shine = 0.0;
#else
  vec3 tone = texture(u_texture, v_uv).rgb;
  // Splashed earth: everything is a little darker and browner near the ground.
  float soil = 0.34 * exp2(-7.0 * max(v_position.z, 0.0));
  vec3 albedo = mix(tone * tone * v_material.rgb, vec3(0.10, 0.085, 0.06), soil);
  vec3 halfway = u_to_sun + to_eye / distance;
  float facing = max(dot(v_normal, halfway), 0.0);
  float facing2 = facing * facing / (dot(halfway, halfway) * dot(v_normal, v_normal));
  float facing8 = facing2 * facing2 * facing2 * facing2;
  float shine = v_material.a * facing8 * facing8 * facing8;
#endif
  float sun = v_light.a * texture(u_shadow, v_shadow);
  vec3 light = v_light.rgb + u_sun_light * sun;
  vec3 colour = albedo * light + u_sun_light * (shine * sun);
  float clear = exp2(-u_fog_density * distance);
  o_colour = vec4(mix(u_fog_colour, sqrt(colour), clear), 1.0);
}
)";

const std::string_view kShadowVertexShader = R"(
layout(location = 0) in vec3 a_position;
layout(location = 2) in uint a_bone;
uniform vec4 u_bones[3 * 65];
uniform mat4 u_view_projection;
void main() {
  int row = int(a_bone) * 3;
  vec4 here = vec4(a_position, 1.0);
  gl_Position = u_view_projection * vec4(dot(u_bones[row], here), dot(u_bones[row + 1], here),
                                         dot(u_bones[row + 2], here), 1.0);
}
)";

const std::string_view kShadowFragmentShader = R"(
void main() {}
)";

const std::string_view kSkyVertexShader = R"(
layout(location = 0) in vec3 a_position;
layout(location = 3) in vec2 a_uv;
uniform mat4 u_view_projection;
out vec2 v_uv;
void main() {
  v_uv = a_uv;
  vec4 position = u_view_projection * vec4(a_position, 1.0);
  gl_Position = position.xyww;   // as far away as can be
}
)";

const std::string_view kSkyFragmentShader = R"(
uniform sampler2D u_texture;
in vec2 v_uv;
out vec4 o_colour;
void main() { o_colour = vec4(texture(u_texture, v_uv).rgb, 1.0); }
)";

const std::string_view kOverlayVertexShader = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec4 a_colour;
out vec4 v_colour;
void main() {
  v_colour = a_colour;
  gl_Position = vec4(a_position, 1.0);
}
)";

const std::string_view kOverlayFragmentShader = R"(
in vec4 v_colour;
out vec4 o_colour;
void main() { o_colour = v_colour; }
)";

}  // namespace eod::sim
