using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.RenderTests.Transport.LightPaths;

/// <summary>
/// Merged paths have a bias that goes with the radius in which they are merged: pictures with ever smaller circles lead to the picture
/// that path tracing has.
/// Covers `PhotonMerge`, `PhotonGrid` and `LightPass`.
/// </summary>
[Trait("Category", "Thorough")]
public class MergeTests
{
    private const string Matt = """{ "type": "diffuse", "color": [0.5, 0.5, 0.5] }""";
    private static readonly int s_seeds = TestSettings.Scale(12, 48);
    private static readonly Block[] s_blocks = [.. Block.Cut(24, 24, 12), new(0, 0, 24, 24)];

    public static TheoryData<string, string> Cases => new()
    {
        { "a room with a ball of glass", "photons" },
        { "a room with a ball of glass", "vcm" },
        { "a lamp within a cloud, seen from outside", "photons" },
        { "a lamp within a cloud, seen from outside", "vcm" },
        { "a mesh that shines, moves, and is stretched", "photons" },
        { "a mesh that shines, moves, and is stretched", "vcm" },
    };

    [Theory]
    [MemberData(nameof(Cases))]
    public void Smaller_and_smaller_circles_lead_to_the_truth(string name, string integrator)
    {
        // Without shading normals: of photons that graze a surface, their factor has no finite variance (Veach 1997, section 5.3).
        LightPathScene scene = LightPathScene.All.Single(s => s.Name == name);
        scene = scene with { Text = scene.Text.Replace("\"shading\": \"smooth\", ", "", StringComparison.Ordinal) };
        ImageSamples path = Render(scene, scene.Reference, 0, 4 * scene.Samples, firstSeed: 5001);
        ImageSamples[] images = [.. new[] { 0.2f, 0.1f, 0.05f }.Select(radius => Render(scene, integrator, radius, 3 * scene.Samples, firstSeed: 6001))];

        // Richardson's extrapolation (1911): what goes with the radius and with its square is gone.
        ImageSamples limit = new(path.Width, path.Height);
        for (int i = 0; i < s_seeds; i++)
        {
            limit.Add(new Limit([.. images.Select(m => m.Image(i))]));
        }

        double p = PValues.Smallest(s_blocks.Select(block => BlockTest.Welch(limit.Estimate(block, 1), path.Estimate(block, 1))));
        BlockEstimate found = limit.Estimate(s_blocks[^1], 1);
        BlockEstimate expected = path.Estimate(s_blocks[^1], 1);
        string what = FormattableString.Invariant($"{name} by {integrator}: {found.Mean} ± {Math.Sqrt(found.Variance)}, path {expected.Mean} ± {Math.Sqrt(expected.Variance)}");
        Assert.True(found.Variance < found.Mean * found.Mean * 4e-4, what);
        ErrorBudget.Transport.Check(p, what);
    }

    [Theory]
    [InlineData("photons")]
    [InlineData("vcm")]
    public void Colours_of_a_prism_are_merged_as_they_are_connected(string integrator)
    {
        LightPathScene scene = new("", 16, IsMatt: true, """
            {
              "camera": { "position": [0.6, 4, 0], "lookAt": [0.6, 0, 0], "up": [0, 0, -1], "projection": "orthographic", "viewSize": 1.2 },
              "render": { "width": 24, "height": 24, "maxDepth": 4 },
              "shapes": [
                { "type": "rectangle", "corner": [-3, 0, 3], "edgeU": [6, 0, 0], "edgeV": [0, 0, -6], "material": { "type": "diffuse", "color": [0.5, 0.5, 0.5] } },
                { "type": "mesh", "material": { "type": "dielectric", "cauchy": [1.4, 0.04] },
                  "transform": [{ "rotate": -35, "axis": [0, 0, 1], "translate": [-0.5, 1.1, 0] }],
                  "positions": [[-0.4, -0.23, -0.4], [0.4, -0.23, -0.4], [0, 0.46, -0.4], [-0.4, -0.23, 0.4], [0.4, -0.23, 0.4], [0, 0.46, 0.4]],
                  "triangles": [[0, 2, 1], [3, 4, 5], [0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]] },
                { "type": "spot", "position": [-2.43, 1.62, 0], "direction": [0.966, -0.259, 0], "intensity": [100, 100, 100], "cutoffAngle": 7, "beamWidth": 6.9 }
              ]
            }
            """);
        ImageSamples connected = Render(scene, "light", 0, 32, firstSeed: 9001);
        ImageSamples merged = Render(scene, integrator, 0.05f, 8, firstSeed: 9501);
        double[] reds = [.. Block.Cut(24, 24, 6).Select(b => (Red: connected.Estimate(b, 0).Mean, Blue: connected.Estimate(b, 2).Mean)).Where(c => c.Red + c.Blue > 0.1).Select(c => c.Red / (c.Red + c.Blue))];
        Assert.True(reds.Max() - reds.Min() > 0.3, string.Join(' ', reds));
        IEnumerable<(Block Block, int Channel)> parts = Block.Cut(24, 24, 6).SelectMany(b => Enumerable.Range(0, 3).Select(c => (b, c)));
        double p = PValues.Smallest(parts.Select(t => BlockTest.Welch(merged.Estimate(t.Block, t.Channel), connected.Estimate(t.Block, t.Channel))));
        ErrorBudget.Transport.Check(p, integrator);
    }

    [Theory]
    [InlineData("photons", Matt)]
    [InlineData("vcm", Matt)]
    [InlineData("photons", $$"""{ "type": "normalMap", "map": [0.75, 0.5, 0.9], "material": {{Matt}} }""")]
    public void Light_of_a_point_that_is_only_seen_through_glass_falls_off_as_it_should(string integrator, string material)
    {
        // The pane bends and takes nothing, but no path can be connected through it: without the pane, the floor has the closed form's light,
        // and so it has where it is shaded with another normal.
        const string pane = """{ "type": "rectangle", "corner": [-3, 1, 3], "edgeU": [6, 0, 0], "edgeV": [0, 0, -6], "material": { "type": "thinDielectric", "refractiveIndex": 1 } },""";
        const string floor = """
            {
              "camera": { "position": [0, 3, 0], "lookAt": [0, 0, 0], "up": [0, 0, -1], "projection": "orthographic", "viewSize": 1.5 },
              "render": { "width": 24, "height": 24, "maxDepth": 4 },
              "shapes": [
                PANE
                { "type": "rectangle", "corner": [-3, 0, 3], "edgeU": [6, 0, 0], "edgeV": [0, 0, -6], "material": MATERIAL },
                { "type": "spot", "position": [0.4, 2, 0.3], "intensity": [4, 4, 4], "cutoffAngle": 45, "beamWidth": 44 }
              ]
            }
            """;
        LightPathScene Scene(string shape) => new("", 16, IsMatt: false, floor.Replace("PANE", shape, StringComparison.Ordinal).Replace("MATERIAL", material, StringComparison.Ordinal));
        ImageSamples bare = Render(Scene(""), "path", 0, 16, firstSeed: 7001);
        ImageSamples behind = Render(Scene(pane), "path", 0, 1, firstSeed: 7001);
        Assert.Equal(0, behind.Estimate(s_blocks[^1], 1).Mean);
        ImageSamples merged = Render(Scene(pane), integrator, 0.1f, 16, firstSeed: 8001);
        double p = PValues.Smallest(s_blocks.Select(block => BlockTest.Welch(merged.Estimate(block, 1), bare.Estimate(block, 1))));
        BlockEstimate found = merged.Estimate(s_blocks[^1], 1);
        string what = FormattableString.Invariant($"{integrator}: {found.Mean} ± {Math.Sqrt(found.Variance)}, without glass {bare.Estimate(s_blocks[^1], 1).Mean}");
        Assert.True(found.Variance < found.Mean * found.Mean * 1e-4, what);
        ErrorBudget.Transport.Check(p, what);
    }

    private static ImageSamples Render(LightPathScene scene, string integrator, float radius, int samples, long firstSeed) => SceneRuns.RenderText(
        scene.Text,
        s_seeds,
        d => d with { Render = d.Render with { Integrator = Integrator.Known.All.Single(i => i.Name == integrator), SamplesPerPixel = samples, MergeRadius = radius } },
        firstSeed);

    /// <summary>The picture to which those of three radii lead, each half as large as the one before.</summary>
    private sealed class Limit(IReadOnlyList<IImageRows> images) : IImageRows
    {
        private static readonly float[] s_factors = [1f / 3, -2, 8f / 3];

        public int Width => images[0].Width;

        public int Height => images[0].Height;

        public void ReadRow(int y, Span<float> rgb)
        {
            float[] row = new float[rgb.Length];
            rgb.Clear();
            for (int image = 0; image < images.Count; image++)
            {
                images[image].ReadRow(y, row);
                for (int i = 0; i < row.Length; i++)
                {
                    rgb[i] += s_factors[image] * row[i];
                }
            }
        }
    }
}
