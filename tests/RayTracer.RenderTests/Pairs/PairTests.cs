using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.RenderTests.Pairs;

/// <summary>
/// Features two by two: each pair of levels of <see cref="PairScene.Features"/> stands in some small scene, and each scene has the same
/// expected image as an equal one that is made otherwise. Features that share a computation have a scene to themselves, with more samples.
/// Covers `PathShader`, `DirectLight`, `Transmittance` and `InstanceMaps`.
/// </summary>
[Trait("Category", "Thorough")]
public class PairTests
{
    private static readonly CoveringArray s_scenes = CoveringArray.Of([.. PairScene.Features.Select(f => f.Levels.Length)]);

    public static TheoryData<int> Scenes => [.. Enumerable.Range(0, s_scenes.Rows.Count)];

    public static TheoryData<int, string> FewFeatures => new()
    {
        // Times of boundaries, of vertices in fog, and of shadows behind boundaries.
        { 64, "jittered, moves, fog, box, gathered, sphere" },

        // Densities of one of many lights, seen through boundaries.
        { 64, "jittered, many, fog, roughness by a texture, box" },
        { 64, "jittered, stretched instance, normal map, smooth mesh" },

        // Lights are found by sampling and by chance through holes, and from the material between them.
        { 576, "jittered, holes, roughness by a texture, smooth mesh" },
        { 36, "jittered, glass, fog" },
        { 36, "jittered, mesh, fog" },
        { 36, "jittered, disk, moves" },
        { 144, "jittered, glass in water, mesh, gathered" },
        { 64, "jittered, many, translucent sheet" },
        { 64, "jittered, many, moves, roughness by a texture, box" },
    };

    [Fact]
    public void Every_pair_of_features_stands_in_some_scene()
    {
        int[] levels = [.. PairScene.Features.Select(f => f.Levels.Length)];
        HashSet<(int, int, int, int)> covered = [.. s_scenes.Rows.SelectMany(CoveringArray.PairsOf)];
        string[] missing = [.. CoveringArray.Pairs(levels).Where(p => !covered.Contains(p))
            .Select(p => $"{PairScene.Features[p.Factor].Levels[p.Level]} with {PairScene.Features[p.OtherFactor].Levels[p.OtherLevel]}")];
        Assert.Empty(missing);
        Assert.True(levels.Length >= 14);
        Assert.InRange(s_scenes.Rows.Count, 16, 30);
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void A_scene_looks_like_an_equal_one_that_is_made_otherwise(int number) =>
        Compare($"scene {number}", new(s_scenes.Rows[number], Samples: 4), seeds: TestSettings.Scale(8, 64));

    [Theory]
    [MemberData(nameof(FewFeatures))]
    public void A_scene_with_few_features_looks_like_an_equal_one_that_is_made_otherwise(int samples, string features) =>
        Compare("few features", PairScene.Of(samples, features.Split(", ")), seeds: TestSettings.Scale(10, 32));

    private static void Compare(string name, PairScene scene, int seeds)
    {
        ImageSamples images = SceneRuns.RenderText(scene.Text, seeds, firstSeed: 1);
        ImageSamples others = new(images.Width, images.Height);
        ImageSamples[] parts = [.. Enumerable.Range(0, scene.Groups)
            .Select(g => SceneRuns.RenderText(scene.Otherwise(g), seeds, firstSeed: 1001 + (g * 1000)))];
        for (int i = 0; i < seeds; i++)
        {
            others.Add(new Sum([.. parts.Select(p => p.Image(i))]));
        }

        BlockTest test = BlockTest.Compare(images, others);
        ErrorBudget.Pairs.Check(test.P, $"{name} ({scene}): {test}", () => $"The scene:\n{scene.Text}\nmade otherwise:\n{scene.Otherwise(0)}");
    }

    /// <summary>Light is added: images of some of the lights make the image of all.</summary>
    private sealed class Sum(IReadOnlyList<IImageRows> parts) : IImageRows
    {
        public int Width => parts[0].Width;

        public int Height => parts[0].Height;

        public void ReadRow(int y, Span<float> rgb)
        {
            float[] part = new float[rgb.Length];
            rgb.Clear();
            foreach (IImageRows image in parts)
            {
                image.ReadRow(y, part);
                for (int i = 0; i < part.Length; i++)
                {
                    rgb[i] += part[i];
                }
            }
        }
    }
}
