using RayTracer.Imaging;

namespace RayTracer.Cli.Tests;

/// <summary>What is missing or wrong beside a scene: alike in all formats, a warning and a stand-in that is seen, or an error.</summary>
public sealed class StandInTests : IDisposable
{
    private const string Obj = "mtllib a.mtl\nv -9 -9 0\nv 9 -9 0\nv 0 9 0\nvt 0 0\nvt 9 0\nvt 0 9\nusemtl m\nf 1/1 2/2 3/3\n";
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("a.json", """{ "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0] }, "background": [1, 1, 1], "shapes": [{ "type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "material": { "type": "diffuse", "color": { "type": "image", "file": "gone.png" } } }] }""", "file not found")]
    [InlineData("a.obj", Obj, "the picture \"gone.png\" is not there")]
    [InlineData("a.gltf", """{ "asset": { "version": "2.0" }, "scene": 0, "scenes": [{ "nodes": [0] }], "nodes": [{ "mesh": 0 }], "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0, "TEXCOORD_0": 1 }, "material": 0 }] }], "materials": [{ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 }, "metallicFactor": 0 } }], "textures": [{ "source": 0 }], "images": [{ "uri": "gone.png" }], "buffers": [{ "uri": "a.bin", "byteLength": 60 }], "bufferViews": [{ "buffer": 0, "byteLength": 36 }, { "buffer": 0, "byteOffset": 36, "byteLength": 24 }], "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-9, -9, 0], "max": [9, 9, 0] }, { "bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2" }] }""", "the picture \"gone.png\" is not there")]
    [InlineData("a.xml", """<scene version="3.0.0"><integrator type="path"/><sensor type="perspective"><float name="fov" value="40"/><transform name="to_world"><lookat origin="0, 0, 2" target="0, 0, 0" up="0, 1, 0"/></transform></sensor><emitter type="constant"/><shape type="rectangle"><bsdf type="diffuse"><texture type="bitmap" name="reflectance"><string name="filename" value="gone.png"/></texture></bsdf></shape></scene>""", "file not found")]
    public void A_picture_that_is_missing_is_shown_as_magenta_checks(string name, string text, string complaint)
    {
        File.WriteAllText(_folder[name], text);
        File.WriteAllText(_folder["a.mtl"], "newmtl m\nKd 1 1 1\nmap_Kd gone.png\n");
        File.WriteAllBytes(_folder["a.bin"], [.. new float[] { -9, -9, 0, 9, -9, 0, 0, 9, 0, 0, 0, 9, 0, 0, 9 }.SelectMany(BitConverter.GetBytes)]);
        string[] command = ["render", _folder[name], "--width", "24", "--height", "24", "--spp", "4", "--quiet", "-o", _folder["a.png"]];
        CliRun run = CliRun.Of(command);
        Assert.Equal(0, run.Status);
        Assert.Contains("warning: ", run.Error, StringComparison.Ordinal);
        Assert.Contains(complaint, run.Error, StringComparison.Ordinal);
        Assert.Contains("magenta checks are shown instead", run.Error, StringComparison.Ordinal);
        float[] pixels = ImageFile.Read(_folder["a.png"]).Pixels;
        Assert.Contains(pixels.Chunk(3), p => p[0] > 0.1f && p[2] > 0.1f && p[1] < 0.7f * p[0]);
        CliRun strict = CliRun.Of([.. command, "--strict"]);
        Assert.Equal(3, strict.Status);
        Assert.Contains("error: ", strict.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("newmtl m\nKd 1 0\nKs 1 1 1\nNs 50\n", "a.mtl: line 2: ")]
    [InlineData("newmtl m\nNs many\n", "a.mtl: line 2: ")]
    [InlineData("Kd 1 1 1\nnewmtl m\n", "a.mtl: line 1: a statement comes before the first newmtl")]
    [InlineData("newmtl other\n", "no material file describes \"m\"")]
    public void A_wrong_statement_of_a_material_file_costs_that_statement_only(string mtl, string complaint)
    {
        File.WriteAllText(_folder["a.obj"], Obj);
        File.WriteAllText(_folder["a.mtl"], mtl);
        CliRun run = CliRun.Of("check", _folder["a.obj"]);
        Assert.Equal(0, run.Status);
        Assert.Contains(complaint, run.Output, StringComparison.Ordinal);
        Assert.Equal(3, CliRun.Of("check", _folder["a.obj"], "--strict").Status);
    }

    [Fact]
    public void A_file_that_is_no_material_file_is_refused()
    {
        File.WriteAllText(_folder["a.obj"], Obj);
        File.WriteAllText(_folder["a.mtl"], string.Concat(Enumerable.Repeat("Kd x\n", 1000)));
        Assert.Equal(3, CliRun.Of("check", _folder["a.obj"]).Status);
    }
}
