namespace RayTracer.Studio;

/// <summary>How the server runs.</summary>
internal sealed record ServerOptions
{
    /// <summary>The port; 0 for a free one.</summary>
    public int Port { get; init; }

    /// <summary>How long to wait for windows.</summary>
    public GraceTimes Grace { get; init; } = GraceTimes.Default;

    /// <summary>How long a request waits for news.</summary>
    public TimeSpan Patience { get; init; } = TimeSpan.FromSeconds(20);

    /// <summary>The clock for waiting for windows.</summary>
    public TimeProvider Time { get; init; } = TimeProvider.System;

    /// <summary>Where errors are told.</summary>
    public TextWriter Errors { get; init; } = Console.Error;
}
