using System.Diagnostics;
using RayTracer.Description;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>What was learned before a picture that is guided.</summary>
/// <param name="Hash">Stands for what was learned.</param>
/// <param name="Paths">The number of paths that it took; 0 where it was read from a file.</param>
/// <param name="Seconds">The time that it took.</param>
public sealed record GuideResult(string Hash, long Paths, double Seconds);

/// <summary>The guide of a job with <c>--guide</c>: learned, or read from the file of <c>--guide-file</c>.</summary>
internal static class Guidance
{
    private const string Mark = "guide-";
    private const int HashLength = 16;

    /// <summary>Refuses what cannot be guided, before the work.</summary>
    /// <exception cref="JobException">The scene is rendered by another integrator, or the file is that of another scene.</exception>
    public static void Check(LoadedJob loaded)
    {
        Integrator integrator = loaded.Scene.Render.Integrator;
        if (loaded.Job.Guide && !integrator.Has(IntegratorTraits.Guides))
        {
            throw new JobException(
                JobFault.Request, $"--guide: {Integrator.Only(IntegratorTraits.Guides, "learn")} where light comes from, and the scene is rendered by {integrator.Name}: "
                + "give --integrator path, or leave --guide out");
        }
    }

    /// <summary>Returns a job whose scene is guided, where that was asked for.</summary>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    /// <exception cref="JobException">The file of the guide is of another scene.</exception>
    public static (LoadedJob Loaded, GuideResult? Result) Guide(LoadedJob loaded)
    {
        if (!loaded.Job.Guide)
        {
            return (loaded, null);
        }

        long start = Stopwatch.GetTimestamp();
        GuideFile? file = loaded.Job.GuideFile is { } path ? new(path, ContentHash.Of(loaded.Description, loaded.Job.Scene, null)) : null;
        GuideLearning learning = new(loaded.Scene, loaded.Options);
        PathGuide? read = file?.Read();
        PathGuide guide = read ?? learning.Learn(loaded.Progress, loaded.Cancellation);
        if (read is null)
        {
            file?.Write(guide);
        }

        GuideResult result = new(guide.Hash, learning.Statistics.Paths, Stopwatch.GetElapsedTime(start).TotalSeconds);
        return (loaded with { Scene = loaded.Scene.Guided(guide) }, result);
    }

    /// <summary>The content of a film of a guided scene; that of the scene where it is not.</summary>
    public static string Content(string content, PathGuide? guide) => guide is null ? content : $"{Mark}{guide.Hash}-{content}";

    /// <summary>Returns whether a film was guided.</summary>
    public static bool IsGuided(string content) => content.StartsWith(Mark, StringComparison.Ordinal);

    /// <summary>The content of a film but for its guide.</summary>
    public static string Unguided(string content) => IsGuided(content) ? content[(Mark.Length + HashLength + 1)..] : content;
}
