namespace RayTracer.Cli;

/// <summary>Where a command writes.</summary>
/// <param name="Output">Results.</param>
/// <param name="Error">Errors, warnings and progress.</param>
/// <param name="HasTerminal">Whether <paramref name="Error"/> is a terminal, which can show a progress bar.</param>
internal sealed record Streams(TextWriter Output, TextWriter Error, bool HasTerminal = false)
{
    /// <summary>Writes one line that says what went wrong.</summary>
    public void Fail(string message) => Error.WriteLine($"raytracer: error: {message}");

    /// <summary>Writes one line about something doubtful.</summary>
    public void Warn(string message) => Error.WriteLine($"raytracer: warning: {message}");
}
