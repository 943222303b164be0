using RayTracer.Rendering;

namespace RayTracer.RenderTests.Transport;

/// <summary>Guided paths against others: each picture of either kind has its own seed, and its own guide. Covers `GuidedMaterial`.</summary>
[Trait("Category", "Thorough")]
public class GuidedPathTests
{
    private static readonly int s_seeds = TestSettings.Scale(12, 64);

    public static TheoryData<string, string> Scenes => new()
    {
        { "a screen", GuidedScenes.Screen },
        { "an open sky", GuidedScenes.Screen.Replace("\"b\": [2, 2, 4]", "\"b\": [2, 0.1, 4]", StringComparison.Ordinal).Replace("\"shapes\"", "\"environment\": { \"type\": \"constant\", \"radiance\": [1, 2, 3] }, \"shapes\"", StringComparison.Ordinal) },
        { "everything", TestScenes.Everything.Replace("SAMPLER", "sobol", StringComparison.Ordinal).Replace("\"report\"", "\"path\"", StringComparison.Ordinal) },
        { "layers and textures", GuidedScenes.Screen.Replace("\"type\": \"plastic\", \"color\": [0.3, 0.5, 0.2]", "\"type\": \"mask\", \"opacity\": 0.6, \"material\": { \"type\": \"principled\", \"roughness\": 0.4 }", StringComparison.Ordinal) },
    };

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Guided_paths_have_the_expectation_of_others(string what, string scene)
    {
        BlockTest test = BlockTest.Compare(Render(scene, 1, s => GuidedScenes.Learned(s)), Render(scene, 1001, s => s));
        ErrorBudget.Transport.Check(test.P, $"guided, {what}: {test}");
    }

    private static ImageSamples Render(string text, int firstSeed, Func<Scene, Scene> guide)
    {
        ImageSamples? images = null;
        for (int i = 0; i < s_seeds; i++)
        {
            long seed = firstSeed + i + (TestSettings.Seed * 1_000_000L);
            Scene scene = TestScenes.Build(text.Replace("\"render\": {", $"\"render\": {{ \"seed\": {(uint)seed},", StringComparison.Ordinal));
            Film film = new RTracer(guide(scene)).Render().Film;
            images ??= new(film.Width, film.Height);
            images.Add(film);
        }

        return images!;
    }
}
