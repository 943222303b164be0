using RayTracer.Materials;

namespace RayTracer.Acceleration;

/// <summary>Surfaces of one kind with consecutive primitive numbers, which describe themselves where rays met them.</summary>
/// <param name="count">Number of surfaces.</param>
/// <param name="stride">Numbers a surface in the packed table.</param>
public abstract class SurfaceTable(int count, int stride)
{
    /// <summary>Number of surfaces.</summary>
    public int Count { get; } = count;

    /// <summary>Numbers a surface in the packed table.</summary>
    public int Stride { get; } = stride;

    /// <summary>Number of the first surface among the scene's primitives.</summary>
    public int FirstPrimitive { get; internal set; }

    /// <summary>Memory of the table in bytes.</summary>
    public abstract long MemoryBytes { get; }

    /// <summary>True where <see cref="SurfaceW.Shading"/> is described and may differ from the normal.</summary>
    public virtual bool HasShadingNormals => false;

    /// <summary>True where <see cref="SurfaceW.Tint"/> is described.</summary>
    public virtual bool HasTint => false;

    /// <summary>True where <see cref="SurfaceW.SecondTint"/> is described.</summary>
    public virtual bool HasSecondTint => false;

    /// <summary>Describes the surface where rays met it.</summary>
    /// <param name="primitives">The primitives hit.</param>
    /// <param name="needsUv">True if uv is wanted.</param>
    /// <param name="surface">
    /// In: the hit point as computed along the ray. Out: that point moved onto the surface, the outward normal, the offset, and uv where
    /// wanted.
    /// </param>
    public abstract void Describe(in PrimitiveIndex primitives, bool needsUv, ref SurfaceW surface);

    /// <summary>Describes how points of the surface move with u and with v; (0, 0, 0), or no number, where that is not known.</summary>
    /// <param name="primitives">The primitives hit.</param>
    /// <param name="surface">In: as <see cref="Describe"/> left it, with uv. Out: <see cref="SurfaceW.AlongU"/> and
    /// <see cref="SurfaceW.AlongV"/>.</param>
    public abstract void DescribeTangents(in PrimitiveIndex primitives, ref SurfaceW surface);
}
