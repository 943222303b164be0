using RayTracer.Textures;

namespace RayTracer.RenderTests.Oracle;

/// <summary>Independent pictures of a scene, by the oracle and by the product.</summary>
internal static class OracleRuns
{
    /// <summary>Renders by the oracle, on all processors.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="batches">Number of pictures.</param>
    /// <param name="samplesPerSide">Side of the square of samples in each pixel.</param>
    /// <param name="stream">Selects random numbers, together with <see cref="TestSettings.Seed"/>.</param>
    public static ImageSamples Oracle(Scene scene, int batches, int samplesPerSide, string stream)
    {
        ulong seed = stream.Aggregate((ulong)TestSettings.Seed, (hash, letter) => (hash * 1_000_003) + letter);
        RandomNumbers seeds = new(seed);
        ulong[] batchSeeds = [.. Enumerable.Range(0, batches).Select(_ => (ulong)(seeds.Next() * (1UL << 53)))];
        Picture[] pictures = new Picture[batches];
        Parallel.For(0, batches, i => pictures[i] = new RecursiveTracer(scene, new(batchSeeds[i])).Render(samplesPerSide));
        ImageSamples images = new(scene.Width, scene.Height);
        Array.ForEach(pictures, images.Add);
        return images;
    }

    /// <summary>Renders by the product, with another seed for each picture.</summary>
    /// <param name="path">The scene file.</param>
    /// <param name="scene">The scene as the oracle has read it, for its size.</param>
    /// <param name="batches">Number of pictures.</param>
    /// <param name="samplesPerSide">Square root of the number of samples in each pixel.</param>
    /// <param name="firstSeed">The first seed.</param>
    public static ImageSamples Product(string path, Scene scene, int batches, int samplesPerSide, long firstSeed = 1) =>
        SceneRuns.Render(
            path,
            batches,
            d => d with
            {
                Render = d.Render with { Width = scene.Width, Height = scene.Height, SamplesPerPixel = samplesPerSide * samplesPerSide },
            },
            firstSeed);
}
