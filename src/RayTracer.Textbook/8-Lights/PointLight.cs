namespace RayTracer.Textbook;

/// <summary>A light at a point, which shines in all directions alike. No ray meets it.</summary>
/// <param name="position">Where it stands.</param>
/// <param name="intensity">Power per steradian.</param>
public sealed class PointLight(Vector position, Rgb intensity) : ILight
{
    /// <inheritdoc/>
    public bool IsPoint => true;

    /// <inheritdoc/>
    public double Power => 4 * Math.PI * intensity.Luminance;

    /// <summary>The light is spread over a sphere, whose area grows as the squared distance.</summary>
    public LightSample? Sample(Vector from, (double U, double V) random)
    {
        Vector to = position - from;
        double distance = to.Length;
        return new LightSample(to * (1 / distance), distance, intensity * (1 / (distance * distance)), 1);
    }

    /// <inheritdoc/>
    public (Ray Ray, Rgb Power)? Emit(ISampler sampler) => (new(position, Warp.Sphere(sampler.Next2())), intensity * (4 * Math.PI));
}
