namespace RayTracer.Textbook;

/// <summary>Makes pictures: a ray through each pixel, again and again, and the mean of what they bring.</summary>
/// <param name="scene">The scene.</param>
/// <param name="integrator">Computes the light that a ray brings.</param>
/// <param name="width">Width of the picture in pixels.</param>
/// <param name="height">Height of the picture in pixels.</param>
/// <param name="newSampler">Makes a source of random numbers, by the number of a stream: rays have the first, paths from lights the second.</param>
public sealed class Renderer(Scene scene, IIntegrator integrator, int width, int height, Func<int, ISampler> newSampler)
{
    /// <summary>The scene.</summary>
    public Scene Scene => scene;

    /// <summary>The same renderer, with sources of random numbers that are made of its own, by the number of the stream.</summary>
    public Renderer With(Func<int, ISampler, ISampler> change) => new(scene, integrator, width, height, stream => change(stream, newSampler(stream)));

    /// <summary>Renders one sample of each pixel.</summary>
    /// <param name="sample">Number of the sample, from 0.</param>
    /// <param name="threads">The number of threads.</param>
    /// <param name="cancellation">Ends it early.</param>
    /// <returns>What the pixels get of it, row by row from the top left.</returns>
    /// <exception cref="OperationCanceledException">It was ended early.</exception>
    public Rgb[] Pass(int sample, int threads = 1, CancellationToken cancellation = default)
    {
        Begin(sample);
        Rgb[] pixels = new Rgb[width * height];
        ParallelOptions options = new() { MaxDegreeOfParallelism = threads, CancellationToken = cancellation };
        Parallel.For(0, height, options, () => newSampler(0), (y, _, sampler) => Row(pixels, y, sample, sampler), _ => { });
        Parallel.For(0, height, options, y =>
        {
            List<(int Pixel, Rgb Light)> splats = [];
            TraceLight(scene, y, sample, (column, row, light) => splats.Add(((row * width) + column, light)));
            lock (pixels)
            {
                splats.ForEach(s => pixels[s.Pixel] += s.Light);
            }
        });
        return pixels;
    }

    /// <summary>Follows paths from the lights: as many as a row has pixels, each of which may light any pixel of the picture.</summary>
    /// <param name="seen">The scene, perhaps with somebody who looks.</param>
    /// <param name="y">The row.</param>
    /// <param name="sample">Number of the sample, from 0.</param>
    /// <param name="splat">Takes the column and row of a pixel, and the light that it gets: one sample of all pixels is the mean of all paths.</param>
    public void TraceLight(Scene seen, int y, int sample, Action<int, int, Rgb> splat)
    {
        ISampler sampler = newSampler(1);
        for (int x = 0; x < width && integrator is ILightPathIntegrator fromLights; x++)
        {
            sampler.Begin(x, y, sample);
            seen.Witness?.Began();
            fromLights.TraceLight(seen, sampler, (column, row, light) => splat((int)column, (int)row, light * (1.0 / (width * height))));
        }
    }

    /// <summary>The light that a sample of a pixel, counted from 0, brings by its own rays, while somebody looks.</summary>
    public Rgb Follow(int x, int y, int sample, IWitness witness)
    {
        Begin(sample);
        return Pixel(scene.WatchedBy(witness), x, y, sample, newSampler(0));
    }

    private void Begin(int sample)
    {
        ISampler ofLight = newSampler(1);
        ofLight.Begin(-1, -1, sample);
        integrator.BeginPass(scene, sample, width * height, ofLight);
    }

    private ISampler Row(Rgb[] pixels, int y, int sample, ISampler sampler)
    {
        for (int x = 0; x < width; x++)
        {
            pixels[(y * width) + x] = Pixel(scene, x, y, sample, sampler);
        }

        return sampler;
    }

    private Rgb Pixel(Scene seen, int x, int y, int sample, ISampler sampler)
    {
        sampler.Begin(x, y, sample);
        (double u, double v) = sampler.Next2();
        Ray ray = seen.Camera.RayThrough(x + u, y + v, sampler);
        return integrator.Radiance(seen, ray, sampler);
    }
}
