using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textbook;
using SceneReader = RayTracer.Textbook.SceneReader;

namespace RayTracer.Jobs;

/// <summary>
/// The edition of the renderer that makes a picture: the fast one, or <see cref="RayTracer.Textbook"/>, which is there to be read. Films of the latter say
/// so in their content, and go with no others.
/// </summary>
internal static class Edition
{
    private const string Textbook = "textbook";
    private static readonly string[] s_own = [.. SceneReader.OwnIntegrators.Select(i => $"{Textbook}:{i}")];

    /// <summary>The words of the option; the fast edition is the first.</summary>
    public static IReadOnlyList<string> Words { get; } = ["fast", Textbook, .. s_own];

    /// <summary>What an edition adds to the name of the program in files.</summary>
    public static string Software(string? edition) => edition is null ? "" : $", {edition} edition, whose bits depend on the system";

    /// <summary>The content of a film of an edition, by that of the fast one.</summary>
    public static string Content(string content, string? edition) => edition is null ? content : $"{edition}-{content}";

    /// <summary>The edition that a film was rendered by, by its content; null for the fast one.</summary>
    public static string? Of(string content) => Words.LastOrDefault(w => content.StartsWith($"{w}-", StringComparison.Ordinal));

    /// <summary>Why a film does not go with an edition; null where that is not the reason.</summary>
    /// <param name="content">The film's content.</param>
    /// <param name="edition">The edition that is asked for; null for the fast one.</param>
    public static string? Complaint(string content, string? edition)
    {
        string? own = Of(content);
        return own == edition ? null
            : own is null ? "the film was not rendered by the textbook edition: leave --edition out" : $"the film was rendered by another edition: give --edition {own}";
    }

    /// <summary>The textbook edition's renderer of a scene that has been loaded; null where the fast one renders it.</summary>
    /// <param name="edition">The edition; null for the fast one.</param>
    /// <param name="load">The scene.</param>
    /// <param name="refused">Takes what that edition lacks, at its places in the file.</param>
    public static Renderer? Renderer(string? edition, SceneLoadResult load, out IReadOnlyList<Diagnostic> refused)
    {
        refused = [];
        if (edition is null)
        {
            return null;
        }

        SceneReader reader = new(load.LoadPicture, load.LoadModel);
        Renderer? renderer = reader.Read(load.Description!, edition.Split(':') is [_, var own] ? own : null);
        refused = [.. reader.Complaints.Select(load.Locate)];
        return renderer;
    }
}

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
                Add(film, area, sample, renderer.Pass(sample, threads, cancellation));
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
