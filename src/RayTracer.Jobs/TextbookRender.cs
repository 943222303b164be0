using RayTracer.Rendering;
using RayTracer.Textbook;

namespace RayTracer.Jobs;

/// <summary>Renders samples by the textbook edition into a film.</summary>
/// <param name="renderer">The textbook edition's renderer.</param>
/// <param name="options">The options of the computation: threads, crop, samples and what to do after passes.</param>
internal sealed class TextbookRender(Renderer renderer, RenderOptions options)
{
    private readonly List<BadSample> _bad = [];
    private long _dropped;
    private long _clamped;

    /// <summary>Renders, sample by sample; one that is broken off does not count.</summary>
    public RenderStatistics Render(Film film, IProgress<RenderProgress>? progress, CancellationToken cancellation)
    {
        SampleRange samples = options.Samples!.Value;
        Tile area = options.Crop ?? new(0, 0, film.Width, film.Height);
        int threads = options.Threads > 0 ? options.Threads : Environment.ProcessorCount;
        int done = 0;
        bool isStopped = false;
        while (done < samples.Count && !isStopped && !cancellation.IsCancellationRequested)
        {
            try
            {
                int sample = samples.First + done;
                Add(film, area, sample, Pass(sample, threads, cancellation));
                done++;
                progress?.Report(new((long)area.Pixels * done, (long)area.Pixels * samples.Count, 0) { Pass = done, SamplesDone = done });
                isStopped = options.AfterPass?.Invoke(new(sample, sample + 1)) <= TimeSpan.Zero;
            }
            catch (OperationCanceledException)
            {
                isStopped = true;
            }
        }

        return new()
        {
            SamplesPerPixel = done,
            Paths = (long)area.Pixels * done,
            NonFiniteSamples = _dropped,
            ClampedSamples = _clamped,
            BadSamples = _bad,
            Cancelled = done < samples.Count,
        };
    }

    private Textbook.Rgb[] Pass(int sample, int threads, CancellationToken cancellation)
    {
        try
        {
            return renderer.Pass(sample, threads, cancellation);
        }
        catch (Exception e) when (PluginFault.Is(e) && Find(sample, cancellation) is { } pixel)
        {
            throw new RenderFailedException(pixel, new(sample, sample + 1), e);
        }
    }

    // The first pixel at which a pass breaks off, by one thread; null where that is on a path from a light, or does not happen again.
    private Tile? Find(int sample, CancellationToken cancellation)
    {
        Tile? last = null;
        try
        {
            renderer.With((stream, own) => new NotedSampler(own, (x, y, _) => last = stream == 0 ? new(x, y, 1, 1) : null)).Pass(sample, 1, cancellation);
            return null;
        }
        catch (Exception e) when (e is not OperationCanceledException)
        {
            return last;
        }
    }

    private void Add(Film film, Tile area, int sample, Textbook.Rgb[] pixels)
    {
        Int128[] sums = new Int128[film.Width * Film.SumsPerPixel];
        uint[] counts = new uint[film.Width];
        for (int y = area.Y; y < area.Y + area.Height; y++)
        {
            Array.Clear(sums);
            Array.Clear(counts);
            for (int x = area.X; x < area.X + area.Width; x++)
            {
                Textbook.Rgb light = pixels[(y * film.Width) + x];
                if (!double.IsFinite(light.R + light.G + light.B))
                {
                    Drop(new(x, y, sample, new((float)light.R, (float)light.G, (float)light.B)));
                    continue;
                }

                counts[x] = 1;
                Put(sums.AsSpan(x * Film.SumsPerPixel), light);
            }

            film.AddSums(y, sums, counts);
        }
    }

    private void Put(Span<Int128> sums, Textbook.Rgb light)
    {
        Textbook.Rgb limited = new(Limited(light.R), Limited(light.G), Limited(light.B));
        _clamped += limited == light ? 0 : 1;
        sums[0] = (Int128)Math.Round(limited.R * Film.ChannelUnits);
        sums[1] = (Int128)Math.Round(limited.G * Film.ChannelUnits);
        sums[2] = (Int128)Math.Round(limited.B * Film.ChannelUnits);
        sums[Film.SquareSum] = (Int128)Math.Round(limited.Luminance * limited.Luminance * Film.SquareUnits);
    }

    private void Drop(BadSample bad)
    {
        _dropped++;
        if (_bad.Count < RenderStatistics.MaxBadSamples)
        {
            _bad.Add(bad);
        }
    }

    private static double Limited(double value) => Math.Clamp(value, -Film.SampleLimit, Film.SampleLimit);
}
