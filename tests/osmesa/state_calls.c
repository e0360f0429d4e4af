/* Calls of matrices, lights, textures and other state, by number of their kind. */
#include "state_calls.h"

#include <math.h>

/* The reference has more texture units: a unit that both have, or a number that is none. */
static GLenum unit_of(const arguments *a)
{
    return a->i[0] & 4 ? a->e[0] & 0xFFF : GL_TEXTURE0 + (GLenum)(a->i[0] & 3);
}

void call_function(const library *gl, unsigned kind, const arguments *a)
{
    const GLenum *const e = a->e;
    const GLint *const i = a->i;
    const GLfloat *const f = a->f;
    const GLdouble *const d = a->d;

    switch (kind) {
    case 0:
        gl->AlphaFunc(e[0], f[0]);
        break;
    case 1:
        gl->BlendColor(f[0], f[1], f[2], f[3]);
        break;
    case 2:
        gl->BlendEquation(e[0]);
        break;
    case 3:
        gl->BlendEquationSeparate(e[0], e[1]);
        break;
    case 4:
        gl->BlendFunc(e[0], e[1]);
        break;
    case 5:
        gl->BlendFuncSeparate(e[0], e[1], e[2], e[3]);
        break;
    case 6:
        gl->ClearColor(f[0], f[1], f[2], f[3]);
        break;
    case 7:
        gl->ClearDepth(d[0]);
        break;
    case 8:
        gl->ClearIndex(fabsf(f[0])); /* glPopAttrib makes negative ones 0 in the reference */
        break;
    case 9:
        gl->ClearStencil(i[0]);
        break;
    case 10:
        gl->Color3b((GLbyte)i[0], (GLbyte)i[1], (GLbyte)i[2]);
        break;
    case 11:
        gl->Color3i(i[0], i[1], i[2]);
        break;
    case 12:
        gl->Color3s((GLshort)i[0], (GLshort)i[1], (GLshort)i[2]);
        break;
    case 13:
        gl->Color3ub((GLubyte)i[0], (GLubyte)i[1], (GLubyte)i[2]);
        break;
    case 14:
        gl->Color3ui((GLuint)i[0], (GLuint)i[1], (GLuint)i[2]);
        break;
    case 15:
        gl->Color3us((GLushort)i[0], (GLushort)i[1], (GLushort)i[2]);
        break;
    case 16:
        gl->Color4d(d[0], d[1], d[2], d[3]);
        break;
    case 17:
        gl->Color4f(f[0], f[1], f[2], f[3]);
        break;
    case 18:
        gl->ColorMask((GLboolean)(i[0] & 1), (GLboolean)i[1], (GLboolean)(i[2] & 1), 1);
        break;
    case 19:
        gl->CullFace(e[0]);
        break;
    case 20:
        gl->DepthFunc(e[0]);
        break;
    case 21:
        gl->DepthMask((GLboolean)(i[0] & 1));
        break;
    case 22:
        gl->DepthRange(d[0], d[1]);
        break;
    case 23:
        gl->DrawBuffer(e[0]);
        break;
    case 24:
        gl->EdgeFlag((GLboolean)(i[0] & 1));
        break;
    case 25:
        gl->FogCoordd(d[0]);
        break;
    case 26:
        gl->FrontFace(e[0]);
        break;
    case 27:
        gl->Hint(e[0], e[1]);
        break;
    case 28:
        gl->Indexd(d[0]);
        break;
    case 29:
        gl->IndexMask((GLuint)i[0]);
        break;
    case 30:
        gl->LineStipple(i[0], (GLushort)i[1]);
        break;
    case 31:
        gl->LineWidth(f[0]);
        break;
    case 32:
        gl->LogicOp(e[0]);
        break;
    case 33:
        gl->MultiTexCoord4f(GL_TEXTURE0 + (GLenum)(i[0] & 3), f[0], f[1], f[2], f[3]);
        break;
    case 34:
        gl->Normal3b((GLbyte)i[0], (GLbyte)i[1], (GLbyte)i[2]);
        break;
    case 35:
        gl->Normal3d(d[0], d[1], d[2]);
        break;
    case 36:
        gl->Normal3i(i[0], i[1], i[2]);
        break;
    case 37:
        gl->Normal3s((GLshort)i[0], (GLshort)i[1], (GLshort)i[2]);
        break;
    case 38:
        gl->PixelStorei(e[0] + GL_UNPACK_SWAP_BYTES - 8, i[0]);
        break;
    case 39:
        gl->PixelStorei(GL_UNPACK_SWAP_BYTES + (GLenum)(i[1] & 15), i[0]);
        break;
    case 40:
        gl->PixelStoref(GL_PACK_SWAP_BYTES + (GLenum)(i[1] & 7), f[0]);
        break;
    case 41:
        gl->PointSize(f[0]);
        break;
    case 42:
        gl->PolygonMode(e[0], e[1]);
        break;
    case 43:
        gl->PolygonOffset(f[0], f[1]);
        break;
    case 44:
        gl->ReadBuffer(e[0]);
        break;
    case 45:
        gl->SampleCoverage(f[0], (GLboolean)(i[0] & 1));
        break;
    case 46:
        gl->Scissor(i[0], i[1], i[2], i[3]);
        break;
    case 47:
        gl->SecondaryColor3f(f[0], f[1], f[2]);
        break;
    case 48:
        gl->SecondaryColor3b((GLbyte)i[0], (GLbyte)i[1], (GLbyte)i[2]);
        break;
    case 49:
        gl->ShadeModel(e[0]);
        break;
    case 50:
        gl->StencilFunc(e[0], i[0], (GLuint)i[1]);
        break;
    case 51:
        gl->StencilFuncSeparate(e[0], e[1], i[0], (GLuint)i[1]);
        break;
    case 52:
        gl->StencilMask((GLuint)i[0]);
        break;
    case 53:
        gl->StencilMaskSeparate(e[0], (GLuint)i[0]);
        break;
    case 54:
        gl->StencilOp(e[0], e[1], e[2]);
        break;
    case 55:
        gl->StencilOpSeparate(e[0], e[1], e[2], e[3]);
        break;
    case 56:
        gl->TexCoord3d(d[0], d[1], d[2]);
        break;
    case 57:
        gl->Viewport(i[0], i[1], i[2], i[3]);
        break;
    case 58:
        gl->VertexPointer(i[0], e[0], a->stride, NULL);
        break;
    case 59:
        gl->ColorPointer(i[0], e[0], a->stride, NULL);
        break;
    case 60:
        gl->NormalPointer(e[0], a->stride & 2047, NULL);
        break; /* -1 sets its type there */
    case 61:
        gl->TexCoordPointer(i[0], e[0], a->stride, NULL);
        break;
    case 62:
        gl->IndexPointer(e[0], a->stride, NULL);
        break;
    case 63:
        gl->FogCoordPointer(e[0], a->stride, NULL);
        break;
    case 64:
        gl->SecondaryColorPointer(i[0], e[0], a->stride, NULL);
        break;
    case 65:
        gl->EdgeFlagPointer(a->stride & 2047, NULL);
        break;
    case 66:
        gl->InterleavedArrays(GL_V2F - 1 + (GLenum)(i[0] & 15), a->stride, NULL);
        break;
    case 67:
        gl->ClientActiveTexture(unit_of(a));
        break;
    case 68:
        gl->ActiveTexture(unit_of(a));
        break;
    case 69:
        gl->EnableClientState(a->name);
        break;
    case 70:
        gl->DisableClientState(a->name);
        break;
    case 71:
        gl->Fogf(GL_FOG_INDEX + (GLenum)(i[0] & 3), f[0]); /* the reference takes GL_FOG_COLOR */
        break;
    case 72:
        gl->Fogi(i[0] & 1 ? GL_FOG_MODE : GL_FOG_COORDINATE_SOURCE - (GLenum)(i[0] & 2),
                 i[1] & 4 ? i[2] : GL_EXP + (i[1] & 1));
        break;
    case 73:
        gl->Fogfv(GL_FOG_INDEX + (GLenum)(i[0] & 7), f);
        break;
    case 74:
        gl->PointParameterf(GL_POINT_SIZE_MIN + (GLenum)(i[0] & 3), f[0]);
        break;
    case 75:
        gl->PointParameterfv(i[0] & 3 ? GL_POINT_DISTANCE_ATTENUATION : e[0], f);
        break;
    case 76:
        gl->PointParameteri(GL_POINT_SIZE_MIN + (GLenum)(i[0] & 3), i[1]);
        break;
    default:
        (i[0] & 1) ? gl->Enable(a->name) : gl->Disable(a->name);
        break;
    }
}

/* Names that lights, their model and materials have, and one that none has. */
static const GLenum light_names[] = {
    GL_AMBIENT,
    GL_DIFFUSE,
    GL_SPECULAR,
    GL_POSITION,
    GL_SPOT_DIRECTION,
    GL_SPOT_EXPONENT,
    GL_SPOT_CUTOFF,
    GL_CONSTANT_ATTENUATION,
    GL_LINEAR_ATTENUATION,
    GL_QUADRATIC_ATTENUATION,
    GL_EMISSION,
    GL_SHININESS,
    GL_AMBIENT_AND_DIFFUSE,
    GL_COLOR_INDEXES,
    GL_LIGHT_MODEL_AMBIENT,
    GL_LIGHT_MODEL_LOCAL_VIEWER,
    GL_LIGHT_MODEL_TWO_SIDE,
    GL_LIGHT_MODEL_COLOR_CONTROL,
    12345,
};

static GLenum light_name(GLint i, unsigned first, unsigned count)
{
    return light_names[(first + (unsigned)i % count) % (sizeof light_names / sizeof *light_names)];
}

void call_light(const library *gl, unsigned kind, const arguments *a)
{
    const GLenum light = GL_LIGHT0 + (GLenum)(a->i[0] & 1) + (a->i[0] % 32 == 0 ? 8u : 0u);
    const GLenum face = a->i[0] & 7 ? GL_FRONT_AND_BACK - (a->i[0] & 2 ? 0u : 3u) : a->e[0];
    const GLenum of_light = light_name(a->i[1], 0, 11), of_material = light_name(a->i[1], 10, 9);
    const GLenum of_model = light_name(a->i[1], 14, 5);
    const GLfloat color_control = (GLfloat)GL_SINGLE_COLOR + (GLfloat)(a->i[2] & 3);
    const GLfloat *const model_values =
        of_model == GL_LIGHT_MODEL_COLOR_CONTROL ? &color_control : a->f;

    switch (kind) {
    case 0:
        gl->Lightfv(light, of_light, a->f);
        break;
    case 1:
        gl->Lightf(light, light_name(a->i[1], 5, 5), 20.0f * a->f[0]);
        break;
    case 2:
        gl->Lightiv(light, of_light, a->i);
        break;
    case 3:
        gl->Lighti(light, light_name(a->i[1], 5, 6), a->i[2]);
        break;
    case 4:
        gl->Materialfv(face, of_material, a->f);
        break;
    case 5:
        gl->Materialf(face, GL_SHININESS, 100.0f * a->f[0]);
        break;
    case 6:
        gl->Materialiv(face, of_material, a->i);
        break;
    case 7:
        gl->Materiali(face, a->i[1] & 7 ? GL_SHININESS : 12345, a->i[2]);
        break;
    case 8:
        gl->LightModelfv(of_model, model_values);
        break;
    case 9:
        gl->LightModelf(of_model, model_values[0]);
        break;
    case 10:
        gl->LightModeliv(of_model, a->i);
        break;
    case 11:
        gl->LightModeli(of_model, (GLint)model_values[0]);
        break;
    default:
        gl->ColorMaterial(face, light_name(a->i[1], 10, 4));
    }
}

/* Names that parameters, environments and generated coordinates of textures have, and one that
 * none has; values that some of them take. */
static const GLenum texture_names[] = {
    GL_TEXTURE_WRAP_S,     GL_TEXTURE_WRAP_T,     GL_TEXTURE_WRAP_R,       GL_TEXTURE_MAG_FILTER,
    GL_TEXTURE_MIN_FILTER, GL_TEXTURE_PRIORITY,   GL_TEXTURE_MIN_LOD,      GL_TEXTURE_MAX_LOD,
    GL_TEXTURE_LOD_BIAS,   GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_BORDER_COLOR, 12345};
static const GLenum texture_values[] = {GL_REPEAT,
                                        GL_CLAMP,
                                        GL_CLAMP_TO_EDGE,
                                        GL_CLAMP_TO_BORDER,
                                        GL_MIRRORED_REPEAT,
                                        GL_NEAREST,
                                        GL_LINEAR,
                                        GL_MODULATE,
                                        GL_LINEAR_MIPMAP_LINEAR,
                                        GL_DECAL,
                                        GL_EYE_LINEAR,
                                        GL_OBJECT_LINEAR,
                                        GL_SPHERE_MAP,
                                        GL_REFLECTION_MAP,
                                        GL_NORMAL_MAP,
                                        GL_BLEND,
                                        GL_ADD,
                                        12345};

/* What GL_COMBINE has and takes. */
static const GLenum combine_names[] = {
    GL_TEXTURE_ENV_MODE,  GL_COMBINE_RGB,     GL_COMBINE_ALPHA,  GL_SOURCE0_RGB,
    GL_SOURCE1_RGB,       GL_SOURCE2_RGB,     GL_SOURCE3_RGB_NV, GL_SOURCE0_ALPHA,
    GL_SOURCE3_ALPHA_NV,  GL_OPERAND0_RGB,    GL_OPERAND2_RGB,   GL_OPERAND0_ALPHA,
    GL_OPERAND3_ALPHA_NV, GL_OPERAND3_RGB_NV, GL_OPERAND1_ALPHA};
static const GLenum combine_values[] = {GL_COMBINE,
                                        GL_COMBINE4_NV,
                                        GL_REPLACE,
                                        GL_MODULATE,
                                        GL_ADD,
                                        GL_ADD_SIGNED,
                                        GL_INTERPOLATE,
                                        GL_SUBTRACT,
                                        GL_DOT3_RGB,
                                        GL_DOT3_RGBA_EXT,
                                        GL_MODULATE_ADD_ATI,
                                        GL_TEXTURE,
                                        GL_CONSTANT,
                                        GL_PREVIOUS,
                                        GL_PRIMARY_COLOR,
                                        GL_TEXTURE0,
                                        GL_TEXTURE3,
                                        GL_ONE,
                                        GL_ZERO,
                                        GL_SRC_COLOR,
                                        GL_ONE_MINUS_SRC_COLOR,
                                        GL_SRC_ALPHA,
                                        GL_ONE_MINUS_SRC_ALPHA,
                                        12345};

static GLenum one_of(const GLenum *list, size_t size, GLint i)
{
    return list[(unsigned)i % (size / sizeof *list)];
}

void call_texture(const library *gl, unsigned kind, const arguments *a)
{
    const GLenum name = one_of(texture_names, sizeof texture_names, a->i[0]);
    const GLint value = (GLint)one_of(texture_values, sizeof texture_values, a->i[1]);
    const GLenum target = a->i[2] & 15 ? GL_TEXTURE_1D + (GLenum)(a->i[2] & 1) : 12345;
    const GLenum coordinate = a->i[2] & 15 ? GL_S + (GLenum)(a->i[2] & 3) : 12345;

    switch (kind) {
    case 0:
        gl->TexParameteri(target, name, value);
        break;
    case 1:
        gl->TexParameterf(target, name, a->f[0]);
        break;
    case 2:
        gl->TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, a->f);
        break;
    case 3:
        gl->TexEnvi(a->i[0] & 7 ? GL_TEXTURE_ENV : GL_BLEND, GL_TEXTURE_ENV_MODE, value);
        break;
    case 4:
        gl->TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, a->f);
        break;
    case 5:
        gl->TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, a->f[0]);
        break;
    case 6:
        gl->TexGeni(coordinate, a->i[0] & 7 ? GL_TEXTURE_GEN_MODE : GL_EYE_PLANE, value);
        break;
    case 7:
        gl->TexEnvi(GL_TEXTURE_ENV, one_of(combine_names, sizeof combine_names, a->i[0]),
                    (GLint)one_of(combine_values, sizeof combine_values, a->i[1]));
        break;
    case 8:
        gl->TexEnvf(GL_TEXTURE_ENV, a->i[0] & 1 ? GL_RGB_SCALE : GL_ALPHA_SCALE,
                    (GLfloat)(a->i[1] & 7));
        break;
    case 9: {
        const GLuint names[2] = {(GLuint)a->i[0] & 3, (GLuint)a->i[1] & 3};

        gl->PrioritizeTextures(a->i[2] & 7 ? 2 : -1, names, a->f);
        break;
    }
    case 10: {
        const GLuint textures[2] = {(GLuint)a->i[0] & 3, (GLuint)a->i[1] & 3};
        GLboolean residences[2];

        (void)gl->AreTexturesResident(a->i[2] & 7 ? a->i[2] & 1 : -1, textures, residences);
        break;
    }
    default:
        gl->TexGenfv(coordinate, a->i[0] & 1 ? GL_EYE_PLANE : GL_OBJECT_PLANE, a->f);
    }
}

void call_matrix(const library *gl, unsigned kind, const arguments *a)
{
    const GLfloat *const f = a->f;
    const GLdouble *const d = a->d;

    switch (kind) {
    case 0:
        gl->MatrixMode(a->e[0] >= GL_TEXTURE0 ? GL_FRONT : a->e[0]);
        break;
    case 1:
        gl->LoadIdentity();
        break;
    case 2:
        gl->LoadMatrixf(f);
        break;
    case 3:
        gl->LoadMatrixd(d);
        break;
    case 4:
        gl->LoadTransposeMatrixf(f);
        break;
    case 5:
        gl->MultMatrixf(f);
        break;
    case 6:
        gl->MultMatrixd(d);
        break;
    case 7:
        gl->MultTransposeMatrixd(d);
        break;
    case 8:
        gl->PushMatrix();
        break;
    case 9:
        gl->PopMatrix();
        break;
    case 10:
        gl->Rotatef(90.0f * f[0], f[1], f[2], f[3]);
        break;
    case 11:
        gl->Rotated(90.0 * d[0], 0.0, 0.0, d[3]);
        break;
    case 12:
        gl->Translatef(f[0], f[1], f[2]);
        break;
    case 13:
        gl->Scalef(f[0], f[1], f[2]);
        break;
    case 14:
        gl->Frustum(d[0], d[1], d[2], d[3], fabs(d[4]), d[5]);
        break;
    case 15:
        gl->Ortho(d[0], d[1], d[2], d[3], d[4], d[5]);
        break;
    case 16:
        gl->ClipPlane(a->i[0] & 31 ? GL_CLIP_PLANE0 + (GLenum)(a->i[0] & 7) : a->e[0], d);
        break;
    default:
        gl->MatrixMode((GLenum)(GL_MODELVIEW + (a->i[0] & 1)));
        break;
    }
}
