using System.Runtime.CompilerServices;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>
/// A colour that may vary over a surface. (0, 0) in uv is the lower left corner of a picture, u grows to the right, v upwards.
/// </summary>
/// <param name="inputs">The inputs on which the colour depends.</param>
public abstract class Texture(TextureInputs inputs = TextureInputs.Uv)
{
    /// <summary>The inputs that the colour depends on.</summary>
    public TextureInputs Inputs => inputs;

    /// <summary>The colour if it is the same everywhere, else null; users may then skip computing uv.</summary>
    public virtual Rgb? Constant => null;

    /// <summary>The smallest rectangle of memory the texture keeps, in bytes: what <c>info</c> reports.</summary>
    public virtual long MemoryBytes => 0;

    /// <summary>The width over the height that its picture has; 1 where it has none.</summary>
    public virtual float Aspect => 1;

    /// <summary>The colour at a point.</summary>
    /// <param name="at">The point: what the texture's <see cref="Inputs"/> name of it.</param>
    /// <param name="color">The colour there, linear.</param>
    public abstract void Evaluate(in TexturePointW at, out RgbW color);

    /// <summary>True where <see cref="Slope(in TexturePointW, out FloatW, out FloatW)"/> gives the derivatives.</summary>
    public virtual bool HasSlope => false;

    /// <summary>The derivatives of the red channel by u and by v; only where <see cref="HasSlope"/> says so.</summary>
    /// <param name="at">The point.</param>
    /// <param name="alongU">Derivative by u.</param>
    /// <param name="alongV">Derivative by v.</param>
    public virtual void Slope(in TexturePointW at, out FloatW alongU, out FloatW alongV) => alongU = alongV = 0f;

    /// <summary>The colour where a path meets a surface.</summary>
    /// <param name="surface">The place: <see cref="SurfaceW.U"/>, <see cref="SurfaceW.V"/>, and what else the texture's <see cref="Inputs"/>
    /// name.</param>
    /// <param name="color">The colour there, linear.</param>
    public void Evaluate(in SurfaceW surface, out RgbW color)
    {
        Find(surface, out TexturePointW at);
        Evaluate(at, out color);
    }

    /// <summary>As <see cref="Slope(in TexturePointW, out FloatW, out FloatW)"/>, where a path meets a surface.</summary>
    /// <param name="surface">The place.</param>
    /// <param name="alongU">Derivative by u.</param>
    /// <param name="alongV">Derivative by v.</param>
    public void Slope(in SurfaceW surface, out FloatW alongU, out FloatW alongV)
    {
        Find(surface, out TexturePointW at);
        Slope(at, out alongU, out alongV);
    }

    /// <summary>The colour at a point of which only uv is known: textures in space are cut at z = 0, and vertices are white.</summary>
    /// <param name="u">First surface coordinate.</param>
    /// <param name="v">Second surface coordinate.</param>
    /// <param name="color">The colour there, linear.</param>
    public void Evaluate(in FloatW u, in FloatW v, out RgbW color)
    {
        Unsafe.SkipInit(out TexturePointW at);
        at.U = u;
        at.V = v;
        if ((inputs & TextureInputs.BeyondUv) != TextureInputs.None)
        {
            at.Local = at.World = new(u, v, 0f);
            at.VertexColor = at.SecondColor = Rgb.White;
        }

        Evaluate(at, out color);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Find(in SurfaceW surface, out TexturePointW at)
    {
        Unsafe.SkipInit(out at);
        at.U = surface.U;
        at.V = surface.V;
        if ((inputs & TextureInputs.BeyondUv) != TextureInputs.None)
        {
            at.Local = surface.Local;
            at.World = surface.Point;
            at.VertexColor = surface.Tint;
            at.SecondColor = surface.SecondTint;
        }
    }
}
