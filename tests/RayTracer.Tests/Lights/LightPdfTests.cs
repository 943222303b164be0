using System.Numerics;
using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Tests.Statistics;

namespace RayTracer.Tests.Lights;

/// <summary>
/// The densities that lights give for rays which meet them by chance: those with which they are sampled.
/// Covers `AreaLight`, `MeshLight` and `InstancedLight`.
/// </summary>
public class LightPdfTests
{
    public static TheoryData<string> Cases => [.. LightCase.All.Select(c => c.Name)];

    [Theory]
    [MemberData(nameof(Cases))]
    public void A_chosen_point_has_the_density_with_which_it_was_chosen(string name)
    {
        LightCase light = LightCase.All.Single(c => c.Name == name);
        Compare(new AreaLight(light.Shape, 0), light.From, 1);
    }

    [Theory]
    [InlineData("""{ "type": "mesh", MESH }""")]
    [InlineData("""{ "type": "instance", "of": { "type": "mesh", MESH }, "transform": [{ "scale": [1.3, -0.4, 0.7], "rotate": 33, "axis": [1, 2, 3] }] }""")]
    [InlineData("""{ "type": "instance", "of": { "type": "sphere", "center": [0.1, 0, 0], "radius": 0.5, SHINES }, "transform": [{ "scale": [1.3, -0.4, 0.7], "rotate": 33, "axis": [1, 2, 3] }] }""")]
    [InlineData("""{ "type": "instance", "of": { "type": "cone", "bottom": [0, 0, 0], "top": [0, 1, 0], "radius": 0.5, SHINES }, "transform": [{ "scale": [1.3, 0.4, 0.7] }] }""")]
    public void Lights_of_many_triangles_and_in_instances_have_it_too(string shape)
    {
        const string shines = """ "material": { "type": "luminaire", "multiplier": 2 } """;
        string json = """{ "shapes": [SHAPE] }""".Replace("SHAPE", shape, StringComparison.Ordinal)
            .Replace("MESH", """ "positions": [[0, 0, 0], [1, 0, 0], [0, 1, 0.2], [1, 0.2, 2]], "triangles": [[0, 1, 2], [1, 3, 2]], """ + shines, StringComparison.Ordinal)
            .Replace("SHINES", shines, StringComparison.Ordinal);
        SceneLoadResult result = SceneLoader.Build(SceneReader.ReadText(json, "test.json"), ".");
        Assert.Equal("", Diagnostic.Format(result.Diagnostics));
        foreach (Vector3 from in new Vector3[] { new(0.5f, 0.3f, 3), new(2, 2, -3), new(-3, -1, 0.2f) })
        {
            Compare(Assert.Single(result.Scene!.Lights), from, 2);
        }
    }

    // Triangles are chosen by area, so the density is the same whichever of them is met.
    private static void Compare(LightSource light, Vector3 from, uint primitives)
    {
        int compared = 0;
        for (int i = 0; i < 256; i += FloatW.Count)
        {
            FloatW u = ((UIntW.Iota + (uint)i).ToFloat() + 0.5f) * (1f / 256);
            FloatW v = (u * 37f) - (u * 37f).ToIntInRange().ToFloat();
            light.Sample(from, u, v, 0f, out ShapeSampleW sample, out _);
            for (uint met = 0; met < primitives; met++)
            {
                LightHitW hit = new() { From = from, Direction = sample.Direction, Distance = sample.Distance, Cosine = sample.Cosine, Time = 0f, Primitive = met };
                light.Pdf(hit, out FloatW pdf);
                for (int lane = 0; lane < FloatW.Count; lane++)
                {
                    if (sample.InversePdf[lane] > 0 && sample.Cosine[lane] > 1e-3f)
                    {
                        compared++;
                        Assert.True(Math.Abs((pdf[lane] * sample.InversePdf[lane]) - 1) < 2e-3, $"{pdf[lane]} and 1/{sample.InversePdf[lane]} at {u[lane]}, {v[lane]}");
                    }
                }
            }
        }

        Assert.True(compared > 0 || !IsSeen(light, from), "nothing was chosen");
    }

    private static bool IsSeen(LightSource light, Vector3 from)
    {
        light.Sample(from, 0.5f, 0.5f, 0f, out ShapeSampleW sample, out _);
        return sample.InversePdf[0] > 0 && sample.Cosine[0] > 1e-3f;
    }
}
