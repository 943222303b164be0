using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.RenderTests.Transport.LightPaths;

/// <summary>
/// What the samples of a picture decide by their numbers alone.
/// Covers `LightPass` and `PathWeights`.
/// </summary>
public class LightPassTests
{
    [Fact]
    public void Circles_shrink_so_that_bias_and_variance_both_vanish()
    {
        // Areas as the number of the sample to the power of -1/4 in the long run (Knaus & Zwicker 2011): a circle that shrinks as fast as the
        // inverse number would hold ever fewer photons of all samples.
        LightPass pass = Pass("vcm", radius: 0.2f);
        float Area(int sample)
        {
            Assert.True(pass.Trace(sample, default));
            return pass.MergedPaths;
        }

        Assert.Equal(24 * 24 / 2 * float.Pi * 0.04f, Area(0), 1e-3f);
        Assert.Equal(0.875, Area(1) / Area(0), 1e-5);
        Assert.InRange(Area(400) / Area(100), 0.705, 0.709);
        Assert.Equal(pass.MergedPaths * 2, pass.Weights.Merge, 1e-3f);
    }

    [Theory]
    [InlineData("light")]
    [InlineData("bidirectional")]
    public void Paths_that_are_not_merged_are_not_weighed_against_merges(string integrator)
    {
        LightPass pass = Pass(integrator, radius: 0.2f);
        Assert.True(pass.Trace(0, default));
        Assert.Null(pass.Photons);
        Assert.Equal(0, pass.Weights.Merging);
    }

    [Theory]
    [InlineData("photons", 24, true)]
    [InlineData("vcm", 24, true)]
    [InlineData("bidirectional", 24, false)]
    [InlineData("path", 2000, false)]
    public void Paths_of_different_pixels_have_one_time_where_they_are_joined(string integrator, int edge, bool isOne)
    {
        Scene scene = TestScenes.Build(LightPathScene.All.Single(s => s.Name.StartsWith("a mesh that", StringComparison.Ordinal)).Text.Replace(
            "\"width\": 24, \"height\": 24,", $"\"width\": {edge}, \"height\": {edge}, \"integrator\": \"{integrator}\",", StringComparison.Ordinal));
        FloatW times = scene.Time(UIntW.Iota * 12345u, 3u);
        Assert.Equal(isOne, times[0] == times[1] && times[1] == times[2]);
    }

    [Fact]
    public unsafe void Each_pixel_has_a_light_path_in_one_of_four_samples_chosen_at_random()
    {
        LightStarts starts = new(TestScenes.Build(LightPathScene.All[0].Text), interiors: null);
        const int Pixels = 4000;
        int[] chosen = new int[4];
        int twice = 0;
        int[] last = new int[Pixels];
        for (int turn = 0; turn < 8; turn++)
        {
            int[] samples = new int[Pixels];
            for (int sample = 0; sample < 4; sample++)
            {
                starts.Begin(0, Pixels, (4 * turn) + sample, rarity: 2, seed: 9);
                for (int path = 0; path < starts.Total; path++)
                {
                    Assert.Equal((uint)turn, starts.Samples[path]);
                    samples[starts.PixelNumbers[path]] += 1 << (8 * sample);
                    chosen[sample]++;
                }
            }

            Assert.All(samples, s => Assert.Contains(s, (int[])[1, 1 << 8, 1 << 16, 1 << 24]));
            twice += turn == 0 ? 0 : samples.Zip(last).Count(s => s.First == s.Second);
            last = samples;
        }

        // A quarter of 32,000 each, and of 28,000, by chance: five standard deviations.
        Assert.All(chosen, c => Assert.InRange(c, 8000 - 390, 8000 + 390));
        Assert.InRange(twice, 7000 - 365, 7000 + 365);
    }

    private static LightPass Pass(string integrator, float radius)
    {
        Scene scene = TestScenes.Build(LightPathScene.All[0].Text.Replace(
            "\"samplesPerPixel\": 1,",
            FormattableString.Invariant($"\"samplesPerPixel\": 1, \"integrator\": \"{integrator}\", \"mergeRadius\": {radius},"),
            StringComparison.Ordinal));
        Assert.Equal(integrator, scene.Render.Integrator.Name);
        return new(scene, new(), threads: 1, seed: 0);
    }
}
