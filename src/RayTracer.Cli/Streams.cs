using RayTracer.Description;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>The streams of a command.</summary>
/// <param name="Output">Results.</param>
/// <param name="Error">Errors, warnings and progress.</param>
/// <param name="HasTerminal">True if <paramref name="Error"/> is a terminal (<see cref="IsTerminal"/>), which can show a progress
/// bar.</param>
internal sealed record Streams(TextWriter Output, TextWriter Error, bool HasTerminal = false) : IJobWatch
{
    /// <summary>Returns whether a stream is a terminal on which the cursor can be moved: one that calls itself dumb cannot.</summary>
    /// <param name="isRedirected">True if it goes elsewhere.</param>
    /// <param name="term">The variable TERM.</param>
    public static bool IsTerminal(bool isRedirected, string? term) => !isRedirected && term != "dumb";

    /// <summary>Writes a line for each file that was written.</summary>
    public void Wrote(IEnumerable<string> files) => files.ToList().ForEach(f => Output.WriteLine($"wrote {f}"));

    /// <summary>Writes one line that says what went wrong.</summary>
    public void Fail(string message) => Error.WriteLine($"raytracer: error: {message}");

    /// <summary>Writes one line about something doubtful.</summary>
    public void Warn(string message) => Error.WriteLine($"raytracer: warning: {message}");

    /// <inheritdoc/>
    public IProgress<RenderProgress>? Begin(RenderDescription render) => HasTerminal ? ProgressDisplay.Start(this) : null;

    /// <inheritdoc/>
    public void Read(IReadOnlyList<Diagnostic> diagnostics) => Read(diagnostics, isQuiet: false);

    /// <summary>Shows diagnostics as a compiler does.</summary>
    /// <param name="diagnostics">The diagnostics.</param>
    /// <param name="isQuiet">True without notes.</param>
    public void Read(IReadOnlyList<Diagnostic> diagnostics, bool isQuiet)
    {
        diagnostics = isQuiet ? [.. diagnostics.Where(d => d.Severity != Severity.Note)] : diagnostics;
        if (diagnostics.Count > 0)
        {
            Error.WriteLine(Diagnostic.Format(diagnostics));
        }
    }
}
