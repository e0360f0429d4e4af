/* OpenGL's functions that the reference and its tests call. They are pointers, set when the driver
 * is chosen, so a program starts on a machine that has neither driver. A function that is called
 * and not listed here does not compile. */
#ifndef OSMESA_FUNCTIONS_H
#define OSMESA_FUNCTIONS_H

#include <GL/glcorearb.h>

/* In alphabetic order, each with glcorearb.h's type of a pointer to it. */
/* clang-format off */
#define GL_FUNCTIONS(F) \
    F(PFNGLACTIVETEXTUREPROC, glActiveTexture) \
    F(PFNGLATTACHSHADERPROC, glAttachShader) \
    F(PFNGLBEGINQUERYPROC, glBeginQuery) \
    F(PFNGLBINDBUFFERPROC, glBindBuffer) \
    F(PFNGLBINDFRAMEBUFFERPROC, glBindFramebuffer) \
    F(PFNGLBINDRENDERBUFFERPROC, glBindRenderbuffer) \
    F(PFNGLBINDSAMPLERPROC, glBindSampler) \
    F(PFNGLBINDTEXTUREPROC, glBindTexture) \
    F(PFNGLBINDVERTEXARRAYPROC, glBindVertexArray) \
    F(PFNGLBLENDCOLORPROC, glBlendColor) \
    F(PFNGLBLENDEQUATIONSEPARATEIPROC, glBlendEquationSeparatei) \
    F(PFNGLBLENDFUNCSEPARATEIPROC, glBlendFuncSeparatei) \
    F(PFNGLBLITFRAMEBUFFERPROC, glBlitFramebuffer) \
    F(PFNGLBUFFERDATAPROC, glBufferData) \
    F(PFNGLBUFFERSUBDATAPROC, glBufferSubData) \
    F(PFNGLCHECKFRAMEBUFFERSTATUSPROC, glCheckFramebufferStatus) \
    F(PFNGLCLEARPROC, glClear) \
    F(PFNGLCLEARCOLORPROC, glClearColor) \
    F(PFNGLCLEARDEPTHFPROC, glClearDepthf) \
    F(PFNGLCLEARSTENCILPROC, glClearStencil) \
    F(PFNGLCLIPCONTROLPROC, glClipControl) \
    F(PFNGLCOLORMASKPROC, glColorMask) \
    F(PFNGLCOLORMASKIPROC, glColorMaski) \
    F(PFNGLCOMPILESHADERPROC, glCompileShader) \
    F(PFNGLCREATEPROGRAMPROC, glCreateProgram) \
    F(PFNGLCREATESHADERPROC, glCreateShader) \
    F(PFNGLCULLFACEPROC, glCullFace) \
    F(PFNGLDELETEBUFFERSPROC, glDeleteBuffers) \
    F(PFNGLDELETEFRAMEBUFFERSPROC, glDeleteFramebuffers) \
    F(PFNGLDELETEPROGRAMPROC, glDeleteProgram) \
    F(PFNGLDELETEQUERIESPROC, glDeleteQueries) \
    F(PFNGLDELETERENDERBUFFERSPROC, glDeleteRenderbuffers) \
    F(PFNGLDELETESAMPLERSPROC, glDeleteSamplers) \
    F(PFNGLDELETESHADERPROC, glDeleteShader) \
    F(PFNGLDELETETEXTURESPROC, glDeleteTextures) \
    F(PFNGLDELETEVERTEXARRAYSPROC, glDeleteVertexArrays) \
    F(PFNGLDEPTHFUNCPROC, glDepthFunc) \
    F(PFNGLDEPTHMASKPROC, glDepthMask) \
    F(PFNGLDEPTHRANGEINDEXEDPROC, glDepthRangeIndexed) \
    F(PFNGLDISABLEPROC, glDisable) \
    F(PFNGLDISABLEIPROC, glDisablei) \
    F(PFNGLDISABLEVERTEXATTRIBARRAYPROC, glDisableVertexAttribArray) \
    F(PFNGLDRAWARRAYSPROC, glDrawArrays) \
    F(PFNGLDRAWARRAYSINSTANCEDPROC, glDrawArraysInstanced) \
    F(PFNGLDRAWBUFFERPROC, glDrawBuffer) \
    F(PFNGLDRAWBUFFERSPROC, glDrawBuffers) \
    F(PFNGLDRAWELEMENTSINSTANCEDPROC, glDrawElementsInstanced) \
    F(PFNGLDRAWELEMENTSINSTANCEDBASEVERTEXPROC, glDrawElementsInstancedBaseVertex) \
    F(PFNGLENABLEPROC, glEnable) \
    F(PFNGLENABLEIPROC, glEnablei) \
    F(PFNGLENABLEVERTEXATTRIBARRAYPROC, glEnableVertexAttribArray) \
    F(PFNGLENDQUERYPROC, glEndQuery) \
    F(PFNGLFINISHPROC, glFinish) \
    F(PFNGLFRAMEBUFFERRENDERBUFFERPROC, glFramebufferRenderbuffer) \
    F(PFNGLFRAMEBUFFERTEXTUREPROC, glFramebufferTexture) \
    F(PFNGLFRAMEBUFFERTEXTURE2DPROC, glFramebufferTexture2D) \
    F(PFNGLFRAMEBUFFERTEXTURELAYERPROC, glFramebufferTextureLayer) \
    F(PFNGLFRONTFACEPROC, glFrontFace) \
    F(PFNGLGENBUFFERSPROC, glGenBuffers) \
    F(PFNGLGENERATEMIPMAPPROC, glGenerateMipmap) \
    F(PFNGLGENFRAMEBUFFERSPROC, glGenFramebuffers) \
    F(PFNGLGENQUERIESPROC, glGenQueries) \
    F(PFNGLGENRENDERBUFFERSPROC, glGenRenderbuffers) \
    F(PFNGLGENSAMPLERSPROC, glGenSamplers) \
    F(PFNGLGENTEXTURESPROC, glGenTextures) \
    F(PFNGLGENVERTEXARRAYSPROC, glGenVertexArrays) \
    F(PFNGLGETERRORPROC, glGetError) \
    F(PFNGLGETPROGRAMINFOLOGPROC, glGetProgramInfoLog) \
    F(PFNGLGETPROGRAMIVPROC, glGetProgramiv) \
    F(PFNGLGETQUERYOBJECTUIVPROC, glGetQueryObjectuiv) \
    F(PFNGLGETSHADERINFOLOGPROC, glGetShaderInfoLog) \
    F(PFNGLGETSHADERIVPROC, glGetShaderiv) \
    F(PFNGLGETSTRINGPROC, glGetString) \
    F(PFNGLGETTEXIMAGEPROC, glGetTexImage) \
    F(PFNGLGETUNIFORMLOCATIONPROC, glGetUniformLocation) \
    F(PFNGLLINEWIDTHPROC, glLineWidth) \
    F(PFNGLLINKPROGRAMPROC, glLinkProgram) \
    F(PFNGLLOGICOPPROC, glLogicOp) \
    F(PFNGLMINSAMPLESHADINGPROC, glMinSampleShading) \
    F(PFNGLPIXELSTOREIPROC, glPixelStorei) \
    F(PFNGLPOINTPARAMETERIPROC, glPointParameteri) \
    F(PFNGLPOINTSIZEPROC, glPointSize) \
    F(PFNGLPOLYGONMODEPROC, glPolygonMode) \
    F(PFNGLPOLYGONOFFSETPROC, glPolygonOffset) \
    F(PFNGLPOLYGONOFFSETCLAMPEXTPROC, glPolygonOffsetClampEXT) \
    F(PFNGLPRIMITIVERESTARTINDEXPROC, glPrimitiveRestartIndex) \
    F(PFNGLPROVOKINGVERTEXPROC, glProvokingVertex) \
    F(PFNGLREADBUFFERPROC, glReadBuffer) \
    F(PFNGLREADPIXELSPROC, glReadPixels) \
    F(PFNGLRENDERBUFFERSTORAGEPROC, glRenderbufferStorage) \
    F(PFNGLSAMPLEMASKIPROC, glSampleMaski) \
    F(PFNGLSAMPLERPARAMETERFPROC, glSamplerParameterf) \
    F(PFNGLSAMPLERPARAMETERFVPROC, glSamplerParameterfv) \
    F(PFNGLSAMPLERPARAMETERIPROC, glSamplerParameteri) \
    F(PFNGLSCISSORPROC, glScissor) \
    F(PFNGLSHADERSOURCEPROC, glShaderSource) \
    F(PFNGLSTENCILFUNCSEPARATEPROC, glStencilFuncSeparate) \
    F(PFNGLSTENCILMASKPROC, glStencilMask) \
    F(PFNGLSTENCILMASKSEPARATEPROC, glStencilMaskSeparate) \
    F(PFNGLSTENCILOPSEPARATEPROC, glStencilOpSeparate) \
    F(PFNGLTEXIMAGE1DPROC, glTexImage1D) \
    F(PFNGLTEXIMAGE2DPROC, glTexImage2D) \
    F(PFNGLTEXIMAGE3DPROC, glTexImage3D) \
    F(PFNGLTEXPARAMETERFPROC, glTexParameterf) \
    F(PFNGLTEXPARAMETERFVPROC, glTexParameterfv) \
    F(PFNGLTEXPARAMETERIPROC, glTexParameteri) \
    F(PFNGLTEXSTORAGE1DPROC, glTexStorage1D) \
    F(PFNGLTEXSTORAGE2DPROC, glTexStorage2D) \
    F(PFNGLTEXSTORAGE2DMULTISAMPLEPROC, glTexStorage2DMultisample) \
    F(PFNGLTEXSTORAGE3DPROC, glTexStorage3D) \
    F(PFNGLTEXSUBIMAGE1DPROC, glTexSubImage1D) \
    F(PFNGLTEXSUBIMAGE2DPROC, glTexSubImage2D) \
    F(PFNGLTEXSUBIMAGE3DPROC, glTexSubImage3D) \
    F(PFNGLUNIFORM1FPROC, glUniform1f) \
    F(PFNGLUNIFORM1IPROC, glUniform1i) \
    F(PFNGLUNIFORM1UIPROC, glUniform1ui) \
    F(PFNGLUNIFORM2FVPROC, glUniform2fv) \
    F(PFNGLUNIFORM3FPROC, glUniform3f) \
    F(PFNGLUNIFORM3FVPROC, glUniform3fv) \
    F(PFNGLUNIFORM4FVPROC, glUniform4fv) \
    F(PFNGLUNIFORMMATRIX3FVPROC, glUniformMatrix3fv) \
    F(PFNGLUNIFORMMATRIX4FVPROC, glUniformMatrix4fv) \
    F(PFNGLUSEPROGRAMPROC, glUseProgram) \
    F(PFNGLVERTEXATTRIB4FPROC, glVertexAttrib4f) \
    F(PFNGLVERTEXATTRIBDIVISORPROC, glVertexAttribDivisor) \
    F(PFNGLVERTEXATTRIBPOINTERPROC, glVertexAttribPointer) \
    F(PFNGLVIEWPORTPROC, glViewport) \
    F(PFNGLVIEWPORTINDEXEDFPROC, glViewportIndexedf)
/* clang-format on */

#define GL_DECLARE(type, name) extern type name;
GL_FUNCTIONS(GL_DECLARE)

#endif
