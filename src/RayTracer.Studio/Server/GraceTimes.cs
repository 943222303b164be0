namespace RayTracer.Studio;

/// <summary>How long the server waits for a window before it ends.</summary>
/// <param name="AtStart">For the first one.</param>
/// <param name="WithoutWindow">For another one, after the last has gone.</param>
/// <param name="AfterFarewell">For another one, after the last has said that it goes.</param>
internal sealed record GraceTimes(TimeSpan AtStart, TimeSpan WithoutWindow, TimeSpan AfterFarewell)
{
    /// <summary>What users get.</summary>
    public static GraceTimes Default { get; } = new(TimeSpan.FromSeconds(60), TimeSpan.FromSeconds(10), TimeSpan.FromSeconds(3));
}
