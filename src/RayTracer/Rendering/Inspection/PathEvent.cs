namespace RayTracer.Rendering;

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
