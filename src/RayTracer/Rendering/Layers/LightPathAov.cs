namespace RayTracer.Rendering;

/// <summary>
/// Parts of a picture's light. A vertex is where a path is scattered: not where it goes straight on, through a hole or a thin pane. The
/// picture is
/// <see cref="Emission"/> + <see cref="Direct"/> + <see cref="Indirect"/>, and also <see cref="Emission"/> + <see cref="Diffuse"/> +
/// <see cref="Specular"/> + <see cref="Volume"/>, and also the sum of <see cref="Lights"/>.
/// </summary>
public enum LightPathAov
{
    /// <summary>Light that comes from a source without any vertex: what shines, and what is behind everything.</summary>
    Emission,

    /// <summary>Light that comes by one vertex.</summary>
    Direct,

    /// <summary>Light that comes by several vertices, and ambient light.</summary>
    Indirect,

    /// <summary>Light whose vertex nearest to the camera is on a surface, as much of it as the matt part of the surface scatters.</summary>
    Diffuse,

    /// <summary>
    /// Light whose vertex nearest to the camera is on a surface, as much of it as all other parts of the surface scatter.
    /// </summary>
    Specular,

    /// <summary>Light whose vertex nearest to the camera is in a medium.</summary>
    Volume,

    /// <summary>A layer for each source or group of sources: all that comes from there, by any way.</summary>
    Lights,
}
