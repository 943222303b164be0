namespace RayTracer.Rendering;

/// <summary>
/// The progress of <see cref="SamplePlanner"/> in rendering the samples that decide, for pictures whose pixels all get the same number: it
/// can be resumed from there.
/// </summary>
/// <param name="Film">
/// A column for each deciding pixel. In the upper row, its samples when it was last decided that more are needed; in the lower row, all
/// that there are since.
/// </param>
/// <param name="Samples">How many samples each pixel has in the lower row, those that came to no finite number included.</param>
/// <param name="Target">How many there shall be when it is decided again.</param>
public sealed record DecidingState(Film Film, int Samples, int Target);
