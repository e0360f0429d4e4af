// States that stand for lessons, to choose from. The contract has no outlines with samples
// (reference/RULES.md, "What the contract leaves out").
export const PRESETS = [
    { name: "2 Wireframe", state: "shader=gouraud&maps=off&polygons=line&samples=1" },
    { name: "3 Triangles", state: "model=triangle&shader=vertex-color" },
    { name: "4 Back faces", state: "shader=flat&maps=off&cull=front" },
    { name: "6 Depth buffer", state: "shader=depth" },
    { name: "7 Texture", state: "model=square&shader=unlit" },
    { name: "8 Perspective", state: "model=cube&shader=flat&fov=70" },
    { name: "10 Gouraud", state: "shader=gouraud&maps=off" },
    { name: "11 Flat", state: "shader=flat&maps=off" },
    { name: "12 Toon", state: "shader=toon&maps=off&bands=4" },
    { name: "13 Phong", state: "shader=phong&maps=off" },
    { name: "13 Blinn-Phong", state: "shader=blinn-phong&maps=off" },
    { name: "14 Normal map", state: "shader=normals" },
    { name: "15 Specular map", state: "shader=phong&exponent=64" },
    { name: "16 Shadow map", state: "shader=phong&shadows=on" },
    { name: "19 Turning triangle", state: "model=triangle&shader=vertex-color&samples=4" },
];
