// The ready-made shaders of gnomon/shaders.h in GLSL ES 3.00, with operations in the same order.
// A `#define` for each map and for each rule of the convention stands before these texts.

const HEAD = `
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DShadow;
`;

// Depths of other conventions become OpenGL's.
const PLACE = `
uniform mat4 clip_from_model;
void place_vertex(vec4 position)
{
    vec4 clip = clip_from_model * position;
#ifdef ZERO_TO_ONE
    clip.z = 2.0 * clip.z - clip.w;
#endif
    gl_Position = clip;
    gl_PointSize = point_size;
}
`;

const ATTRIBUTES = `
layout(location = 0) in vec4 position;
layout(location = 1) in vec4 color;
layout(location = 2) in vec4 normal;
layout(location = 3) in vec4 texcoord;
layout(location = 4) in vec4 tangent;
uniform float point_size;
`;

const PLAIN_VERTEX = `
out vec4 shade;
out vec2 coordinates;
void main()
{
    place_vertex(position);
    shade = color;
    coordinates = texcoord.st;
}
`;

const GOURAUD_VERTEX = `
uniform mat3 normal_matrix;
uniform vec3 light_direction, ambient, diffuse;
out vec4 shade;
out vec2 coordinates;
void main()
{
    place_vertex(position);
    vec3 n = normalize(normal_matrix * normal.xyz);
    float lit = max(dot(n, light_direction), 0.0);
    shade = vec4(color.rgb * (ambient + diffuse * lit), color.a);
    coordinates = texcoord.st;
}
`;

const SURFACE_VERTEX = `
uniform mat4 world_from_model;
uniform mat3 normal_matrix;
out vec4 shade;
out vec2 coordinates;
out vec3 turned_normal;
out vec3 place;
out vec4 turned_tangent;
vec3 unit_or_zero(vec3 v)
{
    float square = dot(v, v);
    return square > 0.0 ? v * (1.0 / sqrt(square)) : vec3(0.0);
}
void main()
{
    place_vertex(position);
    shade = color;
    coordinates = texcoord.st;
    turned_normal = unit_or_zero(normal_matrix * normal.xyz);
    place = (world_from_model * position).xyz;
    turned_tangent = vec4(unit_or_zero(mat3(world_from_model) * tangent.xyz), tangent.w);
}
`;

// Beside maps that do not repeat is a border of white, which a linear filter mixes with the edge.
const LOOKUP = `
float inside(float place, float size)
{
    float steps = min(place, 1.0 - place) * size;
#ifdef LINEAR
    return clamp(steps + 0.5, 0.0, 1.0);
#else
    return step(0.0, steps);
#endif
}
vec4 lookup(sampler2D map, vec2 at)
{
    vec4 texel = texture(map, at);
#if defined(BORDER_S) || defined(BORDER_T)
    vec2 size = vec2(textureSize(map, 0));
    float share = 1.0;
#ifdef BORDER_S
    share *= inside(at.s, size.x);
#endif
#ifdef BORDER_T
    share *= inside(at.t, size.y);
#endif
    texel = mix(vec4(1.0), texel, share);
#endif
    return texel;
}
`;

const CUT = `
uniform float alpha_cutoff;
void cut(float alpha)
{
#ifdef CUTOFF
    if (alpha < alpha_cutoff)
        discard;
#endif
}
`;

const SHADED_FRAGMENT = LOOKUP + CUT + `
in vec4 shade;
in vec2 coordinates;
uniform sampler2D diffuse_map;
layout(location = 0) out vec4 result;
void main()
{
#ifdef DIFFUSE_MAP
    result = shade * lookup(diffuse_map, coordinates);
#else
    result = shade;
#endif
    cut(result.a);
}
`;

const DEPTH_VERTEX = `
void main()
{
    place_vertex(position);
}
`;

const DEPTH_FRAGMENT = `
uniform float black, white;
layout(location = 0) out vec4 result;
void main()
{
    result = vec4(vec3((gl_FragCoord.z - black) / (white - black)), 1.0);
}
`;

const SURFACE = LOOKUP + CUT + `
in vec4 shade;
in vec2 coordinates;
in vec3 turned_normal;
in vec3 place;
in vec4 turned_tangent;
uniform sampler2D diffuse_map, normal_map, specular_map, glow_map;
uniform sampler2DShadow shadow_map;
uniform mat3 normal_matrix;
uniform mat4 shadow_from_world;
uniform vec3 light_direction, ambient, diffuse, specular, eye;
uniform uint exponent;
uniform float bands;
layout(location = 0) out vec4 result;
vec4 surface_color()
{
#ifdef DIFFUSE_MAP
    return shade * lookup(diffuse_map, coordinates);
#else
    return shade;
#endif
}
vec3 surface_normal()
{
    vec3 n = turned_normal;
#ifdef NORMAL_MAP
    vec3 m = lookup(normal_map, coordinates).xyz * 2.0 - 1.0;
#ifdef TANGENTS
    vec3 bitangent = cross(n, turned_tangent.xyz) * turned_tangent.w;
    n = m.x * turned_tangent.xyz + m.y * bitangent + m.z * n;
#else
    n = normal_matrix * m;
#endif
#endif
    return normalize(n);
}
float light_that_arrives()
{
#ifdef SHADOW_MAP
    vec4 seen = shadow_from_world * vec4(place, 1.0);
    vec3 at = (seen.xyz / seen.w) * 0.5 + 0.5;
    float answer = texture(shadow_map, at);
    // WebGL has no border of 1 around a map.
    bool inside = all(greaterThanEqual(at.xy, vec2(0.0))) && all(lessThanEqual(at.xy, vec2(1.0)));
    return inside ? answer : 1.0;
#else
    return 1.0;
#endif
}
vec4 lit_color(vec4 c, float lit)
{
    return vec4(c.rgb * (ambient + diffuse * lit), c.a);
}
`;

const FLAT_MAIN = `
void main()
{
    float left = light_that_arrives();
    vec3 n = normalize(cross(dFdx(place), dFdy(place)));
    result = lit_color(surface_color(), max(dot(n, light_direction), 0.0) * left);
    cut(result.a);
}
`;

const TOON_MAIN = `
void main()
{
    float left = light_that_arrives();
    vec4 c = surface_color();
    float lit = max(dot(normalize(turned_normal), light_direction), 0.0);
    lit = min(floor(lit * bands), bands - 1.0) / (bands - 1.0);
    result = lit_color(c, lit * left);
    cut(result.a);
}
`;

const SHINY_MAIN = `
float power(float base, uint exponent)
{
    float p = 1.0;
    for (; exponent > 0u; exponent >>= 1) {
        if ((exponent & 1u) != 0u)
            p = p * base;
        base = base * base;
    }
    return p;
}
void main()
{
    float left = light_that_arrives();
    vec3 to_eye = normalize(eye - place);
    vec3 n = surface_normal();
    float cosine = dot(n, light_direction);
#ifdef BLINN
    float highlight = dot(n, normalize(light_direction + to_eye));
#else
    float highlight = dot((2.0 * cosine) * n - light_direction, to_eye);
#endif
    highlight = power(max(highlight, 0.0), exponent);
    float shine = cosine > 0.0 ? highlight : 0.0;
    vec3 s = specular;
#ifdef SPECULAR_MAP
    s = s * lookup(specular_map, coordinates).rgb;
#endif
    vec4 c = surface_color();
    vec3 rgb = lit_color(c, max(cosine, 0.0) * left).rgb;
#ifdef GLOW_MAP
    rgb = rgb + lookup(glow_map, coordinates).rgb;
#endif
    rgb = rgb + s * (shine * left);
    result = vec4(rgb, c.a);
    cut(result.a);
}
`;

const NORMALS_MAIN = `
void main()
{
    result = vec4(0.5 * surface_normal() + 0.5, 1.0);
}
`;

// The vertex and the fragment shader of each name.
const PAIRS = {
    "vertex-color": [PLAIN_VERTEX, SHADED_FRAGMENT],
    "unlit": [PLAIN_VERTEX, SHADED_FRAGMENT],
    "gouraud": [GOURAUD_VERTEX, SHADED_FRAGMENT],
    "flat": [SURFACE_VERTEX, SURFACE + FLAT_MAIN],
    "toon": [SURFACE_VERTEX, SURFACE + TOON_MAIN],
    "phong": [SURFACE_VERTEX, SURFACE + SHINY_MAIN],
    "blinn-phong": [SURFACE_VERTEX, SURFACE + SHINY_MAIN],
    "normals": [SURFACE_VERTEX, SURFACE + NORMALS_MAIN],
    "depth": [DEPTH_VERTEX, DEPTH_FRAGMENT],
};

// The maps that each shader reads; the table is in gnomon/shaders.h.
const READS = {
    "vertex-color": [],
    "unlit": ["diffuse"],
    "gouraud": ["diffuse"],
    "flat": ["diffuse", "shadow"],
    "toon": ["diffuse", "shadow"],
    "phong": ["diffuse", "normal", "specular", "glow", "shadow"],
    "blinn-phong": ["diffuse", "normal", "specular", "glow", "shadow"],
    "normals": ["normal"],
    "depth": [],
};

// The names of a draw's maps that its shader reads.
export function mapsOf(draw) {
    return READS[draw.shader].filter((kind) => draw.maps && draw.maps[kind]);
}

// What can be asked of a draw's fragments, as expressions in its fragment shader, with the names that the
// explained pixel (tools/explain) has for their components.
export function probesOf(draw) {
    const isDepth = draw.shader === "depth";
    const [, fragment] = PAIRS[draw.shader];
    const probes = isDepth ? [] : [
        { names: ["red", "green", "blue", "alpha"], text: "shade" },
        { names: ["s", "t"], text: "vec4(coordinates, 0.0, 0.0)" },
    ];
    if (fragment.includes("turned_normal"))
        probes.push(
            { names: ["normal.x", "normal.y", "normal.z"], text: "vec4(turned_normal, 0.0)" },
            { names: ["place.x", "place.y", "place.z"], text: "vec4(place, 0.0)" },
            { names: ["tangent.x", "tangent.y", "tangent.z"], text: "turned_tangent" }
        );
    for (const kind of mapsOf(draw).filter((name) => name !== "shadow"))
        probes.push({
            names: ["red", "green", "blue", "alpha"].map((channel) => `${kind}_map.${channel}`),
            text: `lookup(${kind}_map, coordinates)`,
        });
    return [...probes, { names: ["shaded.red", "shaded.green", "shaded.blue", "shaded.alpha"], text: "result" }];
}

// Returns the two texts of a draw's program. With a probe, the fragment shader returns that expression.
export function programTexts(draw, description, probe = "") {
    const pair = PAIRS[draw.shader];
    if (!pair)
        throw new Error(`WebGL has no shader "${draw.shader}"`);
    const names = mapsOf(draw).map((kind) => `${kind.toUpperCase()}_MAP`);
    const { wrapS, wrapT, magnify } = draw.sampler;
    if (wrapS === "clamp-to-border")
        names.push("BORDER_S");
    if (wrapT === "clamp-to-border")
        names.push("BORDER_T");
    if (magnify === "linear")
        names.push("LINEAR");
    if (draw.alphaCutoff > 0)
        names.push("CUTOFF");
    if (draw.normalsOfTangents)
        names.push("TANGENTS");
    if (draw.shader === "blinn-phong")
        names.push("BLINN");
    if (description.zeroToOne)
        names.push("ZERO_TO_ONE");
    const head = "#version 300 es\n" + names.map((name) => `#define ${name}\n`).join("") + HEAD;
    const asked = probe === "" ? "" : `\nvoid main()\n{\n    shade_fragment();\n    result = ${probe};\n}\n`;
    const fragment = probe === "" ? pair[1] : pair[1].replace("void main()", "void shade_fragment()");
    return { vertex: head + ATTRIBUTES + PLACE + pair[0], fragment: head + fragment + asked };
}
