using System.Diagnostics;
using System.Reflection;
using RayTracer.Description;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>What is reported of an exception that a class of a plug-in threw: the class, its method, the pixel and sample, and the first lines of its own stack.</summary>
internal static class PluginFault
{
    private const int MostLines = 4;

    /// <summary>True for exceptions that a plug-in's class threw, or let pass.</summary>
    public static bool Is(Exception thrown) => Chain(thrown).Last() is not (OperationCanceledException or OutOfMemoryException) and var cause && Own(cause).Length > 0;

    /// <summary>Returns what is reported of one.</summary>
    /// <param name="thrown">An exception for which <see cref="Is"/> is true.</param>
    /// <param name="scene">The scene that was being rendered; null before there was one.</param>
    public static JobException Report(Exception thrown, Scene? scene = null)
    {
        Exception cause = Chain(thrown).Last();
        (StackFrame Frame, MethodBase Method)[] own = Own(cause);
        string place = scene is not null && Chain(thrown).OfType<RenderFailedException>().FirstOrDefault() is { } failed ? Place(scene, failed.Area, failed.Samples) : "";
        string stack = string.Concat(own.Take(MostLines).Select(o => $"\n  at {Name(o.Method)}{Line(o.Frame)}"));
        string message = $"{Name(own[0].Method)}, of the plug-in {Plugins.OriginOf(own[0].Method.DeclaringType!)}, threw {cause.GetType().Name}{place}";
        return new(JobFault.Plugin, $"{message}: {cause.Message.ReplaceLineEndings(" ").TrimEnd('.')}{stack}");
    }

    private static IEnumerable<Exception> Chain(Exception thrown)
    {
        for (Exception? e = thrown; e is not null; e = e.InnerException)
        {
            yield return e;
        }
    }

    private static (StackFrame Frame, MethodBase Method)[] Own(Exception cause) =>
    [
        .. new StackTrace(cause, fNeedFileInfo: true).GetFrames()
            .Where(f => f.GetMethod()?.DeclaringType is { } type && Plugins.OriginOf(type) is not null)
            .Select(f => (f, f.GetMethod()!)),
    ];

    // The fast edition follows the paths of many pixels at once. The same part is rendered again, in halves, until one sample of one pixel is left.
    private static string Place(Scene scene, Tile area, SampleRange samples)
    {
        while (area.Pixels > 1 || samples.Count > 1)
        {
            if (Halves(area, samples).Select(h => ((Tile, SampleRange)?)h).FirstOrDefault(h => Fails(scene, h!.Value)) is not { } half)
            {
                // It does not happen again: perhaps the class has a memory of what came before.
                return $" between the pixels {area.X},{area.Y} and {area.X + area.Width - 1},{area.Y + area.Height - 1}, samples {samples.First} to {samples.End - 1}";
            }

            (area, samples) = half;
        }

        return $" at pixel {area.X},{area.Y}, sample {samples.First}";
    }

    private static (Tile Area, SampleRange Samples)[] Halves(Tile area, SampleRange samples)
    {
        int middle = samples.First + (samples.Count / 2);
        (int width, int height) = (area.Width / 2, area.Height / 2);
        return samples.Count > 1 ? [(area, samples with { End = middle }), (area, samples with { First = middle })]
            : height > 0 && height >= width ? [(area with { Height = height }, samples), (area with { Y = area.Y + height, Height = area.Height - height }, samples)]
            : [(area with { Width = width }, samples), (area with { X = area.X + width, Width = area.Width - width }, samples)];
    }

    private static bool Fails(Scene scene, (Tile Area, SampleRange Samples) part)
    {
        try
        {
            new RTracer(scene, new() { Threads = 1, Crop = part.Area, Samples = part.Samples }).Render();
            return false;
        }
        catch (RenderFailedException)
        {
            return true;
        }
    }

    private static string Line(StackFrame frame) => frame.GetFileName() is { } file ? $" ({Path.GetFileName(file)}:{frame.GetFileLineNumber()})" : "";

    // Functions within functions have names of the compiler's, such as <Evaluate>g__Inner|0, and so have their classes. What implements an interface may be
    // called by the whole name of that.
    private static string Name(MethodBase method)
    {
        Type type = method.DeclaringType!;
        while (type.Name.StartsWith('<') && type.DeclaringType is { } outer)
        {
            type = outer;
        }

        string name = method.Name.StartsWith('<') ? method.Name[1..method.Name.IndexOf('>', StringComparison.Ordinal)] : method.Name[(method.Name.LastIndexOf('.') + 1)..];
        return $"{type.Name}.{name}";
    }
}
