using System.Text;
using System.Text.RegularExpressions;
using RayTracer.Import;
using RayTracer.Scenes;

namespace RayTracer.Import.Tests;

/// <summary>Whatever stands in a glTF file: loading it ends in a scene or a message, and takes no more memory than its size can account for.</summary>
[Trait("Category", "Thorough")]
public class GltfMutationTests
{
    private const int Mutants = 100;
    private static readonly string[] s_numbers =
        ["-1", "0", "1", "2", "3", "7", "255", "65535", "2147483647", "2147483648", "4294967295", "-2147483648", "1e9", "1e39", "1e308", "1e-45", "0.5", "null", "\"x\"", "[]", "{}"];

    [Theory]
    [InlineData(".gltf")]
    [InlineData(".glb")]
    public void Mutated_files_end_in_a_scene_or_a_message(string extension)
    {
        using TemporaryFolder folder = new();
        byte[] good = extension == ".glb" ? Everything().ToGlb() : Everything().ToGltf();
        string path = folder["model" + extension];
        File.WriteAllBytes(path, good);
        Assert.NotNull(SceneLoader.Load(path).Scene);
        Random random = new(2026 + TestSettings.Seed);
        int loaded = 0;
        for (int i = 0; i < TestSettings.Scale(Mutants, 50 * Mutants); i++)
        {
            byte[] bad = Mutate(good, random);
            File.WriteAllBytes(path, bad);
            long before = GC.GetAllocatedBytesForCurrentThread();
            SceneLoadResult result = SceneLoader.Load(path, frame: 12);
            long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
            Assert.True(allocated <= (10L * bad.Length) + (256L << 20), $"mutant {i} took {allocated} bytes");
            Assert.Equal(result.Scene is null, result.Diagnostics.Any(d => d.Severity == Severity.Error));
            loaded += result.Scene is null ? 0 : 1;
        }

        Assert.InRange(loaded, 1, TestSettings.Scale(Mutants, 50 * Mutants) - 1);
    }

    [Theory]
    [InlineData(".gltf")]
    [InlineData(".glb")]
    public void Every_beginning_of_a_file_ends_in_a_message(string extension)
    {
        byte[] good = extension == ".glb" ? TestGltf.Triangle().ToGlb() : TestGltf.Triangle().ToGltf();
        for (int length = 0; length < good.Length; length++)
        {
            Assert.Throws<RayTracer.Description.ModelException>(() => GltfReader.Read(good.AsMemory(0, length), ""));
        }
    }

    /// <summary>A file with a bit of everything that is read.</summary>
    private static TestGltf Everything()
    {
        TestGltf file = TestGltf.Triangle("""
            { "pbrMetallicRoughness": { "baseColorTexture": { "index": 0, "extensions": { "KHR_texture_transform": { "rotation": 1, "scale": [2, 2] } } }, "metallicFactor": 0.1 },
              "emissiveFactor": [1, 1, 0], "extensions": { "KHR_materials_emissive_strength": { "emissiveStrength": 3 }, "KHR_materials_clearcoat": { "clearcoatFactor": 1 } } }
            """);
        GltfTextureTests.AddPicture(file, null, """{ "magFilter": 9728, "wrapS": 33071 }""");
        file.Add("materials", """{ "extensions": { "KHR_materials_transmission": { "transmissionFactor": 1 }, "KHR_materials_volume": { "thicknessFactor": 1, "attenuationDistance": 2 } }, "pbrMetallicRoughness": { "metallicFactor": 0 } }""");
        int places = file.View([1, 2]);
        int values = file.View(TestGltf.Floats(2, 0, 0, 0, 2, 0));
        int sparse = file.Add("accessors", $$"""{ "componentType": 5126, "type": "VEC3", "count": 4, "sparse": { "count": 2, "indices": { "bufferView": {{places}}, "componentType": 5121 }, "values": { "bufferView": {{values}} } } }""");
        int normals = file.Accessor(5120, "VEC3", 4, [0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0], ", \"normalized\": true", ", \"byteStride\": 4");
        int indices = file.Accessor(5123, "SCALAR", 4, TestGltf.Shorts(0, 1, 2, 3));
        int mesh = file.Mesh($$"""{ "mode": 5, "material": 1, "indices": {{indices}}, "attributes": { "POSITION": {{sparse}}, "NORMAL": {{normals}} } }""", ", \"translation\": [1, 0, 0]");
        file.Add("nodes", $$"""{ "mesh": {{mesh}}, "rotation": [0, 0, 0, 1], "scale": [1, 2, 3] }""");
        file.Add("nodes", """{ "children": [0, 1, 2, 4, 5], "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1] }""");
        file.Add("nodes", """{ "camera": 0, "translation": [0, 0, 5] }""");
        file.Add("nodes", """{ "extensions": { "KHR_lights_punctual": { "light": 0 } }, "translation": [0, 3, 0] }""");
        file.Add("cameras", """{ "type": "perspective", "perspective": { "yfov": 0.8, "aspectRatio": 1, "znear": 0.1 } }""");
        int joints = file.Accessor(5121, "VEC4", 3, [0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]);
        int weights = file.Accessor(5121, "VEC4", 3, [255, 0, 0, 0, 255, 0, 0, 0, 100, 100, 0, 0], ", \"normalized\": true");
        int moves = file.Accessor(5126, "VEC3", 3, TestGltf.Floats(0, 0, 1, 0, 0, 2, 0, 0, 4));
        int bent = file.Mesh($$"""{ "attributes": { "POSITION": 0, "JOINTS_0": {{joints}}, "WEIGHTS_0": {{weights}} }, "targets": [{ "POSITION": {{moves}} }] }""", ", \"skin\": 0, \"weights\": [0.5]");
        int matrices = file.Accessor(5126, "MAT4", 2, TestGltf.Floats([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1]));
        file.Add("skins", $$"""{ "joints": [4, 5], "inverseBindMatrices": {{matrices}} }""");
        int copies = file.Accessor(5126, "VEC3", 2, TestGltf.Floats(1, 0, 0, 0, 2, 0));
        file.Add("nodes", $$"""{ "mesh": {{bent}}, "extensions": { "EXT_mesh_gpu_instancing": { "attributes": { "TRANSLATION": {{copies}} } } } }""");
        GltfAnimationTests.Animate(file, 4, "translation", "VEC3", [0, 1], [0, 0, 5, 1, 0, 5], "LINEAR");
        GltfAnimationTests.Animate(file, 5, "rotation", "VEC4", [0, 1], [0, 0, 0, 1, 0, 0, 1, 0], "STEP");
        GltfAnimationTests.Animate(file, 6, "weights", "SCALAR", [0, 1], [0, 0, 1, 1, 0, 0], "CUBICSPLINE");
        file.Add("scenes", """{ "nodes": [3, 6, 7] }""");
        file.Json["extensions"] = System.Text.Json.Nodes.JsonNode.Parse("""{ "KHR_lights_punctual": { "lights": [{ "type": "spot", "intensity": 20 }] } }""");
        return file;
    }

    private static byte[] Mutate(byte[] good, Random random)
    {
        switch (random.Next(4))
        {
            case 0:
                byte[] changed = [.. good];
                for (int edit = random.Next(1, 5); edit > 0; edit--)
                {
                    changed[random.Next(changed.Length)] = (byte)random.Next(256);
                }

                return changed;
            case 1:
                int at = random.Next(good.Length);
                int length = random.Next(1, Math.Min(64, good.Length - at + 1));
                return random.Next(2) == 0 ? [.. good[..at], .. good[(at + length)..]] : [.. good[..(at + length)], .. good[at..]];
            default:
                // Another number, in place so that a .glb keeps its lengths.
                string text = Encoding.Latin1.GetString(good);
                MatchCollection numbers = Regex.Matches(text, @"(?<=[:\[,]\s*)-?\d[\d.]*(?=\s*[,\]}])", RegexOptions.None, TimeSpan.FromSeconds(1));
                Match number = numbers[random.Next(numbers.Count)];
                string other = s_numbers[random.Next(s_numbers.Length)];
                string mutated = text[..number.Index] + other + text[(number.Index + number.Length)..];
                return Encoding.Latin1.GetBytes(mutated.StartsWith("glTF", StringComparison.Ordinal) ? WithLengths(mutated, other.Length - number.Length) : mutated);
        }
    }

    // The header's and the JSON chunk's lengths, which a mutant should not fail by alone.
    private static string WithLengths(string glb, int more)
    {
        byte[] bytes = Encoding.Latin1.GetBytes(glb);
        foreach (int at in (int[])[8, 12])
        {
            BitConverter.TryWriteBytes(bytes.AsSpan(at), BitConverter.ToInt32(bytes, at) + more);
        }

        return Encoding.Latin1.GetString(bytes);
    }
}
