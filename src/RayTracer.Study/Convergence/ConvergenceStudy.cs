using System.Diagnostics;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Study;

/// <summary>Measures how the error of pictures falls with the time of rendering.</summary>
/// <param name="reference">The picture without noise.</param>
/// <param name="duration">The time for which each picture is rendered.</param>
internal sealed class ConvergenceStudy(IImageRows reference, TimeSpan duration)
{
    private static readonly TimeSpan s_longestWarmUp = TimeSpan.FromSeconds(2);

    // From one measurement to the next: two for each doubling of the time.
    private static readonly double s_growth = Math.Sqrt(2);

    /// <summary>Renders a scene with all threads, and measures its error now and then between passes, while the clock is stopped.</summary>
    /// <param name="scene">The scene, with more samples than there is time for.</param>
    /// <param name="cancellation">Ends the rendering.</param>
    /// <returns>The errors so far, by time.</returns>
    public IReadOnlyList<ErrorPoint> Measure(Scene scene, CancellationToken cancellation)
    {
        // The first rendering also compiles the program; its time does not count.
        Render(scene, duration < s_longestWarmUp ? duration : s_longestWarmUp, (_, _, _) => { }, cancellation);
        List<ErrorPoint> points = [];
        Render(scene, duration, (film, samples, time) => points.Add(new(time.TotalSeconds, samples, RelativeError.Of(film, reference))), cancellation);
        return points;
    }

    private static void Render(Scene scene, TimeSpan duration, Action<Film, int, TimeSpan> measure, CancellationToken cancellation)
    {
        Film film = new(scene.Render.Width, scene.Render.Height, FilmPlane.Needed(scene.Render.Integrator));
        Stopwatch watch = Stopwatch.StartNew();
        TimeSpan next = TimeSpan.Zero;
        TimeSpan AfterPass(SampleRange pass)
        {
            watch.Stop();
            TimeSpan time = watch.Elapsed;
            if (time >= next || pass.End == scene.Render.SamplesPerPixel)
            {
                measure(film, pass.End, time);
                next = s_growth * time < duration ? s_growth * time : duration;
            }

            watch.Start();
            return next - time;
        }

        new RTracer(scene, new() { AfterPass = AfterPass }).Render(film, null, cancellation);
    }
}
