using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.RenderTests.Pairs;

/// <summary>
/// Features two by two: each pair of levels of <see cref="PairScene.Features"/> stands in some small scene, and each scene has the same expected image as an equal one that is made otherwise.
/// </summary>
[Trait("Category", "Thorough")]
public class PairTests
{
    private static readonly CoveringArray s_scenes = CoveringArray.Of([.. PairScene.Features.Select(f => f.Levels.Length)]);
    private static readonly int s_seeds = TestSettings.Scale(16, 128);

    public static TheoryData<int> Scenes => [.. Enumerable.Range(0, s_scenes.Rows.Count)];

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
    public void A_scene_looks_like_an_equal_one_that_is_made_otherwise(int number)
    {
        PairScene scene = new(s_scenes.Rows[number]);
        ImageSamples images = SceneRuns.RenderText(scene.Text, s_seeds, firstSeed: 1);
        ImageSamples others = new(images.Width, images.Height);
        Random times = new(TestSettings.Seed + number);
        for (int i = 0; i < s_seeds; i++)
        {
            // An instant of each equal part of the time that the shutter is open: their mean is what is seen of motion.
            long seed = 1001 + (i * 100);
            others.Add(new Sum([.. from instant in Enumerable.Range(0, scene.Instants)
                                   let time = (instant + times.NextDouble()) / scene.Instants
                                   from groupOfLights in Enumerable.Range(0, scene.Groups)
                                   select SceneRuns.RenderText(scene.Otherwise(groupOfLights, time), 1, firstSeed: seed++).Mean()], 1f / scene.Instants));
        }

        BlockTest test = BlockTest.Compare(images, others);
        ErrorBudget.Pairs.Check(test.P, $"scene {number} ({scene}): {test}", () => $"The scene:\n{scene.Text}\nmade otherwise:\n{scene.Otherwise(0, 0.5)}");
    }

    /// <summary>Light is added: images of some of the lights make the image of all. The images of several instants are averaged.</summary>
    private sealed class Sum(IReadOnlyList<IImageRows> parts, float factor) : IImageRows
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
                    rgb[i] += part[i] * factor;
                }
            }
        }
    }
}
