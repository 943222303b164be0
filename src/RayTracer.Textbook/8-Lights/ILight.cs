namespace RayTracer.Textbook;

/// <summary>A source of light, of which points or directions are chosen at random.</summary>
public interface ILight
{
    /// <summary>True for a light without extent, which no ray can meet.</summary>
    bool IsPoint { get; }

    /// <summary>About how much light it sends in all: where one of many lights is chosen, it is in proportion to this.</summary>
    double Power { get; }

    /// <summary>Chooses a point or a direction of the light for a place that it may light; null where it cannot.</summary>
    /// <param name="from">The place.</param>
    /// <param name="random">Two random numbers from 0 to 1.</param>
    LightSample? Sample(Vector from, (double U, double V) random);

    /// <summary>Sends a path of light into the scene.</summary>
    /// <param name="sampler">The source of random numbers.</param>
    /// <returns>The ray, with the power that it carries: what leaves the light, over the density of the choice. Null where it carries none.</returns>
    (Ray Ray, Rgb Power)? Emit(ISampler sampler);
}

/// <summary>Light that may come to a place.</summary>
/// <param name="Direction">The unit direction to the light.</param>
/// <param name="Distance">The distance to it; infinite for what surrounds the scene.</param>
/// <param name="Radiance">The radiance from there; of a light without extent, the irradiance across the direction, and the density is 1.</param>
/// <param name="Pdf">The density of the direction, per steradian.</param>
public readonly record struct LightSample(Vector Direction, double Distance, Rgb Radiance, double Pdf);
