using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Testing;

/// <summary>Renders of one scene with many seeds.</summary>
public static class SceneRuns
{
    /// <summary>Renders a scene file with independent seeds.</summary>
    /// <param name="path">The scene file.</param>
    /// <param name="seeds">How many seeds.</param>
    /// <param name="change">Changes the description, but for the seed; null for none.</param>
    /// <param name="firstSeed">The first seed, before <see cref="TestSettings.Seed"/> is added as a multiple of a million.</param>
    public static ImageSamples Render(string path, int seeds, Func<SceneDescription, SceneDescription>? change = null, long firstSeed = 1) =>
        Render(seeds, seed => Load(path, d => WithSeed(change?.Invoke(d) ?? d, seed)), firstSeed);

    /// <summary>Renders a scene, given as the text of a scene file, with independent seeds.</summary>
    /// <inheritdoc cref="Render(string, int, Func{SceneDescription, SceneDescription}?, long)"/>
    /// <param name="json">The scene.</param>
    /// <param name="seeds">How many seeds.</param>
    /// <param name="change">Changes the description, but for the seed; null for none.</param>
    /// <param name="firstSeed">The first seed, before <see cref="TestSettings.Seed"/> is added as a multiple of a million.</param>
    public static ImageSamples RenderText(string json, int seeds, Func<SceneDescription, SceneDescription>? change = null, long firstSeed = 1)
    {
        SceneReadResult read = SceneReader.ReadText(json, "test.json");
        return Render(seeds, seed => Built(SceneLoader.Build(read, ".", d => WithSeed(change?.Invoke(d) ?? d, seed))), firstSeed);
    }

    /// <summary>Loads a scene file.</summary>
    /// <exception cref="InvalidOperationException">The file is wrong; the message holds the diagnostics.</exception>
    public static Scene Load(string path, Func<SceneDescription, SceneDescription>? change = null) => Built(SceneLoader.Load(path, change));

    private static ImageSamples Render(int seeds, Func<long, Scene> scene, long firstSeed)
    {
        ImageSamples? images = null;
        for (int i = 0; i < seeds; i++)
        {
            Film film = new RTracer(scene((uint)(firstSeed + i + (TestSettings.Seed * 1_000_000L)))).Render().Film;
            images ??= new(film.Width, film.Height);
            images.Add(film);
        }

        return images ?? throw new ArgumentOutOfRangeException(nameof(seeds));
    }

    private static SceneDescription WithSeed(SceneDescription d, long seed) => d with { Render = d.Render with { Seed = seed } };

    private static Scene Built(SceneLoadResult result) =>
        result.Scene ?? throw new InvalidOperationException(Diagnostic.Format(result.Diagnostics));
}
