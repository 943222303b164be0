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
        if (integrator is ILightPathIntegrator fromLights)
        {
            TraceLight(fromLights, pixels, sample, options);
        }

        return pixels;
    }

    /// <summary>
    /// The light that a sample of a pixel, counted from 0, brings by its own rays, while somebody looks; paths from lights are not followed.
    /// </summary>
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

    // As many paths from the lights as there are pixels, each of which may light any of them: one sample of all is their mean.
    private void TraceLight(ILightPathIntegrator fromLights, Rgb[] pixels, int sample, ParallelOptions options)
    {
        Lock gate = new();
        Parallel.For(0, height, options, () => (Sampler: newSampler(1), Splats: new List<(int Pixel, Rgb Light)>()), (y, _, own) =>
        {
            for (int x = 0; x < width; x++)
            {
                own.Sampler.Begin(x, y, sample);
                fromLights.TraceLight(scene, own.Sampler, (column, row, light) => own.Splats.Add((((int)row * width) + (int)column, light)));
            }

            return own;
        },
        own =>
        {
            lock (gate)
            {
                own.Splats.ForEach(s => pixels[s.Pixel] += s.Light * (1.0 / pixels.Length));
            }
        });
    }
}
