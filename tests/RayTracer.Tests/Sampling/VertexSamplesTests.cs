using System.Runtime.CompilerServices;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;

namespace RayTracer.Tests.Sampling;

/// <summary>No random number decides two things of one path.</summary>
public class VertexSamplesTests
{
    private const int Lights = 10;

    // The camera is within a white sphere with a coat, so that paths end at the depth limits only.
    private static readonly string s_scene = $$"""
        { "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0], "lens": { "shape": "eyeJitter", "jitter": [0.1, 0.1, 0.1] } },
          "render": { "integrator": "report", "width": 8, "height": 8, "samplesPerPixel": 2, "maxDiffuseDepth": 20, "maxSpecularDepth": 20 },
          "materials": { "metal": { "type": "phongMetal", "color": [1, 1, 1], "exponent": 100 } },
          "shapes": [
            { "type": "sphere", "center": [0, 0, 0], "radius": 10, "material": { "type": "diffuseSpecular", "diffuse": { "type": "diffuse", "color": [1, 1, 1] }, "specular": "metal" } },
            { "type": "sphere", "center": [-2, 0, 0], "radius": 1.5, "material": { "type": "dielectric" } },
            { "type": "sphere", "center": [2, 0, 0], "radius": 1.5, "material": "metal" } ],
          "lights": [ {{string.Join(", ", Enumerable.Range(0, Lights).Select(i => $$"""{ "type": "sphere", "center": [{{i - 5}}, 8, 0], "radius": 0.1, "material": { "type": "luminaire" } }"""))}} ] }
        """;

    [Fact]
    public void No_random_number_is_used_twice_along_a_path()
    {
        int longest = 0;
        for (int i = 0; i < 128; i++)
        {
            List<(uint Group, uint Pair)> requests = RequestsOfOnePath(i % 8, i / 8 % 8, i / 64);
            longest = Math.Max(longest, AssertUsedOnce(requests));
        }

        Assert.InRange(longest, 21, 41);
    }

    [Fact]
    public void All_decisions_of_a_path_have_numbers_of_their_own()
    {
        Recorder recorder = new();
        foreach (uint group in new[] { Dimensions.Pixel, Dimensions.Lens, Dimensions.Camera })
        {
            recorder.Begin((UIntW)0u, (UIntW)0u, group, out SamplePoints points);
            recorder.Pair(points, 0, out _, out _);
        }

        VertexSamples vertex = new(recorder);
        for (uint depth = 0; depth <= 40; depth++)
        {
            vertex.Begin(0u, 0u, depth);
            vertex.Direction(out _, out _);
            vertex.Choice();
            for (int light = 0; light < 100; light++)
            {
                vertex.Light(light, out _, out _);
            }
        }

        Assert.Equal(3 + (41 * 102), recorder.Requests.Count);
        Assert.Equal(recorder.Requests.Count, recorder.Requests.Distinct().Count());
    }

    // Returns the number of vertices.
    private static int AssertUsedOnce(List<(uint Group, uint Pair)> requests)
    {
        Dictionary<(uint Group, uint Pair), int> uses = requests.CountBy(r => r).ToDictionary();
        foreach (((uint group, uint pair), int count) in uses)
        {
            bool ofVertex = group >= Dimensions.FirstVertex && (group - Dimensions.FirstVertex) % Dimensions.GroupsPerVertex == 0;

            // Of a coat's two lobes, both of which are computed, only one takes effect.
            bool isCoat = ofVertex && pair == Dimensions.Direction && uses.ContainsKey((group + 1, 0));
            Assert.True(count == (isCoat ? 2 : 1) || (isCoat && count == 1), $"pair {pair} of group {group} is used {count} times");
            Assert.InRange(pair, 0u, ofVertex ? Lights : 0u);
        }

        foreach (uint group in new[] { Dimensions.Pixel, Dimensions.Lens, Dimensions.Camera })
        {
            Assert.Contains((group, 0u), uses);
        }

        uint[] vertices = [.. uses.Keys.Where(r => r.Group >= Dimensions.FirstVertex).Select(r => (r.Group - Dimensions.FirstVertex) / Dimensions.GroupsPerVertex).Distinct().Order()];
        Assert.Equal(Enumerable.Range(0, vertices.Length).Select(v => (uint)v), vertices);
        return vertices.Length;
    }

    private static List<(uint Group, uint Pair)> RequestsOfOnePath(int x, int y, int sample)
    {
        Scene scene = TestScenes.Build(s_scene);
        Recorder recorder = new();
        SamplerOf(scene) = recorder;
        new RTracer(scene, new() { Threads = 1, Crop = new(x, y, 1, 1), Samples = new(sample, sample + 1) }).Render();
        return recorder.Requests;
    }

    [UnsafeAccessor(UnsafeAccessorKind.Field, Name = "<Sampler>k__BackingField")]
    private static extern ref Sampler SamplerOf(Scene scene);

    /// <summary>Independent numbers, and a list of what was asked for in the first lane.</summary>
    private sealed class Recorder() : Sampler(2)
    {
        private readonly IndependentSampler _numbers = new(2);

        public List<(uint Group, uint Pair)> Requests { get; } = [];

        public override void Begin(in UIntW pixelKey, in UIntW sample, in UIntW group, out SamplePoints points)
        {
            points.Key = pixelKey;
            points.First = sample;
            points.Second = group;
        }

        public override void Pair(in SamplePoints points, uint pair, out FloatW u, out FloatW v)
        {
            Requests.Add((points.Second[0], pair));
            _numbers.Begin(points.Key, points.First, points.Second, out SamplePoints prepared);
            _numbers.Pair(prepared, pair, out u, out v);
        }
    }
}
