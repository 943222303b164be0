namespace RayTracer.Rendering;

/// <summary>A part of a picture could not be rendered: the inner exception says why, and this one where.</summary>
/// <param name="area">The smallest rectangle that has all pixels of the part.</param>
/// <param name="samples">The samples of them that were being rendered.</param>
/// <param name="innerException">What was thrown.</param>
public sealed class RenderFailedException(Tile area, SampleRange samples, Exception innerException) : InvalidOperationException("Rendering failed.", innerException)
{
    /// <summary>The smallest rectangle that has all pixels of the part.</summary>
    public Tile Area => area;

    /// <summary>The samples of them that were being rendered.</summary>
    public SampleRange Samples => samples;
}
