// Decodes images to texels of RGBA8, the top row first, without a change of any byte: no colour
// space is applied, and colours are not multiplied by alpha.
import { GnomonError } from "./engine.js";
import { withoutOrientation } from "./exif.js";
import { decodeTga } from "./tga.js";

const MAX_SIZE = 8192;

// Returns { name, width, height, texels, orientation }; the orientation, 1 to 8, is not applied.
export async function decodeMap(file) {
    const map = /\.tga$/i.test(file.name)
        ? decodeTga(file.name, new Uint8Array(await file.arrayBuffer()))
        : await decodeByBrowser(file);
    if (map.width > MAX_SIZE || map.height > MAX_SIZE)
        throw new GnomonError(`${file.name}: ${map.width}x${map.height} texels are more than ${MAX_SIZE} in a row`);
    return { name: file.name, orientation: 1, ...map };
}

// The option imageOrientation has no value that every browser takes for "never turn" (whatwg/html
// issue 8085). So browsers receive the file without its orientation.
async function decodeByBrowser(file) {
    const { orientation, bytes } = withoutOrientation(new Uint8Array(await file.arrayBuffer()));
    let image;
    try {
        image = await createImageBitmap(new Blob([bytes], { type: file.type }), {
            premultiplyAlpha: "none",
            colorSpaceConversion: "none",
        });
    } catch {
        throw new GnomonError(`${file.name}: it is not an image that this browser can read (PNG, JPEG, WebP, TGA)`);
    }
    const { width, height } = image;
    try {
        return { width, height, texels: readBack(image, file.name), orientation };
    } finally {
        image.close();
    }
}

// A 2D canvas would multiply by alpha; a texture's bytes stay as they are.
function readBack(image, name) {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl)
        throw new GnomonError(`${name}: maps are decoded by WebGL2, which this browser does not have`);
    const { width, height } = image;
    const texels = new Uint8Array(width * height * 4);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, image);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(
        gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, gl.getParameter(gl.TEXTURE_BINDING_2D), 0
    );
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, texels);
    const error = gl.getError();
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    if (error !== gl.NO_ERROR)
        throw new GnomonError(`${name}: WebGL cannot hold its ${width}x${height} texels`);
    return texels;
}
