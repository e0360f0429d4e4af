/* OpenGL's functions of the reference's libOSMesa and of this project's, side by side.
 *
 * Not alone: registry.py writes gl_registry.h, which it includes. */
#ifndef OSMESA_TWO_LIBRARIES_H
#define OSMESA_TWO_LIBRARIES_H

#include <gl_registry.h>
#include <stdbool.h>

#include "GL/osmesa.h"

#define OSMESA_FUNCTIONS(X)                                                                        \
    X(OSMesaCreateContextExt)                                                                      \
    X(OSMesaCreateContextAttribs)                                                                  \
    X(OSMesaMakeCurrent)                                                                           \
    X(OSMesaDestroyContext)                                                                        \
    X(OSMesaPixelStore)                                                                            \
    X(OSMesaGetIntegerv)                                                                           \
    X(OSMesaGetCurrentContext)

/* The functions of OpenGL that the tests call. */
#define TESTED_FUNCTIONS(X)                                                                        \
    X(ActiveTexture)                                                                               \
    X(AlphaFunc)                                                                                   \
    X(ArrayElement)                                                                                \
    X(Begin)                                                                                       \
    X(BindBuffer)                                                                                  \
    X(BindFramebuffer)                                                                             \
    X(BindRenderbuffer)                                                                            \
    X(BindTexture)                                                                                 \
    X(Bitmap)                                                                                      \
    X(BlendColor)                                                                                  \
    X(BlendEquation)                                                                               \
    X(BlendEquationSeparate)                                                                       \
    X(BlendFunc)                                                                                   \
    X(BlendFuncSeparate)                                                                           \
    X(BlitFramebuffer)                                                                             \
    X(BufferData)                                                                                  \
    X(BufferSubData)                                                                               \
    X(CallList)                                                                                    \
    X(CallLists)                                                                                   \
    X(CheckFramebufferStatus)                                                                      \
    X(Clear)                                                                                       \
    X(ClearColor)                                                                                  \
    X(ClearDepth)                                                                                  \
    X(ClearIndex)                                                                                  \
    X(ClearStencil)                                                                                \
    X(ClientActiveTexture)                                                                         \
    X(ClipControl)                                                                                 \
    X(ClipPlane)                                                                                   \
    X(Color3b)                                                                                     \
    X(Color3f)                                                                                     \
    X(Color3i)                                                                                     \
    X(Color3s)                                                                                     \
    X(Color3ub)                                                                                    \
    X(Color3ui)                                                                                    \
    X(Color3us)                                                                                    \
    X(Color4d)                                                                                     \
    X(Color4f)                                                                                     \
    X(Color4fv)                                                                                    \
    X(Color4ub)                                                                                    \
    X(ColorMask)                                                                                   \
    X(ColorMaterial)                                                                               \
    X(ColorPointer)                                                                                \
    X(CopyPixels)                                                                                  \
    X(CopyTexImage1D)                                                                              \
    X(CopyTexImage2D)                                                                              \
    X(CopyTexSubImage1D)                                                                           \
    X(CopyTexSubImage2D)                                                                           \
    X(CopyTexSubImage3D)                                                                           \
    X(CullFace)                                                                                    \
    X(DeleteBuffers)                                                                               \
    X(DeleteFramebuffers)                                                                          \
    X(DeleteLists)                                                                                 \
    X(DeleteRenderbuffers)                                                                         \
    X(DeleteTextures)                                                                              \
    X(DepthFunc)                                                                                   \
    X(DepthMask)                                                                                   \
    X(DepthRange)                                                                                  \
    X(Disable)                                                                                     \
    X(DisableClientState)                                                                          \
    X(DrawArrays)                                                                                  \
    X(DrawBuffer)                                                                                  \
    X(DrawBuffers)                                                                                 \
    X(DrawElements)                                                                                \
    X(DrawPixels)                                                                                  \
    X(DrawRangeElements)                                                                           \
    X(EdgeFlag)                                                                                    \
    X(EdgeFlagPointer)                                                                             \
    X(Enable)                                                                                      \
    X(EnableClientState)                                                                           \
    X(End)                                                                                         \
    X(EndList)                                                                                     \
    X(Finish)                                                                                      \
    X(Flush)                                                                                       \
    X(FogCoordd)                                                                                   \
    X(FogCoordf)                                                                                   \
    X(FogCoordPointer)                                                                             \
    X(Fogf)                                                                                        \
    X(Fogfv)                                                                                       \
    X(Fogi)                                                                                        \
    X(Fogiv)                                                                                       \
    X(FramebufferRenderbuffer)                                                                     \
    X(FramebufferTexture2D)                                                                        \
    X(FramebufferTexture3D)                                                                        \
    X(FramebufferTextureLayer)                                                                     \
    X(FrontFace)                                                                                   \
    X(Frustum)                                                                                     \
    X(GenBuffers)                                                                                  \
    X(GenerateMipmap)                                                                              \
    X(GenFramebuffers)                                                                             \
    X(GenLists)                                                                                    \
    X(GenRenderbuffers)                                                                            \
    X(GenTextures)                                                                                 \
    X(GetBooleanv)                                                                                 \
    X(GetBufferParameteriv)                                                                        \
    X(GetBufferSubData)                                                                            \
    X(GetDoublev)                                                                                  \
    X(GetClipPlane)                                                                                \
    X(GetError)                                                                                    \
    X(GetFloatv)                                                                                   \
    X(GetIntegerv)                                                                                 \
    X(GetLightfv)                                                                                  \
    X(GetLightiv)                                                                                  \
    X(GetMaterialfv)                                                                               \
    X(GetMaterialiv)                                                                               \
    X(GetPixelMapfv)                                                                               \
    X(GetPixelMapuiv)                                                                              \
    X(GetPolygonStipple)                                                                           \
    X(GetRenderbufferParameteriv)                                                                  \
    X(GetString)                                                                                   \
    X(GetTexEnvfv)                                                                                 \
    X(GetTexEnviv)                                                                                 \
    X(GetTexGenfv)                                                                                 \
    X(GetTexImage)                                                                                 \
    X(GetTexLevelParameterfv)                                                                      \
    X(GetTexLevelParameteriv)                                                                      \
    X(GetTexParameterfv)                                                                           \
    X(GetTexParameteriv)                                                                           \
    X(Hint)                                                                                        \
    X(Indexd)                                                                                      \
    X(IndexMask)                                                                                   \
    X(IndexPointer)                                                                                \
    X(InterleavedArrays)                                                                           \
    X(IsBuffer)                                                                                    \
    X(IsEnabled)                                                                                   \
    X(IsList)                                                                                      \
    X(IsTexture)                                                                                   \
    X(Lightf)                                                                                      \
    X(Lightfv)                                                                                     \
    X(Lighti)                                                                                      \
    X(Lightiv)                                                                                     \
    X(LightModelf)                                                                                 \
    X(LightModelfv)                                                                                \
    X(LightModeli)                                                                                 \
    X(LightModeliv)                                                                                \
    X(LineStipple)                                                                                 \
    X(LineWidth)                                                                                   \
    X(ListBase)                                                                                    \
    X(LoadIdentity)                                                                                \
    X(LoadMatrixd)                                                                                 \
    X(LoadMatrixf)                                                                                 \
    X(LoadTransposeMatrixf)                                                                        \
    X(LogicOp)                                                                                     \
    X(MapBuffer)                                                                                   \
    X(Materialf)                                                                                   \
    X(Materialfv)                                                                                  \
    X(Materiali)                                                                                   \
    X(Materialiv)                                                                                  \
    X(MatrixMode)                                                                                  \
    X(MultiTexCoord2f)                                                                             \
    X(MultiTexCoord4f)                                                                             \
    X(MultMatrixd)                                                                                 \
    X(MultMatrixf)                                                                                 \
    X(MultTransposeMatrixd)                                                                        \
    X(NewList)                                                                                     \
    X(Normal3b)                                                                                    \
    X(Normal3d)                                                                                    \
    X(Normal3f)                                                                                    \
    X(Normal3i)                                                                                    \
    X(Normal3s)                                                                                    \
    X(NormalPointer)                                                                               \
    X(Ortho)                                                                                       \
    X(PixelMapfv)                                                                                  \
    X(PixelMapuiv)                                                                                 \
    X(PixelMapusv)                                                                                 \
    X(PixelStoref)                                                                                 \
    X(PixelStorei)                                                                                 \
    X(PixelTransferf)                                                                              \
    X(PixelTransferi)                                                                              \
    X(PixelZoom)                                                                                   \
    X(PointSize)                                                                                   \
    X(PolygonMode)                                                                                 \
    X(PolygonOffset)                                                                               \
    X(PolygonStipple)                                                                              \
    X(PopAttrib)                                                                                   \
    X(PopClientAttrib)                                                                             \
    X(PopMatrix)                                                                                   \
    X(PushAttrib)                                                                                  \
    X(PushClientAttrib)                                                                            \
    X(PushMatrix)                                                                                  \
    X(RasterPos2d)                                                                                 \
    X(RasterPos2f)                                                                                 \
    X(RasterPos3f)                                                                                 \
    X(RasterPos4f)                                                                                 \
    X(RasterPos4i)                                                                                 \
    X(ReadBuffer)                                                                                  \
    X(ReadPixels)                                                                                  \
    X(Rectf)                                                                                       \
    X(Recti)                                                                                       \
    X(RenderbufferStorage)                                                                         \
    X(RenderbufferStorageMultisample)                                                              \
    X(Rotated)                                                                                     \
    X(Rotatef)                                                                                     \
    X(SampleCoverage)                                                                              \
    X(Scalef)                                                                                      \
    X(Scissor)                                                                                     \
    X(SecondaryColor3b)                                                                            \
    X(SecondaryColor3f)                                                                            \
    X(SecondaryColorPointer)                                                                       \
    X(ShadeModel)                                                                                  \
    X(StencilFunc)                                                                                 \
    X(StencilFuncSeparate)                                                                         \
    X(StencilMask)                                                                                 \
    X(StencilMaskSeparate)                                                                         \
    X(StencilOp)                                                                                   \
    X(StencilOpSeparate)                                                                           \
    X(TexCoord1f)                                                                                  \
    X(TexCoord2f)                                                                                  \
    X(TexCoord3d)                                                                                  \
    X(TexCoord3f)                                                                                  \
    X(TexCoord4f)                                                                                  \
    X(TexCoordPointer)                                                                             \
    X(TexEnvf)                                                                                     \
    X(TexEnvfv)                                                                                    \
    X(TexEnvi)                                                                                     \
    X(TexEnviv)                                                                                    \
    X(TexGenf)                                                                                     \
    X(TexGenfv)                                                                                    \
    X(TexGeni)                                                                                     \
    X(TexImage1D)                                                                                  \
    X(TexImage2D)                                                                                  \
    X(TexImage3D)                                                                                  \
    X(TexParameterf)                                                                               \
    X(TexParameterfv)                                                                              \
    X(TexParameteri)                                                                               \
    X(TexParameteriv)                                                                              \
    X(TexSubImage1D)                                                                               \
    X(TexSubImage2D)                                                                               \
    X(TexSubImage3D)                                                                               \
    X(Translatef)                                                                                  \
    X(UnmapBuffer)                                                                                 \
    X(Vertex2f)                                                                                    \
    X(Vertex3f)                                                                                    \
    X(Vertex4f)                                                                                    \
    X(VertexPointer)                                                                               \
    X(Viewport)                                                                                    \
    X(WindowPos2i)                                                                                 \
    X(WindowPos3f)

typedef struct library {
    const char *name;
#define MEMBER(name) __typeof__(name) *name;
    OSMESA_FUNCTIONS(MEMBER)
#undef MEMBER
#define MEMBER(name) __typeof__(gl##name) *name;
    TESTED_FUNCTIONS(MEMBER)
#undef MEMBER
    OSMesaContext context;
} library;

enum { REFERENCE, OURS, LIBRARIES };

/* Loads the reference's library and the one at `path`, in the pinned environment. Returns false
 * after a message if one of them cannot be loaded or lacks a function. */
bool load_libraries(const char *path, library libraries[LIBRARIES]);

#endif
