#include "sim/camera/shaders.h"

namespace eod::sim {

const std::string_view kSurfaceVertexShader = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in uint a_bone;
layout(location = 3) in vec2 a_uv;
layout(location = 4) in vec4 a_material;
layout(location = 5) in vec4 a_light;     // lamps, sky
uniform vec4 u_bones[4 * 60];     // rows of each bone's pose in the module; lamps and sky
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
#ifdef WET
uniform float u_wetness;
out float v_wet;
#endif
void main() {
  int row = int(a_bone) * 4;
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
  vec4 around = u_bones[row + 3];
  float sky = a_light.a * around.a;
  v_light.rgb = mix(u_ground_light, u_sky_light, 0.5 + 0.5 * normal.z) * sky +
                4.0 * a_light.rgb * a_light.rgb + around.rgb;
  // Beyond the shadow map, what sees little of the sky sees nothing of the sun.
  v_light.a = max(dot(normal, u_to_sun), 0.0) * min(5.0 * sky, 1.0);
#ifdef WET
  v_wet = u_wetness * smoothstep(0.3, 0.9, sky) * smoothstep(0.2, 0.95, normal.z);
#endif
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
#ifdef SPOTS
uniform vec4 u_spot_place[SPOTS]; // position, 1 / range^2
uniform vec4 u_spot_way[SPOTS];   // direction, cosine where it is dark
uniform vec4 u_spot_light[SPOTS]; // colour, 1 / difference of the cone's cosines
uniform vec3 u_spot_fade[SPOTS];  // 1 / (x + y d + z d^2)
#endif
#ifdef WET
uniform vec3 u_sheen;
in float v_wet;
#endif
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
#ifdef SPOTS
  for (int i = 0; i < SPOTS; ++i) {
    vec3 ray = v_position - u_spot_place[i].xyz;
    float squared = dot(ray, ray);
    float inverse = inversesqrt(squared);
    float cone = clamp((dot(ray, u_spot_way[i].xyz) * inverse - u_spot_way[i].w) *
                       u_spot_light[i].w, 0.0, 1.0);
    float share = min(squared * u_spot_place[i].w, 1.0);
    float window = (1.0 - share * share) * cone;
    float facing = max(-dot(v_normal, ray) * inverse, 0.0);
    light += u_spot_light[i].rgb * (window * window * facing /
             (u_spot_fade[i].x + squared * (u_spot_fade[i].y * inverse + u_spot_fade[i].z)));
  }
#endif
#ifdef WET
  albedo *= 1.0 - 0.5 * v_wet;
#endif
  vec3 colour = albedo * light + u_sun_light * (shine * sun);
#ifdef WET
  float grazing = 1.0 - max(dot(v_normal, to_eye) / distance, 0.0);
  float grazing2 = grazing * grazing;
  float mirror = 0.03 + WET * grazing2 * grazing2;
  // Water stands where the ground is low, and the texture dark.
  colour += u_sheen * (v_wet * mirror * clamp(1.6 - 1.4 * tone.g, 0.2, 1.0));
#endif
#ifdef INFRARED
  // Leaves throw back most of what is just beyond red.
  colour = vec3(dot(colour, vec3(0.35, 0.60, 0.05)));
#endif
  float clear = exp2(-u_fog_density * distance);
  o_colour = vec4(mix(u_fog_colour, sqrt(colour), clear), 1.0);
}
)";

const std::string_view kShadowVertexShader = R"(
layout(location = 0) in vec3 a_position;
layout(location = 2) in uint a_bone;
uniform vec4 u_bones[4 * 60];
uniform mat4 u_view_projection;
void main() {
  int row = int(a_bone) * 4;
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
uniform float u_grey;             // 1: no colours
in vec2 v_uv;
out vec4 o_colour;
void main() {
  vec3 colour = texture(u_texture, v_uv).rgb;
  o_colour = vec4(mix(colour, vec3(dot(colour, vec3(0.35, 0.60, 0.05))), u_grey), 1.0);
}
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

const std::string_view kPlumeVertexShader = R"(
layout(location = 0) in vec4 a_position;
layout(location = 1) in vec2 a_uv;
layout(location = 2) in vec4 a_colour;
layout(location = 3) in float a_cover;
out vec2 v_uv;
out vec4 v_colour;
out float v_cover;
void main() {
  v_uv = a_uv;
  v_colour = vec4(sqrt(a_colour.rgb), a_colour.a);
  v_cover = a_cover;
  gl_Position = a_position;
}
)";

const std::string_view kPlumeFragmentShader = R"(
uniform sampler2D u_texture;
in vec2 v_uv;
in vec4 v_colour;
in float v_cover;
out vec4 o_colour;
void main() {
  vec4 puff = texture(u_texture, v_uv);
  float alpha = puff.a * v_colour.a;
  // Lumps of light and shade are those of smoke; flame has its own light.
  vec3 colour = v_colour.rgb * mix(1.0, 1.6 * puff.r, v_cover);
  o_colour = vec4(colour * alpha, alpha * v_cover);
}
)";

const std::string_view kEffectsVertexShader = R"(
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

const std::string_view kEffectsFragmentShader = R"(
uniform sampler2D u_grains;
uniform float u_noise;
uniform float u_flash;
uniform vec3 u_shift;
uniform float u_scale;
out vec4 o_colour;
void main() {
  vec2 place = gl_FragCoord.xy * u_scale;
  // Streaks along the lines, and a slow bar that rolls through.
  float grain = texture(u_grains, vec2(0.45 * place.x, place.y) + u_shift.xy).r;
  float bar = texture(u_grains, vec2(u_shift.z, 0.02 * place.y + u_shift.x)).r;
  vec3 noise = vec3(grain * (0.8 + 0.5 * bar));
  float alpha = 1.0 - (1.0 - u_noise) * (1.0 - u_flash);
  o_colour = vec4(mix(noise * u_noise, vec3(1.0), u_flash), alpha);
}
)";

}  // namespace eod::sim
