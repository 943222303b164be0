using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Where a light path meets something, in the renderer's own numbers. What it has gathered is recorded after each step, so that the differences are
/// what each step adds, with the renderer's roundings.
/// </summary>
public sealed record PathVertex
{
    /// <summary>The event that happens to the path.</summary>
    public required PathEvent Event { get; init; }

    /// <summary>The origin of the ray that leads here.</summary>
    public required Vector3 Origin { get; init; }

    /// <summary>Its unit direction.</summary>
    public required Vector3 Direction { get; init; }

    /// <summary>The point at which it meets the surface; null where it meets nothing.</summary>
    public Vector3? Position { get; init; }

    /// <summary>The unit normal with which the surface is shaded, on the ray's side; null where there is none.</summary>
    public Vector3? Normal { get; init; }

    /// <summary>The primitive met; −1 for none.</summary>
    public int Primitive { get; init; } = -1;

    /// <summary>The instance that shows it; 0 for the world itself.</summary>
    public int Instance { get; init; }

    /// <summary>The factor by which light from here is multiplied.</summary>
    public required Rgb Throughput { get; init; }

    /// <summary>The factor on that for all that comes later: BSDF · cosine / pdf of the chosen direction.</summary>
    public Rgb Weight { get; init; }

    /// <summary>
    /// The density with which the direction was chosen, in 1/sr; null where it was chosen by a mirror-like lobe, or there is none.
    /// </summary>
    public float? Pdf { get; init; }

    /// <summary>The BSDF for the chosen direction, where the weight is BSDF · cosine / pdf of it; else null.</summary>
    public Rgb? Bsdf { get; init; }

    /// <summary>The cosine between the chosen direction and the normal.</summary>
    public float Cosine { get; init; }

    /// <summary>The probability with which the path survived the game of chance here; 1 where none was played. Throughput is divided by it.</summary>
    public float Survival { get; init; } = 1;

    /// <summary>The reason for its end, where it could have gone on.</summary>
    public PathEnd End { get; init; }

    /// <summary>What media on the way here have left of the throughput, over the probability of going so far.</summary>
    public Rgb Passed { get; init; } = Rgb.White;

    /// <summary>The colour of the wavelength that the path gets here; white where it gets none.</summary>
    public Rgb Dispersion { get; init; } = Rgb.White;

    /// <summary>The light that is met here; null where nothing shines.</summary>
    public TracedEmission? Emission { get; init; }

    /// <summary>The points of lights that are asked.</summary>
    public IReadOnlyList<TracedLight> Lights { get; init; } = [];

    /// <summary>The radiance that the path had gathered before.</summary>
    public required Rgb Before { get; init; }

    /// <summary>… after the surface's own light (or the background's, where there is no surface).</summary>
    public required Rgb AfterEmission { get; init; }

    /// <summary>… after ambient light.</summary>
    public required Rgb AfterAmbient { get; init; }

    /// <summary>… after the light that comes from the sources: all that it has gathered so far.</summary>
    public Rgb After { get; init; }

    /// <summary>Where paths come from lights too: the number of vertices before, to which boundaries that are only crossed do not belong.</summary>
    internal uint Number { get; init; }
}

/// <summary>The events at the vertices of a path.</summary>
public enum PathEvent
{
    /// <summary>It goes on in a direction chosen from many, about which light sources are asked too.</summary>
    Diffuse,

    /// <summary>It goes on by a mirror-like lobe.</summary>
    Specular,

    /// <summary>The surface lets nothing go on.</summary>
    Absorbed,

    /// <summary>
    /// It is given up: it has been as deep as the scene allows, carries nothing any more, or would go through the surface.
    /// </summary>
    Ended,

    /// <summary>It meets nothing.</summary>
    Missed,
}
