namespace RayTracer.Materials;

/// <summary>How <see cref="SurfaceW.Facing"/> follows from the ray: what must be repeated where a surface is seen along another one.</summary>
[Flags]
internal enum NormalRules
{
    /// <summary>It is the shape's own normal.</summary>
    None = 0,

    /// <summary>It is <see cref="SurfaceW.Shading"/>, mirrored where that would face away.</summary>
    Smooth = 1,

    /// <summary>It is <see cref="SurfaceW.Shading"/>, which alone says from which side the surface is seen.</summary>
    Literal = 2,

    /// <summary><see cref="Material.Prepare"/> turns it.</summary>
    Mapped = 4,

    /// <summary>Any of the three: it may be another normal than the shape's own.</summary>
    Bent = Smooth | Literal | Mapped,

    /// <summary><see cref="SurfaceW.Tangent"/> goes with it.</summary>
    HasTangent = 8,

    /// <summary><see cref="Material.Prepare"/> depends on the ray, whatever it does to normals.</summary>
    ByRay = 16,

    /// <summary>Light that would pass through the surface is dropped.</summary>
    DropsLeaks = 32,

    /// <summary>There is none, for it is no surface: light is scattered in a medium.</summary>
    InMedium = 64,
}
