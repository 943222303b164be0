namespace RayTracer.Textbook;

/// <summary>Where rays pass the lens (report, section 6.2.3, depth of field).</summary>
public interface ILens
{
    /// <summary>A random point of the lens, from its middle.</summary>
    /// <param name="sampler">The source of random numbers.</param>
    Vector Point(ISampler sampler);
}

/// <summary>A hole so small that everything is sharp.</summary>
public sealed class Pinhole : ILens
{
    /// <inheritdoc/>
    public Vector Point(ISampler sampler) => default;
}

/// <summary>A round lens.</summary>
/// <param name="right">From the middle to the right edge.</param>
/// <param name="up">From the middle to the upper edge.</param>
public sealed class RoundLens(Vector right, Vector up) : ILens
{
    /// <inheritdoc/>
    public Vector Point(ISampler sampler)
    {
        (double x, double y) = Warp.Disk(sampler.Next2());
        return (x * right) + (y * up);
    }
}

/// <summary>A square lens.</summary>
/// <param name="right">From the middle to the right edge.</param>
/// <param name="up">From the middle to the upper edge.</param>
public sealed class SquareLens(Vector right, Vector up) : ILens
{
    /// <inheritdoc/>
    public Vector Point(ISampler sampler)
    {
        (double u, double v) = sampler.Next2();
        return (((2 * u) - 1) * right) + (((2 * v) - 1) * up);
    }
}

/// <summary>The report's Jitter (listing 6.1): the eye itself moves within a box.</summary>
/// <param name="place">The map that takes the unit cube around the origin to the box.</param>
public sealed class EyeJitter(Transform place) : ILens
{
    /// <inheritdoc/>
    public Vector Point(ISampler sampler)
    {
        (double u, double v) = sampler.Next2();
        return place.Direction(new(u - 0.5, v - 0.5, sampler.Next() - 0.5));
    }
}
